//! The motor on an inverter: its load, its run-up and its stop.

use super::axis::speed_segments;
use super::fields::InductionFields;
use super::gear::FormGear;
use crate::drives::ShortTime;
use crate::drives::load::{Load, Move, Phase};
use crate::drives::shaft_motion::{Motion, SpeedSegment};
use crate::drives::spindle_motor::MotorCurve;
use crate::math::RPM;
use crate::motion::RunSegment;

/// Frequency and speed of a motor on an inverter at the full analog signal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FullSignal {
    /// Frequency, Hz.
    pub frequency: f64,
    /// Speed without load, r/min.
    pub no_load: f64,
}

/// Demand on the motor on the inverter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InverterDrive {
    /// Id, for instance `unwinder`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub name: &'static str,
    /// Continuous torque at the motor's shaft, Nm.
    pub torque: f64,
    /// Speed of the motor under that torque, r/min.
    pub speed: f64,
    /// Highest speed at which the machine runs the motor, r/min.
    pub top_speed: f64,
    /// Share of its rated torque and power that the site leaves the motor, 0 to 1.
    pub site_share: f64,
    /// Torque of the brake at the motor that closes without current, Nm; 0 without one.
    pub brake: f64,
    /// Run-up and stop, if the cycle includes them.
    pub cycle: Option<InverterCycle>,
    /// Radians per second of the motor per r/min of the spindle in a run.
    pub radians_per_rpm: f64,
    /// Load at the motor's shaft, without the rotor: inertia, and torque besides that of the work.
    pub load_at_motor: Load,
    /// Inertia of its rotor, kg m²; 0 if the load includes it.
    pub rotor: f64,
    /// The gear unit between motor and load, if it is a purchased part.
    pub gear: Option<FormGear>,
    /// Its frequency and speed at the full analog signal; none if its speed is not commanded in an open loop.
    pub full: Option<FullSignal>,
    /// Lowest speed (r/min) at which the fan on its shaft has to cool it; none with forced cooling, or if that speed is
    /// not known.
    pub cooled_at: Option<f64>,
    /// Fields of the form that take another motor.
    pub fields: Option<&'static InductionFields>,
}

impl InverterDrive {
    /// Continuous curve of a motor at its site, and with the fan on its shaft where the drive has no forced cooling.
    pub fn continuous(&self, motor: &MotorCurve) -> MotorCurve {
        motor.share(self.site_share).with_shaft_fan(self.cooled_at.is_some())
    }

    /// Motion of the motor's shaft in a part of a run; for a main spindle without the torque of its cut.
    pub fn motion(&self, segments: &[RunSegment]) -> Motion {
        Motion::new(speed_segments(segments, self.radians_per_rpm), self.load_at_motor, 0.0)
    }

    /// Segments of the speed of the motor's shaft in run-up, work and stop; only of the work if there is no cycle of
    /// ramps.
    pub fn speed_segments(&self) -> Vec<SpeedSegment> {
        let speed = self.speed.abs() * RPM;
        let steady = |t: f64, seconds: f64| SpeedSegment { t, seconds, from: speed, to: speed };
        match self.cycle {
            None => vec![steady(0.0, 1.0)],
            Some(InverterCycle { motion, .. }) => {
                let rise = SpeedSegment { t: 0.0, seconds: motion.ramp, from: 0.0, to: speed };
                let fall = SpeedSegment {
                    t: motion.ramp + motion.seconds_at_speed,
                    seconds: motion.ramp,
                    from: speed,
                    to: 0.0,
                };
                vec![rise, steady(motion.ramp, motion.seconds_at_speed), fall]
            }
        }
    }
}

/// Run-up and stop of a motor on an inverter, with its work between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InverterCycle {
    /// Load of the ramps, at the motor's shaft and without the rotor.
    pub load: Load,
    /// Inertia (kg m²) assumed for the rotor of a motor whose data sheet has none; none if `load` includes the rotor.
    pub rotor: Option<f64>,
    /// Its ramps, and the time of the work between them.
    pub motion: Move,
    /// Short-time torque of the motor in the run-up and in the stop.
    pub short_time: ShortTime,
}

impl InverterCycle {
    /// Torques of run-up and stop with a rotor, signed.
    pub fn ramps(&self, rotor: Option<f64>) -> [Phase; 2] {
        let [rise, _, fall, _] = self.load.phases(self.rotor.map_or(0.0, |own| rotor.unwrap_or(own)), self.motion);
        [rise, fall]
    }
}
