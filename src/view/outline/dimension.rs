//! Dimensions: the measured distance, and its lines, arrows and text.

use crate::math::{self, PI};

/// A distance between two points, shown by a line beside them.
#[derive(Debug, Clone, PartialEq)]
pub struct Dimension {
    /// First point in mm.
    pub from: (f64, f64),
    /// Second point.
    pub to: (f64, f64),
    /// Distance of the dimension line from the points in mm, to the left of the direction from the first to the second.
    pub away: f64,
    /// Text at the line, for instance `⌀25`.
    pub text: String,
}

/// The layer of all dimensions.
pub(super) const LAYER: &str = "DIMENSIONS";

/// The lines of a dimension; lengths in mm, y upwards.
pub(super) struct DrawnDimension {
    /// Extension lines, followed by the dimension line.
    pub lines: [[(f64, f64); 2]; 3],
    /// Arrow heads: the tip and both rear corners.
    pub arrows: [[(f64, f64); 3]; 2],
    /// Middle of the foot of the text.
    pub foot: (f64, f64),
    /// Middle of the text.
    pub middle: (f64, f64),
    /// Angle of the text in degrees, counter-clockwise, above -90 to 90: readable from below or from the right.
    pub angle: f64,
}

/// In letter heights: length and half width of an arrow, gap at the work, extension beyond the line, gap below a text (ISO 129-1).
const ARROW: f64 = 1.0;
const HALF_WIDTH: f64 = 0.17;
const GAP: f64 = 0.3;
const BEYOND: f64 = 0.6;
const BELOW: f64 = 0.35;

impl Dimension {
    /// Measured distance in mm.
    pub fn length(&self) -> f64 {
        math::hypot(self.to.0 - self.from.0, self.to.1 - self.from.1)
    }

    /// The dimension as lines, with letters of a height in mm.
    pub(super) fn drawn(&self, letter: f64) -> DrawnDimension {
        let length = self.length().max(f64::MIN_POSITIVE);
        let along = ((self.to.0 - self.from.0) / length, (self.to.1 - self.from.1) / length);
        let left = (-along.1, along.0);
        let sign = self.away.signum();
        let moved = |at: (f64, f64), forward: f64, aside: f64| {
            (at.0 + forward * along.0 + aside * left.0, at.1 + forward * along.1 + aside * left.1)
        };
        let extension = |at| [moved(at, 0.0, sign * GAP * letter), moved(at, 0.0, self.away + sign * BEYOND * letter)];
        let ends = [moved(self.from, 0.0, self.away), moved(self.to, 0.0, self.away)];
        let head = |tip: (f64, f64), way: f64| {
            let corner = |aside: f64| moved(tip, way * ARROW * letter, aside * HALF_WIDTH * letter);
            [tip, corner(1.0), corner(-1.0)]
        };
        let degrees = math::atan2(along.1, along.0) * 180.0 / PI;
        // Upside-down text is turned by half a turn; a rounding error beside straight up does not count.
        let turned = degrees > 90.0 + 1e-9 || degrees <= -90.0 + 1e-9;
        let angle = if turned { degrees - 180.0 * degrees.signum() } else { degrees };
        let up = if turned { -1.0 } else { 1.0 };
        let centre = moved(self.from, 0.5 * length, self.away);
        DrawnDimension {
            lines: [extension(self.from), extension(self.to), ends],
            arrows: [head(ends[0], 1.0), head(ends[1], -1.0)],
            foot: moved(centre, 0.0, up * BELOW * letter),
            middle: moved(centre, 0.0, up * (BELOW + 0.5) * letter),
            angle,
        }
    }
}
