//! A main spindle with its motor on an inverter, in one gear stage, as the spindle sees it: run-up, braking, coasting.

use super::load::{self, Load};
use super::spindle_motor::MotorCurve;
use crate::math::RPM;

/// Short-time torque of a motor as a share of the rated one at the same speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShortTime {
    /// In run-up and cut.
    pub driving: f64,
    /// In braking.
    pub braking: f64,
}

impl ShortTime {
    /// The share where the motor brakes, or drives.
    pub fn at(self, brakes: bool) -> f64 {
        if brakes { self.braking } else { self.driving }
    }
}

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
    /// Its short-time torque.
    pub short_time: ShortTime,
}

impl MainSpindle {
    /// Short-time torque of the motor in run-up and cut.
    pub fn driving_motor(&self) -> MotorCurve {
        self.motor.share(self.short_time.driving)
    }

    /// Short-time torque of the motor in braking.
    pub fn braking_motor(&self) -> MotorCurve {
        self.motor.share(self.short_time.braking)
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
        let [up, down] = [self.driving_motor(), self.braking_motor()].map(|motor| motor.torque(highest));
        let ramp = |load: Load, torque: f64| load.shortest_ramp(0.0, self.speed_at_10v * RPM, torque);
        ramp(self.load_at_spindle, up).max(ramp(self.braked(), down))
    }

    /// Seconds to a speed in r/min with the short-time torque of the motor.
    pub fn run_up_time(&self, rpm: f64) -> f64 {
        self.driving_motor().seconds_to(rpm, self.load_at_spindle.inertia, self.load_at_spindle.torque)
    }

    /// Braking time (s) from a speed in r/min to rest.
    pub fn braking(&self, rpm: f64) -> f64 {
        let braked = self.braked();
        self.braking_motor().seconds_to(rpm, braked.inertia, braked.torque)
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
