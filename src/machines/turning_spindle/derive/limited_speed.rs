//! The speed of the spindle as the control holds it within its limits.

use super::command::CommandedSpeed;
use super::stage::EngagedStage;
use crate::drives::Bound;
use crate::drives::speed::{SpeedLimits, SpeedRange, surface_rpm};
use crate::machines::turning_spindle::params::Params;

/// Speed of the spindle over the diameter, as the control limits it.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::turning_spindle) struct LimitedSpeed {
    limits: SpeedLimits,
    /// Surface speed after an override that acts before the limits, m/min.
    speed: f64,
    /// Factor of an override that acts after the limits.
    after: f64,
    /// Greatest speed of the analog output, r/min.
    top: f64,
}

impl LimitedSpeed {
    /// The limits of constant surface speed (`surface`) or of a fixed speed in a gear stage.
    pub(super) fn new(p: &Params, command: &CommandedSpeed, stage: &EngagedStage, surface: bool) -> LimitedSpeed {
        let limits = SpeedLimits {
            machine: p.chuck_limit,
            gear: SpeedRange::new(
                if command.low_always { p.lower_limit } else { 0.0 },
                if surface { stage.surface_top } else { f64::INFINITY },
            ),
            surface: if surface { SpeedRange::new(p.lower_limit, p.upper_limit) } else { SpeedRange::ANY },
            ..SpeedLimits::NONE
        };
        LimitedSpeed { limits, speed: command.surface, after: command.after, top: stage.top }
    }

    /// Speed (r/min) at a diameter (mm) under constant surface speed, and the limit that binds it.
    pub(in crate::machines::turning_spindle) fn at(&self, diameter: f64) -> (f64, Bound) {
        self.within(surface_rpm(self.speed, diameter))
    }

    /// Surface speed after every override, m/min.
    pub(super) fn surface(&self) -> f64 {
        self.speed * self.after
    }

    /// A commanded speed within the limits, and the limit that binds it.
    pub(super) fn within(&self, rpm: f64) -> (f64, Bound) {
        let (rpm, bound) = self.limits.limit(rpm);
        let most = self.limits.machine;
        // An override that acts after the limits may exceed all of them except the machine's.
        let bound = if bound == Bound::None && rpm * self.after > most { Bound::Machine } else { bound };
        let rpm = (rpm * self.after).min(most);
        if rpm > self.top { (self.top, if bound == Bound::Gear { bound } else { Bound::Output }) } else { (rpm, bound) }
    }
}
