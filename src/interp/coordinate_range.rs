//! Range check of coordinates: an end point beyond the range is an alarm, except for axes whose coordinates roll over.

use super::canon::{AXES, Target};
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::state::RunState;
use crate::controls::Alarm;
use crate::controls::dialect::CoordinateFrame;
use crate::msg;

impl RunState {
    /// Refuses an end point beyond the range of the coordinates. Each word alone may be in range: incremental words add up.
    #[inline]
    pub(super) fn refuse_outside_coordinates(&self, cx: &BlockContext, to: &Target) -> BlockResult<()> {
        let Some(frame) = cx.shared.rules.running.range else { return Ok(()) };
        let reach = cx.shared.units.coordinate_max;
        match (0..AXES).find(|k| self.coordinate(frame, to, *k).unsigned_abs() > reach && self.has_range(cx, to, *k)) {
            Some(axis) => Err(self.beyond_range(cx, to, frame, axis)),
            None => Ok(()),
        }
    }

    fn coordinate(&self, frame: CoordinateFrame, to: &Target, axis: usize) -> i64 {
        match frame {
            CoordinateFrame::Program => to.position[axis].saturating_sub(self.modal.zero[axis]),
            CoordinateFrame::Machine => to.position[axis],
        }
    }

    /// Whether an axis moves to the end point and has a range.
    #[cold]
    fn has_range(&self, cx: &BlockContext, to: &Target, axis: usize) -> bool {
        to.mask & 1 << axis != 0 && !cx.shared.rules.modulo[axis] && !cx.world.is_endless(axis)
    }

    #[cold]
    fn beyond_range(&self, cx: &BlockContext, to: &Target, frame: CoordinateFrame, axis: usize) -> Trap {
        let name = cx.control.axes.get(axis).map_or_else(String::new, |axis| axis.letter.to_string());
        let at = self.coordinate(frame, to, axis) as f64 / cx.shared.units.per_unit;
        let max = cx.control.limits.coordinate_max;
        let trap = Trap::alarm(
            Alarm::CoordinateRange,
            msg!("interp.coordinate-range", axis = name, value = (at, 4), limit = max),
        );
        trap.hint(msg!("interp.endless-axis"))
    }
}
