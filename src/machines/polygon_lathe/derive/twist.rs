//! The twist of the flats along the work.

use super::cut::{DEGREES, PolygonCut};
use super::feeds::PolygonFeeds;
use super::speeds::PolygonSpeeds;
use crate::drives::polygon::cut;
use crate::machines::polygon_lathe::params::Params;

/// The twist of the flats.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::machines::polygon_lathe) struct Twist {
    /// Twist over the length of the polygon, degrees.
    pub angle: f64,
    /// Speed of the tool during the last pass that the twist needs, r/min.
    pub tool_speed: f64,
    /// The same during the passes before, r/min: they feed otherwise.
    pub rough_tool_speed: f64,
}

impl Twist {
    pub(super) fn new(p: &Params, cut: &PolygonCut, speeds: &PolygonSpeeds, feeds: &PolygonFeeds) -> Twist {
        if p.lead == 0.0 {
            return Twist { angle: 0.0, tool_speed: speeds.tool, rough_tool_speed: speeds.tool };
        }
        let at = |feed: f64| cut::helical_tool_speed(cut.setup.ratio, speeds.work, -feed, p.lead);
        Twist {
            angle: cut::twist(p.length, p.lead) * DEGREES,
            tool_speed: at(feeds.finish),
            rough_tool_speed: at(feeds.rough),
        }
    }
}
