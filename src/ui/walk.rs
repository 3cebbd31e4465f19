//! The debugger of the page as data: where it is, breakpoints, watches.

use super::dom;
use crate::project::breakpoints::Breakpoints;
use crate::project::debug::{Debugger, Stop};
use crate::text::{FileId, Place};

/// Events of the machine between two looks at the clock.
const STEPS: usize = 64;

/// The debugger of the page.
#[derive(Default)]
pub(super) struct Walk {
    /// The second run, beside the one that is shown.
    pub debugger: Option<Debugger>,
    /// Whether it has stopped at the head.
    pub stands: bool,
    /// Why it has stopped, and before which block.
    pub why: String,
    /// Whether it is under way.
    pub going: bool,
    /// Whether the next slice is scheduled.
    pub slicing: bool,
    /// Breakpoints.
    pub points: Breakpoints,
    /// Expressions shown at every stop.
    pub watches: Vec<String>,
    /// The line of the commands.
    pub cursor: Option<(FileId, u32)>,
}

impl Walk {
    /// The debugger, where it has stopped.
    pub(super) fn stands(&self) -> Option<&Debugger> {
        self.debugger.as_ref().filter(|_| self.stands)
    }

    /// The block before which it has stopped.
    pub(super) fn place(&self) -> Option<Place> {
        self.stands()?.place()
    }

    /// Its time, under way too.
    pub(super) fn t(&self) -> f64 {
        self.debugger.as_ref().map_or(0.0, Debugger::t)
    }

    /// Walks up to `until` seconds for at most `budget` milliseconds; the reason where it stops before.
    pub(super) fn advance(&mut self, until: f64, budget: f64) -> Option<Stop> {
        let begun = dom::now();
        let debugger = self.debugger.as_mut()?;
        loop {
            let stop = debugger.advance(&mut self.points, until, STEPS);
            if stop.is_some() || debugger.t() >= until || dom::now() - begun > budget {
                return stop;
            }
        }
    }
}
