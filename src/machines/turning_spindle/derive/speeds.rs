//! Speeds of the spindle in the cut, at constant surface speed and at a fixed speed.

use super::command::CommandedSpeed;
use super::cut::CutGeometry;
use super::limited_speed::LimitedSpeed;
use super::stage::EngagedStage;
use crate::drives::Bound;
use crate::drives::speed::{surface_rpm, surface_speed};
use crate::machines::turning_spindle::params::Params;

/// Speeds of the cut. r/min unless noted otherwise.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::turning_spindle) struct CutSpeeds {
    /// At the largest diameter, the smallest, and the largest with the whole depth of cut.
    pub largest: f64,
    pub smallest: f64,
    pub largest_whole: f64,
    /// The limit that binds the speed at the smallest diameter.
    pub bound: Bound,
    /// Speed below the limit diameter.
    pub high: f64,
    /// At the smallest diameter, as commanded of an output that is never full.
    pub commanded: f64,
    /// One speed for the whole cut, as commanded at the stock's diameter and as the control holds it.
    pub asked: f64,
    pub fixed: f64,
    /// Surface speed at the smallest diameter, m/min: at constant surface speed, and with one speed for the whole cut.
    pub surface_smallest: f64,
    pub fixed_surface_smallest: f64,
    /// Greatest feed, mm/min.
    pub feed_top: f64,
    /// Speed over the diameter under constant surface speed.
    pub held: LimitedSpeed,
}

impl CutSpeeds {
    pub(super) fn new(p: &Params, cut: &CutGeometry, stage: &EngagedStage, command: &CommandedSpeed) -> CutSpeeds {
        let held = |surface: bool| LimitedSpeed::new(p, command, stage, surface);
        let (surface, constant) = (held(true), held(false));
        let without_end = EngagedStage { top: f64::INFINITY, ..stage.clone() };
        let endless = |surface: bool| LimitedSpeed::new(p, command, &without_end, surface);
        // S is a whole number, and at most the operator's limit.
        let asked = surface_rpm(p.cutting_speed, p.stock_diameter).min(p.upper_limit).floor() * command.before;
        let (fixed, fixed_bound) = constant.within(asked);
        let is_fixed = p.turns_at_fixed_speed();
        let speed = |diameter: f64| if is_fixed { fixed } else { surface.at(diameter).0 };
        let (largest, smallest) = (speed(cut.largest), speed(cut.smallest));
        CutSpeeds {
            largest,
            smallest,
            largest_whole: speed(cut.largest_whole),
            bound: if is_fixed { fixed_bound } else { surface.at(cut.smallest).1 },
            high: (command.highest(stage.surface_top) * command.after).min(p.chuck_limit).min(stage.top),
            commanded: if is_fixed { endless(false).within(asked).0 } else { endless(true).at(cut.smallest).0 },
            asked,
            fixed,
            surface_smallest: surface_speed(smallest, cut.smallest),
            fixed_surface_smallest: surface_speed(fixed, cut.smallest),
            feed_top: p.feed * smallest.max(largest),
            held: surface,
        }
    }

    /// Speed of the spindle (r/min) in the program's cut at a diameter in mm.
    pub(in crate::machines::turning_spindle) fn at(&self, p: &Params, diameter: f64) -> f64 {
        if p.turns_at_fixed_speed() { self.fixed } else { self.held.at(diameter).0 }
    }
}
