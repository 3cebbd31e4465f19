//! The PLC scan: exchanges [`PlcSignals`] and [`PlcOrders`], applies forced inputs, handles FIN.

use super::exec::Exec;
use super::once::Once;
use super::plc::{PlcAlarm, ProgramState};
use super::program::RunningProgram;
use super::sim::Sim;
use super::timeline::VariableChange;
use crate::msg;
use crate::text::Diagnostic;

/// Maximum rounds in which control and PLC settle.
const ROUNDS: u32 = 4;

impl<P: RunningProgram> Sim<'_, P> {
    /// Scans the PLC until it and the spindle agree.
    pub(super) fn scan(&mut self, t: f64) {
        // The speed at a cut's diameter and its feed per revolution depend on each other; they settle before the PLC is scanned.
        (0..ROUNDS).all(|_| self.update_command(t));
        self.show_pmc(t);
        let waited = (self.state.plc.orders.axes_held, self.state.operator.held);
        // A PLC and a control that never agree are left to the next scan.
        for _ in 0..ROUNDS {
            self.state.plc.signals.spindle_actual =
                self.out.timeline.ramps.last().map_or(0.0, |ramp| ramp.actual(&self.plant.spindle, t));
            let key = self.state.plc.signals.hold_key;
            let (state, orders) = (self.program_state(), self.state.plc.orders.spindle);
            self.state.plc.signals.program_state = state;
            self.state.plc.signals.positions = self.state.spindle.orienting.is_some();
            let plc = &mut self.state.plc;
            let wish = plc.logic.scan(t, &plc.signals, &mut plc.orders);
            (self.state.plc.signals.reset, self.state.plc.signals.emergency) = (false, false);
            (self.state.plc.signals.spindle_key, self.state.plc.signals.hold_key) = (None, false);
            // A PLC that requests an immediate scan gets it in its next cycle (1 ms).
            self.state.plc.next_scan = wish.map_or(f64::INFINITY, |wish| if wish > t { wish } else { t + 0.001 });
            let plc = &mut self.state.plc;
            for ((number, part), value) in &plc.forced {
                let word = plc.orders.macro_inputs.entry(*number).or_insert(0.0);
                *word = part.put(*word, *value);
            }
            if let Some(alarm) = self.state.plc.orders.alarm.take() {
                self.plc_alarm(t, alarm);
            }
            let notice = self.state.plc.orders.notice.take();
            if self.state.plc.orders.program_held {
                self.hold(t);
                if let Some(notice) = notice {
                    self.state.plc.hold = Some(notice.clone());
                    self.report_in_block(Diagnostic::warning(notice));
                }
            } else {
                self.state.plc.hold = None;
                if let Some(notice) = notice {
                    self.warn(Once::Notice, || notice);
                }
            }
            let plc = &mut self.state.plc;
            let answered = plc.signals.waits() && plc.orders.fin;
            if answered {
                plc.signals.clear_strobes();
                if matches!(self.state.exec, Exec::Fin) {
                    self.state.exec = Exec::Idle;
                }
            }
            let ordered = answered || self.state.plc.orders.spindle != orders;
            let changed = ordered && self.update_command(t) || self.program_state() != state;
            // The key is released before anything else happens.
            if !changed && !answered && !key {
                break;
            }
        }
        if (self.state.plc.orders.axes_held, self.state.operator.held) != waited {
            self.update_path_speed(t);
        }
        self.turn_pmc(t);
        self.show_inputs(t);
    }

    pub(super) fn program_state(&self) -> ProgramState {
        match &self.state.exec {
            Exec::Stopped => ProgramState::Stopped,
            Exec::Alarm(_) | Exec::Emergency(_) => ProgramState::Alarm,
            exec if !exec.runs() => ProgramState::Idle,
            _ if self.holding() => ProgramState::Held,
            _ => ProgramState::Running,
        }
    }

    /// Shows the PLC that the program has stopped or continued.
    pub(super) fn show_state(&mut self, t: f64) {
        if self.program_state() != self.state.plc.signals.program_state {
            self.scan(t);
        }
    }

    /// Stops the program with an alarm of the PLC.
    fn plc_alarm(&mut self, t: f64, alarm: PlcAlarm) {
        let (shown, message) = match alarm {
            PlcAlarm::SpindleReversal => {
                // The earlier code stays active.
                self.state.spindle.rotation = self.state.spindle.rotation.reversed();
                (self.plant.reversal, msg!("motion.spindle-reversal"))
            }
            PlcAlarm::InverterFault => {
                if !self.state.exec.runs() && !matches!(self.state.exec, Exec::Stopped) {
                    self.state.place = None;
                }
                (self.plant.inverter_fault, msg!("motion.inverter-fault"))
            }
            PlcAlarm::GearTimeout => (self.plant.gear_timeout, msg!("motion.gear-timeout")),
        };
        self.state.plc.signals.clear_strobes();
        self.stop_with(Diagnostic::error(message).alarm(shown));
        self.update_command(t);
    }

    /// Stops with an alarm at the executing block.
    pub(super) fn stop_with(&mut self, diagnostic: Diagnostic) {
        self.break_off(self.state.now);
        let diagnostic = Diagnostic { place: self.state.place, ..diagnostic };
        self.out.report(diagnostic.clone());
        self.state.exec = Exec::Alarm(Box::new(diagnostic));
    }

    /// Records changed macro inputs, for the screen.
    fn show_inputs(&mut self, t: f64) {
        let inputs = &self.state.plc.orders.macro_inputs;
        if *inputs == self.state.plc.shown {
            return;
        }
        for (&number, &value) in inputs.iter() {
            if self.state.plc.shown.get(&number) != Some(&value) {
                self.out.timeline.changes.append(VariableChange { t, number, value });
            }
        }
        self.state.plc.shown.clone_from(inputs);
    }
}
