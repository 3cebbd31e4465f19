//! Builder for drawings of machines: shapes with materials in nested groups, labels with leaders, bodies with depth.

use super::letters::{Anchor, LETTER_BOX};
use super::look::{Gradient, Look, Paint};
use super::scene::{Font, LETTER, LINE, Node, Scene, SceneGroup, Shape};
use crate::math::{self, PI};
use crate::text::columns;
use crate::text::number::{fill, filled};

/// Collects the nodes of a drawing. A node belongs to the present group and shows the present form field.
#[derive(Debug, Default)]
pub struct Drawing {
    /// Nodes so far, in drawing order.
    pub nodes: Vec<Node>,
    /// Groups so far, by number.
    pub groups: Vec<SceneGroup>,
    /// Gradients so far.
    pub gradients: Vec<Gradient>,
    /// Group of the following nodes.
    pub group: u16,
    /// Form field shown by the following nodes.
    pub field: &'static str,
    /// Drawing units per pixel for the layout of labels.
    pub unit: f64,
    /// Named places of the drawing; see [`Scene::stations`].
    pub stations: Vec<(&'static str, f64)>,
    /// Label number of the following nodes.
    label: u16,
    /// Number of labels so far.
    labels: u16,
    leaders: Vec<Leader>,
    /// Number of nodes that leaders are drawn over.
    leaders_over: Option<usize>,
    /// Labels with values of another length than [`VALUE_LETTERS`]: number of the label, most letters.
    value_letters: Vec<(u16, usize)>,
}

/// A hairline from a label to its part.
#[derive(Debug, Clone)]
struct Leader {
    /// Index of its node.
    node: usize,
    /// Lowest and highest start along the edge of the text, and the height of that edge.
    from: (f64, f64, f64),
    /// Start after the end of the name, for use if every start along the edge is covered.
    beside: Option<(f64, f64)>,
    /// The part.
    to: (f64, f64),
}

/// Assumed maximum letters of a value written by poses, for leaders to keep clear.
const VALUE_LETTERS: usize = 16;
/// Number of starts of a leader along its text in the search for a clear one.
const STARTS: u8 = 8;

/// A name with values below it, and a hairline to the part.
#[derive(Debug, Clone, PartialEq)]
pub struct Callout<'a> {
    /// Base line of the name.
    pub at: (f64, f64),
    /// Part of the lines at that point.
    pub anchor: Anchor,
    /// The name.
    pub name: &'a str,
    /// Values: node id for changes by poses, and text at rest.
    pub values: &'a [(Option<u16>, &'a str)],
    /// The part; `None` for a label beside its part.
    pub part: Option<(f64, f64)>,
}

impl Drawing {
    /// A drawing with labels laid out for a number of drawing units per pixel.
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

    /// Draws in a group, then returns to the previous one.
    pub fn within(&mut self, group: u16, draw: impl FnOnce(&mut Drawing)) {
        let before = core::mem::replace(&mut self.group, group);
        draw(self);
        self.group = before;
    }

    /// Draws in a group that is visible only in poses that show it.
    pub fn within_hidden(&mut self, group: u16, draw: impl FnOnce(&mut Drawing)) {
        self.within(group, draw);
        let present = self.groups.get(usize::from(group)).cloned().unwrap_or_default();
        self.place(group, SceneGroup { hidden: true, ..present });
    }

    /// Draws parts that show a form field, then returns to the previous field.
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
        self.nodes.push(Node { id: None, group: self.group, shape, look, field: self.field, label: self.label });
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
    pub fn text(&mut self, at: (f64, f64), anchor: Anchor, text: &str, font: Font, paint: Paint) -> &mut Node {
        let before = self.label;
        if before == 0 && !matches!(font, Font::Engraved(_)) {
            self.labels += 1;
            self.label = self.labels;
        }
        let at = self.line_of_text(at, anchor, text, font, paint, 0);
        self.label = before;
        &mut self.nodes[at]
    }

    /// The rim of a lens (centre and radius) with the figures in it. Together they are a label that never moves and is never covered by
    /// another.
    pub fn lens(&mut self, rim: (f64, f64, f64), figures: impl FnOnce(&mut Drawing)) {
        self.labels += 1;
        self.label = self.labels;
        self.circle(rim, Look::POINTER);
        figures(self);
        self.label = 0;
    }

    fn line_of_text(
        &mut self,
        (x, y): (f64, f64),
        anchor: Anchor,
        text: &str,
        font: Font,
        paint: Paint,
        line: usize,
    ) -> usize {
        let shape = Shape::Text { x, y, anchor, text: text.to_owned(), line: line as f64, font };
        self.shape(shape, Look::fill(paint));
        self.nodes.len() - 1
    }

    /// A callout with values that poses write with at most so many letters: leaders of other labels may pass closer to it.
    pub fn callout_with(&mut self, callout: &Callout, most_letters: usize) {
        self.value_letters.push((self.labels + 1, most_letters));
        self.callout(callout);
    }

    /// A name with its values and a leader to its part.
    pub fn callout(&mut self, callout: &Callout) {
        let Callout { at, anchor, name, values, part } = *callout;
        let letter = LETTER * self.unit;
        self.labels += 1;
        self.label = self.labels;
        if let Some((x, y)) = part {
            // From the edge of the text nearest to the part.
            let below = if y > at.1 { values.len() as f64 * LINE + 0.5 } else { -1.1 };
            let longest = values.iter().map(|(_, text)| columns(text)).chain([columns(name)]).max();
            let wide = 0.45 * letter * longest.unwrap_or(0) as f64;
            let (left, right) = match anchor {
                Anchor::Start => (at.0 + 0.5 * letter, at.0 + wide),
                Anchor::Middle => (at.0 - 0.5 * wide, at.0 + 0.5 * wide),
                Anchor::End => (at.0 - wide, at.0 - 0.5 * letter),
            };
            let from = (math::clamp(x, left, right), at.1 + below * letter);
            let behind = at.0 + (LETTER_BOX.width * columns(name) as f64 + 0.4) * letter;
            let beside = (anchor == Anchor::Start).then_some((behind, at.1 - 0.35 * letter));
            self.leaders.push(Leader { node: self.nodes.len(), from: (left, right, from.1), beside, to: (x, y) });
            self.path(filled("M# #L# #", &[from.0, from.1, x, y]), Look::LEAD);
        }
        self.line_of_text(at, anchor, name, Font::Label, Paint::Dim, 0);
        for (line, (id, text)) in values.iter().enumerate() {
            let value = self.line_of_text(at, anchor, text, Font::Value, Paint::Ink, line + 1);
            self.nodes[value].id = *id;
        }
        self.label = 0;
    }

    /// Draws the leaders of all following labels here, below the parts that come next; without a call each is drawn with its label.
    pub fn draw_leaders_here(&mut self) {
        self.leaders_over = Some(self.nodes.len());
    }

    /// Area of a label's letters: number of the label, left, top, right, bottom. `None` for labels that move.
    fn text_box(&self, node: &Node) -> Option<(u16, [f64; 4])> {
        let Shape::Text { x, y, anchor, text, line, .. } = &node.shape else { return None };
        let letter = LETTER * self.unit;
        let posed = self.value_letters.iter().find(|(label, _)| *label == node.label);
        let posed = posed.map_or(VALUE_LETTERS, |(_, letters)| *letters);
        let count = if node.id.is_some() { columns(text).max(posed) } else { columns(text) };
        let area = LETTER_BOX.area((*x, y + line * LINE * letter), *anchor, letter, count);
        (node.label > 0 && node.group == 0).then_some((node.label, area))
    }

    /// Leads hairlines around the texts of other labels. A hairline without a clear start along its own text or after its name is omitted.
    fn lead_around(&mut self) {
        let boxes: Vec<(u16, [f64; 4])> = self.nodes.iter().filter_map(|node| self.text_box(node)).collect();
        for Leader { node, from: (left, right, y), beside, to } in core::mem::take(&mut self.leaders) {
            let Some(own) = self.nodes.get(node).map(|node| node.label) else { continue };
            let free =
                |from: &(f64, f64)| !boxes.iter().any(|(label, area)| *label != own && crosses(*from, to, *area));
            let best = math::clamp(to.0, left, right);
            let other = |at: u8| left + (right - left) * f64::from(at) / f64::from(STARTS);
            let along = core::iter::once(best).chain((0..=STARTS).map(other)).map(|x| (x, y));
            let start = along.chain(beside).find(free);
            if let Some(Node { shape: Shape::Path { d }, .. }) = self.nodes.get_mut(node) {
                *d = start.map_or(String::new(), |from| filled("M# #L# #", &[from.0, from.1, to.0, to.1]));
            }
        }
    }

    /// Moves the leaders to their place in the drawing order.
    fn lower_leaders(&mut self) {
        let Some(at) = self.leaders_over else { return };
        let is_leader = |node: &Node| node.label > 0 && matches!(node.shape, Shape::Path { .. });
        let (leaders, above): (Vec<Node>, Vec<Node>) =
            self.nodes.split_off(at.min(self.nodes.len())).into_iter().partition(is_leader);
        self.nodes.extend(leaders.into_iter().chain(above));
    }

    /// The finished drawing, without an option.
    pub fn scene(mut self, view: [f64; 4], alt: &'static str) -> Scene {
        self.lead_around();
        self.lower_leaders();
        let Drawing { nodes, mut groups, gradients, unit, stations, .. } = self;
        let most = nodes.iter().map(|node| usize::from(node.group)).max().unwrap_or(0);
        if groups.len() <= most {
            groups.resize(most + 1, SceneGroup::default());
        }
        Scene { view, unit, nodes, groups, gradients, alt, stations, drawing_option: None }
    }
}

/// Whether a line meets a box: left, top, right, bottom.
pub fn crosses(from: (f64, f64), to: (f64, f64), [left, top, right, bottom]: [f64; 4]) -> bool {
    let (mut begin, mut end) = (0.0_f64, 1.0_f64);
    for (at, way, low, high) in [(from.0, to.0 - from.0, left, right), (from.1, to.1 - from.1, top, bottom)] {
        if way == 0.0 {
            if at < low || at > high {
                return false;
            }
            continue;
        }
        let (a, b) = ((low - at) / way, (high - at) / way);
        begin = begin.max(a.min(b));
        end = end.min(a.max(b));
    }
    begin <= end
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

/// A disc of radius `r` at (x, y) extruded along (dx, dy): the outline of a cylinder seen from its face.
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
