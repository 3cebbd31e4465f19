//! Bending of the work from the chuck to the tool, under the force of the cut.

use super::params::{Params, Path};
use crate::drives::bending::{cantilever, supported, supported_in_steps};

/// Slices of a taper, each as a bar of the diameter in its middle.
const SLICES: u32 = 32;

impl Params {
    /// Length (mm) of the work behind the face that is turned; a facing cut leaves the diameter of the stock.
    fn turned_length(&self) -> f64 {
        if self.path == Path::Facing { 0.0 } else { self.length }
    }

    /// Length (mm) of the work from the face to the jaws.
    fn free_length(&self) -> f64 {
        (self.work_length - self.grip).max(self.turned_length())
    }

    /// Diameter (mm) of the finished work at a distance (mm) behind the face. The tip of a taper counts as at least as
    /// thick as the depth of cut, because the force is at the middle of the edge.
    fn diameter_behind_face(&self, distance: f64) -> f64 {
        match self.path {
            _ if distance >= self.turned_length() => self.stock_diameter,
            Path::Facing => self.stock_diameter,
            Path::Turning if self.finished_diameter > 0.0 => self.finished_diameter,
            Path::Turning => self.stock_diameter,
            Path::Taper => {
                let grown = (self.large_diameter - self.finished_diameter) * distance / self.length;
                (self.finished_diameter + grown).max(self.depth)
            }
        }
    }

    /// The work from the face to the jaws as cylinders: length and diameter of each, mm.
    fn steps(&self) -> impl Iterator<Item = (f64, f64)> {
        let turned = self.turned_length();
        let slices = if self.path == Path::Taper { SLICES } else { 1 };
        let length = turned / f64::from(slices);
        let slice = move |at: u32| (length, self.diameter_behind_face((f64::from(at) + 0.5) * length));
        (0..slices).map(slice).chain([(self.free_length() - turned, self.stock_diameter)])
    }
}

/// Greatest deflection (mm) of the work without a tailstock: the force of the cut at the face, over the work in front of the jaws.
pub(super) fn free(p: &Params) -> f64 {
    cantilever(p.cutting_force, p.material.elasticity(), p.steps())
}

/// Greatest deflection (mm) of the work as the form holds it.
pub(super) fn of(p: &Params) -> f64 {
    if p.tailstock { held(p) } else { free(p) }
}

/// Greatest deflection (mm) of the work with a tailstock: for a cylinder with its least diameter, for a taper by its
/// slices.
pub(super) fn held(p: &Params) -> f64 {
    let (force, elasticity) = (p.cutting_force, p.material.elasticity());
    match p.path {
        Path::Taper => supported_in_steps(force, elasticity, p.steps(), p.turned_length()),
        Path::Facing | Path::Turning => supported(force, elasticity, p.free_length(), p.diameter_behind_face(0.0)),
    }
}
