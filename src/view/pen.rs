//! Builder for scenes: one method per shape.

use super::{Node, Shape};
use crate::math::{self, PI};
use crate::text::number::filled;

/// A line from a centre outwards in the direction (c, s), between two radii.
pub fn ray(x: f64, y: f64, (c, s): (f64, f64), from: f64, to: f64) -> String {
    filled("M# #L# #", &[x + from * c, y + from * s, x + to * c, y + to * s])
}

/// Collects the nodes of a drawing. Colours are names of the page's tokens, groups those that poses move (0: none).
#[derive(Debug, Default)]
pub struct Pen {
    /// What is drawn so far, in drawing order.
    pub nodes: Vec<Node>,
}

impl Pen {
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
        self.nodes.push(Node { group, shape, fill, stroke, width, class });
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
        self.node(0, Shape::Rect { x, y, w, h }, fill, "", 0.0, class);
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
        self.node(0, Shape::Text { x, y, anchor, text }, fill, "", 0.0, class);
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
