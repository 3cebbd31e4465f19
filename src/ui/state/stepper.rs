//! The debugger of the page as data: where it is, breakpoints, watches.

use crate::project::debugger::breakpoints::Breakpoints;
use crate::project::debugger::stepping::{Debugger, Stop};
use crate::text::{FileId, Place};
use crate::ui::dom;

/// Events of the machine between two looks at the clock.
const STEPS: usize = 64;

/// The debugger of the page.
#[derive(Default)]
pub(crate) struct Stepper {
    /// The second run, beside the shown one.
    pub debugger: Option<Debugger>,
    /// Whether the debugger has stopped at the play head.
    pub at_stop: bool,
    /// Reason for the stop, and the block before which it stopped.
    pub why: String,
    /// Whether the debugger is running.
    pub going: bool,
    /// Whether the next slice is scheduled.
    pub slicing: bool,
    /// Breakpoints.
    pub points: Breakpoints,
    /// Expressions shown at every stop.
    pub watches: Vec<String>,
    /// Line that the commands act on: file, and number from 1.
    pub cursor: Option<(FileId, u32)>,
}

impl Stepper {
    /// The debugger, where it has stopped.
    pub(crate) fn stopped(&self) -> Option<&Debugger> {
        self.debugger.as_ref().filter(|_| self.at_stop)
    }

    /// The block before which it has stopped.
    pub(crate) fn place(&self) -> Option<Place> {
        self.stopped()?.place()
    }

    /// Machine time (s), also while it runs.
    pub(crate) fn t(&self) -> f64 {
        self.debugger.as_ref().map_or(0.0, Debugger::t)
    }

    /// Steps up to `until` (s) for at most `budget` milliseconds; returns the reason if it stops earlier.
    pub(crate) fn advance(&mut self, until: f64, budget: f64) -> Option<Stop> {
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
