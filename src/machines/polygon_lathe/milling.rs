//! Time of milling the polygon in polar interpolation, for comparison.

use super::params::Params;
use crate::math::{self, PI};

impl Params {
    /// Path of the mill once around the polygon, mm: along every side with its radius outside,
    /// `2 N (d + D/2) tan(π/N)`, with N sides at d = AF/2 from the centre and a mill of the diameter D; with one or two
    /// sides over the chords in the stock, `N (2 √(R² - d²) + D)`, with the stock's radius R.
    fn round_by_mill(&self) -> f64 {
        let (n, d, mill) = (self.sides, 0.5 * self.across_flats, self.mill_diameter);
        if n > 2.0 {
            return 2.0 * n * (d + 0.5 * mill) * math::tan(PI / n);
        }
        let stock = 0.5 * self.blank();
        n * (2.0 * (stock * stock - d * d).max(0.0).sqrt() + mill)
    }

    /// Time to mill the polygon in polar interpolation, s: `60 ⌈L / depth⌉ path / F`, once around for each depth along
    /// the work, at the full depth across it. A lower bound: without approach and tool change.
    pub(super) fn milling_time(&self) -> f64 {
        let rounds = math::whole_up(self.length / self.mill_depth);
        60.0 * rounds * self.round_by_mill() / self.mill_feed
    }
}
