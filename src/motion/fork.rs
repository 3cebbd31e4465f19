//! A second run from a checkpoint of the first, for debuggers: stops before a block and shows variables and inputs as read by the program.

use std::collections::VecDeque;

use super::gate::Gatekeeper;
use super::plan::{Checkpoint, Planner};
use super::program::RunningProgram;
use super::records::Records;
use super::setup::{GatedProgress, Retention};
use crate::interp::{Canon, World};

/// Number of newest commands kept for the debugger.
const COMMANDS_KEPT: usize = 8;

impl<P: RunningProgram> Planner<P> {
    /// Plans like [`advance`](Planner::advance), but stops at a shut gate. The log keeps the newest commands.
    pub fn advance_to(&mut self, until: f64, budget: usize, gate: Gatekeeper<P>) -> GatedProgress {
        let progress = self.plan(until, budget, Some(gate));
        self.records.forget_log(COMMANDS_KEPT);
        progress
    }

    /// Calls `look` with the program at the end of the planned part and the machine as read by it, but with the present axis positions.
    pub fn look<R>(&self, look: impl FnOnce(&P, &mut dyn World) -> R) -> R {
        let t = self.records.timeline.end();
        self.state.look(t, &self.plant.axes, &self.records.timeline, look)
    }

    /// The newest commands since [`Gate::OpenAsFirst`], if the run has a log, and the number of earlier ones.
    pub fn newest_commands(&self) -> (usize, impl Iterator<Item = &Canon>) {
        let log = &self.records.log;
        (self.records.taken.saturating_sub(self.records.first_kept), log.iter().map(|(_, canon, _)| canon))
    }

    /// A run from the last checkpoint not after `t` (s) with at most `blocks` blocks read, or from the first checkpoint. Its timeline is
    /// the same; it keeps only the newest part.
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
            records: Records { timeline, log, taken: 0, first_kept: 0, diagnostics: Vec::new() },
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

    /// A second run from the last checkpoint not after `t` (s), where its timeline begins. Operator events added to it leave this run as it
    /// is. It keeps the same records as this run, without copying the earlier part.
    pub fn branch(&self, t: f64) -> Planner<P> {
        Planner { keep: self.keep, ..self.fork(t, u64::MAX) }
    }
}
