//! Choices of cutter and ratio for the polygon, the best first.

use super::resolved::PolygonLathe;
use crate::drives::polygon::choose::{self, Choice, LatheLimits};

impl PolygonLathe {
    /// All cutters and ratios for the polygon, the best first.
    pub(super) fn choices(&self) -> Vec<Choice> {
        self.choices_within(&self.limits())
    }

    /// Cutters and ratios for the tip circle of the form only: fast enough to be computed at every keystroke.
    pub(super) fn choices_on_tip_circle(&self) -> Vec<Choice> {
        let mut limits = self.limits();
        for cutter in &mut limits.cutters {
            cutter.radius = (self.params.tip_radius, self.params.tip_radius);
        }
        self.choices_within(&limits)
    }

    fn limits(&self) -> LatheLimits {
        self.params.lathe_limits(|limit| self.limit_at_full_feed(limit))
    }

    fn choices_within(&self, limits: &LatheLimits) -> Vec<Choice> {
        choose::choices(&self.params.polygon_spec(&self.sizes), limits)
    }
}
