//! The formulas of the ribbon line, each once: results that need no run, by subject.
//!
//! Lengths in mm, speeds in mm/min unless noted otherwise, times in seconds. The equations (1) to (4) are the paper's. At standstill
//! (override 0) the times of a pitch are infinite.

mod accuracy;
mod dancer;
mod feeds;
mod passes;
mod printing;
mod product;
mod rollers;
mod slack;
mod start;
mod tension;
mod timing;
mod unwinder;

pub(super) use dancer::TRIM;
pub(super) use product::{PITCH_TOLERANCE, SHORTEST};
pub(super) use start::{AT_SPEED, FIN_DELAY, least_dwell};

use super::params::Params;
use crate::controls::AnalogOutput;
use accuracy::Accuracy;
use feeds::LineFeeds;
use printing::PrintSurface;
use product::Product;
use slack::Slack;
use tension::Tension;
use timing::LineTiming;
use unwinder::UnwinderSpeed;

/// The results.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Derived {
    pub unwinder: UnwinderSpeed,
    pub feeds: LineFeeds,
    pub surface: PrintSurface,
    pub timing: LineTiming,
    pub product: Product,
    pub slack: Slack,
    pub tension: Tension,
    pub accuracy: Accuracy,
}

impl Derived {
    /// Computes the results for the analog output of a control.
    pub(super) fn new(p: &Params, output: &AnalogOutput) -> Derived {
        let unwinder = UnwinderSpeed::new(p, output);
        let feeds = LineFeeds::new(p, &unwinder);
        let timing = LineTiming::new(p, &unwinder, &feeds);
        let slack = Slack::new(p, &unwinder, &feeds, &timing);
        Derived {
            surface: PrintSurface::new(p, &feeds),
            product: Product::new(p, &timing),
            tension: Tension::new(p, &unwinder, &slack),
            accuracy: Accuracy::new(p, &feeds, &timing),
            unwinder,
            feeds,
            timing,
            slack,
        }
    }
}

/// The greatest value of a quantity, at least 0, over several positions of the knob.
pub(super) fn greatest<'a>(over: impl IntoIterator<Item = &'a Derived>, of: impl Fn(&Derived) -> f64) -> f64 {
    over.into_iter().map(of).fold(0.0, f64::max)
}
