//! Layout of the parts in the drawing, and its scale.

use super::chuck::Chuck;
use super::solid::AXIS;
use crate::machines::turning_spindle::params::{Params, Path};

/// Left, top, width and height of the drawing, and its units per pixel for which the labels are laid out.
pub(super) const VIEW: [f64; 4] = [-14.0, 0.0, 1030.0, 630.0];
pub(super) const UNIT: f64 = 1.3;
/// Height of the ways of the bed.
pub(super) const BED: f64 = 500.0;
/// Greatest half height and length of the part, in units of the drawing.
pub(super) const ROOM: (f64, f64) = (98.0, 330.0);
/// At most so much smaller for the start of the tool to be in the drawing.
pub(super) const SMALLER: f64 = 0.6;
/// How far the turret reaches above and to the right of the tip of the tool.
const REACH: (f64, f64) = (160.0, 186.0);
/// Left end of the tailstock's centre, and of its body.
pub(super) const TAIL: (f64, f64) = (884.0, 944.0);

/// Layout of the part in the drawing.
pub(in super::super) struct Layout {
    /// Units of the drawing per millimetre.
    pub(in super::super) scale: f64,
    /// Position of the finished face.
    pub(in super::super) face: f64,
    /// Length of the part between the face of the chuck and its finished face, mm.
    pub(in super::super) part_length: f64,
    /// The chuck.
    pub(in super::super) chuck: Chuck,
    /// Right end of the turret where the tool may be as low as the part.
    low_end: f64,
    /// The tailstock holds the work.
    pub(super) holds_work: bool,
}

impl Layout {
    pub(in super::super) fn new(p: &Params) -> Layout {
        let stock = 0.5 * p.stock_diameter;
        // Least length of the part in front of the chuck, and stock before the finished face.
        let (free, before) = match p.path {
            Path::Facing => (1.6 * stock, p.allowance),
            _ => (p.length + 0.3 * stock, 0.0),
        };
        let part = (ROOM.0 / stock).min(ROOM.1 / (free + before));
        let front = Chuck::of(ROOM.0).front();
        let right = VIEW[0] + VIEW[2] - REACH.1 - 4.0;
        let whole = ((AXIS - REACH.0 - 6.0) / (0.5 * p.start_x)).min((right - front) / (free + p.start_z));
        let scale = part.min(whole.max(SMALLER * part));
        let chuck = Chuck::of(stock * scale);
        let face = chuck.front() + free * scale;
        let part_length = (face - chuck.face()) / scale;
        let below = |radius: f64| radius * scale < 90.0;
        let start = if below(0.5 * p.start_x) { p.start_z } else { 0.0 };
        let low_end = face + p.clearance.max(p.allowance).max(start) * scale + REACH.1;
        Layout { scale, face, part_length, chuck, low_end, holds_work: p.tailstock }
    }

    /// Place along the axis and radius in the drawing: mm from the finished face, diameter in mm.
    pub(in super::super) fn side(&self, z: f64, diameter: f64) -> (f64, f64) {
        (self.face + z * self.scale, 0.5 * diameter * self.scale)
    }

    /// Place of the tip of the tool: mm from the axis and from the finished face.
    pub(in super::super) fn tip(&self, radius: f64, z: f64) -> (f64, f64) {
        (self.face + z * self.scale, AXIS - radius * self.scale)
    }

    /// Whether a tailstock is drawn: one that holds the work, else only where the turret never reaches its place.
    pub(in super::super) fn has_tailstock(&self) -> bool {
        self.holds_work || self.low_end < TAIL.0
    }
}
