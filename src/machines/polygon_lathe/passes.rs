//! The passes of a polygon: their number, and size and feed of each.

use super::params::Params;
use crate::math;

/// Greatest number of passes.
pub(super) const PASSES: f64 = 60.0;

impl Params {
    /// Distance of the far end of the polygon from the face, mm.
    pub(super) fn far_end(&self) -> f64 {
        self.from_face + self.length
    }

    /// Diameter (mm) of the stock of the polygon: that of the end turned before it where the polygon lies on it, else that of the bar.
    pub(super) fn blank(&self) -> f64 {
        let [before, _] = &*self.turned_ends;
        let lies_on_it = before.on && self.far_end() <= before.length && before.diameter > self.across_flats;
        if lies_on_it { before.diameter.min(self.stock_diameter) } else { self.stock_diameter }
    }

    /// Diameter (mm) of the greatest circle in the section: that across flats, or between a single flat and the stock opposite to it.
    pub(super) fn circle_in_flats(&self) -> f64 {
        let is_single = self.ratio().is_some_and(|ratio| ratio.sides(self.inserts as u32) == 1);
        if is_single { 0.5 * (self.across_flats + self.blank()) } else { self.across_flats }
    }

    /// Depth of all roughing passes together, on the radius, mm.
    fn rough(&self) -> f64 {
        (0.5 * (self.blank() - self.across_flats) - self.allowance).max(0.0)
    }

    /// Depth of the tips in the stock at the last pass, mm: `(stock - AF) / 2`. The body of the cutter, `h` behind the
    /// tips, touches stock beside the polygon if this reach is more than `h`. Source: mechanics, with the distance of
    /// the axes a = AF/2 + r and a body of the radius r - h.
    pub(super) fn reach(&self) -> f64 {
        (0.5 * (self.stock_beside() - self.across_flats)).max(0.0)
    }

    /// Diameter (mm) of the stock beside the polygon. Where it lies on a turned end, the body of the cutter meets the bar at its shoulder: it is
    /// taken to be an insert wider than the inserts towards the chuck (an assumption: the form has no width of the body).
    fn stock_beside(&self) -> f64 {
        let [before, _] = &*self.turned_ends;
        let body_end = self.far_end() + self.insert_width;
        if body_end > before.length { self.stock_diameter } else { self.blank() }
    }

    /// Number of passes; the last one finishes.
    pub(super) fn passes(&self) -> f64 {
        // Nine decimals: 0.3 / 0.1 is three passes.
        1.0 + math::clamp(math::whole_up(self.rough() / self.depth), 0.0, PASSES)
    }

    /// Distance across flats (mm) after a pass (from 1).
    pub(super) fn size(&self, pass: f64) -> f64 {
        let rough = self.across_flats + 2.0 * self.allowance;
        if pass >= self.passes() { self.across_flats } else { (self.blank() - 2.0 * pass * self.depth).max(rough) }
    }

    /// Feed of a pass, mm per turn of the work.
    pub(super) fn feed_of(&self, pass: f64) -> f64 {
        if pass >= self.passes() { self.finish_feed } else { self.feed }
    }

    /// F (mm/min) of a feed in mm per turn of the work.
    pub(super) fn per_minute(&self, feed: f64) -> f64 {
        feed * self.work_speed().abs()
    }
}
