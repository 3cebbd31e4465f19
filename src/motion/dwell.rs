//! A dwell in turns of the spindle.

use super::exec::MEASURE;
use super::program::RunningProgram;
use super::sim::Sim;

/// Tolerance in turns.
const TURNED: f64 = 1e-9;

impl<P: RunningProgram> Sim<'_, P> {
    /// Spindle turns since the start of the run.
    pub(super) fn turns(&self, t: f64) -> f64 {
        self.out.timeline.ramps.last().map_or(0.0, |ramp| ramp.turns(&self.plant.spindle, t))
    }

    /// Turns left of a dwell.
    pub(super) fn turns_left(&self, t: f64, from: f64, turns: f64) -> f64 {
        let left = turns - (self.turns(t) - from).abs();
        if left > TURNED { left } else { 0.0 }
    }

    /// Earliest end (s) of a dwell in turns; computed again while the spindle changes its speed.
    pub(super) fn turns_time(&self, from: f64, turns: f64) -> f64 {
        let t = self.state.now;
        let (left, rpm) = (self.turns_left(t, from, turns), self.measured(t));
        let next = if rpm > 0.0 { t + (left * 60.0 / rpm).max(1e-6) } else { f64::INFINITY };
        let changes = self.state.spindle.reached_at.is_finite();
        if left <= 0.0 {
            t
        } else if changes {
            next.min(t + MEASURE)
        } else {
            next
        }
    }
}
