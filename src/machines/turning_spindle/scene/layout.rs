//! Layout of the parts in the drawing, and its scale.

use super::chuck::Chuck;
use super::solid::AXIS;
use crate::machines::turning_spindle::params::{Params, Path};

/// Left, top, width and height of the drawing, and its units per pixel for which the labels are laid out.
pub(super) const VIEW: [f64; 4] = [-14.0, 0.0, 1058.0, 630.0];
pub(super) const UNIT: f64 = 1.3;
/// Height of the ways of the bed.
pub(super) const BED: f64 = 500.0;
/// Greatest half height and length of the part, in units of the drawing.
pub(super) const ROOM: (f64, f64) = (98.0, 330.0);
/// Least factor by which the drawing is reduced to contain the start point of the tool.
pub(super) const SMALLER: f64 = 0.6;
/// How far the turret reaches above the tip of the tool, and the farthest place of the tip to the right.
const REACH: f64 = 160.0;
const FARTHEST: f64 = 826.0;
/// Greatest length of the work behind its cut, in its radii: a slenderer one would be a thread in the drawing.
const SLENDER: f64 = 12.0;
/// Left end of the tailstock's body.
pub(super) const TAIL: f64 = 944.0;
/// Centre and radius of the lens, and of one above the tailstock.
const LENS: (f64, f64, f64) = (956.0, 388.0, 78.0);
const HIGH_LENS: (f64, f64, f64) = (962.0, 286.0, 66.0);

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
    /// The tailstock holds the work.
    pub(in super::super) holds_work: bool,
    /// Centre and radius of the lens.
    pub(super) lens: (f64, f64, f64),
}

impl Layout {
    pub(in super::super) fn new(p: &Params) -> Layout {
        let stock = 0.5 * p.stock_diameter;
        // Length of the work in front of the jaws, with room for what is cut of it, and stock before the finished face.
        let (least, before) = match p.path {
            Path::Facing => (0.2 * stock, p.allowance),
            _ => (p.length, 0.0),
        };
        let free = (p.work_length - p.grip).max(least).min(least + SLENDER * stock);
        let part = (ROOM.0 / stock).min(ROOM.1 / (free + before));
        let front = Chuck::of(ROOM.0).front();
        let whole = ((AXIS - REACH - 6.0) / (0.5 * p.start_x)).min((FARTHEST - front) / (free + p.start_z));
        let scale = part.min(whole.max(SMALLER * part));
        let chuck = Chuck::of(stock * scale);
        let face = chuck.front() + free * scale;
        let part_length = (face - chuck.face()) / scale;
        // In the column at the right, which the work never reaches: above the tailstock, if there is one.
        let lens = if p.tailstock { HIGH_LENS } else { LENS };
        Layout { scale, face, part_length, chuck, holds_work: p.tailstock, lens }
    }

    /// Place along the axis and radius in the drawing: mm from the finished face, diameter in mm.
    pub(in super::super) fn side(&self, z: f64, diameter: f64) -> (f64, f64) {
        (self.face + z * self.scale, 0.5 * diameter * self.scale)
    }

    /// Place of the tip of the tool: mm from the axis and from the finished face.
    pub(in super::super) fn tip(&self, radius: f64, z: f64) -> (f64, f64) {
        (self.face + z * self.scale, AXIS - radius * self.scale)
    }
}
