//! Commanded spindle speed: S and override within their limits, gear stages, ramps.

use super::once::Once;
use super::plc::percent;
use super::program::RunningProgram;
use super::sim::Sim;
use super::spindle::{InverterRamp, SpeedCommand, SpindleMode};
use crate::drives::{Bound, Rotation, SpeedLimits, SpeedRange};
use crate::msg;

/// Cap (r/min) on speeds, above any real spindle.
pub(super) const FASTEST: f64 = 1e9;

impl<P: RunningProgram> Sim<'_, P> {
    /// Carries out the spindle's next event.
    pub(super) fn spindle(&mut self, t: f64) {
        let changes = self.state.spindle.next_change() <= t;
        if self.state.spindle.sampled_at <= t {
            self.regulate_web(t);
        }
        if !changes {
            return;
        }
        if self.state.spindle.reached_at <= t {
            self.state.spindle.reached_at = f64::INFINITY;
            self.travel_on(t);
        }
        if let Some(surface) = &mut self.state.spindle.surface
            && surface.again <= t
        {
            surface.again = f64::INFINITY;
        }
        self.scan(t);
        self.update_path_speed(t);
    }

    /// Updates the spindle's command and scans the PLC on a change.
    pub(super) fn update_spindle_and_plc(&mut self, t: f64) {
        if self.update_command(t) {
            self.scan(t);
        }
    }

    /// Updates the spindle's command; returns whether it changed.
    pub(super) fn update_command(&mut self, t: f64) -> bool {
        if self.state.spindle.orienting.is_some() {
            return false;
        }
        let (now, later, span) = match self.following(t) {
            Some((now, later, span)) => {
                self.state.spindle.speed = later;
                if let Some(surface) = &mut self.state.spindle.surface {
                    surface.again = if span > 0.0 { t + span } else { f64::INFINITY };
                }
                (now, later, span)
            }
            None => (self.state.spindle.speed, self.state.spindle.speed, 0.0),
        };
        let (to, bound) = self.limited_speed(later);
        let from = if now == later { to } else { self.limited_speed(now).0 };
        let span = if from == to { 0.0 } else { span };
        let without_current = self.plant.is_without_current(t, &self.state.plc.signals);
        let stands = without_current || self.state.plc.orders.spindle.held;
        let rotation = match (self.state.spindle.rotation, self.state.plc.orders.spindle.shift_volts) {
            _ if stands => Rotation::Stopped,
            (Rotation::Stopped, Some(_)) => self.state.plc.orders.shift_rotation,
            (programmed, _) => programmed,
        };
        let last = self.out.timeline.ramps.last();
        // A drive with its current restored does not brake before its next speed command.
        let coasted = last.is_some_and(|last| last.command.coasts) && rotation == Rotation::Stopped;
        let coasts = without_current || coasted;
        let trim = if rotation == Rotation::Stopped { 0.0 } else { self.state.spindle.trim };
        let command = SpeedCommand { from, to, span, rotation, stage: self.gear(), bound, coasts, trim };
        let is_followed = |last: &InverterRamp| {
            let same = if span > 0.0 { last.t == t && command.agrees(&last.command) } else { command == last.command };
            same && last.control == SpindleMode::Speed
        };
        if last.is_some_and(is_followed) {
            return false;
        }
        let limited = self.state.spindle.surface.is_none() && command.rotation != Rotation::Stopped;
        if limited && bound.is_upper() {
            let wanted = now * self.override_share();
            let stage = command.stage;
            self.warn(Once::SpindleClamp, || match bound {
                Bound::Output => {
                    msg!("motion.output-full", commanded = wanted, stage = f64::from(stage), full = (to, 3))
                }
                _ => msg!("motion.spindle-clamp", commanded = wanted, clamp = to),
            });
        }
        self.put_ramp(t, command);
        self.update_path_speed(t);
        true
    }

    /// The gear stage reported by the PLC; 1 if the spindle lacks it.
    fn gear(&self) -> u8 {
        let gear = self.state.plc.orders.spindle.gear;
        if gear <= self.plant.spindle.stage_count { gear.max(1) } else { 1 }
    }

    /// The spindle override as a factor.
    pub(super) fn override_share(&self) -> f64 {
        let whole = self.state.exec.threads() && !self.plant.spindle.rules.thread_override;
        if whole { 1.0 } else { percent(self.state.plc.orders.spindle.percent) / 100.0 }
    }

    /// Speed (r/min) after override and limits, and the active limit.
    pub(super) fn limited_speed(&self, rpm: f64) -> (f64, Bound) {
        let (plant, turning) = (&self.plant.spindle, &self.state.spindle);
        let (stage, analog) = (plant.stage(self.gear()), plant.analog(self.gear()));
        if let Some(volts) = self.state.plc.orders.spindle.shift_volts {
            return (analog.speed(volts).min(FASTEST), Bound::Shift);
        }
        let mut set = turning.setting_limits;
        if plant.rules.lower_wins {
            set.high = set.high.max(set.low);
        }
        let mut limits = SpeedLimits { machine: plant.speed_clamp, gear: stage.range, set, ..SpeedLimits::NONE };
        if turning.surface.is_some() {
            limits.surface = SpeedRange::new(plant.surface_low, turning.surface_high);
            limits.gear.high = limits.gear.high.min(analog.stage_maximum());
        } else if plant.rules.surface_limit_stays {
            limits.surface.high = turning.surface_high;
        }
        let share = self.override_share();
        let (rpm, bound) = if plant.rules.override_last {
            let (rpm, bound) = limits.limit(rpm);
            let machine = SpeedLimits { machine: plant.speed_clamp, ..SpeedLimits::NONE }.limit(rpm * share);
            (machine.0, if bound == Bound::None { machine.1 } else { bound })
        } else {
            limits.limit(rpm * share)
        };
        // The output is limited to full voltage.
        let top = analog.top_speed();
        if rpm > top { (top, Bound::Output) } else { (rpm, bound) }
    }

    /// Starts a ramp from the present speed to the commanded one.
    pub(super) fn put_ramp(&mut self, t: f64, command: SpeedCommand) {
        let plant = &self.plant.spindle;
        let last = self.out.timeline.ramps.last();
        let (mut start, turns) = last.map_or((0.0, 0.0), |ramp| (ramp.speed(t), ramp.turns(plant, t)));
        let (from, target) = command.trimmed();
        let mut rate =
            if command.coasts { plant.coasting_rate(command.stage) } else { plant.acceleration(command.stage) };
        if command.span > 0.0 {
            if rate == f64::INFINITY {
                start = from;
            }
            rate = rate.min((target - start).abs() / command.span);
        }
        if let (Some(regulator), Some(last)) = (plant.regulator, last)
            && command.is_trimmed_anew(&last.command)
        {
            rate = rate.min((target - start).abs() / regulator.interval);
        }
        self.state.plc.signals.spindle_command = command.rotation.sign() * command.to;
        self.state.plc.signals.speed_trim = command.trim;
        let diameter_axis = self.state.spindle.diameter_axis;
        let ramp = InverterRamp { t, start, target, rate, turns, command, control: SpindleMode::Speed, diameter_axis };
        self.put(ramp);
    }

    /// Records a ramp and schedules its end as an event.
    pub(super) fn put(&mut self, ramp: InverterRamp) {
        let reached = ramp.reached();
        self.state.spindle.reached_at = if reached > ramp.t { reached } else { f64::INFINITY };
        self.out.timeline.ramps.set_from(ramp);
    }
}
