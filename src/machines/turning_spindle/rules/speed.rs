//! The rules of the spindle's speed: the chuck's limit, the diameter at which the limit binds, and the acceleration needed in the cut.

use super::knob_positions::at_knobs;
use super::remedies::{slower_cut, with_feed};
use crate::drives::speed::{surface_rpm, surface_speed};
use crate::machines::form::entry::at_most;
use crate::machines::lathe::knobs;
use crate::machines::turning_spindle::params::{FIELDS, Params};
use crate::machines::turning_spindle::resolved::{CutAtKnobs, TurningSpindle};
use crate::machines::turning_spindle::run_up::programmed_speed_of;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::text::Diagnostic;
use crate::text::catalog::number_text as show;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// The operator's limit against the highest speed of the chuck. The control holds the spindle at that, so a higher limit only misleads.
pub(super) fn top_speed(lathe: &TurningSpindle) -> Option<Judgement> {
    let p = &lathe.params;
    let limit = AtMost(p.chuck_limit);
    if p.upper_limit > p.chuck_limit {
        let set = at_most(FIELDS, "upper-limit", p.chuck_limit);
        let advice =
            Advice::from(msg!("turning.limit-above-chuck", speed = (p.upper_limit, 0), limit = (p.chuck_limit, 0)))
                .setting(msg!("advice.set-speed", speed = set.text.as_str()), [set]);
        return warn(limit, [advice]);
    }
    ok(limit)
}

/// Judges the limit diameter, below which the surface speed falls with the diameter: allowed over half of the diameters
/// of the cut.
pub(super) fn limit_diameter(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { derived: d, .. } = lathe;
    if !lathe.surface() || d.limits.limited_share <= 0.0 {
        return ok(None);
    }
    let advice = msg!(
        "turning.limited",
        diameter = (d.limits.high, 3),
        surface_speed = (d.speeds.surface_smallest, 1),
        percent = (d.limits.limited_share * 100.0, 0),
        speed = (d.speeds.high, 0)
    );
    let middle = 0.5 * (d.cut.smallest + d.cut.largest);
    let judgement = if d.limits.high > middle { warn(AtMost(middle), []) } else { ok(AtMost(middle)) };
    Some(Judgement { advice: vec![advice.into()], ..judgement? })
}

/// Judges the acceleration needed for constant surface speed against the ramp of the spindle.
pub(super) fn acceleration(lathe: &TurningSpindle) -> Option<Judgement> {
    let d = &lathe.derived;
    if d.acceleration.needed > d.acceleration.ramp {
        let advice =
            msg!("turning.spindle-lags", needed = (d.acceleration.needed, 0), acceleration = (d.acceleration.ramp, 0));
        let follows = |slower: &TurningSpindle| slower.derived.acceleration.needed <= slower.derived.acceleration.ramp;
        let everywhere = |slower: &TurningSpindle| {
            follows(slower) && knobs::worst(slower.cuts_at_knobs(), acceleration_demand).is_none()
        };
        let advice = match slower_cut(lathe, &everywhere) {
            Some((button, set)) => Advice::from(advice).setting(button, [set]),
            None => with_feed(lathe, d.acceleration.ramp / d.acceleration.needed, advice),
        };
        return warn(AtMost(d.acceleration.ramp), [advice]);
    }
    if d.acceleration.ramp.is_infinite() {
        return ok(None);
    }
    at_knobs(lathe, d.acceleration.ramp, acceleration_demand, |cut, (needed, ramp)| {
        let (feed, spindle) = ((cut.at.feed, 0), (cut.at.spindle, 0));
        msg!("turning.lags-at-knobs", feed, spindle, needed = (needed, 0), acceleration = (ramp, 0))
    })
}

fn acceleration_demand(cut: &CutAtKnobs) -> (f64, f64) {
    (cut.derived.acceleration.needed, cut.derived.acceleration.ramp)
}

/// The limits of the speed against each other.
pub(super) fn check_speed_limits(lathe: &TurningSpindle, found: &mut Vec<Diagnostic>) {
    let p = &lathe.params;
    found.extend(lifted_speed(lathe));
    let upper = if lathe.surface() { p.upper_limit.min(p.chuck_limit) } else { p.chuck_limit };
    if (lathe.surface() || lathe.rules().low_always) && p.lower_limit > upper {
        let message = msg!("turning.limits-crossed", lower = show(p.lower_limit, 0), upper = show(upper, 0));
        found.push(Diagnostic::warning(message).about("lower-limit"));
    }
}

/// Warning about a lower limit above the speed that the cutting speed needs at the largest diameter, with the resulting
/// cutting speed.
fn lifted_speed(lathe: &TurningSpindle) -> Option<Diagnostic> {
    let TurningSpindle { params: p, derived: d, .. } = lathe;
    let lowest = if lathe.surface() || lathe.rules().low_always { p.lower_limit.min(p.upper_limit) } else { 0.0 };
    let largest = d.cut.largest.min(p.stock_diameter);
    let asked = surface_rpm(p.cutting_speed, largest);
    if lowest <= asked {
        return None;
    }
    let (diameter, surface_speed) = ((largest, 1), (surface_speed(lowest, largest), 0));
    let message = msg!("turning.lower-limit-lifts", limit = (lowest, 0), diameter, surface_speed);
    Some(Diagnostic::warning(message).about("lower-limit").mended_by(asked.floor()))
}

/// Judges the greatest speed over the range of the override knob against the operator's limit; the remedy is a cutting
/// speed that stays below it. The control limits neither a fixed speed nor an override that acts after the limits.
pub(super) fn passes_limit(lathe: &TurningSpindle) -> Option<Judgement> {
    let p = &lathe.params;
    let most = p.chuck_limit.min(p.upper_limit);
    let (limit, (percent, speed)) = (AtMost(most), fastest(lathe));
    if speed <= most * (1.0 + ROUNDING) {
        return ok(limit);
    }
    let (percent_now, turns, held_at) = ((percent, 0), (speed, 0), (most, 0));
    let (message, diameter) = if lathe.surface() {
        let message = msg!("turning.override-after-limits", percent = percent_now, speed = turns, limit = held_at);
        (message, lathe.derived.cut.smallest)
    } else {
        let message = msg!("turning.override-passes-limit", percent = percent_now, speed = turns, limit = held_at);
        (message, p.stock_diameter)
    };
    let slower = surface_speed(most * 100.0 / percent, diameter).floor();
    let holds = |slower: f64| {
        let form = Params { cutting_speed: slower, ..lathe.form.clone() };
        fastest(&lathe.with(form)).1 <= most * (1.0 + ROUNDING)
    };
    let advice = Advice::from(message);
    let advice = if slower >= 1.0 && holds(slower) {
        let set = at_most(FIELDS, "cutting-speed", slower);
        let button = msg!("advice.set-cutting-speed", speed = set.text.as_str());
        advice.setting(button, [set])
    } else {
        advice
    };
    fail(limit, [advice])
}

/// Relative amount by which rounding may raise a speed.
const ROUNDING: f64 = 1e-9;

/// The position (%) of the override knob where the speed of the program is greatest, and that speed.
fn fastest(lathe: &TurningSpindle) -> (f64, f64) {
    let present = (lathe.params.override_percent, programmed_speed_of(&lathe.derived));
    lathe
        .at_highest_knob()
        .map(|(percent, d)| (percent, programmed_speed_of(d)))
        .filter(|fast| fast.1 > present.1)
        .unwrap_or(present)
}
