//! The drawing in the page: its parts once, then only the attributes that change.

use std::collections::BTreeMap;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, HtmlInputElement};

use super::{dom, words};
use crate::text::number::filled;
use crate::view::svg::{page, paint_name, transform};
use crate::view::{Paint, Pose, Scene, SceneGroup};

/// The scene as SVG. Words in it are escaped.
pub(super) fn svg(scene: &Scene) -> String {
    page(scene, words::t(scene.alt))
}

/// The parts of the page that move with the head.
pub(super) struct Stage {
    groups: Vec<Group>,
    parts: BTreeMap<u16, Part>,
    picture: Option<HtmlElement>,
    view: [f64; 4],
    unit: f64,
    /// Start of the names of the scene's own gradients.
    alt: &'static str,
    clock: Option<HtmlElement>,
    slider: Option<HtmlInputElement>,
    clock_text: String,
    slider_at: (u32, u32),
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

impl Stage {
    /// Finds the parts of a drawing that stands in `host`, and the clock and slider of the page.
    pub(super) fn new(host: &Element, scene: &Scene) -> Stage {
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
        let stage = Stage {
            groups,
            parts,
            picture: dom::all(host, ".scene").into_iter().next().map(JsCast::unchecked_into),
            view: scene.view,
            unit: scene.unit,
            alt: scene.alt,
            clock: dom::by_id("clock"),
            slider: dom::by_id("head").and_then(|e| e.dyn_into().ok()),
            clock_text: String::new(),
            slider_at: (0, 0),
        };
        stage.fit();
        stage
    }

    /// Keeps labels at their size in pixels, as far as they have room: `--u` is the number of drawing units per pixel.
    pub(super) fn fit(&self) {
        let Some(picture) = &self.picture else { return };
        let (room, [_, _, width, height]) = (picture.get_bounding_client_rect(), self.view);
        if room.width() > 0.0 && room.height() > 0.0 {
            let unit = (width / room.width()).max(height / room.height());
            let unit = if self.unit > 0.0 { unit.min(self.unit) } else { unit };
            let _ = picture.style().set_property("--u", &format!("{unit:.4}"));
        }
    }

    /// Moves the parts; what stands where it stood is not touched.
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

    /// Shows the time of the head on clock and slider.
    pub(super) fn time(&mut self, head: f64, planned: f64) {
        let text = words::clock(head);
        if text != self.clock_text {
            if let Some(clock) = &self.clock {
                clock.set_text_content(Some(&text));
            }
            self.clock_text = text;
        }
        let at = ((head * 1000.0) as u32, (planned * 1000.0) as u32);
        if at != self.slider_at
            && let Some(slider) = &self.slider
        {
            if at.1 != self.slider_at.1 {
                slider.set_max(&at.1.to_string());
            }
            slider.set_value(&at.0.to_string());
            dom::set(slider, "aria-valuetext", &self.clock_text);
            let part = if planned > 0.0 { head / planned * 100.0 } else { 0.0 };
            let _ = slider.style().set_property("--part", &filled("#%", &[part]));
            self.slider_at = at;
        }
    }
}
