//! Standstill: settling of axes and spindle after the end of a run.

use super::path::Path;
use super::plant::AxisPlant;
use super::program::RunningProgram;
use super::sim::Sim;
use crate::math;

/// Longest time (s) planned beyond the end of a run for axes and spindle to settle.
const SETTLING: f64 = 60.0;

/// Longest time (s) planned beyond the end of a run for a spindle that coasts without current.
const COASTING: f64 = 3600.0;

/// Tolerance of the position lag at standstill, in command increments.
const SETTLED: f64 = 0.01;

impl Path {
    /// Settling time (s) of an axis after its last change of feed to `v` at `t₀` on the path `U`. `e` is the deviation from the steady lag
    /// `v / K` at `t₀ + τ`. An axis already `v (τ/2 + 1/K)` behind `U` at `t₀` has settled then.
    ///
    /// `t = t₀ + τ + ln(e / tolerance) / K  [s]`
    fn settled(&self, k: usize, plant: &AxisPlant, tolerance: f64) -> f64 {
        let Some(last) = self.segments.last() else { return 0.0 };
        let (tau, speed) = (plant.time_constant, last.velocity[k]);
        let follows = if plant.position_gain > 0.0 { 1.0 / plant.position_gain } else { 0.0 };
        let lag = speed * follows;
        let now = self.axis(k, plant, last.t);
        let behind = last.from[k] - now.actual - 0.5 * speed * tau - lag;
        if behind.abs() <= tolerance && (now.feed / 60.0 - speed).abs() <= tolerance {
            return last.t;
        }
        let smooth = self.axis(k, plant, last.t + tau);
        let left = (smooth.position - smooth.actual - lag).abs();
        last.t + tau + if left > tolerance { math::ln(left / tolerance) * follows } else { 0.0 }
    }
}

impl<P: RunningProgram> Sim<'_, P> {
    /// Time (s) at which axes and spindle have settled after the end of the run, at rest or at a constant commanded speed, provided that no
    /// event changes a command before.
    pub(super) fn standstill(&mut self) -> f64 {
        let ended_at = *self.state.ended_at.get_or_insert(self.state.now);
        let timeline = &self.out.timeline;
        let tolerance = |k: usize| SETTLED * self.plant.scale[k];
        let axes = self.plant.axes.iter().enumerate();
        let axes = axes.map(|(k, axis)| timeline.path.settled(k, axis, tolerance(k)));
        let least = self.plant.scale.iter().copied().fold(f64::INFINITY, f64::min);
        let pmc = timeline.pmc_axes.iter().enumerate();
        let pmc = pmc.map(|(k, axis)| timeline.pmc.settled(k, axis, SETTLED * least));
        let ramp = timeline.ramps.last();
        let spindle = ramp.map_or(0.0, |ramp| ramp.reached().max(ramp.t + ramp.command.span));
        let longest = if ramp.is_some_and(|ramp| ramp.command.coasts) { COASTING } else { SETTLING };
        // The PLC still slows down its axes.
        let turning = self.state.plc.orders.pmc_speed.iter().any(|rpm| *rpm != 0.0);
        let plc = if turning && self.state.plc.next_scan.is_finite() { f64::INFINITY } else { 0.0 };
        let settled = axes.chain(pmc).fold(spindle.max(plc), f64::max);
        math::clamp(settled, ended_at, ended_at + longest)
    }
}
