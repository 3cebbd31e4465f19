//! Turning before and after the polygons: to a diameter from the face, with a chamfer and a thread. The spindle turns the work.

use super::params::{Params, Slot};
use super::path::{PassStep, To, time};
use crate::math;

/// Depth of the flanks of a metric thread over its pitch, `17 √3 / 48`.
const FLANKS: f64 = 0.613_435;

/// Most cuts of a slot, and of a thread.
const MOST: f64 = 100.0;

impl Slot {
    /// Number of cuts; the last one is to size.
    pub(super) fn cuts(&self, stock: f64) -> f64 {
        math::whole_up(0.5 * (stock - self.diameter) / self.depth).max(1.0)
    }

    /// Number of cuts of the thread, each taking the same area: `(h / first)²`, rounded up, with the depth h of the flanks.
    pub(super) fn thread_cuts(&self) -> f64 {
        let ratio = FLANKS * self.pitch / self.thread_infeed;
        math::whole_up(ratio * ratio).max(1.0)
    }

    /// Diameter at the root of the thread, or the turned one: `d - 2 h`.
    pub(super) fn least_diameter(&self) -> f64 {
        self.diameter - 2.0 * FLANKS * self.pitch
    }

    /// Whether there are too many cuts.
    pub(super) fn is_endless(&self, stock: f64) -> bool {
        self.cuts(stock) > MOST || self.pitch > 0.0 && self.thread_cuts() > MOST
    }

    /// Turning: cuts to depth, the last with the chamfer. Each ends at feed out of the stock and goes back in front of the face.
    pub(super) fn steps(&self, p: &Params) -> Vec<PassStep> {
        let (feed, end) = (self.feed * self.speed, To::Along(-self.length));
        let back =
            [PassStep::Feed(To::Across(p.clear_diameter()), p.way_out()), PassStep::Rapid(To::Along(p.clearance))];
        let cuts = self.cuts(p.stock_diameter).min(MOST) as u32;
        let mut all = Vec::new();
        for cut in 1..=cuts {
            let last = cut == cuts;
            let size = if last { self.diameter } else { p.stock_diameter - 2.0 * f64::from(cut) * self.depth };
            if last && self.chamfer > 0.0 {
                all.push(PassStep::Rapid(To::Across(size - 2.0 * self.chamfer)));
                all.push(PassStep::Feed(To::Along(0.0), feed));
                all.push(PassStep::Slope(size, -self.chamfer, feed));
            } else {
                all.push(PassStep::Rapid(To::Across(size)));
            }
            all.push(PassStep::Feed(end, feed));
            all.extend(back);
        }
        all
    }

    /// Thread cutting, each cut from in front of the face.
    pub(super) fn thread(&self, p: &Params) -> Vec<PassStep> {
        let depth = FLANKS * self.pitch;
        let cuts = self.thread_cuts().min(MOST) as u32;
        let one = |cut: u32| {
            let down = depth * (f64::from(cut) / f64::from(cuts)).sqrt();
            [
                PassStep::Rapid(To::Across(self.diameter - 2.0 * down)),
                PassStep::Thread(-self.thread_length, self.pitch),
                PassStep::Feed(To::Across(p.clear_diameter()), p.way_out()),
                PassStep::Rapid(To::Along(p.clearance)),
            ]
        };
        if self.pitch > 0.0 { (1..=cuts).flat_map(one).collect() } else { Vec::new() }
    }

    /// Time at feed, s.
    pub(super) fn time(&self, p: &Params) -> f64 {
        let begin = (p.clear_diameter(), p.clearance);
        time(begin, self.steps(p).into_iter(), self.speed) + time(begin, self.thread(p).into_iter(), self.speed)
    }
}
