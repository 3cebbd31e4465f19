//! Contacts of the machine that follow its movers: the times at which they are read.

use super::plc::ProgramState;
use super::program::RunningProgram;
use super::sim::Sim;

/// Least and greatest time (s) between two readings.
const BETWEEN: (f64, f64) = (0.01, 1.0);

impl<P: RunningProgram> Sim<'_, P> {
    /// Reads the contacts at `t`, and scans the PLC if one has changed.
    pub(super) fn read_contacts(&mut self, t: f64) {
        let state = self.program_state();
        let plc = &mut self.state.plc;
        let (changed, wait) = plc.logic.follow(t, state, &self.out.timeline);
        // A NaN counts as the least time.
        plc.next_reading = t + if wait > BETWEEN.0 { wait.min(BETWEEN.1) } else { BETWEEN.0 };
        if changed {
            self.scan(t);
        }
    }

    /// After an event: contacts are read while the program runs and something moves.
    #[inline]
    pub(super) fn await_contacts(&mut self, t: f64) {
        if !self.state.plc.follows {
            return;
        }
        if self.program_state() != ProgramState::Running || !self.moves(t) {
            self.state.plc.next_reading = f64::INFINITY;
        } else if self.state.plc.next_reading == f64::INFINITY {
            self.state.plc.next_reading = t;
        }
    }

    /// Whether an axis or the spindle moves.
    fn moves(&self, t: f64) -> bool {
        let turns = || self.out.timeline.ramps.last().is_some_and(|ramp| ramp.target != 0.0 || ramp.reached() > t);
        self.state.path.moving || self.rest_time() > t || turns()
    }
}
