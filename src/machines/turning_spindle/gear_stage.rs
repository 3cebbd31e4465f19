//! Motor and rotating parts reduced to the spindle in a gear stage.

use super::params::{Params, Path};
use crate::drives::MainSpindle;
use crate::drives::inertia::Cylinder;
use crate::drives::spindle_motor::MotorCurve;
use crate::machines::lathe::main_spindle::SpindleGear;

impl Params {
    /// The gear stage of `stage_speed` r/min at 10 V.
    pub(super) fn spindle_gear(&self, stage_speed: f64) -> SpindleGear {
        SpindleGear { speed_at_10v: stage_speed, efficiency: self.efficiency }
    }

    /// The motor at the spindle in a gear stage of `stage_speed` r/min at 10 V, by its data sheet.
    pub(super) fn motor(&self, stage_speed: f64) -> MotorCurve {
        self.spindle.motor(self.spindle_gear(stage_speed))
    }

    /// Continuous curve of the motor at the spindle, derated for its site and for a fan on its shaft.
    pub(super) fn continuous(&self, stage_speed: f64) -> MotorCurve {
        self.spindle.continuous(self.spindle_gear(stage_speed), self.site_share)
    }

    /// Moment of inertia (kg m²) of the stock, a solid cylinder at least as long as the cut. Source: sizing facts 2.1.
    pub(super) fn work_inertia(&self) -> f64 {
        let cut = if self.path == Path::Facing { 0.0 } else { self.length };
        let (outer, length) = (self.stock_diameter / 1000.0, self.work_length.max(cut) / 1000.0);
        Cylinder { outer, inner: 0.0, length, density: self.work_density }.inertia()
    }

    /// The spindle with its motor in a gear stage of `stage_speed` r/min at 10 V. Chuck, work and rotor as the spindle sees them:
    /// `J = J_spindle + J_work + J_rotor (n_m / n10)²`. Source: sizing facts 2.1.
    pub(super) fn main_spindle(&self, stage_speed: f64) -> MainSpindle {
        self.spindle.main_spindle(self.spindle_gear(stage_speed), self.spindle_inertia + self.work_inertia())
    }
}
