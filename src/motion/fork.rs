//! A second run from a checkpoint of the first, for debuggers: it stops before a block, and shows what the program sees.

use std::collections::VecDeque;

use super::gate::Gatekeeper;
use super::plan::{Checkpoint, Planner};
use super::program::RunningProgram;
use super::records::Records;
use super::setup::{Progress, Retention};
use crate::interp::{Canon, World};

/// Newest commands that are kept for the debugger.
const GIVEN: usize = 8;

impl<P: RunningProgram> Planner<P> {
    /// As [`advance`](Planner::advance), but only until the gate is shut; whether it is. Of the log the newest commands stay.
    pub fn advance_to(&mut self, until: f64, budget: usize, gate: Gatekeeper<P>) -> (Progress, bool) {
        let answer = self.plan(until, budget, Some(gate));
        self.records.forget_log(GIVEN);
        answer
    }

    /// Shows the program at the end of what is planned, and the machine as it would see it, but with the axes where they are.
    pub fn look<R>(&self, look: impl FnOnce(&P, &mut dyn World) -> R) -> R {
        let t = self.records.timeline.end();
        self.state.look(t, &self.records.timeline, look)
    }

    /// The newest commands that the program has given since the gate began anew, where the run has a log, and how many came before.
    pub fn given(&self) -> (usize, impl Iterator<Item = &Canon>) {
        let log = &self.records.log;
        (self.records.taken.saturating_sub(self.records.anew), log.iter().map(|(_, canon, _)| canon))
    }

    /// A run of its own from the last checkpoint not after `t` at which at most so many blocks were read, or from the first: it comes to
    /// the same timeline. It keeps only the newest moments.
    pub fn fork(&self, t: f64, blocks: u64) -> Planner<P> {
        let fits = |point: &&Checkpoint<P>| {
            let read = point.state.program.blocks();
            point.t <= t && read.nc + read.macros <= blocks
        };
        let point = self.checkpoints.iter().rfind(fits).or(self.checkpoints.first());
        let now = self.records.marks();
        let (marks, state, t) = match point {
            Some(point) => (&point.marks, &point.state, point.t),
            None => (&now, &self.state, self.state.now),
        };
        let (timeline, state) = (self.records.timeline.up_to(&marks.timeline, t), state.clone());
        let log = VecDeque::new();
        Planner {
            records: Records { timeline, log, taken: 0, anew: 0, diagnostics: Vec::new() },
            state,
            plant: self.plant.clone(),
            panel: self.panel.clone(),
            checkpoints: Vec::new(),
            keep: Retention::Log,
            due: t,
            ended: None,
            has_last_word: false,
        }
    }
}
