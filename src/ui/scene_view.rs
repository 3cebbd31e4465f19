//! The drawing in the page: its parts once, then only the attributes that change.

use std::fmt::Write;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, HtmlInputElement};

use super::{dom, words};
use crate::text::number::{fill, filled};
use crate::view::svg::escape;
use crate::view::{Node, Pose, Scene, Shape};

/// The scene as SVG. Words in it are escaped.
pub(super) fn svg(scene: &Scene) -> String {
    let mut out = filled("<svg class=\"scene\" viewBox=\"# # # #\" role=\"img\" aria-label=\"", &scene.view);
    escape(&mut out, words::t(scene.alt));
    out.push_str("\">");
    let mut group = None;
    for (at, node) in scene.nodes.iter().enumerate() {
        if group != Some(node.group) {
            if group.is_some() {
                out.push_str("</g>");
            }
            let _ = write!(out, "<g data-g=\"{}\">", node.group);
            group = Some(node.group);
        }
        shape(&mut out, at, node);
    }
    if group.is_some() {
        out.push_str("</g>");
    }
    out.push_str("</svg>");
    out
}

fn shape(out: &mut String, at: usize, node: &Node) {
    match &node.shape {
        Shape::Circle { x, y, r } => fill(out, "<circle cx=\"#\" cy=\"#\" r=\"#\"", &[*x, *y, *r]),
        Shape::Rect { x, y, w, h } => {
            fill(out, "<rect x=\"#\" y=\"#\" width=\"#\" height=\"#\"", &[*x, *y, *w, *h]);
        }
        Shape::Path { d } => {
            out.push_str("<path d=\"");
            escape(out, d);
            out.push('"');
        }
        Shape::Text { x, y, anchor, .. } => {
            fill(out, "<text x=\"#\" y=\"#\"", &[*x, *y]);
            let _ = write!(out, " text-anchor=\"{anchor}\"");
        }
    }
    let _ = write!(out, " data-n=\"{at}\" class=\"{}", node.class);
    // Without a fill a shape is an outline; words are always filled.
    let _ = write!(out, " f-{}", if node.fill.is_empty() { "none" } else { node.fill });
    if !node.stroke.is_empty() {
        let _ = write!(out, " s-{}", node.stroke);
        fill(out, "\" stroke-width=\"#", &[node.width]);
    }
    out.push_str("\">");
    if let Shape::Text { text, .. } = &node.shape {
        escape(out, text);
    }
    out.push_str(match node.shape {
        Shape::Circle { .. } => "</circle>",
        Shape::Rect { .. } => "</rect>",
        Shape::Path { .. } => "</path>",
        Shape::Text { .. } => "</text>",
    });
}

/// The parts of the page that move with the head.
pub(super) struct Stage {
    groups: Vec<Group>,
    nodes: Vec<Option<(Element, String)>>,
    clock: Option<HtmlElement>,
    slider: Option<HtmlInputElement>,
    clock_text: String,
    slider_at: (u32, u32),
}

struct Group {
    parts: Vec<Element>,
    transform: String,
    opacity: f64,
}

impl Stage {
    /// Finds the parts of a drawing that stands in `host`, and the clock and slider of the page.
    pub(super) fn new(host: &Element, scene: &Scene) -> Stage {
        let mut groups: Vec<Group> =
            (0..=scene.groups).map(|_| Group { parts: Vec::new(), transform: String::new(), opacity: 1.0 }).collect();
        for part in dom::all(host, "[data-g]") {
            let number = part.get_attribute("data-g").and_then(|n| n.parse::<usize>().ok());
            if let Some(group) = number.and_then(|n| groups.get_mut(n)) {
                group.parts.push(part);
            }
        }
        let nodes = dom::all(host, "[data-n]").into_iter().map(|node| Some((node, String::new()))).collect();
        Stage {
            groups,
            nodes,
            clock: dom::by_id("clock"),
            slider: dom::by_id("head").and_then(|e| e.dyn_into().ok()),
            clock_text: String::new(),
            slider_at: (0, 0),
        }
    }

    /// Moves the parts; what stands where it stood is not touched.
    pub(super) fn pose(&mut self, pose: &Pose) {
        let mut text = String::new();
        for place in &pose.placements {
            let Some(group) = self.groups.get_mut(place.group as usize) else { continue };
            text.clear();
            if place.dx != 0.0 || place.dy != 0.0 {
                fill(&mut text, "translate(# #)", &[place.dx, place.dy]);
            }
            if place.turn != 0.0 {
                fill(&mut text, "rotate(# # #)", &[place.turn, place.cx, place.cy]);
            }
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
            if let Some(Some((node, last))) = self.nodes.get_mut(*at)
                && last != d
            {
                dom::set(node, "d", d);
                last.clone_from(d);
            }
        }
        for (at, words) in &pose.texts {
            if let Some(Some((node, last))) = self.nodes.get_mut(*at)
                && last != words
            {
                node.set_text_content(Some(words));
                last.clone_from(words);
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
