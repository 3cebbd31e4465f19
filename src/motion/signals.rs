//! PLC and spindle: what is put out, what is answered, and how fast the spindle is told to turn.

use super::executor::{Exec, MEASURE};
use super::moves::Pace;
use super::plc::Io;
use super::program::Program;
use super::spindle::Ramp;
use super::state::{Once, Sim, Surface};
use super::timeline::Change;
use crate::math;
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
            let io = &mut self.s.io;
            let waiting = io.m_strobe.is_some() || io.s_strobe.is_some() || io.t_strobe.is_some();
            let answered = waiting && io.fin;
            if answered {
                (io.m_strobe, io.s_strobe, io.t_strobe) = (None, None, None);
                if matches!(self.s.exec, Exec::Fin) {
                    self.s.exec = Exec::Idle;
                }
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

    /// Under constant surface speed: tells the spindle the speed for where its axis will be half a step later, in a rapid for where
    /// that ends.
    pub(super) fn follow(&mut self, t: f64) {
        let Some(Surface { speed, axis, zero, again }) = &mut self.s.surface else { return };
        if again.is_finite() {
            *again = t + MEASURE;
        }
        let (speed, axis, zero) = (*speed, *axis, *zero);
        let place = match &self.s.exec {
            Exec::Moving(motion) if motion.pace == Pace::Rapid => motion.end[axis],
            Exec::Moving(motion) => motion.axis_at(axis, t + 0.5 * MEASURE),
            _ => self.s.position[axis],
        };
        let circumference = 2.0 * math::PI * (place - zero).abs();
        let limit = self.s.speed_limit.min(self.machine.spindle.speed_clamp);
        // n = 1000 v / (π D), D in mm; at D = 0 it is the limit (reference/gsk-knd-polygon.md section 1.3).
        self.s.speed = if speed > 0.0 { (1000.0 * speed / circumference).min(limit) } else { 0.0 };
        if self.turn(t) {
            self.scan(t);
        }
    }

    /// When the spindle follows its axis next.
    pub(super) fn follow_time(&self) -> f64 {
        self.s.surface.map_or(f64::INFINITY, |surface| surface.again)
    }

    pub(super) fn put_ramp(&mut self, t: f64, start: f64, turns: f64) {
        let plant = &self.machine.spindle;
        let command = self.s.io.spindle_command;
        // The output ends at full voltage, whatever the clamp allows.
        let target = math::clamp(command, -plant.speed_at_full, plant.speed_at_full);
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
