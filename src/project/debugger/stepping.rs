//! Stepping: a second run, forked from a checkpoint of the main run, that stops before chosen blocks. Used by page and command line.
//!
//! Inputs, positions, overrides and time are those of the main run. The run stops before a block is read; as the control reads ahead, the
//! machine may still execute an earlier block.

use super::breakpoints::Breakpoints;
pub use super::breakpoints::Stop;
use crate::interp::inspect::{CallLevel, Change};
use crate::interp::{Interp, World};
use crate::motion::{Event, Gate, GatedProgress};
use crate::nc::{self, Stmt};
use crate::project::run::Run;
use crate::text::{Diagnostic, Place};

/// Goal of a step command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Goal {
    /// The next block, also inside a called program.
    Into,
    /// The next block of this program or of a caller, after all calls and repeats of this block.
    Over,
    /// The block after the call of this program; in the start program, its end.
    Out,
    /// A block by its place.
    To(Place),
    /// A breakpoint or the end.
    Continue,
    /// The block with this number of blocks read before it; breakpoints are ignored.
    Block(u64),
}

/// A fork starts at least this many blocks before its target, so that `back` finds the preceding block even across comments.
const LEAD: u64 = 200;

/// Steps through a run.
pub struct Debugger {
    run: Run,
    gate: StepGate,
}

/// A block in front of the reader.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Here {
    /// Number of blocks read before it.
    number: u64,
    place: Place,
}

/// Decides before each block whether the run stops.
struct StepGate {
    goal: Goal,
    /// Earliest time (s) for a stop.
    from: f64,
    /// Call depth at the first block after `from`.
    depth: Option<usize>,
    /// The block in front of which the run has stopped.
    here: Option<Here>,
    /// The block that the next step executes: no stop there.
    leaving: Option<Here>,
    /// Number of the block read last.
    last: Option<u64>,
    /// State of the program that changes are compared with.
    before: Option<Interp>,
    stop: Option<Stop>,
}

fn number(interp: &Interp) -> u64 {
    let counts = interp.blocks();
    counts.nc + counts.macros
}

impl StepGate {
    fn new(goal: Goal, from: f64) -> StepGate {
        StepGate { goal, from, depth: None, here: None, leaving: None, last: None, before: None, stop: None }
    }

    fn answer(&mut self, points: &mut Breakpoints, t: f64, interp: &Interp, world: &mut dyn World) -> Gate {
        let Some((place, block)) = interp.next_block() else { return Gate::Open };
        // Comments are no steps.
        let idle = block.stmt == Stmt::Empty && block.number.is_none();
        let here = Here { number: number(interp), place };
        let leaves = self.leaving.take() == Some(here);
        // Before the time or block from which stops count.
        let early = t < self.from || matches!(self.goal, Goal::Block(to) if here.number < to);
        if !leaves && !early {
            let depth = *self.depth.get_or_insert(interp.depth());
            self.stop = match self.goal {
                Goal::Block(_) => None,
                _ => points.stop(place, interp, world),
            };
            if self.stop.is_none() && self.reaches(place, interp.depth(), depth, idle) {
                self.stop = Some(Stop::Reached);
            }
            if self.stop.is_some() {
                self.here = Some(here);
                return Gate::Shut;
            }
        }
        if idle && !leaves {
            return Gate::Open;
        }
        self.last = Some(here.number);
        if leaves || early || self.before.is_none() {
            self.before = Some(interp.clone());
            return Gate::OpenAsFirst;
        }
        Gate::Open
    }

    fn reaches(&self, place: Place, now: usize, depth: usize, idle: bool) -> bool {
        match self.goal {
            Goal::To(goal) => place == goal,
            Goal::Block(_) => true,
            _ if idle => false,
            Goal::Into => true,
            Goal::Over => now <= depth,
            Goal::Out => now < depth,
            Goal::Continue => false,
        }
    }
}

impl Debugger {
    /// Steps to a goal from the first block that `main` reads at time `t` or later; that block itself may be the goal. The fork starts at a
    /// checkpoint of `main`, so planned parts take little time.
    pub fn new(main: &Run, t: f64, goal: Goal) -> Debugger {
        // The block before must be executed too: `back` and `changes` need it.
        let read = number(main.fork(t, u64::MAX).program());
        let run = main.fork(t, read.saturating_sub(LEAD));
        Debugger { run, gate: StepGate::new(goal, t) }
    }

    /// Sets a goal, counted from the present block.
    pub fn go(&mut self, goal: Goal) {
        self.gate.goal = goal;
        self.gate.depth = Some(self.run.program().depth());
        self.gate.leaving = self.gate.here.take();
    }

    /// Goes back to the block read before; false where there is none.
    pub fn back(&mut self, main: &Run) -> bool {
        let Some(to) = self.gate.last else { return false };
        self.run = main.fork(f64::INFINITY, to.saturating_sub(LEAD));
        self.gate = StepGate::new(Goal::Block(to), 0.0);
        true
    }

    /// Applies an operator's action now; the goal is the present block, or the next one if the run waited.
    pub fn act(&mut self, event: Event) {
        self.run.event(event);
        self.gate.goal = Goal::Block(number(self.run.program()));
    }

    /// Runs on, at most to machine time `until` (s) and for `budget` events of the machine; the reason of the stop, if there is one.
    pub fn advance(&mut self, points: &mut Breakpoints, until: f64, budget: usize) -> Option<Stop> {
        let gate = &mut self.gate;
        let gate = &mut |t: f64, interp: &Interp, world: &mut dyn World| gate.answer(points, t, interp, world);
        let GatedProgress { progress, is_shut } = self.run.advance_to(until, budget, gate);
        if is_shut { self.gate.stop.take() } else { progress.ended.map(Stop::Ended) }
    }

    /// Machine time in seconds.
    pub fn t(&self) -> f64 {
        self.run.timeline().end()
    }

    /// The run at the stop.
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// The next block; after an alarm or the end the last one.
    pub fn place(&self) -> Option<Place> {
        self.levels().first().map(|level| level.place)
    }

    /// The block that the machine executes.
    pub fn executing(&self) -> Option<Place> {
        self.run.timeline().block_at(self.t())
    }

    /// The call stack, innermost first.
    pub fn levels(&self) -> Vec<CallLevel> {
        self.run.program().levels()
    }

    /// Changes since the last goal was set; after a search, changes by the last block.
    pub fn changes(&self) -> Vec<Change> {
        let Some(before) = &self.gate.before else { return Vec::new() };
        self.run.look(|interp, world| interp.changes_since(before, world))
    }

    /// Value of an expression or condition in the present state of the program; `None` is vacant.
    pub fn evaluate(&self, text: &str) -> Result<Option<f64>, Box<Diagnostic>> {
        self.run.look(|interp, world| interp.evaluate(&nc::formula(text, interp.parsed())?, world))
    }
}
