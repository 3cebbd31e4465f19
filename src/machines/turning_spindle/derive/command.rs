//! The commanded speed: the override before or after the limits, and the limits of operator and chuck.

use crate::controls::SpindleRules;
use crate::drives::speed::surface_rpm;
use crate::machines::turning_spindle::params::{Params, SpeedMode};

/// Commanded speed and its limits. An override that acts after the limits is limited by chuck and output only.
pub(super) struct CommandedSpeed {
    /// Factors of the override that act before and after the limits.
    pub before: f64,
    pub after: f64,
    /// Surface speed after an override that acts before the limits, m/min.
    pub surface: f64,
    /// Lowest speed, r/min; 0 where no lower limit acts.
    pub lowest: f64,
    /// Whether the lower limit acts on every speed; otherwise only on constant surface speed.
    pub low_always: bool,
    /// Lower of the limits of operator and chuck, r/min.
    pub limit: f64,
}

impl CommandedSpeed {
    pub(super) fn new(p: &Params, rules: &SpindleRules) -> CommandedSpeed {
        let knob = p.override_percent / 100.0;
        let (before, after) = if rules.override_last { (1.0, knob) } else { (knob, 1.0) };
        CommandedSpeed {
            before,
            after,
            surface: p.cutting_speed * before,
            lowest: if p.turns_at_fixed_speed() && !rules.low_always { 0.0 } else { p.lower_limit },
            low_always: rules.low_always,
            limit: p.chuck_limit.min(p.upper_limit),
        }
    }

    /// Highest commanded speed (r/min) of a cut down to the diameter `smallest` (mm), at most the limit of the chuck
    /// and, at constant surface speed, that of the operator.
    pub(super) fn top(&self, p: &Params, smallest: f64) -> f64 {
        if p.turns_at_fixed_speed() {
            let asked = surface_rpm(p.cutting_speed, p.stock_diameter).min(p.upper_limit);
            let speed = asked * (p.override_percent / 100.0);
            speed.max(self.lowest).min(p.chuck_limit)
        } else {
            surface_rpm(self.surface, smallest).max(self.lowest).min(self.limit)
        }
    }

    /// Highest speed (r/min) before an override that acts after the limits, in a gear stage that gives `stage_top` at the most.
    pub(super) fn highest(&self, stage_top: f64) -> f64 {
        self.limit.min(stage_top)
    }
}

impl Params {
    /// Whether the spindle has one speed for the whole cut.
    pub(super) fn turns_at_fixed_speed(&self) -> bool {
        self.speed_mode == SpeedMode::Fixed
    }
}
