//! Bending of the work from the chuck to the tool, under the force of the cut.

use super::params::{Params, Path};
use crate::drives::bending::{cantilever, supported};

impl Params {
    /// Least diameter (mm) of the finished work, over the length of the cut.
    fn thinnest(&self) -> f64 {
        match self.path {
            Path::Facing => self.stock_diameter,
            Path::Turning => self.finished_diameter,
            Path::Taper => self.finished_diameter.min(self.large_diameter),
        }
    }

    /// The work from the face to the end of the stock: lengths and diameters, mm. What the chuck holds counts as free.
    fn steps(&self) -> [(f64, f64); 2] {
        let cut = if self.path == Path::Facing { 0.0 } else { self.length };
        let thin = if self.thinnest() > 0.0 { self.thinnest() } else { self.stock_diameter };
        [(cut, thin), (self.work_length - cut, self.stock_diameter)]
    }
}

/// Greatest deflection (mm) of the work without a tailstock: the force of the cut at the face, over the whole stock.
pub(super) fn free(p: &Params) -> f64 {
    cantilever(p.cutting_force, p.material.elasticity(), p.steps())
}

/// Greatest deflection (mm) of the work as the form holds it.
pub(super) fn of(p: &Params) -> f64 {
    if p.tailstock { held(p) } else { free(p) }
}

/// Greatest deflection (mm) of the work with a tailstock, by its least diameter.
pub(super) fn held(p: &Params) -> f64 {
    let [(cut, thin), (rest, _)] = p.steps();
    supported(p.cutting_force, p.material.elasticity(), cut + rest.max(0.0), thin)
}
