//! PMC axes, turned by the PLC: it commands their speeds; acceleration and servo lag are those of any axis.

use super::path::Segment;
use super::plant::{AxisPlant, PMC_AXES};
use super::program::RunningProgram;
use super::sim::Sim;
use super::timeline::Timeline;
use crate::interp::canon::AXES;

/// Degrees a second for each turn a minute.
const DEGREES: f64 = 6.0;

impl Timeline {
    /// Commanded angles (°) of the PLC's axes at `t`, before acceleration.
    fn pmc_told(&self, t: f64) -> [f64; AXES] {
        self.pmc
            .segments
            .at(t)
            .map_or([0.0; AXES], |last| core::array::from_fn(|k| last.from[k] + last.velocity[k] * (t - last.t)))
    }
}

impl<P: RunningProgram> Sim<'_, P> {
    /// Hands the PLC the commanded angles of its axes.
    pub(super) fn show_pmc(&mut self, t: f64) {
        let told = self.out.timeline.pmc_told(t);
        self.s.plc.io.pmc_turns = core::array::from_fn(|k| told[k] / 360.0);
    }

    /// Turns the axes of the PLC at the speeds that it now gives.
    pub(super) fn turn_pmc(&mut self, t: f64) {
        let speed = self.s.plc.io.pmc_speed;
        let asked = |k: usize| speed.get(k).copied().filter(|rpm| rpm.is_finite()).unwrap_or(0.0) * DEGREES;
        let velocity: [f64; AXES] = core::array::from_fn(asked);
        if velocity != self.out.timeline.pmc.segments.last().map_or([0.0; AXES], |last| last.velocity) {
            let from = self.out.timeline.pmc_told(t);
            self.out.timeline.pmc.segments.put(Segment { t, from, velocity, circle: 0 });
        }
    }
}

/// The axes of the PLC as the timeline needs them: where the machine has fewer, nothing turns.
pub(super) fn axes(plant: &[AxisPlant]) -> [AxisPlant; PMC_AXES] {
    let positive = |x: f64| if x > 0.0 && x.is_finite() { x } else { 0.0 };
    core::array::from_fn(|k| {
        let axis = plant.get(k).copied().unwrap_or(AxisPlant::PMC);
        let (time_constant, position_gain) = (positive(axis.time_constant), positive(axis.position_gain));
        AxisPlant { time_constant, position_gain, ..axis }
    })
}
