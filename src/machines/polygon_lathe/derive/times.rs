//! Number of the passes, and the times until ready and of the cut.

use crate::machines::polygon_lathe::params::Params;

/// Times, s.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::polygon_lathe) struct PolygonTimes {
    /// Number of passes.
    pub passes: f64,
    /// Turning to the start angles, run-up, and run-down.
    pub ready: f64,
    /// All motions at feed.
    pub cutting: f64,
}

impl PolygonTimes {
    pub(super) fn new(p: &Params, sizes: &[f64]) -> PolygonTimes {
        PolygonTimes {
            passes: sizes.len() as f64,
            ready: p.longest_index_time() + 2.0 * p.settling(),
            cutting: p.cutting_time(),
        }
    }
}
