//! Motor and rotating parts as the spindle sees them in a gear stage.

use super::params::{Params, Path};
use crate::drives::MainSpindle;
use crate::drives::inertia::{Cylinder, through_gear};
use crate::drives::load::Load;
use crate::drives::spindle_motor::MotorCurve;

impl Params {
    /// The motor at the spindle in a gear stage of `rated` r/min at 10 V, by its data sheet.
    pub(super) fn motor(&self, rated: f64) -> MotorCurve {
        MotorCurve::new(self.motor_power, self.efficiency / 100.0, (self.motor_base, self.motor_top), rated)
    }

    /// Continuous curve of the motor at the spindle, derated for its site and for its own fan.
    pub(super) fn continuous(&self, rated: f64) -> MotorCurve {
        self.motor(rated).share(self.site_share / 100.0).with_own_fan(!self.forced_cooling)
    }

    /// Moment of inertia (kg m²) of the stock, a solid cylinder that is as long as the cut at least. Source: sizing facts 2.1.
    pub(super) fn work_inertia(&self) -> f64 {
        let cut = if self.path == Path::Facing { 0.0 } else { self.length };
        let (outer, length) = (self.stock_diameter / 1000.0, self.work_length.max(cut) / 1000.0);
        Cylinder { outer, inner: 0.0, length, density: self.work_density }.inertia()
    }

    /// Chuck, work and rotor as the spindle sees them in a gear stage of `rated` r/min at 10 V, against its friction:
    /// `J = J_spindle + J_work + J_rotor (n_m / n10)²`. Source: sizing facts 2.1.
    pub(super) fn turned(&self, rated: f64) -> Load {
        let rotor = through_gear(self.rotor_inertia, rated / self.motor_top);
        Load {
            inertia: self.spindle_inertia + self.work_inertia() + rotor,
            torque: self.spindle_friction,
            efficiency: 1.0,
        }
    }

    /// Seconds in which the spindle coasts to rest from `rpm` in a gear stage: friction alone slows it. Source: sizing facts 2.2.
    pub(super) fn coasting(&self, rated: f64, rpm: f64) -> f64 {
        self.main_spindle(rated).coasting(rpm)
    }

    /// Short-time torque of the motor at the spindle, in run-up and in braking.
    pub(super) fn for_moments(&self, rated: f64) -> [MotorCurve; 2] {
        self.main_spindle(rated).short_time()
    }

    /// The spindle with its motor in a gear stage of `rated` r/min at 10 V.
    pub(super) fn main_spindle(&self, rated: f64) -> MainSpindle {
        MainSpindle {
            rated,
            ramp: self.spindle_ramp,
            turned: self.turned(rated),
            motor: self.motor(rated),
            peak: [self.motor_peak, self.motor_braking].map(|percent| percent / 100.0),
        }
    }
}
