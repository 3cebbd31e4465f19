//! Demands between the continuous and the short-time rating of the spindle's motor.

use crate::machines::form::entry::at_least;
use crate::machines::turning_spindle::params::{FIELDS, Params};
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::machines::verdict::{Judgement, fail, warn};
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Warning that the motor's short-time rating suffices, with its share in percent; then the advice about the positions of the knobs.
pub(super) fn overloaded(lathe: &TurningSpindle, limit: f64, at_knobs: Option<Judgement>) -> Option<Judgement> {
    let overload = Advice::from(msg!("turning.overload", percent = (lathe.params.motor_overload, 0)));
    let at_knobs = at_knobs.map_or_else(Vec::new, |judgement| judgement.advice);
    warn(AtMost(limit), core::iter::once(overload).chain(at_knobs).collect::<Vec<_>>())
}

/// Judges a demand above the continuous rating that the motor's overload would cover with a longer pause to the next
/// part.
pub(super) fn overload_without_pause(lathe: &TurningSpindle, demand: f64, rated: f64) -> Option<Judgement> {
    let TurningSpindle { params: p, derived: d, .. } = lathe;
    let set = at_least(FIELDS, "pause", d.times.pause_for_overload());
    let with_pause = Params { pause: set.value, ..p.clone() };
    if demand <= d.times.for_the_cut(p, rated) || demand > d.times.for_the_cut(&with_pause, rated) {
        return None;
    }
    let (percent, time, pause) = ((p.motor_overload, 0), (d.times.cutting, 1), (set.value, 1));
    let advice = Advice::from(msg!("turning.overload-without-pause", percent, time, pause))
        .setting(msg!("advice.set-pause", time = set.text.as_str()), [set]);
    fail(AtMost(rated), [advice])
}
