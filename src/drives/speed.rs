//! Spindle speed: constant surface speed, gear stages, limits, and the active limit.

use crate::math::PI;

/// Spindle speed in r/min for a surface speed in m/min at a diameter in mm: `n = 1000 v / (π d)`. Infinite at the centre.
///
/// Source: `docs/reference/gsk-980tdc.md` section 1.3, `docs/reference/sinumerik-802d.md` section 3.4.
pub fn surface_rpm(speed: f64, diameter: f64) -> f64 {
    if speed > 0.0 { 1000.0 * speed / (PI * diameter.abs()) } else { 0.0 }
}

/// Surface speed in m/min at a diameter in mm: `v = π d n / 1000`.
pub fn surface_speed(rpm: f64, diameter: f64) -> f64 {
    PI * diameter.abs() * rpm.abs() / 1000.0
}

/// Diameter in mm at which a surface speed in m/min needs exactly this spindle speed: `d = 1000 v / (π n)`; a limit of that speed is
/// inactive at larger diameters. 22.918 mm for 180 m/min and 2500 r/min.
pub fn limit_diameter(speed: f64, rpm: f64) -> f64 {
    if speed > 0.0 { 1000.0 * speed / (PI * rpm) } else { 0.0 }
}

/// Active limit of a spindle speed that differs from the requested one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Bound {
    /// The requested speed is in force.
    #[default]
    None,
    /// The highest speed of spindle or chuck.
    Machine,
    /// The highest speed of the gear stage.
    Gear,
    /// The programmed upper limit, setting data (G26).
    Upper,
    /// The upper limit of constant surface speed (G50 S, G92 S, LIMS).
    Surface,
    /// The programmed lower limit, setting data (G25).
    Lower,
    /// The lowest speed of the gear stage.
    GearLow,
    /// The lowest speed of constant surface speed.
    SurfaceLow,
    /// The converter is at its full voltage.
    Output,
    /// A gear change by the PLC.
    Shift,
}

impl Bound {
    /// Whether the limit reduces the speed.
    pub fn is_upper(self) -> bool {
        matches!(self, Bound::Machine | Bound::Gear | Bound::Upper | Bound::Surface | Bound::Output)
    }
}

/// A limit set by program or operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpeedLimit {
    /// Lowest speed: setting data, kept (G25).
    Lower,
    /// Highest speed: setting data, kept (G26).
    Upper,
    /// Highest speed under constant surface speed (G50 S, G92 S, LIMS).
    Surface,
}

/// Lowest and highest speed, r/min.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedRange {
    /// Lowest speed; 0 without one.
    pub low: f64,
    /// Highest speed; infinite without one.
    pub high: f64,
}

impl SpeedRange {
    /// Any speed.
    pub const ANY: SpeedRange = SpeedRange { low: 0.0, high: f64::INFINITY };

    /// The speeds from `low` to `high` r/min.
    pub const fn new(low: f64, high: f64) -> SpeedRange {
        SpeedRange { low, high }
    }
}

/// All limits of a speed in r/min. Missing upper limits are infinite, missing lower ones 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedLimits {
    /// Highest speed of spindle or chuck.
    pub machine: f64,
    /// Lowest and highest speed of the gear stage.
    pub gear: SpeedRange,
    /// Lowest and highest speed of the setting data.
    pub set: SpeedRange,
    /// Lowest and highest speed under constant surface speed, while it is on.
    pub surface: SpeedRange,
}

impl SpeedLimits {
    /// No limit at all.
    pub const NONE: SpeedLimits =
        SpeedLimits { machine: f64::INFINITY, gear: SpeedRange::ANY, set: SpeedRange::ANY, surface: SpeedRange::ANY };

    /// Limited speed and the active limit: the smallest of the upper limits, the largest of the lower ones; if they cross, the upper limit.
    /// Standstill is below no limit.
    ///
    /// Source: `docs/reference/sinumerik-802d.md` section 3.4, `docs/reference/gsk-980tdc.md` section 1.3 (the upper one wins).
    pub fn limit(&self, rpm: f64) -> (f64, Bound) {
        if rpm <= 0.0 {
            return (0.0, Bound::None);
        }
        let mut limited = (rpm, Bound::None);
        let lower =
            [(self.set.low, Bound::Lower), (self.gear.low, Bound::GearLow), (self.surface.low, Bound::SurfaceLow)];
        let upper = [
            (self.machine, Bound::Machine),
            (self.gear.high, Bound::Gear),
            (self.set.high, Bound::Upper),
            (self.surface.high, Bound::Surface),
        ];
        for (limit, bound) in lower {
            if limit > limited.0 {
                limited = (limit, bound);
            }
        }
        for (limit, bound) in upper {
            if limit < limited.0 {
                limited = (limit, bound);
            }
        }
        limited
    }
}

impl Default for SpeedLimits {
    fn default() -> SpeedLimits {
        SpeedLimits::NONE
    }
}

/// Maximum gear stages of a spindle (M41 to M45).
pub const STAGES: usize = 5;

/// A gear stage. Speeds in r/min of the spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stage {
    /// Speed at the rated voltage of the output.
    pub rated: f64,
    /// Lowest and highest speed of the stage.
    pub range: SpeedRange,
    /// Speed range of the stage in automatic gear selection (M40).
    pub automatic: SpeedRange,
}

impl Stage {
    /// A stage without speed limits; automatic gear selection uses it up to its rated speed.
    pub const fn new(rated: f64) -> Stage {
        Stage { rated, range: SpeedRange::ANY, automatic: SpeedRange::new(0.0, rated) }
    }
}

/// Stage, from 1, of automatic gear selection for a speed: the present one if it fits, otherwise the first that does. `None` if no stage
/// fits; the present one stays engaged.
///
/// Source: `docs/reference/sinumerik-802d.md` sections 3.4 and 4.
pub fn stage_for(stages: &[Stage], present: u8, rpm: f64) -> Option<u8> {
    let fits = |stage: &Stage| (stage.automatic.low..=stage.automatic.high).contains(&rpm);
    if stages.get(usize::from(present).wrapping_sub(1)).is_some_and(fits) {
        return Some(present);
    }
    stages.iter().position(fits).map(|at| at as u8 + 1)
}

/// Ends of an override knob, seen from one of its positions, in percent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnobEnds {
    /// Highest position; `None` if the knob is there.
    pub higher: Option<f64>,
    /// Lowest position at which the spindle turns; `None` if the knob is there or below.
    pub lower: Option<f64>,
}

/// Positions of an override knob in percent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnobRange {
    /// Lowest position.
    pub low: f64,
    /// Highest position.
    pub high: f64,
    /// Percent from one position to the next; 0 for a knob without steps.
    pub step: f64,
}

impl KnobRange {
    /// The lowest position at which the spindle turns.
    pub fn lowest_turning(&self) -> f64 {
        if self.low > 0.0 { self.low } else { self.step }
    }

    /// The ends of the knob, seen from a position in percent.
    pub fn ends(&self, percent: f64) -> KnobEnds {
        let (highest, lowest) = (self.high, self.lowest_turning());
        KnobEnds { higher: (percent < highest).then_some(highest), lower: (lowest < percent).then_some(lowest) }
    }

    /// The lowest position that is at least a percentage; the highest where all are lower.
    pub fn at_least(&self, percent: f64) -> f64 {
        let steps =
            if self.step > 0.0 { ((percent - self.low) / self.step).ceil() * self.step } else { percent - self.low };
        crate::math::clamp(self.low + steps, self.low, self.high)
    }

    /// The position nearest to a percentage.
    pub fn nearest(&self, percent: f64) -> f64 {
        let steps =
            if self.step > 0.0 { ((percent - self.low) / self.step).round() * self.step } else { percent - self.low };
        crate::math::clamp(self.low + steps, self.low, self.high)
    }
}
