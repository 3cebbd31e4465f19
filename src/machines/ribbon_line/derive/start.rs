//! The start of the line: how long X waits for the unwinder, and the ribbon laid meanwhile.

use crate::drives::web;
use crate::machines::ribbon_line::params::{FeedForm, Params, Wait};

/// Time (s) from a strobe to FIN if the PLC need not wait: a few scans of the ladder.
pub(in crate::machines::ribbon_line) const FIN_DELAY: f64 = crate::machines::ladder::plc::ANSWER;

/// Share of the commanded speed from which the PLC reports the spindle at speed.
pub(in crate::machines::ribbon_line) const AT_SPEED: f64 = 0.95;

/// Time from M3 to the first pull, s: the wait, or the time in which the control reads the blocks from M3 to that pull, if that is longer; 0 at
/// standstill.
pub(super) fn first_wait(p: &Params, moves: bool) -> f64 {
    if moves { wait(p, true).max(p.first_reading()) } else { 0.0 }
}

/// Longest dwell (s) that does not delay the first pull, because it ends while the control still reads blocks or waits for the speed.
pub(in crate::machines::ribbon_line) fn least_dwell(p: &Params) -> f64 {
    (p.first_reading().max(speed_wait(p)) - FIN_DELAY).max(0.0)
}

/// Time (s) for which the control itself holds a feed back after a start of the spindle: until the speed is within its tolerance,
/// `(1 - tolerance) · t_ramp`; 0 where it does not wait. Source: ribbon line facts, 7.
pub(super) fn speed_wait(p: &Params) -> f64 {
    p.speed_tolerance.map_or(0.0, |tolerance| (1.0 - tolerance) * ramp(p))
}

/// Time from M3 to the first feed, s: the wait of the program, or that of the control, if that is longer; 0 at standstill.
pub(super) fn wait(p: &Params, moves: bool) -> f64 {
    if moves { program_wait(p, true).max(speed_wait(p)) } else { 0.0 }
}

/// Time from M3 to the release of X by program and PLC, s: `t_FIN + t_dwell`, or `max(0.95 t_ramp, t_FIN)` where FIN waits for the speed; 0
/// at standstill.
pub(super) fn program_wait(p: &Params, moves: bool) -> f64 {
    match p.wait {
        _ if !moves => 0.0,
        Wait::Dwell => FIN_DELAY + p.dwell,
        Wait::Fin => (ramp(p) * AT_SPEED).max(FIN_DELAY),
    }
}

/// Time that X loses on the rest of the spindle ramp after the wait, because a feed per revolution follows the spindle,
/// s: `(t_ramp - t_wait)² / (2 t_ramp)`.
pub(super) fn still_to_ramp(p: &Params, wait: f64) -> f64 {
    let (ramp, left) = (ramp(p), ramp(p) - wait);
    if p.feed_form == FeedForm::PerRevolution && left > 0.0 { left * left / (2.0 * ramp) } else { 0.0 }
}

/// Time (s) of the inverter from standstill to the actual speed.
pub(super) fn ramp(p: &Params) -> f64 {
    p.ramp_to(p.speed_at(p.override_stepped()))
}

impl Params {
    /// Time (s) of the inverter for a change of the unwinder's speed by n (r/min): `t_10 · n / n10`, with its ramp t_10 for the speed n10 at 10 V.
    pub(in crate::machines::ribbon_line) fn ramp_to(&self, speed: f64) -> f64 {
        self.inverter_ramp * speed / self.speed_at_10v
    }

    /// Time (s) at full speed in which X covers its way from a hold to its stop: `τ / 2 + 1 / K`. Source: ribbon line facts, 11.
    pub(in crate::machines::ribbon_line) fn x_stop_time(&self) -> f64 {
        self.axes.pull.time_constant / 2000.0 + 1.0 / self.axes.pull.position_gain
    }
}

/// Ribbon unwound at a start before X pulls at the same speed, mm. With F per revolution and a wait t_w shorter than the spindle ramp t_r:
/// `s = v · (t_w² / (2 t_r) + τ / 2)`, with ribbon speed v [mm/s] and time constant τ of X [s]; else [`web::slack_after_start`].
/// Source: sizing facts 2.6.
pub(super) fn laid_at_start(p: &Params, speed: f64, ramp: f64, tau: f64, wait: f64) -> f64 {
    if p.feed_form == FeedForm::PerRevolution && wait < ramp {
        speed * (wait * wait / (2.0 * ramp) + tau / 2.0)
    } else {
        web::slack_after_start(speed, ramp, tau, wait)
    }
}
