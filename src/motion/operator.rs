//! Events of the operator panel: overrides, cycle start, hold, reset, forced inputs.

use super::exec::Exec;
use super::input_name::InputName;
use super::panel::Action;
use super::plc::{ProgramState, percent};
use super::program::RunningProgram;
use super::sim::Sim;
use super::timeline::VariableChange;
use crate::drives::Rotation;
use crate::math;
use crate::msg;
use crate::text::Diagnostic;

impl<P: RunningProgram> Sim<'_, P> {
    /// Carries out the next event of the panel.
    pub(super) fn operate(&mut self, t: f64) {
        let panel = self.panel;
        let Some(event) = panel.events().get(self.state.operator.events_done) else { return };
        self.state.operator.events_done += 1;
        match &event.action {
            Action::SpindleOverride(value) => {
                self.state.plc.signals.knobs.spindle = percent(*value);
                self.scan(t);
            }
            Action::FeedOverride(value) => {
                self.state.operator.knobs.feed = *value;
                self.state.plc.signals.knobs.feed = percent(*value);
                self.scan(t);
                self.update_path_speed(t);
            }
            Action::RapidOverride(value) => {
                self.state.operator.knobs.rapid = *value;
                self.update_path_speed(t);
            }
            Action::Start => self.start(t),
            Action::Hold => self.hold_key(t),
            Action::Reset => self.reset(t, Exec::Ready),
            Action::EmergencyStop => self.emergency_stop(t),
            Action::InverterFault(on) => self.inverter_fault(t, *on),
            Action::ProgramZeroReturn => self.return_to_zero(t),
            Action::SingleBlock(on) => self.state.operator.knobs.single_block = *on,
            Action::OptionalStop(on) => self.state.operator.knobs.optional_stop = *on,
            Action::BlockSkip(on) => self.state.operator.knobs.block_skip = *on,
            Action::ManualSpeed(rpm) => self.manual_speed(t, *rpm),
            Action::SpeedLimit(limit, rpm) => {
                self.state.spindle.limit(*limit, *rpm);
                self.scan(t);
            }
            Action::Input(name, value) => self.force_input(t, name, *value),
            Action::Variable(number, value) => self.set_variable(t, *number, *value),
        }
    }

    /// The key "feed hold": read by the PLC where it reads it, else a hold of the control.
    fn hold_key(&mut self, t: f64) {
        if self.state.plc.logic.reads_hold_key() {
            self.state.plc.signals.hold_key = true;
            self.scan(t);
        } else {
            self.hold(t);
        }
        self.update_path_speed(t);
    }

    fn emergency_stop(&mut self, t: f64) {
        let diagnostic = Diagnostic::error(msg!("motion.emergency-stop")).alarm(self.plant.emergency);
        self.out.report(diagnostic.clone());
        self.reset(t, Exec::Emergency(Box::new(diagnostic)));
    }

    /// Begin or end of a fault of the spindle inverter, on machines whose PLC watches one.
    fn inverter_fault(&mut self, t: f64, on: bool) {
        if !self.state.plc.logic.watches_inverter() {
            return self.out.report(Diagnostic::warning(msg!("motion.no-inverter")));
        }
        self.state.plc.signals.inverter_fault = on;
        if on {
            // Without current from the inverter the spindle is not held at an angle.
            self.state.spindle.orienting = None;
        }
        self.scan(t);
    }

    /// Forces an input of the PLC, within its range.
    fn force_input(&mut self, t: f64, name: &InputName, value: f64) {
        let key = match *name {
            InputName::Variable(number, part) if self.plant.is_input(number) => (number, part),
            _ => return self.nothing_to_set(&name.to_string()),
        };
        let (least, most) = self.plant.input_range(key.0, key.1);
        let taken = math::clamp(value, least, most);
        if taken != value {
            let message = msg!("interp.output-range", variable = name.to_string(), value = (value, 9), taken);
            self.out.report(Diagnostic::warning(message));
        }
        self.state.plc.forced.insert(key, taken);
        self.scan(t);
    }

    /// Sets a common variable of the program; `None` is vacant.
    fn set_variable(&mut self, t: f64, number: u32, value: Option<f64>) {
        if self.state.program.set_variable(number, value) {
            self.out.timeline.changes.append(VariableChange { t, number, value: value.unwrap_or(f64::NAN) });
        } else {
            self.nothing_to_set(&format!("#{number}"));
        }
    }

    /// Feed hold, by the operator or the PLC; the path speed follows in [`update_path_speed`](Sim::update_path_speed).
    pub(super) fn hold(&mut self, t: f64) {
        if let Some(ended) = self.state.exec.returning() {
            self.break_off(t);
            self.state.exec = Exec::after_return(ended);
        }
        self.state.operator.held |= self.state.exec.runs();
        self.state.path.flow_end = None;
    }

    /// Manual S. Most controls refuse it while the program runs; others let it replace the programmed S in a running or interrupted
    /// program, with a warning. Its sign is a key of the spindle, which the PLC may leave without effect.
    fn manual_speed(&mut self, t: f64, rpm: f64) {
        if matches!(self.state.exec, Exec::Emergency(_)) || !rpm.is_finite() {
            return;
        }
        let runs = self.state.exec.runs() && !self.holding();
        if runs && !self.plant.spindle.rules.manual_in_automatic {
            self.out.report(Diagnostic::warning(msg!("motion.manual-speed-refused", speed = rpm)));
            return;
        }
        let wanted = Rotation::of(rpm);
        self.state.plc.signals.spindle_key = Some(wanted);
        self.scan(t);
        if self.state.plc.orders.run_contacts.is_some_and(|rotation| rotation != wanted) {
            self.out.report(Diagnostic::warning(msg!("motion.spindle-key-refused", speed = rpm)));
            return;
        }
        let turning = &mut self.state.spindle;
        if (self.state.exec.runs() || matches!(self.state.exec, Exec::Stopped)) && turning.rotation != Rotation::Stopped
        {
            let programmed = turning.rotation.sign() * turning.speed;
            self.out.report(Diagnostic::warning(msg!(
                "motion.manual-speed-taken",
                speed = rpm,
                programmed = (programmed, 3)
            )));
        }
        (turning.surface, turning.orienting) = (None, None);
        (turning.speed, turning.rotation) = (rpm.abs(), wanted);
        self.scan(t);
    }

    fn nothing_to_set(&mut self, name: &str) {
        self.out.report(Diagnostic::warning(msg!("motion.nothing-to-set", name)));
    }

    /// Cycle start: continues after a stop or hold, restarts after reset or program end. A hold of the PLC refuses it.
    fn start(&mut self, t: f64) {
        let waits = !matches!(self.program_state(), ProgramState::Running | ProgramState::Alarm);
        if self.state.plc.follows && waits {
            self.read_contacts(t);
        }
        if self.state.plc.orders.program_held && waits {
            self.out.report(Diagnostic::warning(msg!("motion.start-refused")));
            return;
        }
        match self.state.exec {
            Exec::Stopped => {
                self.state.exec = Exec::Idle;
                self.out.timeline.started(t);
            }
            Exec::Ready | Exec::Finished => {
                let (position, scale) = (&self.state.path.position, &self.plant.scale);
                self.state.program.restart(core::array::from_fn(|k| (position[k] / scale[k]).round() as i64));
                self.clear();
                self.state.reader.next_step = t;
                self.state.exec = Exec::Idle;
            }
            _ => {}
        }
        if self.state.exec.runs() {
            self.state.operator.stepped = false;
            self.state.operator.held = false;
            self.state.path.flow_end = None;
            // A PLC that holds the spindle releases it before the path speed is computed.
            self.show_state(t);
            self.update_path_speed(t);
        }
    }

    /// Stops the axes over their time constants, and the spindle over its ramp on controls that do so.
    fn reset(&mut self, t: f64, then: Exec) {
        self.break_off(t);
        if self.plant.log {
            // Commands that were read and not begun are removed from the log.
            if let Some(next) = self.state.reader.queue.front() {
                self.out.log.truncate(next.logged.saturating_sub(self.out.taken));
            }
        }
        self.clear();
        self.out.timeline.clear_message(t);
        let emergency = matches!(then, Exec::Emergency(_));
        if emergency || self.orients() {
            self.state.spindle.orienting = None;
        }
        let rules = &self.plant.spindle.rules;
        if emergency || !rules.turns_through_reset {
            self.state.spindle.rotation = Rotation::Stopped;
        }
        if emergency && rules.emergency_clears {
            self.state.spindle.speed = 0.0;
        }
        self.state.exec = then;
        self.state.plc.signals.clear_strobes();
        (self.state.plc.signals.reset, self.state.plc.signals.emergency) = (true, emergency);
        self.scan(t);
    }

    /// The state of a control after reset.
    fn clear(&mut self) {
        let s = &mut *self.state;
        s.reader.queue.clear();
        s.reader.ahead = 0;
        s.reader.drains = false;
        s.reader.over = None;
        s.operator.held = false;
        s.operator.stepped = false;
        s.path.flow_end = None;
        (s.suppressed.hold, s.suppressed.feed_override, s.suppressed.exact) = (false, false, false);
        (s.suppressed.single_block, s.suppressed.fin) = (false, false);
        s.spindle.surface = None;
    }
}
