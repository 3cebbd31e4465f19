//! The motor and the encoder of a spindle in a run.

use super::resistor::{ResistorDemand, WITHOUT_RESISTOR};
use crate::drives::ShortTime;
use crate::drives::shaft_motion::{Motion, OperatingPoint};
use crate::drives::spindle_motor::MotorCurve;

/// The motor of a main spindle in a part of a run: cut, friction and acceleration together. Torques at its shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct SpindleRun {
    /// Catalog id of the name of its drive.
    pub name: &'static str,
    /// Motion of its shaft, without the rotor: friction and cut, and the inertia of chuck and work.
    pub motion: Motion,
    /// The same motion in a run without stock: no cut helps to brake.
    pub idle: Motion,
    /// Inertia of the form's rotor, kg m².
    pub rotor: f64,
    /// The form's motor by its data sheet.
    pub motor: MotorCurve,
    /// Short-time torque of the motor.
    pub short_time: ShortTime,
}

impl SpindleRun {
    /// The operating point with the largest fraction of the short-time torque of a motor with this curve and rotor (kg m²), with and
    /// without stock.
    pub fn worst_point(&self, motor: &MotorCurve, rotor: f64) -> OperatingPoint {
        let (cut, idle) = (self.under(&self.motion, motor, rotor), self.worst_point_idle(motor, rotor));
        if idle.share > cut.share { idle } else { cut }
    }

    /// The operating point with the largest fraction in a run without stock, where only the ramps load the motor.
    pub fn worst_point_idle(&self, motor: &MotorCurve, rotor: f64) -> OperatingPoint {
        self.under(&self.idle, motor, rotor)
    }

    fn under(&self, motion: &Motion, motor: &MotorCurve, rotor: f64) -> OperatingPoint {
        motion.worst_point_under(rotor, |brakes, speed| self.short_time.at(brakes) * motor.torque(speed))
    }

    /// The greatest share of the torque that the rated current of a motor with this curve and rotor (kg m²) gives at the same speed, with
    /// and without stock.
    pub fn share_of_rated(&self, motor: &MotorCurve, rotor: f64) -> f64 {
        let share = |motion: &Motion| motion.worst_point_under(rotor, |_, speed| motor.torque(speed)).share;
        share(&self.motion).max(share(&self.idle))
    }

    /// The brake resistor needed for a braking torque (`percent` of the rated one) of the form: all energy returned in
    /// a run without stock, over the run and its pause (s).
    pub fn resistor(&self, percent: f64, pause: f64) -> Option<ResistorDemand> {
        let energies = self.idle.returns(self.rotor);
        let seconds: f64 = self.idle.segments().iter().map(|segment| segment.seconds).sum();
        let is_asked = percent > WITHOUT_RESISTOR && !energies.is_empty();
        is_asked.then_some(ResistorDemand { name: self.name, percent, energies, cycle: seconds + pause })
    }

    /// The operating point of cut and friction with the largest fraction of the torque that this curve gives.
    pub fn worst_point_steady(&self, motor: &MotorCurve) -> OperatingPoint {
        self.motion.clone().without_inertia().worst_point_under(0.0, |_, speed| motor.torque(speed))
    }
}

/// Demand on the encoder of a spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpindleEncoder {
    /// Catalog id of the name of its drive.
    pub name: &'static str,
    /// Greatest speed of the encoder, r/min.
    pub speed: f64,
    /// Lines per turn of the encoder.
    pub lines: f64,
}
