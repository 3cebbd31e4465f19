//! The cut in the stock: its passes, its diameters, and the torque of cut and friction at a diameter.

use crate::drives::cutting::{self, Cut};
use crate::machines::turning_spindle::params::{Params, Path};

/// Passes and diameters (mm) of the cut.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::turning_spindle) struct CutGeometry {
    /// Number of passes.
    pub passes: f64,
    /// Largest and smallest diameter of the cut, with the approach from the clearance.
    pub largest: f64,
    pub smallest: f64,
    /// Largest diameter of the tool tip at which the whole depth of cut is in the stock.
    pub largest_whole: f64,
}

impl CutGeometry {
    pub(super) fn new(p: &Params) -> CutGeometry {
        let (largest, smallest) = p.diameters();
        let whole = p.stock_diameter - if p.path == Path::Facing { 0.0 } else { 2.0 * p.depth };
        // A single pass may be less deep.
        let largest_whole = largest.min(whole.max(smallest));
        CutGeometry { passes: p.passes(), largest, smallest, largest_whole }
    }
}

impl Params {
    /// Torque (Nm) of cut and friction with the tool tip at a diameter in mm: `F d_m / 2000 + M_f`, with d_m the middle
    /// of the edge in the stock. In front of the stock it is the friction torque alone. Source: turning spindle facts,
    /// 4.
    pub(in crate::machines::turning_spindle) fn steady_torque(&self, diameter: f64) -> f64 {
        let cut = if diameter > self.stock_diameter { 0.0 } else { self.cutting_force };
        cutting::torque(cut, self.middle_of_edge(diameter)) + self.spindle.friction
    }

    /// Diameter (mm) at the middle of the engaged edge, with the tool tip at diameter `tip` (mm): in a cut along the
    /// axis the edge extends over the depth of cut.
    pub(in crate::machines::turning_spindle) fn middle_of_edge(&self, tip: f64) -> f64 {
        let reach = if self.path == Path::Facing { 0.0 } else { 2.0 * self.depth };
        0.5 * (tip + (tip + reach).min(self.stock_diameter).max(tip))
    }

    /// Largest and smallest diameter of the cut, with the approach from the clearance.
    fn diameters(&self) -> (f64, f64) {
        let ends = [1.0, self.passes().max(1.0)].map(|pass| {
            self.cuts(pass).fold((0.0_f64, f64::INFINITY), |(large, small), Cut { diameters: (from, to), .. }| {
                (large.max(from).max(to), small.min(from).min(to))
            })
        });
        (ends[0].0.max(ends[1].0), ends[0].1.min(ends[1].1))
    }
}
