//! Speeds of work and tool, and their ratio.

use crate::drives::polygon::Ratio;
use crate::machines::polygon_lathe::params::Params;

/// Speeds of work and tool, r/min, signed.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::polygon_lathe) struct PolygonSpeeds {
    /// Tool to work speed; 0 where D or Q is 0.
    pub ratio: f64,
    pub work: f64,
    pub tool: f64,
}

impl PolygonSpeeds {
    pub(super) fn new(p: &Params) -> PolygonSpeeds {
        PolygonSpeeds { ratio: p.ratio().map_or(0.0, Ratio::value), work: p.work_speed(), tool: p.tool_speed() }
    }
}
