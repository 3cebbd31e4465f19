//! Choices of cutter and ratio for the polygon, the best first.

use super::params::Params;
use crate::drives::polygon::choose::{self, Choice};

/// All cutters and ratios for the polygon, the best first.
pub(super) fn choices(p: &Params, sizes: &[f64]) -> Vec<Choice> {
    choose::choices(&p.polygon_spec(sizes), &p.lathe_limits())
}

/// Cutters and ratios for the tip circle of the form only: fast enough to be computed at every keystroke.
pub(super) fn choices_on_tip_circle(p: &Params, sizes: &[f64]) -> Vec<Choice> {
    let mut limits = p.lathe_limits();
    for cutter in &mut limits.cutters {
        cutter.radius = (p.tip_radius, p.tip_radius);
    }
    choose::choices(&p.polygon_spec(sizes), &limits)
}
