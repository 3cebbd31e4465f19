//! Stepping: a second run beside the one that is shown, walked from block to block. The same behind page and command line.
//!
//! It comes from a checkpoint of the run that is shown and is a run like any other, so inputs, positions, overrides and time are those of
//! the run. It stops before a block is read; as the control reads ahead, the machine may be some blocks behind.

use super::breakpoints::Breakpoints;
pub use super::breakpoints::Stop;
use super::run::Run;
use crate::interp::inspect::{Change, Level};
use crate::interp::{Interp, World};
use crate::motion::{Event, Gate};
use crate::nc::{self, Stmt};
use crate::text::{Diagnostic, Place};

/// How far to go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Goal {
    /// To the next block, be it in what this one calls.
    Into,
    /// To the next block, with all that this one calls and repeats.
    Over,
    /// Behind the block that called; from the start program to its end.
    Out,
    /// To this block.
    To(Place),
    /// To a breakpoint or the end.
    Continue,
    /// To the block before which so many were read, past all breakpoints.
    Block(u64),
}

/// So many blocks before the one that is searched, at least, the walk to it begins: nobody writes longer comments.
const LEAD: u64 = 200;

/// A walk through a run.
pub struct Debugger {
    run: Run,
    walk: Walk,
}

/// A block that is about to be read.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Here {
    /// Blocks that were read before it.
    number: u64,
    place: Place,
}

struct Walk {
    goal: Goal,
    /// Blocks that are read before this time are none to stop at.
    from: f64,
    /// Calls that were open at the first block that was.
    depth: Option<usize>,
    /// The block that the walk stands before.
    here: Option<Here>,
    /// The block that it is about to leave: no reason to stop.
    leaving: Option<Here>,
    /// Number of the block that was read last.
    last: Option<u64>,
    /// The program before what changes are told against.
    before: Option<Interp>,
    stop: Option<Stop>,
}

fn number(interp: &Interp) -> u64 {
    let counts = interp.blocks();
    counts.nc + counts.macros
}

impl Walk {
    fn new(goal: Goal, from: f64) -> Walk {
        Walk { goal, from, depth: None, here: None, leaving: None, last: None, before: None, stop: None }
    }

    fn gate(&mut self, points: &mut Breakpoints, t: f64, interp: &Interp, world: &mut dyn World) -> Gate {
        let Some((place, block)) = interp.next_block() else { return Gate::Open };
        // Nobody steps through comments.
        let idle = block.stmt == Stmt::Empty && block.number.is_none();
        let here = Here { number: number(interp), place };
        let leaves = self.leaving.take() == Some(here);
        // The way to where the walk begins.
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
            return Gate::Anew;
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
    /// A walk to a goal from the first block on that `main` reads at time `t` or later; that block itself may be the goal. What `main` has
    /// planned already is a short way.
    pub fn new(main: &Run, t: f64, goal: Goal) -> Debugger {
        // The block before it has to be on the way, for `back` and for what it changed.
        let read = number(main.fork(t, u64::MAX).program());
        let run = main.fork(t, read.saturating_sub(LEAD));
        Debugger { run, walk: Walk::new(goal, t) }
    }

    /// Sets a goal from the present block on.
    pub fn go(&mut self, goal: Goal) {
        self.walk.goal = goal;
        self.walk.depth = Some(self.run.program().depth());
        self.walk.leaving = self.walk.here.take();
    }

    /// Goes back to the block that was read before. Whether there is one.
    pub fn back(&mut self, main: &Run) -> bool {
        let Some(to) = self.walk.last else { return false };
        self.run = main.fork(f64::INFINITY, to.saturating_sub(LEAD));
        self.walk = Walk::new(Goal::Block(to), 0.0);
        true
    }

    /// The operator does something now; the goal is the present block, or the next one if the run waited.
    pub fn act(&mut self, event: Event) {
        self.run.event(event);
        self.walk.goal = Goal::Block(number(self.run.program()));
    }

    /// Walks on, at most to machine time `until` and for `budget` events of the machine; why the walk is over, if it is.
    pub fn advance(&mut self, points: &mut Breakpoints, until: f64, budget: usize) -> Option<Stop> {
        let walk = &mut self.walk;
        let gate = &mut |t: f64, interp: &Interp, world: &mut dyn World| walk.gate(points, t, interp, world);
        let (progress, shut) = self.run.advance_to(until, budget, gate);
        if shut { self.walk.stop.take() } else { progress.ended.map(Stop::Ended) }
    }

    /// Machine time in seconds.
    pub fn t(&self) -> f64 {
        self.run.timeline().end()
    }

    /// The run at the stop.
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// The block that is about to be read; after an alarm or the end the one that was read last.
    pub fn place(&self) -> Option<Place> {
        self.levels().first().map(|level| level.place)
    }

    /// The block that the machine executes.
    pub fn executing(&self) -> Option<Place> {
        self.run.timeline().block_at(self.t())
    }

    /// What runs, the innermost first.
    pub fn levels(&self) -> Vec<Level> {
        self.run.program().levels()
    }

    /// What is other than before the last goal was set; after a search, what the last block changed.
    pub fn changes(&self) -> Vec<Change> {
        let Some(before) = &self.walk.before else { return Vec::new() };
        self.run.look(|interp, world| interp.changes_since(before, world))
    }

    /// The value of an expression or condition as the program would find it now; `None` is vacant.
    pub fn evaluate(&self, text: &str) -> Result<Option<f64>, Box<Diagnostic>> {
        self.run.look(|interp, world| interp.evaluate(&nc::formula(text, interp.parsed())?, world))
    }
}
