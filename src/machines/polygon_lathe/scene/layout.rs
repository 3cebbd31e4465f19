//! Layout of the parts in the drawing, and its scales.

use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::math;

/// Left, top, width and height of the drawing, and its units per pixel for which the labels are laid out.
pub(super) const VIEW: [f64; 4] = [-14.0, 0.0, 1030.0, 630.0];
pub(super) const UNIT: f64 = 1.3;
/// Height of the axes of work and cutter.
pub(super) const AXIS: f64 = 330.0;
/// Height of the floor.
pub(super) const FLOOR: f64 = 560.0;
/// Right end of the cutter's room.
pub(super) const RIGHT: f64 = 622.0;
/// Left end of the chuck.
const LEFT: f64 = 22.0;
/// Greatest radii of cutter and work, and least and greatest one of the chuck.
const ROOM: (f64, f64) = (172.0, 92.0);
const CHUCK: (f64, f64) = (74.0, 134.0);
/// Least factor by which the drawing is reduced to contain the start point of the slide.
const SMALLER: f64 = 0.6;

/// Radius of the main motor.
pub(super) const MAIN_MOTOR: f64 = 38.0;

/// Centre of the section as the work sees it, radius of the stock in it, and of its glass.
pub(in super::super) const CLOSE: (f64, f64, f64) = (918.0, 118.0, 74.0);
pub(super) const GLASS: f64 = 86.0;

/// From above: face of the chuck's jaws and height of the axis; room for the bar: length and half its width.
pub(super) const SIDE: (f64, f64) = (690.0, 418.0);
const BAR: (f64, f64) = (222.0, 34.0);
/// Least length of the bar from above, in units.
const FREE: f64 = 140.0;
/// Room for the slide towards the operator.
const TOWARDS: f64 = 44.0;

/// Layout of the parts in the drawing.
#[derive(Clone, Copy)]
pub(in super::super) struct Layout {
    /// Units per mm on the machine.
    pub(in super::super) scale: f64,
    /// Centre of the work on the machine.
    pub(in super::super) work: (f64, f64),
    /// Radius of the chuck.
    pub(in super::super) chuck: f64,
    /// Centre of the cutter on the machine at the finished size.
    pub(in super::super) cutter: (f64, f64),
    /// Units per mm in the section.
    pub(in super::super) close: f64,
    /// Units per mm from above.
    pub(in super::super) side: f64,
    /// The face of the bar from above.
    pub(in super::super) face: f64,
}

impl Layout {
    pub(in super::super) fn new(lathe: &PolygonLathe) -> Layout {
        let p = &lathe.params;
        let stock = 0.5 * p.stock_diameter;
        let most = |value: fn(&PolygonLathe) -> f64| lathe.polygons().map(value).fold(0.0, f64::max);
        let r = most(|lathe| lathe.params.tip_radius);
        let across = RIGHT - LEFT - CHUCK.1;
        let clear = (0.5 * p.clear_diameter()).max(most(|lathe| 0.5 * lathe.params.across_flats));
        let part = (ROOM.0 / r).min(ROOM.1 / stock).min(across / (clear + 2.0 * r));
        let whole = across / (clear.max(0.5 * p.start_x) + 2.0 * r);
        let scale = part.min(whole.max(SMALLER * part));
        let chuck = math::clamp(2.7 * stock * scale, CHUCK.0, CHUCK.1);
        let work = (LEFT + chuck, AXIS);
        let free = if p.free_length > 0.0 {
            p.free_length
        } else {
            most(|lathe| lathe.params.far_end()) + 0.3 * p.length + 0.4 * stock
        };
        let bar = (BAR.0 / (free + p.clearance)).min(BAR.1 / stock);
        let start = ((BAR.0 + 46.0) / (free + p.start_z))
            .min((BAR.0 + 46.0 - FREE) / p.start_z)
            .min(2.0 * TOWARDS / (p.start_x - p.across_flats).max(1e-3));
        let side = bar.min(start.max(SMALLER * bar));
        let face = SIDE.0 + (free * side).max(FREE);
        let layout = Layout { scale, work, chuck, cutter: work, close: CLOSE.2 / stock, side, face };
        layout.of(lathe)
    }

    /// The layout with the cutter at the depth of a polygon.
    pub(in super::super) fn of(self, lathe: &PolygonLathe) -> Layout {
        let p = &lathe.params;
        Layout { cutter: (self.work.0 + (0.5 * p.across_flats + p.tip_radius) * self.scale, AXIS), ..self }
    }

    /// Left and right side and top of the headstock.
    pub(super) fn headstock(&self) -> [f64; 3] {
        let ((x, y), chuck) = (self.work, self.chuck);
        [x - chuck - 14.0, x + chuck + 14.0, y - chuck - 16.0]
    }

    /// Centre of the main motor, which the headstock covers in part.
    pub(in super::super) fn main_motor(&self) -> (f64, f64) {
        let [left, _, top] = self.headstock();
        (left + 18.0 + MAIN_MOTOR, top - 0.8 * MAIN_MOTOR)
    }

    /// Where an insert touches the finished side of a polygon: at the level of the axes, towards the cutter.
    pub(in super::super) fn contact(&self, lathe: &PolygonLathe) -> (f64, f64) {
        (self.work.0 + 0.5 * lathe.params.across_flats.min(lathe.params.stock_diameter) * self.scale, AXIS)
    }
}
