//! The PLC: what is put out to it, and what it answers.

use super::executor::Exec;
use super::plc::Io;
use super::program::Program;
use super::state::Sim;
use super::timeline::VariableChange;
use crate::controls::Alarm;
use crate::msg;
use crate::text::Diagnostic;

impl<P: Program> Sim<'_, P> {
    /// Lets the PLC act until it and the spindle agree.
    pub(super) fn scan(&mut self, t: f64) {
        self.turn(t);
        self.show_pmc(t);
        // A PLC and a control that never agree are left for the next scan.
        for _ in 0..4 {
            self.s.io.spindle_actual =
                self.out.timeline.ramps.last().map_or(0.0, |ramp| ramp.actual(&self.machine.spindle, t));
            let wish = self.s.plc.0.scan(t, &mut self.s.io);
            (self.s.io.reset, self.s.io.emergency) = (false, false);
            // A PLC that wants to be asked at once is asked in its next cycle.
            self.s.plc_at = wish.map_or(f64::INFINITY, |wish| if wish > t { wish } else { t + 0.001 });
            let Io { forced, inputs, .. } = &mut self.s.io;
            for ((number, part), value) in forced.iter() {
                let word = inputs.entry(*number).or_insert(0.0);
                *word = part.put(*word, *value);
            }
            if let Some(alarm) = self.s.io.alarm.take() {
                self.plc_alarm(t, alarm);
            }
            let io = &mut self.s.io;
            let waiting = io.m_strobe.is_some() || io.s_strobe.is_some() || io.t_strobe.is_some();
            let answered = waiting && io.fin;
            if answered {
                io.clear_strobes();
                if matches!(self.s.exec, Exec::Fin) {
                    self.s.exec = Exec::Idle;
                }
            }
            if !self.turn(t) && !answered {
                break;
            }
        }
        self.turn_pmc(t);
        self.show_inputs(t);
    }

    /// The PLC stops the program.
    fn plc_alarm(&mut self, t: f64, alarm: Alarm) {
        let reversal = alarm == Alarm::SpindleReversal;
        if reversal {
            // What was put out before stays out.
            self.s.turning.direction = -self.s.turning.direction;
        }
        let (shown, message) = match reversal {
            true => (self.machine.reversal, msg!("motion.spindle-reversal")),
            false => (self.machine.gear_timeout, msg!("motion.gear-timeout")),
        };
        self.s.io.clear_strobes();
        self.stop_with(Diagnostic::error(message).alarm(shown));
        self.turn(t);
    }

    /// An alarm at the block that is executing.
    pub(super) fn stop_with(&mut self, diagnostic: Diagnostic) {
        let diagnostic = Diagnostic { place: self.s.place, ..diagnostic };
        self.out.diagnostics.push(diagnostic.clone());
        self.s.exec = Exec::Alarm(Box::new(diagnostic));
    }

    /// Records macro inputs that have changed, for the screen.
    fn show_inputs(&mut self, t: f64) {
        let inputs = &self.s.io.inputs;
        if *inputs == self.s.shown {
            return;
        }
        for (&number, &value) in inputs.iter() {
            if self.s.shown.get(&number) != Some(&value) {
                self.out.timeline.changes.push(VariableChange { t, number, value });
            }
        }
        self.s.shown.clone_from(inputs);
    }
}

/// An override in percent: 0 to 1000, 0 where it is no number.
pub(super) fn percent(value: f64) -> f64 {
    if value > 0.0 { value.min(1000.0) } else { 0.0 }
}

/// The sign of a speed or an angle, 0 where it is none.
pub(super) fn sense(value: f64) -> i8 {
    i8::from(value > 1e-9) - i8::from(value < -1e-9)
}
