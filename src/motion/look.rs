//! Looking into a run: stopping before a block is read, seeing what the program sees, a second run from a checkpoint of the first.

use std::collections::VecDeque;

use super::plan::{Keep, Planner, Progress};
use super::program::Program;
use super::state::Records;
use crate::interp::{Canon, World};

/// What happens to a step of the program that is about to be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gate {
    /// It is read.
    Open,
    /// It is read, and [`Planner::given`] begins anew with it.
    Anew,
    /// The run stops before it.
    Shut,
}

/// Asked before each step of the program: at its time, with the program and the machine as the program would see it.
pub type Gatekeeper<'a, P> = &'a mut dyn FnMut(f64, &P, &mut dyn World) -> Gate;

/// Commands that are kept, the newest.
const GIVEN: usize = 8;

/// The commands of some steps of a program.
#[derive(Debug, Clone, Default)]
pub struct Given {
    newest: VecDeque<Canon>,
    count: u64,
}

impl Given {
    pub(super) fn add(&mut self, canon: &Canon) {
        if self.newest.len() == GIVEN {
            self.newest.pop_front();
        }
        self.newest.push_back(canon.clone());
        self.count += 1;
    }

    /// The newest of them, in the order of the program.
    pub fn newest(&self) -> impl Iterator<Item = &Canon> {
        self.newest.iter()
    }

    /// How many came before those.
    pub fn earlier(&self) -> u64 {
        self.count - self.newest.len() as u64
    }
}

impl<P: Program> Planner<P> {
    /// Plans on until the gate is shut, the run is over, or for `budget` events; whether the gate is shut.
    pub fn advance_to(&mut self, budget: usize, gate: Gatekeeper<P>) -> (Progress, bool) {
        self.plan(f64::INFINITY, budget, Some(gate))
    }

    /// Shows the program at the end of what is planned, and the machine as it would see it, but with the axes where they are.
    pub fn look<R>(&self, look: impl FnOnce(&P, &mut dyn World) -> R) -> R {
        let t = self.records.timeline.end();
        self.state.look(t, &self.records.timeline, look)
    }

    /// The commands that the program has given since the gate began anew.
    pub fn given(&self) -> Option<&Given> {
        self.records.given.as_ref()
    }

    /// A run of its own from the last checkpoint that fits (its time, the program there), or from the first: it comes to the same
    /// timeline. It keeps only the newest moments.
    pub fn fork(&self, fits: impl Fn(f64, &P) -> bool) -> Planner<P> {
        let last = self.checkpoints.iter().rposition(|point| fits(point.t, &point.state.program)).unwrap_or(0);
        let (timeline, state, t) = match self.checkpoints.get(last) {
            Some(point) => (self.records.timeline.up_to(&point.marks.timeline, point.t), point.state.clone(), point.t),
            None => (self.records.timeline.clone(), self.state.clone(), 0.0),
        };
        let mut machine = self.machine.clone();
        machine.log = false;
        Planner {
            records: Records {
                timeline,
                log: VecDeque::new(),
                taken: 0,
                diagnostics: Vec::new(),
                given: Some(Given::default()),
            },
            state,
            machine,
            panel: self.panel.clone(),
            checkpoints: Vec::new(),
            keep: Keep::Log,
            due: t,
            ended: None,
            has_last_word: false,
        }
    }
}
