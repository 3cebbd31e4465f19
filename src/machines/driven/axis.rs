//! The servo motor of an axis for the sizing: its load, and its motion in a run.

use super::fields::MotorFields;
use super::gear::{FormGear, pulled_taut};
use crate::drives::holding_brake;
use crate::drives::load::Load;
use crate::drives::servo::FittedMotor;
use crate::drives::shaft_motion::{CutSpan, Motion, SpeedSegment, Strikes};
use crate::motion::{Mover, RunSegment};

/// A servo motor of a machine, and the source of its motion in a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrivenAxis {
    /// Id, for instance `x`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub name: &'static str,
    /// Source of its motion in a run.
    pub mover: Mover,
    /// Angle of the motor (rad) per unit of the run: per millimetre or degree.
    pub radians_per_unit: f64,
    /// Load at the motor's shaft, without the rotor.
    pub load: Load,
    /// Torque at standstill, Nm.
    pub standstill_torque: f64,
    /// Torque (Nm) of a weight that it lifts in the positive direction, besides `standstill_torque`; 0 without one.
    pub weight: f64,
    /// Its interrupted cut.
    pub strikes: Strikes,
    /// Greatest additional torque (Nm) at steady speed that no planned run shows: a web pulled taut after a start. 0 without one.
    pub taut_torque: f64,
    /// Torque (Nm) of the cut while the machine works, besides the steady torque of the load; none if the load's torque already includes
    /// the work.
    pub cut: Option<f64>,
    /// Continuous torque (Nm) of the heaviest cut with friction and weight, without a pause; none where no cut adds to
    /// the load.
    pub continuous_cut_torque: Option<f64>,
    /// Starts per minute by the formulas, while the work lasts; 0 where only the starts of the run count.
    pub starts_per_minute: f64,
    /// The gear unit between motor and load, if it is a purchased part.
    pub gear: Option<FormGear>,
    /// The motor that the form has.
    pub fitted: FittedMotor,
    /// Share of its continuous torque that the site leaves a motor, 0 to 1.
    pub site_share: f64,
    /// Fields of the form that take another motor; none where the form has the power of the drive alone.
    pub fields: Option<&'static MotorFields>,
}

impl DrivenAxis {
    /// Greatest distance (in units of the run) that the axis sinks under its weight from rest until the brake at its
    /// motor has closed; none without a weight.
    pub fn sinks(&self) -> Option<f64> {
        let inertia = self.load.inertia + self.fitted.motor.rotor;
        (self.weight > 0.0).then(|| holding_brake::turn_until_closed(self.weight, inertia) / self.radians_per_unit)
    }

    /// The motion of the motor's shaft in a part of a run. The torque of its work acts within the spans `works` (s);
    /// without spans always.
    pub fn motion(&self, segments: &[RunSegment], works: Option<&[(f64, f64)]>) -> Motion {
        let motion = Motion::new(speed_segments(segments, self.radians_per_unit), self.load, self.standstill_torque)
            .with_weight(self.weight)
            .with_strikes(pulled_taut(self.strikes, self.taut_torque));
        match (works, self.cut) {
            (None, _) => motion,
            (Some(works), None) => motion.with_loaded_spans(works.to_vec()),
            (Some(works), Some(torque)) => {
                motion.with_cuts(works.iter().map(|&(begin, end)| CutSpan { begin, end, torque }).collect())
            }
        }
    }
}

/// Stretches of a run as segments of the speed of a shaft; `per_unit`: angle of the shaft (rad) per unit of the run.
pub fn speed_segments(segments: &[RunSegment], per_unit: f64) -> impl Iterator<Item = SpeedSegment> {
    segments.iter().map(move |segment| SpeedSegment {
        t: segment.t,
        seconds: segment.seconds,
        from: segment.from * per_unit,
        to: segment.to * per_unit,
    })
}
