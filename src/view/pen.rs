//! Builder for scenes whose colours are named by words. New drawings are made with `Drawing`.

use super::look::{Look, Paint};
use super::scene::{Font, Node, SceneGroup, Shape};
use crate::math::{self, PI};
use crate::text::number::filled;

/// A line from a centre outwards in the direction (c, s), between two radii.
pub fn ray(x: f64, y: f64, (c, s): (f64, f64), from: f64, to: f64) -> String {
    filled("M# #L# #", &[x + from * c, y + from * s, x + to * c, y + to * s])
}

/// Collects the nodes of a drawing. Colours are words, groups those that poses move (0: none). The number of a node is its index.
#[derive(Debug, Default)]
pub struct Pen {
    /// What is drawn so far, in drawing order.
    pub nodes: Vec<Node>,
}

fn paint(name: &str) -> Paint {
    match name {
        "ink" => Paint::Ink,
        "dim" => Paint::Dim,
        "accent" => Paint::Accent,
        "pane" => Paint::Page,
        "bad" => Paint::Bad,
        "ok" => Paint::Good,
        "steel" => Paint::Steel,
        "line" => Paint::SteelLight,
        "ribbon" => Paint::Ribbon,
        _ => Paint::Clear,
    }
}

impl Pen {
    /// Groups without nesting, 0 to `last`.
    pub fn groups(last: u16) -> Vec<SceneGroup> {
        vec![SceneGroup::default(); usize::from(last) + 1]
    }

    /// A shape with its look.
    pub fn node(
        &mut self,
        group: u16,
        shape: Shape,
        fill: &'static str,
        stroke: &'static str,
        width: f64,
        class: &'static str,
    ) {
        let look = Look::fill(paint(fill)).edge(paint(stroke), width);
        let look = match class {
            "dash" => look.dashed(4.0, 4.0),
            "soft" | "winding" => look.faint(0.5),
            "plate" => look.faint(0.55),
            "wound" => look.faint(0.35),
            _ => look,
        };
        let id = Some(self.nodes.len() as u16);
        self.nodes.push(Node { id, group, shape, look, field: "" });
    }

    /// A path in SVG syntax.
    pub fn path(
        &mut self,
        group: u16,
        d: String,
        fill: &'static str,
        stroke: &'static str,
        width: f64,
        class: &'static str,
    ) {
        self.node(group, Shape::Path { d }, fill, stroke, width, class);
    }

    /// A stroke.
    pub fn line(&mut self, group: u16, d: &str, stroke: &'static str, width: f64) {
        self.path(group, d.to_owned(), "", stroke, width, "");
    }

    /// A filled circle.
    pub fn disc(&mut self, group: u16, x: f64, y: f64, r: f64, fill: &'static str, class: &'static str) {
        self.node(group, Shape::Circle { x, y, r }, fill, "", 0.0, class);
    }

    /// A circle's outline: centre and radius.
    pub fn ring(
        &mut self,
        group: u16,
        (x, y, r): (f64, f64, f64),
        stroke: &'static str,
        width: f64,
        class: &'static str,
    ) {
        self.node(group, Shape::Circle { x, y, r }, "", stroke, width, class);
    }

    /// A filled rectangle that never moves.
    pub fn rect(&mut self, x: f64, y: f64, w: f64, h: f64, fill: &'static str, class: &'static str) {
        self.node(0, Shape::Rect { x, y, w, h, r: 0.0 }, fill, "", 0.0, class);
    }

    /// A line of text that never moves.
    pub fn text(
        &mut self,
        x: f64,
        y: f64,
        anchor: &'static str,
        text: String,
        fill: &'static str,
        class: &'static str,
    ) {
        let font = if class == "value" { Font::Value } else { Font::Label };
        self.node(0, Shape::Text { x, y, anchor, text, line: 0.0, font }, fill, "", 0.0, class);
    }

    /// A smooth roller with hub and `spokes` marks, all of one group; `blur` is the ring shown when it turns too fast to see.
    pub fn roller(&mut self, (x, y, r): (f64, f64, f64), marks: u16, blur: Option<u16>, spokes: u8) {
        self.disc(0, x, y, r, "steel", "roller");
        self.ring(0, (x, y, r - 1.0), "dim", 0.8, "soft");
        for spoke in 0..spokes {
            let (s, c) = math::sin_cos(2.0 * PI * f64::from(spoke) / f64::from(spokes));
            let d = ray(x, y, (c, s), 0.42 * r, 0.86 * r);
            self.path(marks, d, "", "pane", r * 0.11, "mark");
        }
        if let Some(blur) = blur {
            self.ring(blur, (x, y, 0.64 * r), "pane", 0.44 * r, "blur");
        }
        self.disc(0, x, y, 0.24 * r, "pane", "");
        self.ring(0, (x, y, 0.24 * r), "dim", 1.0, "");
    }
}
