//! Elements of a drawing in true millimetres.

use super::dimension::Dimension;
use crate::math;

/// Meaning of a line; each kind has its own layer in a CAD program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// The finished part.
    Part,
    /// The stock.
    Stock,
    /// The nominal part.
    Ideal,
    /// Centre lines.
    Centre,
}

/// A corner of a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Place in mm, y upwards.
    pub at: (f64, f64),
    /// Bulge of the arc to the next corner, as in CAD: tangent of a quarter of its angle, counter-clockwise positive; 0 is straight.
    pub bulge: f64,
}

/// A line of the drawing; lengths in mm, y upwards.
#[derive(Debug, Clone, PartialEq)]
pub enum OutlineShape {
    /// A closed line of straight and round pieces.
    Contour(Vec<Vertex>),
    /// A circle by its centre and radius.
    Circle((f64, f64), f64),
    /// A straight line.
    Line((f64, f64), (f64, f64)),
}

/// A section around the origin.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outline {
    /// Lines in drawing order.
    pub shapes: Vec<(LineKind, OutlineShape)>,
    /// Dimensions.
    pub dimensions: Vec<Dimension>,
}

impl LineKind {
    /// All kinds, in the order of a legend.
    pub const ALL: [LineKind; 4] = [LineKind::Part, LineKind::Stock, LineKind::Ideal, LineKind::Centre];

    /// Name of its layer.
    pub fn layer(self) -> &'static str {
        match self {
            LineKind::Part => "PART",
            LineKind::Stock => "STOCK",
            LineKind::Ideal => "IDEAL",
            LineKind::Centre => "CENTRE",
        }
    }
}

impl OutlineShape {
    /// A closed line through spans of first, middle and last point: an arc through the three points, and a straight line to the next span
    /// if there is a gap.
    pub fn through(spans: &[[(f64, f64); 3]]) -> OutlineShape {
        let mut corners = Vec::with_capacity(spans.len());
        for (span, next) in spans.iter().zip(spans.iter().cycle().skip(1)) {
            let [first, middle, last] = *span;
            corners.push(Vertex { at: first, bulge: bulge(first, middle, last) });
            if math::hypot(next[0].0 - last.0, next[0].1 - last.1) > SAME_POINT {
                corners.push(Vertex { at: last, bulge: 0.0 });
            }
        }
        OutlineShape::Contour(corners)
    }

    /// A closed line of straight pieces.
    pub fn polygon(corners: &[(f64, f64)]) -> OutlineShape {
        OutlineShape::Contour(corners.iter().map(|at| Vertex { at: *at, bulge: 0.0 }).collect())
    }

    /// The shape, shifted.
    pub(super) fn moved(&self, (dx, dy): (f64, f64)) -> OutlineShape {
        let moved = |(x, y): (f64, f64)| (x + dx, y + dy);
        match self {
            OutlineShape::Contour(corners) => {
                OutlineShape::Contour(corners.iter().map(|corner| Vertex { at: moved(corner.at), ..*corner }).collect())
            }
            OutlineShape::Circle(centre, radius) => OutlineShape::Circle(moved(*centre), *radius),
            OutlineShape::Line(from, to) => OutlineShape::Line(moved(*from), moved(*to)),
        }
    }

    /// Largest distance from the origin in mm.
    fn reach(&self) -> f64 {
        let far = |at: &(f64, f64)| math::hypot(at.0, at.1);
        match self {
            OutlineShape::Contour(corners) => corners.iter().map(|corner| far(&corner.at)).fold(0.0, f64::max),
            OutlineShape::Circle(centre, radius) => far(centre) + radius,
            OutlineShape::Line(from, to) => far(from).max(far(to)),
        }
    }
}

impl Outline {
    /// Largest distance of a line from the origin in mm.
    pub fn reach(&self) -> f64 {
        self.shapes.iter().map(|(_, shape)| shape.reach()).fold(0.0, f64::max)
    }

    /// Height of letters in mm, in proportion to the drawing.
    pub(super) fn letter(&self) -> f64 {
        math::clamp(0.1 * self.reach(), 0.5, 7.0)
    }

    /// Distance in mm from the outermost line to a dimension line.
    pub fn beside(&self) -> f64 {
        self.reach() + 2.5 * self.letter()
    }

    /// Extent of the section on each side of the origin, mm, with letters of a height in mm.
    pub(super) fn edge(&self, letter: f64) -> f64 {
        if self.dimensions.is_empty() { self.reach() + letter } else { self.beside() + 1.6 * letter }
    }
}

/// Points nearer to each other (mm) are equal.
const SAME_POINT: f64 = 1e-6;

/// Bulge of the arc through three points: the inscribed angle over the chord is half a turn minus half the angle of the arc.
fn bulge(first: (f64, f64), middle: (f64, f64), last: (f64, f64)) -> f64 {
    let (ax, ay) = (middle.0 - first.0, middle.1 - first.1);
    let (bx, by) = (last.0 - middle.0, last.1 - middle.1);
    math::tan(0.5 * math::atan2(ax * by - ay * bx, ax * bx + ay * by))
}
