//! Load of a motion on a gear unit, and the check against its ratings: torque at the output, speed at the input.

use super::parts::GearRatings;
use super::shaft_motion::Motion;
use crate::math::{self, RPM};

/// Load on a gear unit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GearDuty {
    /// Greatest torque at the output, Nm.
    pub peak: f64,
    /// Mean torque at the output for the life of teeth and bearings, Nm.
    pub mean: f64,
    /// Greatest speed at the input, r/min.
    pub speed: f64,
    /// Mean speed at the input, including standstill, r/min.
    pub mean_speed: f64,
}

impl GearDuty {
    /// Load of a motion of the output on a gear of this ratio.
    pub fn new(output: &Motion, ratio: f64) -> GearDuty {
        let load = output.motor_load(0.0);
        GearDuty {
            peak: load.peak.torque,
            mean: lasting(output),
            speed: load.speed / RPM * ratio,
            mean_speed: output.mean_speed() * ratio,
        }
    }

    /// The greater of each figure.
    pub fn max(self, other: GearDuty) -> GearDuty {
        GearDuty {
            peak: self.peak.max(other.peak),
            mean: self.mean.max(other.mean),
            speed: self.speed.max(other.speed),
            mean_speed: self.mean_speed.max(other.mean_speed),
        }
    }
}

/// Mean torque in Nm with the same wear of a gear unit as the motion: `∛(Σ |n| t |T|³ / Σ |n| t)`, the selection criterion of makers of
/// planetary gear units; 0 at standstill. Source: their catalogues, from memory.
fn lasting(output: &Motion) -> f64 {
    let (mut sum, mut way) = (0.0, 0.0);
    for segment in output.segments() {
        let turned = 0.5 * (segment.from + segment.to).abs() * segment.seconds;
        let torque = output.torque(segment, 0.0).abs();
        sum += turned * torque * torque * torque;
        way += turned;
    }
    if way > 0.0 { math::pow(sum / way, 1.0 / 3.0) } else { 0.0 }
}

/// Reason for rejecting a gear unit, with the required and the allowed value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GearRefusal {
    /// Backlash of the unit, and the largest assumed one, minutes of arc.
    Backlash(f64, f64),
    /// Mean speed at the input, r/min.
    MeanSpeed(f64, f64),
    /// Greatest speed at the input, r/min.
    Speed(f64, f64),
    /// Mean torque at the output, Nm.
    Mean(f64, f64),
    /// Greatest torque at the output, Nm.
    Peak(f64, f64),
    /// Torque or speed rating is unknown.
    Unknown,
}

impl GearRatings {
    /// The first reason for rejecting the unit, `None` if it is suitable. `backlash` (minutes of arc) is the largest assumed one, if any. A
    /// missing rating rejects the unit if no other rating replaces it.
    pub fn refuses(&self, asked: &GearDuty, backlash: Option<f64>) -> Option<GearRefusal> {
        let highest = self.peak_torque.or(self.rated_torque);
        let fastest = self.top_speed.or(self.rated_speed);
        let (Some(peak), Some(mean), Some(speed)) = (highest, self.rated_torque, fastest) else {
            return Some(GearRefusal::Unknown);
        };
        let mean_speed = self.rated_speed.unwrap_or(speed);
        if asked.peak > peak {
            return Some(GearRefusal::Peak(asked.peak, peak));
        }
        if asked.mean > mean {
            return Some(GearRefusal::Mean(asked.mean, mean));
        }
        if asked.speed > speed {
            return Some(GearRefusal::Speed(asked.speed, speed));
        }
        if asked.mean_speed > mean_speed {
            return Some(GearRefusal::MeanSpeed(asked.mean_speed, mean_speed));
        }
        let (own, most) = self.backlash.zip(backlash)?;
        (own > most).then_some(GearRefusal::Backlash(own, most))
    }
}
