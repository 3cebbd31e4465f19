//! A main spindle with its motor on an inverter, in one gear stage, as the spindle sees it: run-up, braking, coasting.

use super::load::{self, Load};
use super::spindle_motor::MotorCurve;
use crate::math::RPM;

/// Everything that turns in a gear stage, and the motor that turns it. Torques and inertia at the spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MainSpindle {
    /// Speed of the spindle at 10 V, r/min.
    pub speed_at_10v: f64,
    /// Time (s) of the inverter's ramp from standstill to the speed at 10 V.
    pub ramp: f64,
    /// Chuck, work and rotor, against the friction.
    pub load_at_spindle: Load,
    /// The motor by its data sheet.
    pub motor: MotorCurve,
    /// Short-time torque as a share of the rated one at the same speed, in run-up and in braking.
    pub peak: [f64; 2],
}

impl MainSpindle {
    /// Short-time torque of the motor, in run-up and in braking.
    pub fn short_time(&self) -> [MotorCurve; 2] {
        self.peak.map(|share| self.motor.share(share))
    }

    /// Load of braking: friction helps the motor.
    fn braked(&self) -> Load {
        Load { torque: -self.load_at_spindle.torque, ..self.load_at_spindle }
    }

    /// Torque (Nm) that the run-up over the ramp asks: `J ω10 / t + M_f`. Source: turning spindle facts, 5.
    pub fn ramp_torque(&self) -> f64 {
        self.load_at_spindle.accelerating(0.0, self.speed_at_10v * RPM, self.ramp) + self.load_at_spindle.torque
    }

    /// The shortest ramp (s to the speed at 10 V) whose run-up and braking the motor has the torque for at a highest speed in
    /// r/min, where it has the least. Source: turning spindle facts, 5.
    pub fn shortest_ramp(&self, highest: f64) -> f64 {
        let [up, down] = self.short_time().map(|motor| motor.torque(highest));
        let ramp = |load: Load, torque: f64| load.shortest_ramp(0.0, self.speed_at_10v * RPM, torque);
        ramp(self.load_at_spindle, up).max(ramp(self.braked(), down))
    }

    /// Seconds to a speed in r/min with the short-time torque of the motor.
    pub fn run_up(&self, rpm: f64) -> f64 {
        let [motor, _] = self.short_time();
        motor.seconds_to(rpm, self.load_at_spindle.inertia, self.load_at_spindle.torque)
    }

    /// Braking time (s) from a speed in r/min to rest.
    pub fn braking(&self, rpm: f64) -> f64 {
        let ([_, motor], braked) = (self.short_time(), self.braked());
        motor.seconds_to(rpm, braked.inertia, braked.torque)
    }

    /// Coasting time (s) without current from a speed in r/min to rest: friction alone slows the spindle. Source: sizing facts 2.2.
    pub fn coasting(&self, rpm: f64) -> f64 {
        load::coasting(self.load_at_spindle.inertia, rpm * RPM, self.load_at_spindle.torque)
    }

    /// Energy (J) that a stop over the ramp from a speed in r/min gives back, less what friction takes; 0 where that takes all. Source:
    /// sizing facts 2.4.
    pub fn stop_energy(&self, rpm: f64) -> f64 {
        self.load_at_spindle.stop_energy(0.0, rpm * RPM, self.ramp * rpm / self.speed_at_10v).max(0.0)
    }
}
