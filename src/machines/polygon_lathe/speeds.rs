//! Speeds of work and tool, and times and phases of their settling, lag, coasting and indexing.

use super::params::Params;

impl Params {
    /// Speed of the work in r/min, signed: `n = B · D`. Source: K2000T facts 2.
    pub(super) fn work_speed(&self) -> f64 {
        self.speed * self.work_ratio
    }

    /// Speed of the tool in r/min, signed: `n = B · Q`. Source: K2000T facts 2.
    pub(super) fn tool_speed(&self) -> f64 {
        self.speed * self.tool_ratio
    }

    /// Settling time of both axes, s: `max(τ) + 8 / min(K)`, with time constants τ [s] and position gains K [1/s].
    pub(super) fn settling(&self) -> f64 {
        self.axes.work.time_constant.max(self.axes.tool.time_constant) / 1000.0
            + 8.0 / self.axes.work.gain.min(self.axes.tool.gain)
    }

    /// Phase of the tool ahead of the work at speed, degrees of the tool: `6 n_tool · ((τ_w/2 + 1/K_w) - (τ_t/2 + 1/K_t))`, with time
    /// constants τ [s] and gains K [1/s] of work and tool. Source: servo lag after linear acceleration.
    pub(super) fn phase(&self) -> f64 {
        let lag = |ms: f64, gain: f64| 0.5 * ms / 1000.0 + 1.0 / gain;
        let early = lag(self.axes.work.time_constant, self.axes.work.gain)
            - lag(self.axes.tool.time_constant, self.axes.tool.gain);
        6.0 * self.tool_speed() * early + 0.0
    }

    /// Deceleration of work and tool by friction with the drives off, r/min per second.
    pub(super) fn coasting_deceleration(&self) -> [f64; 2] {
        [self.axes.work.limit / self.axes.work.coast, self.axes.tool.limit / self.axes.tool.coast]
    }

    /// Phase of the tool ahead of the work after coasting to rest, degrees of the tool: each axis turns by `3 n² / a` degrees, with speed n
    /// [r/min] and deceleration a [r/min per second].
    pub(super) fn coast_phase(&self) -> f64 {
        let [work, tool] = self.coasting_deceleration();
        let left = |rpm: f64, deceleration: f64| 3.0 * rpm * rpm.abs() / deceleration;
        let ratio = self.tool_ratio / self.work_ratio;
        left(self.tool_speed(), tool) - ratio * left(self.work_speed(), work) + 0.0
    }

    /// Time of the axes from 0° to their start angles, s: `max(|A|, |E|) / (6 n_index)`.
    pub(super) fn index_time(&self) -> f64 {
        self.work_start.abs().max(self.tool_start.abs()) / (6.0 * self.index_speed)
    }

    /// Mean time of both axes to their start angles, s, each from any angle in one sense: two thirds of a turn, the mean of the longer of two
    /// equally distributed ways.
    pub(super) fn mean_index_time(&self) -> f64 {
        2.0 / 3.0 * self.longest_index_time()
    }

    /// Longest time of the axes to their start angles, s: a turn, `60 / n_index`. They go there in one sense, from where the part before has
    /// ended.
    pub(super) fn longest_index_time(&self) -> f64 {
        60.0 / self.index_speed
    }
}
