//! The cutter in the stock: its section, the path of its inserts, and the pass with the greatest demand on them.

use crate::drives::polygon::cut::InsertLoad;
use crate::drives::polygon::{Curve, CutterSetup, Section};
use crate::machines::polygon_lathe::params::Params;
use crate::math::PI;

/// Degrees in a radian.
pub(super) const DEGREES: f64 = 180.0 / PI;

/// A cutter that cuts a section out of the stock.
pub(super) struct PolygonCut {
    pub setup: CutterSetup,
    pub section: Section,
    /// Path of the first insert.
    pub curve: Curve,
    /// Greatest needed relief, and least and greatest cutting speed, over all passes.
    pub demand: InsertLoad,
    /// Number (from 1) of the pass that needs the greatest relief.
    pub relief_pass: f64,
}

impl PolygonCut {
    /// The cut in passes of these `sizes` across flats (mm); none if the inserts cut no section.
    pub(super) fn new(p: &Params, sizes: &[f64]) -> Option<PolygonCut> {
        let (setup, section) = p.setup(p.across_flats).zip(p.section())?;
        if p.across_flats >= p.stock_diameter {
            return None;
        }
        let curve = setup.curve(0)?;
        let passes = p.cuts(&setup, sizes).into_iter();
        let (relief_pass, demand) = passes.fold((0.0, None), |(worst, all), (pass, cut)| {
            let more = all.is_none_or(|all: InsertLoad| cut.relief > all.relief);
            (if more { pass } else { worst }, Some(all.map_or(cut, |all| all.worst(cut))))
        });
        Some(PolygonCut { setup, section, curve, demand: demand?, relief_pass })
    }

    /// Degrees of the work from one side to the next.
    pub(super) fn pitch(&self) -> f64 {
        360.0 / f64::from(self.setup.sides())
    }
}
