//! The spindle over time: straight ramps toward the command, slip, and the exact count of turns.

use super::plant::SpindlePlant;
use super::snapshot::SpindleState;
use super::track::Timed;
use crate::drives::Analog;
use crate::math;

/// From `t` until the next segment the inverter runs from `start` toward `target`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ramp {
    /// Seconds.
    pub(super) t: f64,
    /// Speed at `t` behind the ramp, before slip, signed, r/min.
    pub(super) start: f64,
    /// Speed at the end of the ramp, signed, r/min.
    pub(super) target: f64,
    /// Commanded speed, signed, r/min.
    pub(super) command: f64,
    /// Turns at `t`.
    pub(super) turns: f64,
}

impl Timed for Ramp {
    fn t(&self) -> f64 {
        self.t
    }
}

impl SpindlePlant {
    /// The analog output.
    pub fn analog(&self) -> Analog {
        Analog { speed_at_full: self.speed_at_full, volts_full: self.volts_full, bits: self.output_bits }
    }

    /// Seconds from one speed to another.
    fn ramp_time(&self, from: f64, to: f64) -> f64 {
        if self.ramp > 0.0 && self.speed_at_full > 0.0 {
            (to - from).abs() / self.speed_at_full * self.ramp
        } else {
            0.0
        }
    }

    /// Speed of the motor: `gain · n`, less `slip · speed_at_full` toward standstill. A motor that is driven along (negative slip)
    /// runs at most twice as fast as without, so that it starts from 0 without a jump.
    fn slipped(&self, speed: f64) -> f64 {
        let free = self.gain * speed;
        free - math::clamp(self.slip * self.speed_at_full, -free.abs(), free.abs()) * free.signum()
    }

    /// `∫ slipped(n) dn` from 0.
    fn slipped_area(&self, speed: f64) -> f64 {
        let (free, lost) = ((self.gain * speed).abs(), self.slip * self.speed_at_full);
        let area = if lost >= 0.0 {
            let left = (free - lost).max(0.0);
            0.5 * left * left
        } else {
            let low = free.min(-lost);
            low * low + 0.5 * (free * free - low * low) - lost * (free - low)
        };
        area / self.gain
    }
}

impl Ramp {
    /// When the ramp is over.
    pub(super) fn reached(&self, plant: &SpindlePlant) -> f64 {
        self.t + plant.ramp_time(self.start, self.target)
    }

    /// Speed behind the ramp, before slip, signed.
    pub(super) fn speed(&self, plant: &SpindlePlant, t: f64) -> f64 {
        let whole = plant.ramp_time(self.start, self.target);
        let part = t - self.t;
        if part < whole { self.start + (self.target - self.start) * (part / whole) } else { self.target }
    }

    /// Speed of the motor, signed.
    pub(super) fn actual(&self, plant: &SpindlePlant, t: f64) -> f64 {
        plant.slipped(self.speed(plant, t))
    }

    /// Turns since the run began.
    pub(super) fn turns(&self, plant: &SpindlePlant, t: f64) -> f64 {
        let whole = plant.ramp_time(self.start, self.target);
        let part = math::clamp(t - self.t, 0.0, whole);
        let mut minutes_rpm = (t - self.t - part) * plant.slipped(self.target);
        if part > 0.0 {
            let area = plant.slipped_area(self.speed(plant, t)) - plant.slipped_area(self.start);
            minutes_rpm += area * whole / (self.target - self.start);
        }
        self.turns + minutes_rpm / 60.0
    }

    /// The spindle at `t`.
    pub(super) fn state(&self, plant: &SpindlePlant, t: f64) -> SpindleState {
        let analog = plant.analog();
        SpindleState {
            command: self.command,
            actual: self.actual(plant, t),
            volts_command: analog.command(self.command),
            volts: analog.output(self.command),
            turns: self.turns(plant, t),
        }
    }
}
