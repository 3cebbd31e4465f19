//! PLC and spindle: what is put out, what is answered, and how fast the spindle is told to turn.

use super::executor::Exec;
use super::plc::Io;
use super::program::Program;
use super::spindle::Ramp;
use super::state::{Once, Sim};
use super::timeline::Change;
use crate::msg;

impl<P: Program> Sim<'_, P> {
    /// Lets the PLC act until it and the spindle agree.
    pub(super) fn scan(&mut self, t: f64) {
        self.turn(t);
        // A PLC and a control that never agree are left for the next scan.
        for _ in 0..4 {
            self.s.io.spindle_actual =
                self.out.timeline.ramps.last().map_or(0.0, |ramp| ramp.actual(&self.machine.spindle, t));
            let wish = self.s.plc.0.scan(t, &mut self.s.io);
            // A PLC that wants to be asked at once is asked in its next cycle.
            self.s.plc_at = wish.map_or(f64::INFINITY, |wish| if wish > t { wish } else { t + 0.001 });
            let Io { forced, inputs, .. } = &mut self.s.io;
            for ((number, part), value) in forced.iter() {
                let word = inputs.entry(*number, 0.0);
                *word = part.put(*word, *value);
            }
            let answered = matches!(self.s.exec, Exec::Fin) && self.s.io.fin;
            if answered {
                let io = &mut self.s.io;
                (io.m_strobe, io.s_strobe, io.t_strobe) = (None, None, None);
                self.s.exec = Exec::Idle;
            }
            if !self.turn(t) && !answered {
                break;
            }
        }
        self.show_inputs(t);
    }

    /// Records macro inputs that have changed, for the screen.
    fn show_inputs(&mut self, t: f64) {
        let inputs = &self.s.io.inputs;
        if *inputs == self.s.shown {
            return;
        }
        for (&number, &value) in inputs.iter() {
            if self.s.shown.get(&number) != Some(&value) {
                self.out.timeline.changes.push(Change { t, number, value });
            }
        }
        self.s.shown.clone_from(inputs);
    }

    /// Brings the spindle's command up to date; whether it changed.
    fn turn(&mut self, t: f64) -> bool {
        let plant = &self.machine.spindle;
        let wanted = self.s.speed * percent(self.s.io.spindle_override_out) / 100.0;
        let sign = f64::from(self.s.direction);
        if wanted > plant.speed_clamp && sign != 0.0 {
            self.say(Once::SpindleClamp as u32, || msg!("motion.spindle-clamp", wanted, plant.speed_clamp));
        }
        let command = if sign == 0.0 { 0.0 } else { sign * wanted.min(plant.speed_clamp) };
        if command == self.s.io.spindle_command {
            return false;
        }
        let now =
            self.out.timeline.ramps.last().map_or((0.0, 0.0), |ramp| (ramp.speed(plant, t), ramp.turns(plant, t)));
        self.s.io.spindle_command = command;
        self.put_ramp(t, now.0, now.1);
        self.pace(t);
        true
    }

    pub(super) fn put_ramp(&mut self, t: f64, start: f64, turns: f64) {
        let plant = &self.machine.spindle;
        let command = self.s.io.spindle_command;
        // The output ends at full voltage, whatever the clamp allows.
        let target = command.clamp(-plant.speed_at_full, plant.speed_at_full);
        let ramp = Ramp { t, start, target, command, turns };
        let reached = ramp.reached(plant);
        self.s.reached_at = if reached > t { reached } else { f64::INFINITY };
        self.out.timeline.ramps.put(ramp);
    }
}

/// An override in percent: 0 to 1000, 0 where it is no number.
pub(super) fn percent(value: f64) -> f64 {
    if value > 0.0 { value.min(1000.0) } else { 0.0 }
}
