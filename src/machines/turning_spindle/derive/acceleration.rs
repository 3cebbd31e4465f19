//! Acceleration of the spindle: the one needed for constant surface speed, and that of its ramp.

use super::cut::CutGeometry;
use super::limits::LimitDiameters;
use super::speeds::CutSpeeds;
use super::stage::EngagedStage;
use crate::drives::cutting;
use crate::drives::speed::surface_rpm;
use crate::machines::turning_spindle::params::Params;

/// Accelerations, r/min per second.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::turning_spindle) struct SpindleAcceleration {
    /// Greatest one needed for constant surface speed; 0 at a fixed speed, and where a limit holds the speed over the whole cut.
    pub needed: f64,
    /// Acceleration of the ramp; infinite without one.
    pub ramp: f64,
}

impl SpindleAcceleration {
    pub(super) fn new(
        p: &Params,
        cut: &CutGeometry,
        stage: &EngagedStage,
        limits: &LimitDiameters,
        speeds: &CutSpeeds,
    ) -> SpindleAcceleration {
        // The speed changes with the diameter only between both limits; in front of the stock it need not be followed.
        let hardest = limits.high.max(cut.smallest);
        let is_held = hardest >= cut.largest.min(p.stock_diameter) || limits.low > 0.0 && hardest >= limits.low;
        SpindleAcceleration {
            needed: if p.turns_at_fixed_speed() || is_held {
                0.0
            } else {
                acceleration(p, speeds.held.surface(), hardest)
            },
            ramp: if p.spindle.ramp > 0.0 { stage.speed / p.spindle.ramp } else { f64::INFINITY },
        }
    }
}

/// Acceleration of the spindle (r/min per second) at a diameter in mm, with a surface speed in m/min.
fn acceleration(p: &Params, surface: f64, diameter: f64) -> f64 {
    let cuts = p.cuts(1.0).filter(|cut| cut.length > 0.0);
    let slope = cuts.map(|cut| (cut.diameters.1 - cut.diameters.0).abs() / cut.length).fold(0.0, f64::max);
    cutting::speed_gradient(surface_rpm(surface, diameter), p.feed, slope, diameter)
}
