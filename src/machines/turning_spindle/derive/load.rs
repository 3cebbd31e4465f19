//! Power and torque of cut and friction, and the continuous ratings of the motor for them.

use super::cut::CutGeometry;
use super::limits::LimitDiameters;
use super::speeds::CutSpeeds;
use super::stage::EngagedStage;
use crate::drives::spindle_motor;
use crate::machines::turning_spindle::params::Params;

/// Load of cut and friction, without acceleration.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::turning_spindle) struct SteadyLoad {
    /// Greatest power of cut and friction, and continuous power of the motor, kW.
    pub power: f64,
    pub power_available: f64,
    /// Torque of cut and friction at the largest diameter of the whole depth, and continuous torque of the motor at the spindle there, Nm.
    pub torque: f64,
    pub torque_available: f64,
}

impl SteadyLoad {
    pub(super) fn new(
        p: &Params,
        cut: &CutGeometry,
        stage: &EngagedStage,
        limits: &LimitDiameters,
        speeds: &CutSpeeds,
    ) -> SteadyLoad {
        let motor = p.continuous(stage.speed);
        let power = |diameter: f64| spindle_motor::power(p.steady_torque(diameter), speeds.at(p, diameter));
        SteadyLoad {
            power: limits.hardest(cut, speeds, f64::INFINITY).map(power).into_iter().fold(0.0, f64::max),
            power_available: motor.power,
            torque: p.steady_torque(cut.largest_whole),
            torque_available: motor.torque(speeds.largest_whole),
        }
    }
}
