//! Diameters at which the limits of the speed begin to bind, and those with the greatest demand on a motor.

use super::command::CommandedSpeed;
use super::cut::CutGeometry;
use super::speeds::CutSpeeds;
use crate::drives::speed::limit_diameter;
use crate::machines::turning_spindle::params::Params;
use crate::math;

/// Diameters (mm) where the limits of constant surface speed bind.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::turning_spindle) struct LimitDiameters {
    /// Diameter below which the highest speed binds.
    pub high: f64,
    /// Diameter above which the lowest speed binds; 0 without a lower limit.
    pub low: f64,
    /// Share (0 to 1) of the diameters of the cut at which the highest speed binds.
    pub limited_share: f64,
}

impl LimitDiameters {
    pub(super) fn new(p: &Params, cut: &CutGeometry, command: &CommandedSpeed, speeds: &CutSpeeds) -> LimitDiameters {
        // With an override that acts after the limits, both speeds are those behind it.
        let high = limit_diameter(speeds.held.surface(), speeds.high);
        let span = cut.largest - cut.smallest;
        let binds = span > 0.0 && !p.turns_at_fixed_speed();
        LimitDiameters {
            high,
            low: if command.lowest > 0.0 { limit_diameter(command.surface, command.lowest) } else { 0.0 },
            limited_share: if binds { math::clamp((high - cut.smallest) / span, 0.0, 1.0) } else { 0.0 },
        }
    }

    /// Candidates for the diameter (mm) with the greatest demand on a motor whose base speed at the spindle is `base`
    /// r/min. Above base speed the demand of power, `F v / 60 + ω (M_f + J dω/dt)`, falls with the diameter; below,
    /// torque of cut and acceleration have no greatest value between both ends.
    pub(in crate::machines::turning_spindle) fn hardest(
        &self,
        cut: &CutGeometry,
        speeds: &CutSpeeds,
        base: f64,
    ) -> [f64; 3] {
        let largest = cut.largest_whole;
        let least = self.high.max(cut.smallest).min(largest);
        let bend = limit_diameter(speeds.held.surface(), base);
        [largest, if bend > least && bend < largest { bend } else { largest }, least]
    }
}
