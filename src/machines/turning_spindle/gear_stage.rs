//! Motor and rotating parts as the spindle sees them in a gear stage.

use super::params::{Params, Path};
use crate::drives::MainSpindle;
use crate::drives::inertia::{Cylinder, through_gear};
use crate::drives::load::Load;
use crate::drives::spindle_motor::MotorCurve;

impl Params {
    /// The motor at the spindle in a gear stage of `stage_speed` r/min at 10 V, by its data sheet.
    pub(super) fn motor(&self, stage_speed: f64) -> MotorCurve {
        MotorCurve::new(self.motor_power, self.efficiency / 100.0, (self.motor_base, self.motor_top), stage_speed)
    }

    /// Continuous curve of the motor at the spindle, derated for its site and for a fan on its shaft.
    pub(super) fn continuous(&self, stage_speed: f64) -> MotorCurve {
        self.motor(stage_speed).share(self.site_share / 100.0).with_shaft_fan(!self.forced_cooling)
    }

    /// Moment of inertia (kg m²) of the stock, a solid cylinder that is as long as the cut at least. Source: sizing facts 2.1.
    pub(super) fn work_inertia(&self) -> f64 {
        let cut = if self.path == Path::Facing { 0.0 } else { self.length };
        let (outer, length) = (self.stock_diameter / 1000.0, self.work_length.max(cut) / 1000.0);
        Cylinder { outer, inner: 0.0, length, density: self.work_density }.inertia()
    }

    /// Chuck, work and rotor as the spindle sees them in a gear stage of `stage_speed` r/min at 10 V, against its friction:
    /// `J = J_spindle + J_work + J_rotor (n_m / n10)²`. Source: sizing facts 2.1.
    pub(super) fn load_at_spindle(&self, stage_speed: f64) -> Load {
        let rotor = through_gear(self.rotor_inertia, stage_speed / self.motor_top);
        Load {
            inertia: self.spindle_inertia + self.work_inertia() + rotor,
            torque: self.spindle_friction,
            efficiency: 1.0,
        }
    }

    /// The spindle with its motor in a gear stage of `stage_speed` r/min at 10 V.
    pub(super) fn main_spindle(&self, stage_speed: f64) -> MainSpindle {
        MainSpindle {
            speed_at_10v: stage_speed,
            ramp: self.spindle_ramp,
            load_at_spindle: self.load_at_spindle(stage_speed),
            motor: self.motor(stage_speed),
            peak: [self.motor_peak, self.motor_braking].map(|percent| percent / 100.0),
        }
    }
}
