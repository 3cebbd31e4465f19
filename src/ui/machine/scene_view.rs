//! The drawing in the page: its parts once, then only the attributes that change.

use std::collections::BTreeMap;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement};

use crate::text::number::filled;
use crate::ui::dom;
use crate::ui::parts::scene::fit;
use crate::view::svg::{paint_name, transform};
use crate::view::{Paint, Pose, Scene, SceneGroup};

/// The parts of a drawing that move with the head.
pub(super) struct Drawn {
    groups: Vec<Group>,
    parts: BTreeMap<u16, Part>,
    picture: Option<HtmlElement>,
    view: [f64; 4],
    unit: f64,
    /// Start of the names of the scene's own gradients.
    alt: &'static str,
}

struct Group {
    parts: Vec<Element>,
    rest: SceneGroup,
    transform: String,
    opacity: f64,
}

/// A part that poses change by its number.
struct Part {
    element: Element,
    /// Path or text at present.
    text: String,
    dash: f64,
    fill: Option<Paint>,
}

impl Drawn {
    /// Finds the parts of a drawing in `host`.
    pub(super) fn new(host: &Element, scene: &Scene) -> Drawn {
        let group =
            |rest: &SceneGroup| Group { parts: Vec::new(), rest: rest.clone(), transform: String::new(), opacity: 1.0 };
        let mut groups: Vec<Group> = scene.groups.iter().map(group).collect();
        for part in dom::all(host, "[data-g]") {
            let number = part.get_attribute("data-g").and_then(|n| n.parse::<usize>().ok());
            if let Some(group) = number.and_then(|n| groups.get_mut(n)) {
                group.transform = part.get_attribute("transform").unwrap_or_default();
                group.parts.push(part);
            }
        }
        let numbered = |element: Element| {
            let number = element.get_attribute("data-n")?.parse().ok()?;
            Some((number, Part { element, text: String::new(), dash: f64::NAN, fill: None }))
        };
        let parts = dom::all(host, "[data-n]").into_iter().filter_map(numbered).collect();
        Drawn {
            groups,
            parts,
            picture: dom::all(host, ".scene").into_iter().next().map(JsCast::unchecked_into),
            view: scene.view,
            unit: scene.unit,
            alt: scene.alt,
        }
    }

    /// Keeps labels at their size in pixels, as far as they have room.
    pub(super) fn fit(&self) {
        if let Some(picture) = &self.picture {
            fit(picture, self.view, self.unit);
        }
    }

    /// Moves the parts; parts that have not moved are not touched.
    pub(super) fn pose(&mut self, pose: &Pose) {
        let mut text = String::new();
        for place in &pose.placements {
            let Some(group) = self.groups.get_mut(place.group as usize) else { continue };
            text.clear();
            transform(&mut text, &group.rest, place);
            if text != group.transform {
                group.parts.iter().for_each(|part| dom::set(part, "transform", &text));
                group.transform.clone_from(&text);
            }
            if place.opacity != group.opacity {
                group.opacity = place.opacity;
                let opacity = filled("#", &[place.opacity]);
                group.parts.iter().for_each(|part| dom::set(part, "opacity", &opacity));
            }
        }
        for (at, d) in &pose.paths {
            if let Some(part) = self.parts.get_mut(at).filter(|part| part.text != *d) {
                dom::set(&part.element, "d", d);
                part.text.clone_from(d);
            }
        }
        for (at, words) in &pose.texts {
            if let Some(part) = self.parts.get_mut(at).filter(|part| part.text != *words) {
                part.element.set_text_content(Some(words));
                part.text.clone_from(words);
            }
        }
        for (at, offset) in &pose.dashes {
            if let Some(part) = self.parts.get_mut(at).filter(|part| part.dash != *offset) {
                dom::set(&part.element, "stroke-dashoffset", &filled("#", &[*offset]));
                part.dash = *offset;
            }
        }
        for (at, paint) in &pose.fills {
            if let Some(part) = self.parts.get_mut(at).filter(|part| part.fill != Some(*paint)) {
                dom::set(&part.element, "fill", &paint_name(*paint, self.alt));
                part.fill = Some(*paint);
            }
        }
    }
}
