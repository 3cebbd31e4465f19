//! The passes from stock to finished part: their number, their cuts, and the stock left after each.

use crate::drives::cutting::Cut;
use crate::machines::turning_spindle::params::{Params, Path};
use crate::math;

/// Greatest number of passes.
pub(in crate::machines::turning_spindle) const PASSES: f64 = 2000.0;

impl Params {
    /// Passes from stock to finished part.
    pub(in crate::machines::turning_spindle) fn passes(&self) -> f64 {
        let depth = match self.path {
            Path::Facing => self.allowance,
            Path::Turning => 0.5 * (self.stock_diameter - self.finished_diameter),
            Path::Taper => 0.5 * (self.stock_diameter - self.finished_diameter.min(self.large_diameter)),
        };
        // Nine decimals: 0.3 / 0.1 is three passes.
        math::clamp(math::whole_up(depth / self.depth), 0.0, PASSES)
    }

    /// Stock that remains after pass `pass` (from 1), mm: along Z on a face, else in diameter.
    pub(in crate::machines::turning_spindle) fn left(&self, pass: f64) -> f64 {
        match self.path {
            Path::Facing => (self.allowance - pass * self.depth).max(0.0),
            Path::Turning => (self.stock_diameter - self.finished_diameter - 2.0 * pass * self.depth).max(0.0),
            Path::Taper => {
                let small = self.finished_diameter.min(self.large_diameter);
                (self.stock_diameter - small - 2.0 * pass * self.depth).max(0.0)
            }
        }
    }

    /// The cuts of a pass (from 1), one or two. They begin at the clearance.
    pub(in crate::machines::turning_spindle) fn cuts(&self, pass: f64) -> impl Iterator<Item = Cut> {
        let (feed, clear) = (self.feed, self.clearance);
        let along = |diameter: f64, length: f64| Cut { diameters: (diameter, diameter), length, feed };
        let cuts = match self.path {
            Path::Facing => {
                let from = self.stock_diameter + 2.0 * clear;
                let length = (0.5 * (from - self.finished_diameter)).max(0.0);
                [Some(Cut { diameters: (from, self.finished_diameter), length, feed }), None]
            }
            Path::Turning => [Some(along(self.finished_diameter + self.left(pass), self.length + clear)), None],
            Path::Taper => {
                let offset = self.left(pass);
                let (face, end) = (self.finished_diameter + offset, self.large_diameter + offset);
                // A pass begins and ends where its line is clear of the stock.
                let most = self.stock_diameter + 2.0 * clear;
                let (from, to) = (face.min(most), end.min(most));
                let share = if face == end { 1.0 } else { (to - from) / (end - face) };
                let length = share * math::hypot(self.length, 0.5 * (end - face));
                [Some(along(from, clear)), Some(Cut { diameters: (from, to), length, feed })]
            }
        };
        cuts.into_iter().flatten()
    }
}
