//! The unwinder without current, at a fault of its inverter or a power failure: how long it coasts, and the loop that takes up what it lays
//! meanwhile.

use super::derive::Derived;
use super::params::FIELDS;
use super::resolved::RibbonLine;
use crate::drives::inertia::CM2;
use crate::drives::{load, web};
use crate::machines::verdict::{Judgement, fail, ok, up};
use crate::math::RPM;
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Seconds from `rpm` to rest: web, friction and the motor's brake slow down all that turns. Source: sizing facts 2.2.
pub(super) fn seconds(line: &RibbonLine, rpm: f64) -> f64 {
    let unwinding = &line.p.unwinding;
    load::coasting(unwinding.inertia * CM2, rpm * RPM, line.mechanics.unwinder + unwinding.motor_brake)
}

/// Ribbon (mm) that is laid into the loop while X stops over its time constant and the unwinder coasts: as at a hold, with the time of
/// coasting in the place of the ramp. Source: ribbon line facts, 7.
pub(super) fn laid(line: &RibbonLine, d: &Derived) -> f64 {
    if d.actual_speed <= 0.0 {
        return 0.0;
    }
    let speed = d.line_speed / 60.0;
    web::slack_after_stop(speed, seconds(line, d.actual_speed), line.p.time_constant_x / 1000.0, 0.0)
        - speed / line.p.position_gain_x
}

/// Ribbon (mm) that is in the loop at the worst moment, with the knob at its end.
fn laid_before(line: &RibbonLine) -> f64 {
    line.fast.slack_start.abs() + line.fast.slack_run.abs()
}

/// Capacity (mm) that takes up a product which ends without current, with the knob at its end: `C ≥ |start| + |run| + |laid|`.
pub(super) fn loop_needed(line: &RibbonLine) -> f64 {
    laid_before(line) + laid(line, &line.fast).abs()
}

/// What the loop holds against what a product without current lays into it; a brake at the motor or a greater loop mends it.
pub(super) fn holds(line: &RibbonLine) -> Option<Judgement> {
    let (capacity, needed) = (line.p.loop_capacity, loop_needed(line));
    let limit = AtMost(capacity);
    if limit.holds(needed) {
        return ok(limit);
    }
    let time = seconds(line, line.fast.actual_speed);
    let said = msg!("ribbon.coasts-too-long", (time, 2), (needed.ceil(), 0), (capacity, 0));
    let mut advice = Vec::new();
    // The brake that stops the unwinder in the time in which the loop fills up.
    let speed = line.fast.line_speed / 60.0;
    let room = capacity - laid_before(line) + speed / line.p.position_gain_x;
    let left = 2.0 * room / speed + line.p.time_constant_x / 1000.0;
    if room > 0.0 {
        let torque = load::braking(line.p.unwinding.inertia * CM2, line.fast.actual_speed * RPM, left);
        let set = up(FIELDS, "unwinder-motor-brake", torque - line.mechanics.unwinder);
        advice.push(Advice::from(said.clone()).setting(msg!("advice.set-motor-brake", set.1.as_str()), [set]));
    }
    let set = up(FIELDS, "loop-capacity", needed);
    advice.push(Advice::from(said).setting(msg!("advice.set-loop", set.1.as_str()), [set]));
    fail(limit, advice)
}
