//! The position of the cutter beside the work, and the length from face to jaws that it needs.

use crate::machines::polygon_lathe::params::Params;

/// Distances of the cutter, mm.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::polygon_lathe) struct CutterPlace {
    /// Distance of the axes of work and cutter at the last pass.
    pub distance: f64,
    /// Depth of the tips in the stock at the last pass: so far would a cutter body as large as the tip circle be in
    /// stock beside the polygon.
    pub reach: f64,
    /// Tool offset of X, in units of its words.
    pub offset: f64,
    /// Length from face to jaws that the cutter needs: its body is taken to be an insert wider than the inserts towards the chuck.
    pub length_to_jaws: f64,
}

impl CutterPlace {
    /// X words count `x_per_mm` units per mm of the slide.
    pub(super) fn new(p: &Params, x_per_mm: f64) -> CutterPlace {
        CutterPlace {
            distance: 0.5 * p.across_flats + p.tip_radius,
            reach: p.reach(),
            offset: -p.tip_radius * x_per_mm,
            length_to_jaws: p.far_end() + p.insert_width + p.clearance,
        }
    }
}
