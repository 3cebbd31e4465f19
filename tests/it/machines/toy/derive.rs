//! The formulas of the cut-to-length feeder.

use super::params::{Feed, Params};

/// The results. Times in seconds.
#[derive(Debug, Clone)]
pub(crate) struct Derived {
    /// Feed speed, mm/min.
    pub speed: f64,
    /// One piece.
    pub piece_time: f64,
    /// Pieces per hour.
    pub output: f64,
}

impl Derived {
    /// `t = 60 L / v + τ + t_cut`, with length L [mm], speed v [mm/min], time constant τ [s] of the linear acceleration and cutting time
    /// t_cut [s]. Source: a trapezoidal velocity profile takes its time constant longer than the same way at constant speed.
    pub(super) fn new(p: &Params) -> Derived {
        let speed = if p.feed == Feed::Rapid { p.clamp } else { p.speed };
        let piece_time = 60.0 * p.length / speed + p.time_constant / 1000.0 + p.cut_time;
        Derived { speed, piece_time, output: 3600.0 / piece_time }
    }
}
