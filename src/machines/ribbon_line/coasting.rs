//! The unwinder without current, at a fault of its inverter or a power failure: coasting time, and loop for the ribbon laid meanwhile.

use super::derive::Derived;
use super::mechanics::unwinder_load;
use super::params::{FIELDS, PathMode};
use super::resolved::RibbonLine;
use super::rules::slack;
use crate::drives::holding_brake::{BrakedStop, CLOSING_TIME};
use crate::drives::{load, web};
use crate::machines::form::entry::at_least;
use crate::machines::verdict::{Judgement, fail, ok};
use crate::math::RPM;
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Step (Nm) to which a proposed brake is rounded up. Engineering choice.
const BRAKES: f64 = 0.5;

/// Torque of the strongest brake that an advice offers, over the rated torque of its motor: makers fit brakes of about twice that. Engineering
/// choice.
const STRONGEST: f64 = 2.0;

/// Moment of inertia (kg m²) of all rotating parts at the motor's shaft, with the reel.
fn inertia(line: &RibbonLine) -> f64 {
    unwinder_load(&line.params, 0.0).inertia
}

/// The stop from `rpm` to rest: web and friction slow down all rotating parts, and the motor's brake when it has closed.
fn stop(line: &RibbonLine, rpm: f64) -> BrakedStop {
    BrakedStop::new(inertia(line), rpm * RPM, line.mechanics.unwinder, line.params.unwinding.motor_brake)
}

/// Coasting time (s) from `rpm` to rest. Source: sizing facts 2.2.
pub(super) fn seconds(line: &RibbonLine, rpm: f64) -> f64 {
    stop(line, rpm).seconds
}

/// Time (s) of the linear ramp from the speed at 10 V that lays as much ribbon as the stop. Lower speeds have the same slope.
pub(super) fn ramp(line: &RibbonLine) -> f64 {
    stop(line, line.params.speed_at_10v).ramp
}

/// Ribbon (mm) laid while the unwinder coasts. X begins to stop `delay` s earlier, takes `ramp` s to come to rest, and
/// still travels its `lag` (mm).
fn laid_while_x_stops(line: &RibbonLine, d: &Derived, (delay, ramp): (f64, f64), lag: f64) -> f64 {
    if d.unwinder.actual <= 0.0 {
        return 0.0;
    }
    let coasting = self::ramp(line) * d.unwinder.actual / line.params.speed_at_10v;
    web::slack_after_stop(d.feeds.mm_per_second(), coasting, ramp, delay) - lag
}

/// Ribbon (mm) that is laid into the loop while X stops over its time constant and the unwinder coasts: as at a hold, with the time of
/// coasting in the place of the ramp. Source: ribbon line facts, 7.
pub(super) fn laid_in_move(line: &RibbonLine, d: &Derived) -> f64 {
    laid_while_x_stops(
        line,
        d,
        (0.0, line.params.axes.pull.time_constant / 1000.0),
        d.feeds.mm_per_second() / line.params.axes.pull.position_gain,
    )
}

/// Ribbon (mm) in the loop before the stop at the worst moment, with the knob at its highest position.
fn loop_before_stop(line: &RibbonLine) -> f64 {
    line.fast.slack.laid_before_stop()
}

/// Ribbon (mm) laid at the worst moment, with the knob at its highest position: both axes are at rest after the last move and M5 is not
/// read yet, so that the unwinder coasts from its full speed.
fn laid_after_last_move(line: &RibbonLine) -> f64 {
    let EndOfMove { rest, stop, lag } = EndOfMove::new(line);
    laid_while_x_stops(line, &line.fast, (rest, stop), lag)
}

/// The end of a product with the knob at its highest position. All values are 0 with exact stops, whose block time includes them.
#[derive(Default)]
struct EndOfMove {
    /// Time (s) in which both axes come to rest.
    rest: f64,
    /// Time (s) in which X stops.
    stop: f64,
    /// Lag (mm) of X before the stop.
    lag: f64,
}

impl EndOfMove {
    fn new(line: &RibbonLine) -> EndOfMove {
        let p = &line.params;
        match p.path_mode {
            PathMode::ExactStop => EndOfMove::default(),
            PathMode::Continuous => EndOfMove {
                rest: p.slowest(),
                stop: p.axes.pull.time_constant / 1000.0,
                lag: line.fast.feeds.mm_per_second() / p.axes.pull.position_gain,
            },
        }
    }
}

/// Loop capacity (mm) for a product that ends by a loss of current at any moment, with the knob at its highest
/// position: `C ≥ |start| + |run| + |coasting after the last move|`. With a brake that stops the unwinder sooner than X
/// stops, a loss of current within a move needs more.
pub(super) fn loop_needed(line: &RibbonLine) -> f64 {
    loop_before_stop(line) + laid_after_last_move(line).abs().max(laid_in_move(line, &line.fast).abs())
}

/// Judges the loop's capacity against the ribbon laid when a product ends without current; the remedies are a brake at
/// the motor and a longer loop.
pub(super) fn holds(line: &RibbonLine) -> Option<Judgement> {
    let (capacity, needed) = (line.params.loop_capacity, loop_needed(line));
    let limit = AtMost(capacity);
    if limit.holds(needed) {
        return ok(limit);
    }
    let time = seconds(line, line.fast.unwinder.actual);
    let message =
        msg!("ribbon.coasts-too-long", time = (time, 2), needed = (needed.ceil(), 0), capacity = (capacity, 0));
    let mut advice = Vec::new();
    // The brake that stops the unwinder in the time in which the loop fills up, less the time in which it closes.
    let speed = line.fast.feeds.mm_per_second();
    let EndOfMove { rest, stop, lag } = EndOfMove::new(line);
    let left = 2.0 * (capacity - loop_before_stop(line) + lag) / speed - 2.0 * rest + stop - 2.0 * CLOSING_TIME;
    if left > 0.0 {
        let torque = load::braking(inertia(line), line.fast.unwinder.actual * RPM, left);
        let brake = ((torque - line.mechanics.unwinder) / BRAKES).ceil() * BRAKES;
        if brake <= STRONGEST * line.params.unwinding.torque {
            let set = at_least(FIELDS, "unwinder-motor-brake", brake);
            let button = msg!("advice.set-motor-brake", torque = set.text.as_str());
            advice.push(Advice::from(message.clone()).setting(button, [set]));
        }
    }
    // The first advice says what happens.
    if advice.is_empty() {
        advice.push(slack::with_loop(message.into(), needed, Vec::new()));
    } else if needed <= slack::LONGEST_LOOP {
        let also = msg!("ribbon.coasting-fills", needed = (needed.ceil(), 0));
        advice.push(slack::with_loop(also.into(), needed, Vec::new()));
    }
    fail(limit, advice)
}
