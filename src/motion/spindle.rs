//! The spindle over time: straight ramps toward the command, slip, and the exact count of turns.

use super::plant::SpindlePlant;
use super::snapshot::SpindleState;
use super::time_series::Timed;
use crate::drives::orient::turn;
use crate::drives::{Bound, Rotation};
use crate::math;

/// Commanded speed of the spindle. Equal commands give the same ramp.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct SpeedCommand {
    /// Speed in r/min without sign, now and `span` seconds later. Under constant surface speed it changes linearly in between.
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) span: f64,
    pub(super) rotation: Rotation,
    /// Gear stage, from 1.
    pub(super) stage: u8,
    /// Limit that acts on the speed.
    pub(super) bound: Bound,
    /// The drive supplies no current: the spindle coasts to rest.
    pub(super) coasts: bool,
    /// Trim by the inverter's regulator, as a fraction of the speed; 0 at standstill. Speed and volts of the control do not include it.
    pub(super) trim: f64,
}

impl SpeedCommand {
    /// Signed speeds (r/min) for the inverter, now and after the span: the commanded ones with the trim.
    pub(super) fn trimmed(&self) -> (f64, f64) {
        let factor = self.rotation.sign() * (1.0 + self.trim);
        (factor * self.from, factor * self.to)
    }

    /// Whether this command differs from the last one by its trim alone.
    pub(super) fn is_trimmed_anew(&self, last: &SpeedCommand) -> bool {
        self.trim != last.trim && SpeedCommand { trim: last.trim, ..*self } == *last
    }

    /// Relative difference of two commands at one time below which speed and feed have settled: far below the curvature of the speed
    /// between two steps, and far above rounding errors.
    const AGREED: f64 = 1e-9;

    /// Whether this command, computed again at the same time, has settled.
    pub(super) fn agrees(&self, last: &SpeedCommand) -> bool {
        let is_near = |a: f64, b: f64| (a - b).abs() <= SpeedCommand::AGREED * b.abs();
        let is_same = SpeedCommand { from: last.from, to: last.to, span: last.span, ..*self } == *last;
        is_same && is_near(self.from, last.from) && is_near(self.to, last.to) && is_near(self.span, last.span)
    }
}

/// Control mode of the spindle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum SpindleMode {
    /// Speed control through the inverter, with slip.
    #[default]
    Speed,
    /// Travel to an angle, in position control.
    Position,
    /// Held at an angle.
    Held,
}

/// Ramp of the inverter from `start` toward `target`, valid from `t` until the next segment.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct InverterRamp {
    /// Seconds.
    pub(super) t: f64,
    /// Speed at `t` after the ramp and before slip, signed, r/min.
    pub(super) start: f64,
    /// Speed at the end of the ramp, signed, r/min.
    pub(super) target: f64,
    /// Change of speed in r/min per second.
    pub(super) rate: f64,
    /// Turns at `t`.
    pub(super) turns: f64,
    /// The command followed by the ramp.
    pub(super) command: SpeedCommand,
    pub(super) control: SpindleMode,
    /// The axis perpendicular to the spindle, and its position in mm at diameter 0.
    pub(super) diameter_axis: Option<(u8, f64)>,
}

impl Timed for InverterRamp {
    fn t(&self) -> f64 {
        self.t
    }
}

/// Motor speed after an inverter: `gain · n`, reduced by `lost` toward standstill. With negative `lost` (a motor driven by its load) the
/// speed is at most doubled, so that it starts from 0 without a step.
#[derive(Clone, Copy)]
pub(super) struct Slip {
    pub(super) gain: f64,
    pub(super) lost: f64,
}

impl Slip {
    fn speed(self, speed: f64) -> f64 {
        let free = self.gain * speed;
        free - math::clamp(self.lost, -free.abs(), free.abs()) * free.signum()
    }

    /// `∫ speed(n) dn` from 0.
    fn area(self, speed: f64) -> f64 {
        let (free, lost) = ((self.gain * speed).abs(), self.lost);
        let area = if lost >= 0.0 {
            let left = (free - lost).max(0.0);
            0.5 * left * left
        } else {
            let low = free.min(-lost);
            low * low + 0.5 * (free * free - low * low) - lost * (free - low)
        };
        area / self.gain
    }

    /// Whether the motor speed is linear between two inverter speeds.
    fn straight(self, a: f64, b: f64) -> bool {
        self.lost == 0.0 || a * b > 0.0 && self.gain * a.abs().min(b.abs()) >= self.lost.abs()
    }
}

impl InverterRamp {
    /// Duration (s) of the ramp.
    fn whole(&self) -> f64 {
        let change = (self.target - self.start).abs();
        if change > 0.0 && self.rate > 0.0 { change / self.rate } else { 0.0 }
    }

    /// End (s) of the ramp.
    pub(super) fn reached(&self) -> f64 {
        self.t + self.whole()
    }

    /// Speed after the ramp and before slip, signed, r/min.
    pub(super) fn speed(&self, t: f64) -> f64 {
        // Computed like the ramp's end time, so that the end speed is exact at that time.
        let whole = self.whole();
        if t < self.t + whole {
            self.start + (self.target - self.start) * ((t - self.t) / whole).min(1.0)
        } else {
            self.target
        }
    }

    /// Time (s) from which the speed is within a fraction of its target.
    pub(super) fn within(&self, part: f64) -> f64 {
        let left = (self.target - self.start).abs() - part * self.target.abs();
        if left > 0.0 && self.rate > 0.0 { self.t + left / self.rate } else { self.t }
    }

    pub(super) fn slip(&self, plant: &SpindlePlant) -> Slip {
        match self.control {
            SpindleMode::Speed => Slip { gain: plant.gain, lost: plant.slip * plant.stage(self.command.stage).rated },
            _ => Slip { gain: 1.0, lost: 0.0 },
        }
    }

    /// Speed of the spindle, signed, r/min.
    pub(super) fn actual(&self, plant: &SpindlePlant, t: f64) -> f64 {
        self.slip(plant).speed(self.speed(t))
    }

    /// Turns since the start of the run.
    pub(super) fn turns(&self, plant: &SpindlePlant, t: f64) -> f64 {
        let (slip, whole) = (self.slip(plant), self.whole());
        let part = math::clamp(t - self.t, 0.0, whole);
        let mut minutes_rpm = (t - self.t - part) * slip.speed(self.target);
        if part > 0.0 {
            let now = self.speed(t);
            minutes_rpm += if slip.straight(self.start, now) {
                0.5 * (slip.speed(self.start) + slip.speed(now)) * part
            } else {
                (slip.area(now) - slip.area(self.start)) * whole / (self.target - self.start)
            };
        }
        self.turns + minutes_rpm / 60.0
    }

    /// Commanded speed without sign, r/min.
    fn commanded(&self, t: f64) -> f64 {
        let SpeedCommand { from, to, span, .. } = self.command;
        if t < self.t + span { from + (to - from) * ((t - self.t) / span) } else { to }
    }

    /// State of the spindle at `t` (s); `place` gives the position of an axis.
    pub(super) fn state(&self, plant: &SpindlePlant, t: f64, place: impl Fn(usize) -> f64) -> SpindleState {
        let (analog, speed) = (plant.analog(self.command.stage), self.commanded(t));
        let command = speed * self.command.rotation.sign();
        let out = if plant.rules.volts_stay && self.command.rotation == Rotation::Stopped { speed } else { command };
        let (actual, turns) = (self.actual(plant, t), self.turns(plant, t));
        let diameter = self.diameter_axis.map(|(axis, zero)| 2.0 * (place(usize::from(axis)) - zero).abs());
        SpindleState {
            command,
            actual,
            volts_command: analog.command(out),
            volts: analog.output(out),
            turns,
            // Rounded, so that whole turns give 0 and not 359.99….
            angle: turn((turns * 360e9).round() / 1e9),
            held: self.control == SpindleMode::Held,
            stage: self.command.stage,
            bound: self.command.bound,
            surface_speed: diameter.map(|diameter| crate::drives::speed::surface_speed(actual, diameter)),
        }
    }
}
