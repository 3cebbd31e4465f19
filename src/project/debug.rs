//! Stepping: a second run beside the one that is shown, walked from block to block. The same behind page and command line.
//!
//! It comes from a checkpoint of the run that is shown and is a run like any other, so inputs, positions, overrides and time are those of
//! the run. It stops before a block is read; as the control reads ahead, the machine may be some blocks behind.

use super::breakpoints::Breakpoints;
use super::run::Run;
use crate::interp::inspect::{Change, Level};
use crate::interp::{Interp, World};
use crate::motion::{Event, Gate, Given, RunEnd};
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
    /// To the first block that is read at this time or later, past all breakpoints.
    Time(f64),
    /// To the block before which so many were read, past all breakpoints.
    Block(u64),
}

/// Why a walk is over.
#[derive(Debug, Clone, PartialEq)]
pub enum Stop {
    /// The goal is reached.
    Reached,
    /// A breakpoint, by its number.
    Breakpoint(u32),
    /// The condition of a breakpoint, by its number, has no value here.
    Condition(u32, Box<Diagnostic>),
    /// The run is over, or waits for the operator.
    Ended(RunEnd),
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
    /// Calls that were open when the goal was set.
    depth: usize,
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
    fn new(goal: Goal) -> Walk {
        Walk { goal, depth: 0, here: None, leaving: None, last: None, before: None, stop: None }
    }

    /// Whether the goal is a place in the past or a moment, to be found again whatever lies between.
    fn finds(&self) -> bool {
        matches!(self.goal, Goal::Time(_) | Goal::Block(_))
    }

    fn gate(&mut self, points: &mut Breakpoints, t: f64, interp: &Interp, world: &mut dyn World) -> Gate {
        let Some((place, block)) = interp.next_block() else { return Gate::Open };
        // Nobody steps through comments.
        let idle = block.stmt == Stmt::Empty && block.number.is_none();
        let here = Here { number: number(interp), place };
        let leaves = self.leaving.take() == Some(here);
        if !leaves {
            self.stop = match self.finds() {
                true => None,
                false => points.stop(place, interp, world),
            };
            if self.stop.is_none() && self.reaches(here, t, interp.depth(), idle) {
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
        if leaves || self.finds() || self.before.is_none() {
            self.before = Some(interp.clone());
            return Gate::Anew;
        }
        Gate::Open
    }

    fn reaches(&self, here: Here, t: f64, depth: usize, idle: bool) -> bool {
        match self.goal {
            Goal::To(place) => here.place == place,
            Goal::Block(number) => here.number >= number,
            _ if idle => false,
            Goal::Into => true,
            Goal::Over => depth <= self.depth,
            Goal::Out => depth < self.depth,
            Goal::Continue => false,
            Goal::Time(until) => t >= until,
        }
    }
}

impl Debugger {
    /// A walk that goes to the first block that `main` reads at time `t` or later; `main` has to be planned up to there.
    pub fn new(main: &Run, t: f64) -> Debugger {
        // The block before it has to be on the way, for `back` and for what it changed.
        let read = number(main.fork(|at, _| at <= t).program());
        let run = main.fork(|at, interp| at <= t && number(interp) + LEAD <= read);
        Debugger { run, walk: Walk::new(Goal::Time(t)) }
    }

    /// Sets a goal from the present block on.
    pub fn go(&mut self, goal: Goal) {
        self.walk.goal = goal;
        self.walk.depth = self.run.program().depth();
        self.walk.leaving = self.walk.here.take();
    }

    /// Goes back to the block that was read before; `main` has to be planned up to [`t`](Debugger::t). Whether there is one.
    pub fn back(&mut self, main: &Run) -> bool {
        let Some(to) = self.walk.last else { return false };
        self.run = main.fork(|_, interp| number(interp) + LEAD <= to);
        self.walk = Walk::new(Goal::Block(to));
        true
    }

    /// The operator does something now; the goal is the present block, or the next one if the run waited.
    pub fn act(&mut self, event: Event) {
        self.run.event(event);
        self.walk.goal = Goal::Block(number(self.run.program()));
    }

    /// Walks on for at most `budget` events of the machine; why the walk is over, if it is.
    pub fn advance(&mut self, points: &mut Breakpoints, budget: usize) -> Option<Stop> {
        let walk = &mut self.walk;
        let (progress, shut) = self.run.advance_to(budget, &mut |t, interp, world| walk.gate(points, t, interp, world));
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

    /// The commands that were given since then.
    pub fn given(&self) -> Option<&Given> {
        self.run.given()
    }

    /// The value of an expression or condition as the program would find it now; `None` is vacant.
    pub fn evaluate(&self, text: &str) -> Result<Option<f64>, Box<Diagnostic>> {
        self.run.look(|interp, world| interp.evaluate(&nc::formula(text, interp.control())?, world))
    }
}
