//! The regulator of a dancer: it samples the web between spindle and axis and trims the speed of the inverter.

use super::plc::ProgramState;
use super::program::RunningProgram;
use super::sim::Sim;
use super::spindle::SpindleMode;
use crate::drives::Rotation;

impl<P: RunningProgram> Sim<'_, P> {
    /// Samples the web at `t`, and starts a ramp of the inverter if the trim changes.
    pub(super) fn regulate_web(&mut self, t: f64) {
        let Some(regulator) = self.plant.spindle.regulator else { return };
        self.state.spindle.sampled_at = t + regulator.interval;
        let unwound = regulator.per_turn * self.turns(t);
        let web = unwound - self.out.timeline.actual(regulator.axis, t);
        let trim = regulator.trim(web - self.state.plc.orders.web_at_set_point, self.state.spindle.trim);
        if trim != self.state.spindle.trim {
            self.state.spindle.trim = trim;
            self.update_command(t);
        }
    }

    /// After an event: the web is sampled while the program runs and the inverter drives the spindle.
    #[inline]
    pub(super) fn await_web(&mut self, t: f64) {
        if self.plant.spindle.regulator.is_none() {
            return;
        }
        let is_driven = self.out.timeline.ramps.last().is_some_and(|ramp| {
            ramp.control == SpindleMode::Speed && ramp.command.rotation != Rotation::Stopped && !ramp.command.coasts
        });
        if self.program_state() != ProgramState::Running || !is_driven {
            self.state.spindle.sampled_at = f64::INFINITY;
        } else if self.state.spindle.sampled_at == f64::INFINITY {
            self.state.spindle.sampled_at = t;
        }
    }
}
