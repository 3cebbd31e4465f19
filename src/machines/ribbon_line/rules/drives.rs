//! The rules of the ribbon line's drives: torque of the motors, inertia, the grip of the nip.
//!
//! Judged with the knob at its highest position: acceleration grows with the speed, because a ramp lasts its time constant at every speed.

use super::slack;
use crate::drives::cage_motor::RATED_FREQUENCY;
use crate::drives::servo::DYNAMIC_BRAKE_RATIO;
use crate::machines::driven::devices::forced_cooling_advice;
use crate::machines::form::entry::{NumberEntry, at_least, at_most, field_max, nearest};
use crate::machines::ribbon_line::axes::{LineAxis, PerAxis};
use crate::machines::ribbon_line::mechanics::{GRIP, ServoAxis};
use crate::machines::ribbon_line::params::{AXIS_FIELDS, FIELDS};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::unwinder_motor::SHORT_TIME;
use crate::machines::verdict::{Judgement, Rule, fail, ok, warn};
use crate::msg;
use crate::text::{Citation, Grade};
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// All rules about the drives.
pub(in crate::machines::ribbon_line) const RULES: &[Rule<RibbonLine>] = &[
    Rule::new("x-peak-torque", pull_peak, Citation::new("sizing facts 2.3", Grade::Inferred)),
    Rule::new("y-peak-torque", |line| peak(line, LineAxis::Print), Citation::new("sizing facts 2.3", Grade::Inferred)),
    Rule::new("x-rapid-torque", |line| rapid(line, LineAxis::Pull), Citation::new("sizing facts 2.3", Grade::Inferred)),
    Rule::new(
        "y-rapid-torque",
        |line| rapid(line, LineAxis::Print),
        Citation::new("sizing facts 2.3", Grade::Inferred),
    ),
    Rule::new(
        "x-effective-torque",
        |line| effective(line, LineAxis::Pull),
        Citation::new("sizing facts 2.3", Grade::Inferred),
    ),
    Rule::new(
        "y-effective-torque",
        |line| effective(line, LineAxis::Print),
        Citation::new("sizing facts 2.3", Grade::Inferred),
    ),
    Rule::new(
        "x-inertia-ratio",
        |line| inertia(line, LineAxis::Pull),
        Citation::new("sizing facts 2.3", Grade::Inferred),
    ),
    Rule::new(
        "y-inertia-ratio",
        |line| inertia(line, LineAxis::Print),
        Citation::new("sizing facts 2.3", Grade::Inferred),
    ),
    Rule::new("nip-use", grip, Citation::new("sizing facts 2.2, from memory", Grade::Open)),
    Rule::new("unwinder-torque", unwinder, Citation::new("data sheet of the motor", Grade::Inferred)),
    Rule::new("unwinder-ramp-torque", unwinder_ramp, Citation::new("FR-E800: 150 % for 60 s", Grade::Inferred)),
    Rule::new("unwinder-torque", unwinder_load, Citation::new("sizing facts D1", Grade::Inferred)),
    Rule::new("unwinder-braking-torque", unwinder_braking, Citation::new("turning spindle facts, 5", Grade::Open)),
];

/// Difference (% of the rated torque) between the load of the form and that of brake and friction from which it is reported: a twentieth of
/// the slip. Engineering choice.
const LOAD: f64 = 5.0;

/// Limit with the knob at its highest position, scaled to its present position by the results there (`fast`) and here (`now`).
pub(in crate::machines::ribbon_line) fn here(limit: f64, now: f64, fast: f64) -> f64 {
    if fast > 0.0 { limit * now / fast } else { limit }
}

/// A servo axis with the knob as it is, and at its highest position.
fn servo(line: &RibbonLine, axis: LineAxis) -> (&ServoAxis, &ServoAxis) {
    (&line.mechanics.axes[axis], &line.fast_mechanics.axes[axis])
}

fn peak(line: &RibbonLine, axis: LineAxis) -> Option<Judgement> {
    let (now, fast) = servo(line, axis);
    let most = fast.fitted.short_time_limit(fast.demand.speed);
    let limit = AtMost(here(most, now.demand.peak, fast.demand.peak));
    if limit.holds(now.demand.peak) {
        return ok(limit);
    }
    let ramp = fast.shortest_ramp() * 1e3;
    if ramp > field_max(FIELDS, AXIS_FIELDS.pull.time_constant) {
        return fail(
            limit,
            [Advice::from(msg!("ribbon.peak-torque-motor", torque = (fast.demand.peak / fast.fitted.limits.peak, 2)))],
        );
    }
    // Both axes must have the same ramp, otherwise their ratio is wrong on every ramp.
    let set = at_least(FIELDS, AXIS_FIELDS.pull.time_constant, ramp);
    let milliseconds = set.value;
    let both = [set.clone(), NumberEntry { field: AXIS_FIELDS.print.time_constant, ..set }];
    let sentence =
        msg!("ribbon.peak-torque", torque = (fast.demand.peak, 2), limit = (most, 2), time = (milliseconds, 1));
    fail(limit, [Advice::from(sentence).setting(msg!("advice.set-time-constants", time = (milliseconds, 1)), both)])
}

/// Judges the peak torque of the pull roller, which a taut ribbon loads too.
fn pull_peak(line: &RibbonLine) -> Option<Judgement> {
    let (now, fast) = servo(line, LineAxis::Pull);
    let most = fast.fitted.short_time_limit(fast.demand.speed);
    if fast.taut.abs() <= most {
        return peak(line, LineAxis::Pull);
    }
    // No ramp takes the tension from a taut ribbon.
    let tension = (line.mechanics.tautest, 0);
    let message = msg!("ribbon.taut-torque", tension, torque = (fast.taut.abs(), 2), limit = (most, 2));
    fail(AtMost(here(most, now.demand.peak, fast.demand.peak)), [slack::advice_against_taut(line, message)])
}

/// Torque (Nm) of the ramp to rapid traverse, of the motors of X and of the print roller.
pub(in crate::machines::ribbon_line) fn rapid_torques(line: &RibbonLine) -> PerAxis<f64> {
    let (axes, speeds) = (&line.mechanics.axes, line.rapid_speeds());
    PerAxis { pull: axes.pull.ramp_torque(speeds.pull), print: axes.print.ramp_torque(speeds.print) }
}

/// Judges the ramp to rapid traverse, which lasts as long as that to a feed: the print roller turns to its next head at rapid traverse, both
/// rollers turn by hand. A steady torque that is too great by itself is left to the rule of the peak torque.
fn rapid(line: &RibbonLine, axis: LineAxis) -> Option<Judgement> {
    let (servo, speed) = (&line.mechanics.axes[axis], line.rapid_speeds()[axis]);
    let (torque, most) = (servo.ramp_torque(speed), servo.fitted.short_time_limit(speed));
    let (limit, share) = (AtMost(most), servo.allowed_share(speed));
    if limit.holds(torque) {
        return ok(limit);
    }
    if share <= 0.0 {
        return None;
    }
    let set = at_most(FIELDS, AXIS_FIELDS[axis].rapid, line.params.axes[axis].rapid * share);
    let advice = Advice::from(msg!("ribbon.rapid-torque", torque = (torque, 2), limit = (most, 2)));
    fail(limit, [advice.setting(msg!("advice.set-rapid", speed = set.text.as_str()), [set])])
}

fn effective(line: &RibbonLine, axis: LineAxis) -> Option<Judgement> {
    let (now, fast) = servo(line, axis);
    let most = fast.fitted.continuous_limit(fast.mean_speed);
    let limit = AtMost(here(most, now.demand.effective, fast.demand.effective));
    if limit.holds(now.demand.effective) {
        return ok(limit);
    }
    if most < fast.fitted.continuous_limit(0.0) {
        let (torque, speed, limit_there) = ((fast.demand.effective, 2), (fast.mean_speed, 0), (most, 2));
        return fail(limit, [Advice::from(msg!("ribbon.warm-at-speed", torque, speed, limit = limit_there))]);
    }
    let stall = fast.demand.effective / fast.fitted.limits.effective;
    let share = (100.0 * fast.fitted.limits.effective, 1);
    fail(
        limit,
        [Advice::from(msg!(
            "ribbon.effective-torque",
            torque = (fast.demand.effective, 2),
            limit = (most, 2),
            stall_torque = (stall, 2),
            percent = share
        ))],
    )
}

fn inertia(line: &RibbonLine, axis: LineAxis) -> Option<Judgement> {
    // More stops per minute at the highest position of the knob leave less.
    let (now, fast) = servo(line, axis);
    let most = fast.fitted.limits.inertia_ratio.min(DYNAMIC_BRAKE_RATIO);
    let ratio = now.shares().inertia_ratio;
    let limit = AtMost(most);
    if limit.holds(ratio) {
        return ok(limit);
    }
    if ratio > DYNAMIC_BRAKE_RATIO {
        let (brakes, most) = ((DYNAMIC_BRAKE_RATIO, 0), (most, 1));
        return fail(limit, [msg!("slides.inertia-burns-brake", ratio = (ratio, 1), brakes, limit = most).into()]);
    }
    warn(limit, [Advice::from(msg!("ribbon.inertia-ratio", ratio = (ratio, 1), limit = (most, 1)))])
}

fn grip(line: &RibbonLine) -> Option<Judgement> {
    let (now, fast) = (100.0 * line.mechanics.nip_use, 100.0 * line.fast_mechanics.nip_use);
    let limit = AtMost(here(GRIP, now, fast));
    if limit.holds(now) {
        return ok(limit);
    }
    let set = at_least(FIELDS, "pinch-force", line.params.pinch.force * fast / GRIP);
    let force = set.value;
    let tautest = line.mechanics.tautest;
    let is_taut = 100.0 * line.fast_mechanics.taut_nip_use >= fast && tautest > line.params.web.tension_before;
    let message = if is_taut {
        msg!("ribbon.nip-slips-taut", tension = (tautest, 0), percent = (fast, 1), force = (force, 1))
    } else {
        msg!("ribbon.nip-slips", percent = (fast, 1), force = (force, 1))
    };
    let mut advice = vec![Advice::from(message).setting(msg!("advice.set-pinch", force = (force, 1)), [set])];
    // Against ribbon that is missing, ribbon helps: more force would stretch it further.
    if is_taut {
        let tension = (tautest, 0);
        let way = if slack::is_drawn_taut(line) {
            msg!("ribbon.nip-slack-dancer", tension)
        } else {
            msg!("ribbon.nip-slack", tension)
        };
        advice.insert(0, slack::advice_against_taut(line, way));
    }
    if fast > 100.0 { fail(limit, advice) } else { warn(limit, advice) }
}

/// The steady torque is the same at every speed: the fan on the motor's shaft cools least with the knob at its lowest position, and the field
/// is weakest at its highest, with the upward trim of a dancer.
fn unwinder(line: &RibbonLine) -> Option<Judgement> {
    let (torque, p) = (line.mechanics.unwinder, &line.params);
    let (slow, fast) = (line.slow.unwinder.frequency, line.fast.unwinder.frequency * line.trimmed_up());
    let (most, at_fast) = (p.unwinding.continuous(slow), p.unwinding.continuous(fast));
    let limit = AtMost(most.min(at_fast));
    if limit.holds(torque) {
        return ok(limit);
    }
    if at_fast < most {
        let message = msg!("ribbon.field-weakening", frequency = (fast, 1), torque = (torque, 2), limit = (at_fast, 2));
        return fail(limit, [message.into()]);
    }
    let frequency = slow;
    let mut advice = Vec::new();
    if most < p.unwinding.continuous(RATED_FREQUENCY) {
        let message = msg!("ribbon.shaft-fan", frequency = (frequency, 1), torque = (torque, 2), limit = (most, 2));
        advice.push(forced_cooling_advice("unwinder-forced-cooling", message));
    }
    // The greatest brake of the reel: motor torque less gear losses and friction.
    let at_roller = most * p.reduction_ratio * p.unwinding.efficiency / 100.0 - p.unwinding.friction;
    let brake = at_roller / (p.press_roller_diameter / 2e3);
    let weaker = Advice::from(msg!("ribbon.unwinder-torque", torque = (torque, 2), limit = (most, 2)));
    advice.push(if brake > 0.0 {
        let set = at_most(FIELDS, "reel-brake", brake);
        weaker.setting(msg!("advice.set-brake", force = (set.value, 2)), [set])
    } else {
        weaker
    });
    fail(limit, advice)
}

/// Judges the stop over the inverter's ramp: an inverter that can absorb less braking torque trips, and the unwinder
/// coasts into the loop.
fn unwinder_braking(line: &RibbonLine) -> Option<Judgement> {
    let (p, torque, steady) = (&line.params, line.mechanics.unwinder_braking, line.mechanics.unwinder);
    let percent = p.unwinding.motor_braking;
    let most = p.unwinding.short_time(percent / 100.0, line.fast.unwinder.frequency);
    let limit = AtMost(most);
    if limit.holds(torque) {
        return ok(limit);
    }
    let mut advice = Vec::new();
    let message = msg!("ribbon.unwinder-brakes", torque = (torque, 2), limit = (most, 2), percent = (percent, 0));
    let ramp = p.inverter_ramp * (torque + steady) / (most + steady);
    if ramp <= field_max(FIELDS, "inverter-ramp") {
        let set = at_least(FIELDS, "inverter-ramp", ramp);
        advice.push(Advice::from(message.clone()).setting(msg!("advice.set-ramp", time = (set.value, 2)), [set]));
    }
    let asked = 100.0 * torque / p.unwinding.short_time(1.0, line.fast.unwinder.frequency);
    if asked <= 100.0 * SHORT_TIME {
        let set = at_least(FIELDS, "unwinder-motor-braking", asked);
        let button = msg!("advice.set-braking", percent = set.text.as_str());
        advice.push(Advice::from(msg!("ribbon.brake-resistor", percent = (asked, 0))).setting(button, [set]));
    }
    if advice.is_empty() {
        advice.push(message.into());
    }
    fail(limit, advice)
}

/// Judges the inverter's ramp. Its torque is the same at every speed, because the ramp is set for the speed at 10 V; that of the motor is least
/// with the knob at its highest position.
fn unwinder_ramp(line: &RibbonLine) -> Option<Judgement> {
    let (p, torque, steady) = (&line.params, line.mechanics.unwinder_ramp, line.mechanics.unwinder);
    let most = p.unwinding.short_time(SHORT_TIME, line.fast.unwinder.frequency);
    let limit = AtMost(most);
    if limit.holds(torque) {
        return ok(limit);
    }
    let advice = Advice::from(msg!("ribbon.unwinder-ramp-torque", torque = (torque, 2), limit = (most, 2)));
    let ramp = p.inverter_ramp * (torque - steady) / (most - steady);
    let advice = if most > steady && ramp <= field_max(FIELDS, "inverter-ramp") {
        let set = at_least(FIELDS, "inverter-ramp", ramp);
        advice.setting(msg!("advice.set-ramp", time = (set.value, 2)), [set])
    } else {
        advice
    };
    fail(limit, [advice])
}

/// Compares the load of the form, used for the slip, with the torque that follows from brake and friction.
fn unwinder_load(line: &RibbonLine) -> Option<Judgement> {
    let (p, share) = (&line.params, 100.0 * line.mechanics.unwinder / line.params.unwinding.torque);
    if (share - p.unwinder_load).abs() <= LOAD {
        return None;
    }
    let set = nearest(FIELDS, "unwinder-load", share.min(200.0));
    let sentence = msg!("ribbon.unwinder-load-differs", load = (p.unwinder_load, 2), needed = (share, 2));
    warn(None, [Advice::from(sentence).setting(msg!("advice.set-load", load = (set.value, 2)), [set])])
}
