//! The form for each polygon of a part: inserts and ratio by its shape, and each further polygon in place of the first one.

use super::further_form::Further;
use super::params::Params;
use super::shape::Shape;

impl Params {
    /// The form with inserts and ratio of the chosen shape.
    pub(super) fn with_shape(mut self) -> Params {
        let shape = match self.shape {
            Shape::Own => None,
            Shape::Knob => Some((2.0, 1.0, 1.0, 2.0)),
            Shape::Triangle => Some((3.0, 2.0, 2.0, 3.0)),
            Shape::Square => Some((4.0, 2.0, 1.0, 2.0)),
            Shape::Hexagon => Some((6.0, 3.0, 1.0, 2.0)),
        };
        if let Some(shape) = shape {
            (self.sides, self.inserts, self.work_ratio, self.tool_ratio) = shape;
        }
        self
    }

    /// The form for each further polygon, with that polygon in place of the first one. The third needs the second.
    pub(super) fn further(&self) -> Vec<Params> {
        let one = |further: &Further| {
            let own = Params {
                shape: further.shape,
                sides: further.sides,
                across_flats: further.across_flats,
                from_face: further.from_face,
                length: further.length,
                orientation: self.orientation + further.angle,
                inserts: further.inserts,
                work_ratio: further.work_ratio,
                tool_ratio: further.tool_ratio,
                work_start: further.work_start,
                tool_start: further.tool_start,
                tool: further.tool,
                tip_radius: if further.tip_radius > 0.0 { further.tip_radius } else { self.tip_radius },
                further: Default::default(),
                ..self.clone()
            };
            let mut own = own.with_shape();
            if own.tool != self.tool {
                // The entered errors of the inserts belong to the first polygon's cutter.
                own.radius_errors.clear();
                own.angle_errors.clear();
            }
            own
        };
        self.further.iter().take_while(|further| further.on).map(one).collect()
    }
}
