//! Working area limits (G25, G26): end points and arcs outside are alarms.

use super::arc::passes;
use super::canon::{AXES, Target};
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::state::{ArcGeometry, RunState};
use crate::controls::{Address, Alarm};
use crate::math;
use crate::msg;

/// Linear axes with limits by G25 and G26.
const LINEAR_AXES: [Address; 3] = [Address::X, Address::Y, Address::Z];

impl RunState {
    /// Limits of the working area; `None` if they are off.
    #[inline]
    pub(super) fn area(&self, cx: &BlockContext) -> Option<&[[i64; AXES]; 2]> {
        self.modal.area.limits.as_ref().filter(|_| cx.shared.rules.running.area && !self.modal.area.off)
    }

    /// Refuses an end point outside the working area.
    #[cold]
    pub(super) fn refuse_outside_area(
        &self,
        cx: &BlockContext,
        to: Target,
        [low, high]: &[[i64; AXES]; 2],
    ) -> BlockResult<()> {
        for (k, axis) in cx.control.axes.iter().enumerate().take(AXES).filter(|(k, _)| to.mask & 1 << k != 0) {
            let at = to.position[k];
            if !(low[k]..=high[k]).contains(&at) {
                let limit = if at < low[k] { low[k] } else { high[k] };
                let [at, limit] = [at, limit].map(|place| place as f64 / cx.shared.units.per_unit);
                let letter = axis.letter.to_string();
                let trap = Trap::alarm(
                    Alarm::WorkingArea,
                    msg!("interp.working-area", axis = letter, value = (at, 4), limit = (limit, 4)),
                );
                let own = axis.letter.after(Address::X).and_then(|at| LINEAR_AXES.chunks(1).nth(at));
                return Err(trap.at_word(own.unwrap_or(&LINEAR_AXES)));
            }
        }
        Ok(())
    }

    /// Refuses an arc that leaves the working area between its ends.
    #[cold]
    pub(super) fn arc_within(
        &self,
        cx: &BlockContext,
        to: Target,
        round: ArcGeometry,
        area: &[[i64; AXES]; 2],
    ) -> BlockResult<()> {
        let ArcGeometry { plane: (first, second), center, clockwise } = round;
        let scale = |axis: u8| cx.shared.rules.moved(axis);
        let from_center = |place: &[i64; AXES]| {
            let part = |axis: u8, center: f64| {
                (place.get(usize::from(axis)).map_or(0.0, |at| *at as f64) - center) * scale(axis)
            };
            (part(first, center.0), part(second, center.1))
        };
        let (start, end) = (from_center(&self.position), from_center(&to.position));
        let radius = math::hypot(start.0, start.1);
        let sides = [(first, center.0, (1.0, 0.0)), (second, center.1, (0.0, 1.0))];
        for ((axis, center, (x, y)), sign) in sides.into_iter().flat_map(|side| [(side, 1.0), (side, -1.0)]) {
            let mut far = Target { position: to.position, mask: 1 << axis };
            if let (true, Some(at)) =
                (passes((start, end), clockwise, (sign * x, sign * y)), far.position.get_mut(usize::from(axis)))
            {
                *at = (center + sign * radius / scale(axis)).round() as i64;
                self.refuse_outside_area(cx, far, area)?;
            }
        }
        Ok(())
    }
}
