//! The passes from stock to finished part: their number, their cuts, and the stock left after each.

use crate::drives::cutting::Cut;
use crate::machines::turning_spindle::params::{Params, Path};
use crate::math;

/// Stock (mm) that is no pass of its own: half of the least increment of X and Z. The sums of the program end within it.
pub(in crate::machines::turning_spindle) const TRACE: f64 = 0.0005;

/// Greatest number of passes.
pub(in crate::machines::turning_spindle) const PASSES: f64 = 2000.0;

impl Params {
    /// Stock to cut, mm: along Z on a face, else in diameter.
    fn stock(&self) -> f64 {
        match self.path {
            Path::Facing => self.allowance,
            Path::Turning => self.stock_diameter - self.finished_diameter,
            Path::Taper => self.stock_diameter - self.finished_diameter.min(self.large_diameter),
        }
    }

    /// What a depth of cut of 1 mm takes from the stock to cut, mm.
    fn taken(&self) -> f64 {
        if self.path == Path::Facing { 1.0 } else { 2.0 }
    }

    /// The entered depth of cut, at most the whole stock: deeper, the tool would still cut no more in its single pass. mm.
    pub(in crate::machines::turning_spindle) fn greatest_depth(&self) -> f64 {
        let whole = self.stock() / self.taken();
        if whole > 0.0 { self.depth.min(whole) } else { self.depth }
    }

    /// Passes from stock to finished part.
    pub(in crate::machines::turning_spindle) fn passes(&self) -> f64 {
        math::clamp(math::whole_up((self.stock() - TRACE) / (self.taken() * self.depth)), 0.0, PASSES)
    }

    /// Stock that remains after pass `pass` (from 1), mm: along Z on a face, else in diameter.
    pub(in crate::machines::turning_spindle) fn left(&self, pass: f64) -> f64 {
        (self.stock() - pass * self.taken() * self.depth).max(0.0)
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
