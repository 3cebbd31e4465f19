//! Feeds of the passes.

use crate::machines::polygon_lathe::params::Params;

/// Feeds, mm/min.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::polygon_lathe) struct PolygonFeeds {
    pub rough: f64,
    pub finish: f64,
    /// Down into the stock.
    pub infeed: f64,
}

impl PolygonFeeds {
    pub(super) fn new(p: &Params) -> PolygonFeeds {
        PolygonFeeds {
            rough: p.per_minute(p.feed),
            finish: p.per_minute(p.finish_feed),
            infeed: p.per_minute(p.infeed),
        }
    }
}
