//! Ribbon between unwinder and pull roller: lengths laid by start, run, stop and interruption, and the loop that holds them.

use super::feeds::LineFeeds;
use super::start::{first_wait, laid_at_start, program_wait, ramp, speed_wait, wait};
use super::timing::LineTiming;
use super::unwinder::UnwinderSpeed;
use crate::drives::web;
use crate::machines::ribbon_line::params::{Params, PathMode, Wait};

/// Slack rate (mm/min) up to which a loop lasts for ever: less is rounding.
const NO_RATE: f64 = 1e-9;

/// Ribbon between unwinder and pull roller, mm; positive where it piles up.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::ribbon_line) struct Slack {
    pub start: f64,
    /// Slack rate, mm/min, at the running load and at rated load.
    pub rate: f64,
    pub rate_rated: f64,
    pub run: f64,
    pub stop: f64,
    pub hold: f64,
    pub resume: f64,
    /// Greatest ribbon laid by a hold and its restart.
    pub interruption: f64,
    /// Ribbon missing after a start or restart with an empty loop, by which X is ahead of the unwinder; 0 if ribbon is
    /// left over.
    pub missing: f64,
    /// Slack that the regulator of a dancer keeps, and the loop that many products leave before the next, infinite where it grows with each
    /// product; 0 without regulator.
    pub set_point: f64,
    pub before: f64,
    /// Ribbon that stands in the loop while a knob turns the unwinder alone to its highest position and a regulator trims that away.
    pub standing: f64,
    /// Loop capacity for all ribbon that one product with one interruption may lay:
    /// `C ≥ |start| + |run| + |stop| + interruption`. The magnitudes are added, because the signs differ and an
    /// operator may interrupt at any moment. An emergency stop replaces the stop at the end of the product and lays as
    /// much as a hold, which is less than a stop: there M5 waits until the axes are at rest. Source: sizing facts 2.6,
    /// ribbon line facts, 7.
    pub loop_needed: f64,
    /// Time (s) in which the slack rate fills or empties the loop.
    pub loop_time: f64,
}

impl Slack {
    pub(super) fn new(p: &Params, unwinder: &UnwinderSpeed, feeds: &LineFeeds, timing: &LineTiming) -> Slack {
        let (line_speed, error) = (feeds.line_speed, unwinder.error);
        // Ribbon unwound per minute; a regulator trims it to the program's.
        let laid = p.laid_by_turns(unwinder.actual);
        let unwound = |error: f64| if p.is_regulated() { line_speed } else { laid * (1.0 + error) };
        // A feed per revolution follows the measured speed of the unwinder.
        let in_step = p.feeds_per_revolution();
        let pulled = |error: f64| if in_step { line_speed * (1.0 + error) } else { line_speed };
        let rate = |error: f64, kept: f64| p.beyond_trim(unwound(error) - pulled(error) * kept, unwound(error));
        let (rate, rate_rated) = (rate(error, timing.kept), rate(unwinder.error_rated, timing.kept_rated));
        // Slip acts throughout; losses by exact stops and starved blocks act only from the first pass to the last.
        let slip = unwound(error) - pulled(error);
        let run = (slip * timing.product + pulled(error) * timing.lost) / 60.0;
        let run = if p.is_regulated() { run.min(kept_by_trim(p, timing, line_speed)) } else { run };
        let speed = feeds.mm_per_second();
        let (feed_ramp, tau) = (ramp(p), p.axes.pull.time_constant / 1000.0);
        let started = unwinder.actual > 0.0;
        // A running axis lags its command by v / K.
        let lag = speed / p.axes.pull.position_gain;
        // Each exact stop has its ramps and the lag in its time.
        let stops = p.path_mode == PathMode::ExactStop;
        let (edge, edge_lag, rest) = if stops { (0.0, 0.0, 0.0) } else { (tau, lag, p.slowest()) };
        let start =
            if started { laid_at_start(p, speed, feed_ramp, edge, first_wait(p, true)) + edge_lag } else { 0.0 };
        // The PLC stops the unwinder in the scan that sees the hold. Axes that follow the unwinder restart with it, or with their next block
        // where the control waits for the speed; others wait as at the start, with their blocks read.
        let hold = web::slack_after_stop(speed, feed_ramp, tau, 0.0) - lag;
        let again = if in_step { speed_wait(p) } else { wait(p, true) };
        let resume = if started { laid_at_start(p, speed, feed_ramp, tau, again) + lag } else { 0.0 };
        // A control that waits for the speed waits less after a short pause, so that the dwell alone counts there.
        let timed = p.wait == Wait::Dwell && !in_step;
        let short = if timed { web::slack_of_short_stop(speed, feed_ramp, program_wait(p, started)) } else { 0.0 };
        let run = if started { run } else { 0.0 };
        // M5 follows the last move and is read when both axes have stopped.
        let stop = web::slack_after_stop(speed, feed_ramp, edge, rest) - edge_lag;
        let interruption = (hold.abs() + resume.abs()).max(short);
        let worst = rate.abs().max(rate_rated.abs());
        Slack {
            start,
            rate,
            rate_rated,
            run,
            stop,
            hold,
            resume,
            interruption,
            missing: (-start.min(resume)).max(0.0),
            set_point: 0.0,
            before: 0.0,
            standing: 0.0,
            loop_needed: start.abs() + run.abs() + stop.abs() + interruption,
            loop_time: if worst > NO_RATE { p.loop_capacity / worst * 60.0 } else { f64::INFINITY },
        }
    }
}

impl Slack {
    /// Enters the loop that a regulator keeps: its set point, the loop (mm) before a product, and that standing with the knob turned.
    pub(in crate::machines::ribbon_line) fn keep(&mut self, set_point: f64, before: f64, standing: f64) {
        (self.set_point, self.before, self.standing) = (set_point, before, standing);
        self.loop_needed = self.laid_to_the_end() + self.interruption;
    }

    /// Greatest ribbon (mm) in the loop before the stop: `max(before + |start|, set point) + |run| + standing`. A loop that grows with each
    /// product is taken up before.
    pub(in crate::machines::ribbon_line) fn laid_before_stop(&self) -> f64 {
        let before = if self.before.is_finite() { self.before } else { 0.0 };
        (before + self.start.abs()).max(self.set_point) + self.run.abs() + self.standing
    }

    /// Greatest ribbon (mm) in the loop of a product: before the stop, or `max(|start|, set point) + |run| + standing + |stop|` after it. What products
    /// before have left is taken away until then.
    pub(in crate::machines::ribbon_line) fn laid_to_the_end(&self) -> f64 {
        let stopped = self.start.abs().max(self.set_point) + self.run.abs() + self.standing + self.stop.abs();
        self.laid_before_stop().max(stopped)
    }
}

/// Slack (mm) to which a regulator lets the losses of X by exact stops and starved blocks grow. With the share `λ` of the speed that X loses
/// it is `range · λ / limit`; a share beyond the limit of the trim adds `(λ - limit) · v · t`. Source: ribbon line facts, 7.
fn kept_by_trim(p: &Params, timing: &LineTiming, line_speed: f64) -> f64 {
    let (lost, limit) = (1.0 - timing.kept, p.loop_trim());
    let held = if limit > 0.0 { p.loop_trim_range() * (lost / limit).min(1.0) } else { 0.0 };
    held + p.beyond_trim(lost * line_speed, line_speed) / 60.0 * timing.product
}
