//! The drawing in the page: its parts once, then only the attributes that change.

use std::collections::BTreeMap;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement};

use super::labels::untangle;
use crate::text::columns;
use crate::text::number::filled;
use crate::ui::dom;
use crate::view::svg::{paint_name, transform};
use crate::view::{Paint, Pose, Scene, SceneGroup};

/// The parts of a drawing that move with the play head.
pub(in crate::ui::machine) struct Drawn {
    groups: Vec<Group>,
    parts: BTreeMap<u16, Part>,
    picture: Option<HtmlElement>,
    view: [f64; 4],
    unit: f64,
    /// Whether the drawing may be wider than its container; it then has places to go to.
    pans: bool,
    /// Start of the names of the scene's own gradients.
    alt: &'static str,
}

/// Ratio of the drawing's units per pixel to those its labels are laid out for, above which the drawing becomes wider than its room:
/// the same as in `ui/boot.js`, which shows the still before this code is loaded (held by a test).
const CROWDED: f64 = 1.35;
/// Height in pixels of the strip over such a drawing: the same as in `ui/boot.js` and in `style/app.css`, `.stage.pans` (held by a test).
const STRIP: f64 = 40.0;

struct Group {
    parts: Vec<Element>,
    rest: SceneGroup,
    /// Transform at present; none where a change of the drawing has put only some of its parts at rest.
    transform: Option<String>,
    /// Opacity at present, once it is known.
    opacity: Option<f64>,
}

/// A part that poses change by its number.
struct Part {
    element: Element,
    /// Path or text at present, once it is known.
    text: Option<String>,
    /// Letters of the longest text so far.
    longest: usize,
    dash: f64,
    fill: Option<Paint>,
}

impl Drawn {
    /// Finds the parts of a drawing in `host`.
    pub(in crate::ui::machine) fn new(host: &Element, scene: &Scene) -> Drawn {
        let group = |rest: &SceneGroup| Group { parts: Vec::new(), rest: rest.clone(), transform: None, opacity: None };
        let mut groups: Vec<Group> = scene.groups.iter().map(group).collect();
        for part in dom::all(host, "[data-g]") {
            let number = part.get_attribute("data-g").and_then(|n| n.parse::<usize>().ok());
            if let Some(group) = number.and_then(|n| groups.get_mut(n)) {
                let transform = part.get_attribute("transform").unwrap_or_default();
                let is_as_others = group.parts.is_empty() || group.transform.as_ref() == Some(&transform);
                group.transform = is_as_others.then_some(transform);
                group.parts.push(part);
            }
        }
        let numbered = |element: Element| {
            let number = element.get_attribute("data-n")?.parse().ok()?;
            Some((number, Part { element, text: None, longest: 0, dash: f64::NAN, fill: None }))
        };
        let parts = dom::all(host, "[data-n]").into_iter().filter_map(numbered).collect();
        Drawn {
            groups,
            parts,
            picture: dom::all(host, ".scene").into_iter().next().map(JsCast::unchecked_into),
            // Rounded as in the SVG, because boot.js lays out the first drawing by that.
            view: scene.view.map(|length| (100.0 * length).round() / 100.0),
            unit: scene.unit,
            pans: scene.unit > 0.0 && !scene.stations.is_empty(),
            alt: scene.alt,
        }
    }

    /// Keeps the labels at their size in pixels and apart, in a room of these pixels; without enough room the drawing becomes wider than
    /// it. Returns whether it did.
    pub(in crate::ui::machine) fn fit(&self, (width, height): (f64, f64)) -> bool {
        let room = self.picture.as_ref().and_then(|picture| Some((picture, picture.parent_element()?)));
        let Some((picture, parent)) = room.filter(|_| width > 0.0 && height > 0.0) else { return false };
        let [_, _, wide, high] = self.view;
        let (across, down) = (wide / width, high / height);
        let strip = if parent.class_list().contains("pans") { 0.0 } else { STRIP };
        // A drawing limited by the height of its room would become narrower than the room.
        let fills = across > high / (height - strip).max(1.0);
        let pans = self.pans && fills && across > CROWDED * self.unit;
        let unit = if pans { down.max(self.unit) } else { across.max(down) };
        let style = picture.style();
        let _ = style.set_property("--u", &format!("{unit:.4}"));
        let _ = if pans {
            style.set_property("width", &format!("{:.0}px", wide / unit))
        } else {
            style.remove_property("width").map(drop)
        };
        untangle(picture, unit);
        pans
    }

    /// Shows a place of a drawing that is wider than its room, given in its units from the left.
    pub(super) fn go_to(&self, x: f64) {
        let Some(picture) = &self.picture else { return };
        let Some(room) = picture.parent_element() else { return };
        let part = (x - self.view[0]) / self.view[2];
        let left = part * picture.get_bounding_client_rect().width() - 0.5 * f64::from(room.client_width());
        room.set_scroll_left(left as i32);
    }

    /// Moves the parts; parts that have not moved are not touched. Returns whether a text has become longer than all earlier ones in its
    /// place, so that the labels have to be fitted again.
    pub(in crate::ui::machine) fn pose(&mut self, pose: &Pose) -> bool {
        let (mut text, mut longer) = (String::new(), false);
        for place in &pose.placements {
            let Some(group) = self.groups.get_mut(place.group as usize) else { continue };
            text.clear();
            transform(&mut text, &group.rest, place);
            if group.transform.as_ref() != Some(&text) {
                group.parts.iter().for_each(|part| dom::set(part, "transform", &text));
                group.transform.get_or_insert_default().clone_from(&text);
            }
            if group.opacity != Some(place.opacity) {
                group.opacity = Some(place.opacity);
                let opacity = filled("#", &[place.opacity]);
                group.parts.iter().for_each(|part| dom::set(part, "opacity", &opacity));
            }
        }
        for (at, d) in &pose.paths {
            if let Some(part) = self.parts.get_mut(at).filter(|part| part.text.as_ref() != Some(d)) {
                dom::set(&part.element, "d", d);
                part.text.get_or_insert_default().clone_from(d);
            }
        }
        for (at, words) in &pose.texts {
            if let Some(part) = self.parts.get_mut(at).filter(|part| part.text.as_ref() != Some(words)) {
                dom::set_text(&part.element, words);
                part.text.get_or_insert_default().clone_from(words);
                let letters = columns(words);
                longer |= letters > part.longest;
                part.longest = part.longest.max(letters);
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
        longer
    }
}
