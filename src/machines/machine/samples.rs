//! Samples of a run: the machine at a time, and when the blocks of its program execute.

use crate::motion::{Planner, RunningProgram, Snapshot, Visit};

/// Executions of a block of the program up to a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Executions {
    /// Number of executions begun.
    pub begun: u32,
    /// Whether the block executes at this time.
    pub executes: bool,
}

/// Samples of a run, for charts and poses.
pub trait Samples {
    /// The machine at time `t`.
    fn at(&self, t: f64) -> Snapshot;
    /// Executions up to time `t` of the block with this sequence number in the started program.
    fn executions(&self, sequence: u32, t: f64) -> Executions;
    /// Spans (s) up to time `t` in which that block executes.
    fn execution_spans(&self, sequence: u32, t: f64) -> Vec<(f64, f64)>;
    /// Visits of the commands of two axes (by index) to the region where both are below their limits, up to time `t`.
    fn visits(&self, below: [(usize, f64); 2], t: f64) -> Vec<Visit>;
}

impl<P: RunningProgram> Samples for Planner<P> {
    fn at(&self, t: f64) -> Snapshot {
        self.timeline().at(t)
    }

    fn executions(&self, sequence: u32, t: f64) -> Executions {
        let Some(place) = self.program().numbered(sequence) else { return Executions::default() };
        let timeline = self.timeline();
        Executions { begun: timeline.times(place, t), executes: timeline.block_at(t) == Some(place) }
    }

    fn execution_spans(&self, sequence: u32, t: f64) -> Vec<(f64, f64)> {
        let Some(place) = self.program().numbered(sequence) else { return Vec::new() };
        let timeline = self.timeline();
        let end = |begin: f64| timeline.next_other_block(begin).map_or(t, |end| end.min(t));
        timeline.begins(place).take_while(|begin| *begin < t).map(|begin| (begin, end(begin))).collect()
    }

    fn visits(&self, below: [(usize, f64); 2], t: f64) -> Vec<Visit> {
        self.timeline().visits(below, t)
    }
}
