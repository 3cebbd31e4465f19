//! What the operator's hand does to a run.

use super::executor::Exec;
use super::panel::Action;
use super::plc::Part;
use super::program::Program;
use super::signals::{percent, sense};
use super::state::Sim;
use super::timeline::VariableChange;
use crate::math;
use crate::msg;
use crate::text::Diagnostic;

impl<P: Program> Sim<'_, P> {
    /// The next event of the panel happens.
    pub(super) fn operate(&mut self, t: f64) {
        let panel = self.panel;
        let Some(event) = panel.events().get(self.s.panel_done) else { return };
        self.s.panel_done += 1;
        match &event.action {
            Action::SpindleOverride(value) => {
                self.s.io.spindle_override = percent(*value);
                self.scan(t);
            }
            Action::FeedOverride(value) => {
                self.s.knobs.feed = *value;
                self.s.io.feed_override = percent(*value);
                self.scan(t);
                self.pace(t);
            }
            Action::RapidOverride(value) => {
                self.s.knobs.rapid = *value;
                self.pace(t);
            }
            Action::Start => self.start(t),
            Action::Hold => {
                self.s.held |= self.s.exec.runs();
                self.s.flow_end = None;
                self.pace(t);
            }
            Action::Reset => self.reset(t, Exec::Ready),
            Action::EmergencyStop => {
                let diagnostic = Diagnostic::error(msg!("motion.emergency-stop")).alarm(self.machine.emergency);
                self.out.diagnostics.push(diagnostic.clone());
                self.reset(t, Exec::Emergency(Box::new(diagnostic)));
            }
            Action::SingleBlock(on) => self.s.knobs.single_block = *on,
            Action::OptionalStop(on) => self.s.knobs.optional_stop = *on,
            Action::BlockSkip(on) => self.s.knobs.block_skip = *on,
            Action::ManualSpeed(rpm) => {
                if !matches!(self.s.exec, Exec::Emergency(_)) && rpm.is_finite() {
                    let turning = &mut self.s.turning;
                    (turning.surface, turning.orienting) = (None, None);
                    (turning.speed, turning.direction) = (rpm.abs(), sense(*rpm));
                    self.scan(t);
                }
            }
            Action::SpeedLimit(limit, rpm) => {
                self.s.turning.limit(*limit, *rpm);
                self.scan(t);
            }
            Action::Input(name, value) => match forced(name).filter(|(number, _)| self.machine.is_input(*number)) {
                Some(key) => {
                    let (least, most) = self.machine.input_range(key.0, key.1);
                    let taken = math::clamp(*value, least, most);
                    if taken != *value {
                        let message = msg!("interp.output-range", name.as_str(), (*value, 9), taken);
                        self.out.diagnostics.push(Diagnostic::warning(message));
                    }
                    self.s.io.forced.insert(key, taken);
                    self.scan(t);
                }
                None => self.nothing_to_set(name),
            },
            Action::Variable(number, value) => {
                if self.s.program.set_variable(*number, *value) {
                    self.out.timeline.changes.push(VariableChange {
                        t,
                        number: *number,
                        value: value.unwrap_or(f64::NAN),
                    });
                } else {
                    self.nothing_to_set(&format!("#{number}"));
                }
            }
        }
    }

    fn nothing_to_set(&mut self, name: &str) {
        self.out.diagnostics.push(Diagnostic::warning(msg!("motion.nothing-to-set", name)));
    }

    /// Cycle start: goes on after a stop or hold, begins anew after reset or program end.
    fn start(&mut self, t: f64) {
        match self.s.exec {
            Exec::Stopped => self.s.exec = Exec::Idle,
            Exec::Ready | Exec::Finished => {
                let (position, scale) = (&self.s.position, &self.machine.scale);
                self.s.program.restart(core::array::from_fn(|k| (position[k] / scale[k]).round() as i64));
                self.clear();
                self.s.read_at = t;
                self.s.exec = Exec::Idle;
            }
            _ => {}
        }
        if self.s.exec.runs() {
            self.s.stepped = false;
            self.s.held = false;
            self.s.flow_end = None;
            self.pace(t);
        }
    }

    /// Stops everything: the axes over their time constants, the spindle over its ramp, where the control does so.
    fn reset(&mut self, t: f64, then: Exec) {
        self.break_off(t);
        if self.machine.log {
            // What was read and not begun has not happened.
            if let Some(next) = self.s.queue.front() {
                self.out.log.truncate(next.logged.saturating_sub(self.out.taken));
            }
        }
        self.clear();
        let emergency = matches!(then, Exec::Emergency(_));
        if emergency || self.orients() {
            self.s.turning.orienting = None;
        }
        let rules = &self.machine.spindle.rules;
        if emergency || !rules.turns_through_reset {
            self.s.turning.direction = 0;
        }
        if emergency && rules.emergency_clears {
            self.s.turning.speed = 0.0;
        }
        self.s.exec = then;
        self.s.io.clear_strobes();
        (self.s.io.reset, self.s.io.emergency) = (true, emergency);
        self.scan(t);
    }

    /// The state of a control after reset.
    fn clear(&mut self) {
        let s = &mut *self.s;
        s.queue.clear();
        s.ahead = 0;
        s.drain = false;
        s.over = None;
        s.held = false;
        s.stepped = false;
        s.flow_end = None;
        (s.suppress_hold, s.suppress_override, s.suppress_exact) = (false, false, false);
        (s.suppress_single_block, s.suppress_fin) = (false, false);
        s.turning.surface = None;
    }
}

/// Variable and part of a forced input: `#1033`, `#1033.low`, `#1033.high`.
fn forced(name: &str) -> Option<(u32, Part)> {
    let name = name.strip_prefix('#')?;
    let (number, part) = match name.split_once('.') {
        None => (name, Part::Whole),
        Some((number, "low")) => (number, Part::Low),
        Some((number, "high")) => (number, Part::High),
        Some(_) => return None,
    };
    Some((number.parse().ok()?, part))
}
