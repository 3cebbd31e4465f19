//! Times of a gear change, and the delay in which the spindle slows down before it.

use super::resolved::TurningSpindle;
use crate::controls::ParamRole;
use crate::machines::verdict::{Judgement, ok};
use crate::math;
use crate::msg;
use crate::view::Verdict;

/// Gear stage in which the machine begins; the program's stage stays engaged beyond its end.
pub(super) const AT_POWER_ON: u8 = 1;

/// Times (s) of a gear change.
#[derive(Clone, Copy)]
pub(super) struct GearTimes {
    /// Time until the old gear is out.
    pub(super) before: f64,
    /// From then until the new gear is in position.
    pub(super) meshing: f64,
    /// From then until the output has the voltage of the speed.
    pub(super) after: f64,
    /// Time limit for the new gear to be in position, beyond which the PLC raises an alarm; `None` without supervision.
    pub(super) patience: Option<f64>,
}

/// Divides the time of a gear change: an eighth before, half for meshing, the rest after.
pub(super) fn gear_times(lathe: &TurningSpindle) -> GearTimes {
    let p = &lathe.params;
    let patience = (p.gear_patience > 0.0).then_some(p.gear_patience);
    let seconds = p.gear_time;
    GearTimes { before: 0.125 * seconds, meshing: 0.5 * seconds, after: 0.375 * seconds, patience }
}

/// Longest time (s) in which the spindle slows down in the stage that it leaves: `t · n / n10`, t the ramp from 0 to
/// the speed n10 at 10 V, n the highest speed in that stage, at most the chuck's limit; of all stages the longest.
/// Source: turning spindle facts, 2.
pub(super) fn slowing(lathe: &TurningSpindle) -> f64 {
    let p = &lathe.params;
    p.stages().map(|n10| p.spindle.ramp * n10.min(p.chuck_limit) / n10).fold(0.0, f64::max)
}

/// Delay (ms) until the old gear goes out, for a control whose own ladder waits by time alone: at least the time of slowing down.
pub(super) fn delay_before(lathe: &TurningSpindle) -> f64 {
    math::whole_up(1000.0 * slowing(lathe).max(gear_times(lathe).before))
}

/// Compares the time of slowing down with the default delay of such a control's own ladder. Information only: the
/// exported ladder waits for the shift speed and reads no such delay.
pub(super) fn judge_delay(lathe: &TurningSpindle) -> Option<Judgement> {
    let parameter = lathe.control.param(ParamRole::GearShiftBefore)?;
    let (needed, initial) = (slowing(lathe), lathe.control.bench.shift.before);
    if needed <= initial {
        return ok(None);
    }
    let (parameter, least) = (parameter.number, delay_before(lathe));
    let advice = vec![msg!("turning.gear-delay-too-short", needed = (needed, 2), initial, parameter, least).into()];
    Some(Judgement { verdict: Verdict::None, limit: None, advice })
}
