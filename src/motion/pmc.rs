//! PMC axes, moved by the PLC: it commands their speeds; acceleration and servo lag are those of any axis.

use super::path::Segment;
use super::plant::{AxisPlant, PMC_AXES};
use super::program::RunningProgram;
use super::sim::Sim;
use super::timeline::Timeline;
use crate::interp::canon::AXES;

/// °/s per r/min.
const DEGREES: f64 = 6.0;

impl Timeline {
    /// Commanded angles (°) of the PMC axes at `t`, before acceleration.
    fn pmc_commanded(&self, t: f64) -> [f64; AXES] {
        self.pmc
            .segments
            .at(t)
            .map_or([0.0; AXES], |last| core::array::from_fn(|k| last.from[k] + last.velocity[k] * (t - last.t)))
    }
}

impl<P: RunningProgram> Sim<'_, P> {
    /// Writes the commanded turns of the PMC axes to the PLC interface.
    pub(super) fn show_pmc(&mut self, t: f64) {
        let angles = self.out.timeline.pmc_commanded(t);
        self.state.plc.signals.pmc_turns = core::array::from_fn(|k| angles[k] / 360.0);
    }

    /// Turns the PMC axes at the speeds from the PLC.
    pub(super) fn turn_pmc(&mut self, t: f64) {
        let speed = self.state.plc.orders.pmc_speed;
        let asked = |k: usize| speed.get(k).copied().filter(|rpm| rpm.is_finite()).unwrap_or(0.0) * DEGREES;
        let velocity: [f64; AXES] = core::array::from_fn(asked);
        if velocity != self.out.timeline.pmc.segments.last().map_or([0.0; AXES], |last| last.velocity) {
            let from = self.out.timeline.pmc_commanded(t);
            self.out.timeline.pmc.segments.set_from(Segment { t, from, velocity, circle: 0 });
        }
    }
}

/// PMC axes for the timeline; missing ones are at rest.
pub(super) fn axes(plant: &[AxisPlant]) -> [AxisPlant; PMC_AXES] {
    let positive = |x: f64| if x > 0.0 && x.is_finite() { x } else { 0.0 };
    core::array::from_fn(|k| {
        let axis = plant.get(k).copied().unwrap_or(AxisPlant::PMC);
        let (time_constant, position_gain) = (positive(axis.time_constant), positive(axis.position_gain));
        AxisPlant { time_constant, position_gain, ..axis }
    })
}
