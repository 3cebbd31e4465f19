//! Builder for drawings of machines: shapes with materials in nested groups, labels with leaders, bodies with depth.

use super::look::{Gradient, Look, Paint};
use super::scene::{Font, LETTER, LINE, Node, Scene, SceneGroup, Shape};
use crate::math::{self, PI};
use crate::text::number::{fill, filled};

/// Collects the nodes of a drawing. A node goes into the group and shows the field that were named last.
#[derive(Debug, Default)]
pub struct Drawing {
    /// Nodes so far, in drawing order.
    pub nodes: Vec<Node>,
    /// Groups so far, by number.
    pub groups: Vec<SceneGroup>,
    /// Gradients so far.
    pub gradients: Vec<Gradient>,
    /// Group of the nodes that follow.
    pub group: u16,
    /// Field of the form that the nodes that follow show.
    pub field: &'static str,
    /// Drawing units per pixel for which labels are laid out.
    pub unit: f64,
}

/// A name with values below it, and a hairline to the part.
#[derive(Debug, Clone, PartialEq)]
pub struct Callout<'a> {
    /// Base line of the name.
    pub at: (f64, f64),
    /// Which end of the lines is at that point.
    pub anchor: &'static str,
    /// The name.
    pub name: &'a str,
    /// Values: number by which poses change it, and its text at rest.
    pub values: &'a [(Option<u16>, &'a str)],
    /// The part; none for a label beside its part.
    pub part: Option<(f64, f64)>,
}

impl Drawing {
    /// A drawing whose labels are laid out for so many drawing units per pixel.
    pub fn new(unit: f64) -> Drawing {
        Drawing { groups: vec![SceneGroup::default()], unit, ..Drawing::default() }
    }

    /// Places a group. Groups without a place are at the origin of the drawing.
    pub fn place(&mut self, group: u16, place: SceneGroup) {
        let at = usize::from(group);
        if self.groups.len() <= at {
            self.groups.resize(at + 1, SceneGroup::default());
        }
        self.groups[at] = place;
    }

    /// Draws in a group, then goes back to the group before.
    pub fn within(&mut self, group: u16, draw: impl FnOnce(&mut Drawing)) {
        let before = core::mem::replace(&mut self.group, group);
        draw(self);
        self.group = before;
    }

    /// Draws parts that show a field of the form, then goes back to the field before.
    pub fn showing(&mut self, field: &'static str, draw: impl FnOnce(&mut Drawing)) {
        let before = core::mem::replace(&mut self.field, field);
        draw(self);
        self.field = before;
    }

    /// Adds a gradient and returns its paint.
    pub fn gradient(&mut self, gradient: Gradient) -> Paint {
        self.gradients.push(gradient);
        Paint::Own((self.gradients.len() - 1) as u8)
    }

    /// Adds a shape.
    pub fn shape(&mut self, shape: Shape, look: Look) -> &mut Node {
        let at = self.nodes.len();
        self.nodes.push(Node { id: None, group: self.group, shape, look, field: self.field });
        &mut self.nodes[at]
    }

    /// A path in SVG syntax.
    pub fn path(&mut self, d: impl Into<String>, look: Look) -> &mut Node {
        self.shape(Shape::Path { d: d.into() }, look)
    }

    /// A circle: centre and radius.
    pub fn circle(&mut self, (x, y, r): (f64, f64, f64), look: Look) -> &mut Node {
        self.shape(Shape::Circle { x, y, r }, look)
    }

    /// An ellipse: centre and half axes.
    pub fn ellipse(&mut self, (x, y): (f64, f64), (rx, ry): (f64, f64), look: Look) -> &mut Node {
        self.shape(Shape::Ellipse { x, y, rx, ry }, look)
    }

    /// A rectangle: left, top, width, height, radius of its corners.
    pub fn rect(&mut self, [x, y, w, h, r]: [f64; 5], look: Look) -> &mut Node {
        self.shape(Shape::Rect { x, y, w, h, r }, look)
    }

    /// A line of text.
    pub fn text(&mut self, at: (f64, f64), anchor: &'static str, text: &str, font: Font, paint: Paint) -> &mut Node {
        self.line_of_text(at, anchor, text, font, paint, 0)
    }

    fn line_of_text(
        &mut self,
        (x, y): (f64, f64),
        anchor: &'static str,
        text: &str,
        font: Font,
        paint: Paint,
        line: usize,
    ) -> &mut Node {
        let shape = Shape::Text { x, y, anchor, text: text.to_owned(), line: line as f64, font };
        self.shape(shape, Look::fill(paint))
    }

    /// A name with its values and a leader to its part.
    pub fn callout(&mut self, callout: &Callout) {
        let Callout { at, anchor, name, values, part } = *callout;
        let letter = LETTER * self.unit;
        if let Some((x, y)) = part {
            // From the edge of the text that is nearest to the part.
            let below = if y > at.1 { values.len() as f64 * LINE + 0.5 } else { -1.1 };
            let longest = values.iter().map(|(_, text)| text.chars().count()).chain([name.chars().count()]).max();
            let wide = 0.45 * letter * longest.unwrap_or(0) as f64;
            let (left, right) = match anchor {
                "end" => (at.0 - wide, at.0 - 0.5 * letter),
                "middle" => (at.0 - 0.5 * wide, at.0 + 0.5 * wide),
                _ => (at.0 + 0.5 * letter, at.0 + wide),
            };
            let from = (math::clamp(x, left, right), at.1 + below * letter);
            self.path(filled("M# #L# #", &[from.0, from.1, x, y]), Look::LEAD);
        }
        self.line_of_text(at, anchor, name, Font::Label, Paint::Dim, 0);
        for (line, (id, text)) in values.iter().enumerate() {
            self.line_of_text(at, anchor, text, Font::Value, Paint::Ink, line + 1).id = *id;
        }
    }

    /// The finished drawing, without an option.
    pub fn scene(self, view: [f64; 4], alt: &'static str) -> Scene {
        let Drawing { nodes, mut groups, gradients, unit, .. } = self;
        let most = nodes.iter().map(|node| usize::from(node.group)).max().unwrap_or(0);
        if groups.len() <= most {
            groups.resize(most + 1, SceneGroup::default());
        }
        Scene { view, unit, nodes, groups, gradients, alt, option: None }
    }
}

/// A path through points, closed; empty without points.
pub fn polygon(points: &[(f64, f64)]) -> String {
    let mut d = polyline(points);
    if !points.is_empty() {
        d.push('Z');
    }
    d
}

/// A path through points, open.
pub fn polyline(points: &[(f64, f64)]) -> String {
    let mut d = String::new();
    for (at, (x, y)) in points.iter().enumerate() {
        fill(&mut d, if at == 0 { "M# #" } else { "L# #" }, &[*x, *y]);
    }
    d
}

/// A whole circle as a path.
pub fn circle(x: f64, y: f64, r: f64) -> String {
    filled("M# #a# # 0 1 0 # 0a# # 0 1 0 # 0Z", &[x - r, y, r, r, 2.0 * r, r, r, -2.0 * r])
}

/// A disc of radius `r` at (x, y) drawn along (dx, dy): the outline of a cylinder that is seen from its face.
pub fn barrel((x, y): (f64, f64), r: f64, (dx, dy): (f64, f64)) -> String {
    let length = math::hypot(dx, dy);
    if length <= 0.0 {
        return circle(x, y, r);
    }
    let (nx, ny) = (-dy / length * r, dx / length * r);
    filled(
        "M# #A# # 0 0 1 # #L# #A# # 0 0 1 # #Z",
        &[x + nx, y + ny, r, r, x - nx, y - ny, x - nx + dx, y - ny + dy, r, r, x + nx + dx, y + ny + dy],
    )
}

/// A line outwards from a centre at an angle (degrees, clockwise from the right), between two radii.
pub fn spoke((x, y): (f64, f64), degrees: f64, from: f64, to: f64) -> String {
    let (s, c) = math::sin_cos(degrees * PI / 180.0);
    filled("M# #L# #", &[x + from * c, y + from * s, x + to * c, y + to * s])
}

/// A point at a distance from a centre, at an angle (degrees, clockwise from the right).
pub fn polar((x, y): (f64, f64), degrees: f64, r: f64) -> (f64, f64) {
    let (s, c) = math::sin_cos(degrees * PI / 180.0);
    (x + r * c, y + r * s)
}
