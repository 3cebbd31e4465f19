//! A plate of sections in true millimetres, side by side, each with its name.

use super::dimension::{Dimension, DrawnDimension};
use super::shapes::{LineKind, Outline, OutlineShape};

/// Sections side by side; lengths in mm, y upwards, the first one at the origin.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Plate {
    /// Lines in drawing order.
    pub(super) shapes: Vec<(LineKind, OutlineShape)>,
    /// Dimensions.
    pub(super) dimensions: Vec<Dimension>,
    /// Names, each with the middle of its foot.
    pub(super) names: Vec<(String, (f64, f64))>,
    /// Height of letters.
    pub(super) letter: f64,
    /// Left, lowest, right and highest coordinate.
    pub(super) room: [f64; 4],
}

impl Plate {
    /// Places sections from left to right. An empty name is omitted.
    pub fn new(sections: &[(String, Outline)]) -> Plate {
        let letter = sections.iter().map(|(_, outline)| outline.letter()).fold(0.0, f64::max);
        let mut plate = Plate { letter, ..Plate::default() };
        let lowest = sections.iter().map(|(_, outline)| outline.edge(letter).ceil()).fold(0.0, f64::max);
        let mut right = 0.0;
        for (at, (name, outline)) in sections.iter().enumerate() {
            let edge = outline.edge(letter).ceil();
            let centre = if at == 0 { 0.0 } else { right + edge };
            right = centre + edge;
            let moved = |(x, y): (f64, f64)| (x + centre, y);
            plate.shapes.extend(outline.shapes.iter().map(|(kind, shape)| (*kind, shape.moved((centre, 0.0)))));
            plate.dimensions.extend(outline.dimensions.iter().map(|dimension| Dimension {
                from: moved(dimension.from),
                to: moved(dimension.to),
                ..dimension.clone()
            }));
            if !name.is_empty() {
                plate.names.push((name.clone(), (centre, -lowest - letter)));
            }
            let below = if name.is_empty() { lowest } else { lowest + (1.6 * letter).ceil() };
            let [left, low, _, high] = plate.room;
            plate.room = [if at == 0 { -edge } else { left }, low.min(-below), right, high.max(edge)];
        }
        plate
    }

    /// The dimensions as lines.
    pub(super) fn drawn(&self) -> impl Iterator<Item = (&Dimension, DrawnDimension)> {
        self.dimensions.iter().map(|dimension| (dimension, dimension.drawn(self.letter)))
    }
}
