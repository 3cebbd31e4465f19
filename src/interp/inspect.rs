//! Looking at a run between two blocks without touching it: next block, levels, the value of an expression, what has changed.

use super::Interp;
use super::fault::Trap;
use super::state::{Cx, State};
use super::vars::{LOCALS, VACANT};
use super::world::World;
use crate::controls::{Group, VarKind};
use crate::nc::{Block, Formula};
use crate::text::{Diagnostic, FileId, Place, Span};

/// How a level was entered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Entered {
    /// The program that the run started with.
    Start,
    /// As a subprogram: it shares the local variables of its caller.
    Subprogram,
    /// As a macro, with local variables of its own.
    Macro,
}

/// A program that runs, or waits for what it called.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// Number of the program; 0 where it has none.
    pub program: u32,
    /// How it was entered.
    pub entered: Entered,
    /// The block that is next, or the one that called.
    pub place: Place,
    /// How often it runs again after this time.
    pub again: u32,
    /// Level of the local variables in force, from 0.
    pub level: usize,
    /// Those that are not vacant, by number.
    pub locals: Vec<(u32, f64)>,
}

/// What a change is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// A variable that all levels share, by number.
    Variable(u32),
    /// A variable of the level that runs.
    Local(u32),
    /// A code of a modal group: the values are its number.
    Code,
    /// A word that stays in force, by its letter.
    Word(u8),
}

/// What is other than it was; `None` is vacant, or nothing yet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// What it is about.
    pub what: What,
    /// As it was.
    pub before: Option<f64>,
    /// As it is.
    pub after: Option<f64>,
}

/// Words that stay in force and are told when they change; S, M and T are told by the commands they give.
const WORDS: &[u8] = b"F";

/// A value as people look at it: vacant is nothing.
fn shown(value: f64) -> Option<f64> {
    (!value.is_nan()).then_some(value)
}

fn change(what: What, before: f64, after: f64) -> Option<Change> {
    let (before, after) = (shown(before), shown(after));
    (before != after).then_some(Change { what, before, after })
}

impl Interp {
    /// The block that the next step reads for the first time; `None` while the last one is not over, where it is waited for, and at the end.
    pub fn next_block(&self) -> Option<(Place, &Block)> {
        let state = &self.state;
        let between = state.queue.is_empty() && state.ended.is_none() && !state.pause && !state.synced;
        let block =
            self.shared.parsed.deck().blocks.get(state.at as usize).filter(|_| between && state.at < state.end)?;
        Some((Place { file: state.file, span: block.span }, block))
    }

    /// What runs, the innermost first.
    pub fn levels(&self) -> Vec<Level> {
        let (state, deck) = (&self.state, self.shared.parsed.deck());
        let mut levels = Vec::with_capacity(state.frames.len() + 1);
        let mut level = 0;
        for at in 0..=state.frames.len() {
            let by = at.checked_sub(1).and_then(|at| state.frames.get(at));
            let arguments = by.is_some_and(|frame| frame.arguments.is_some());
            level += usize::from(arguments);
            let (program, place) = match state.frames.get(at) {
                // Behind the block that called stands the one that the return goes on with.
                Some(frame) => (frame.program, self.place_of(frame.program, frame.back.saturating_sub(1))),
                None => (state.program, self.next_block().map_or(state.place, |(place, _)| place)),
            };
            let entered = match by {
                None => Entered::Start,
                Some(_) if arguments => Entered::Macro,
                Some(_) => Entered::Subprogram,
            };
            let values = (1..).zip(state.vars.locals_of(level));
            levels.push(Level {
                program: deck.programs.get(program as usize).map_or(0, |program| program.number),
                entered,
                place,
                again: by.map_or(0, |frame| frame.again),
                level,
                locals: values.filter(|(_, value)| !value.is_nan()).collect(),
            });
        }
        levels.reverse();
        levels
    }

    fn place_of(&self, program: u32, block: u32) -> Place {
        let deck = self.shared.parsed.deck();
        let file = deck.programs.get(program as usize).map_or(FileId::default(), |program| program.file);
        let span = deck.blocks.get(block as usize).map_or(Span::default(), |block| block.span);
        Place { file, span }
    }

    /// The value of an expression here and now, 1 or 0 for a condition; `None` is vacant. What waits for the machine at rest in a program
    /// is taken as the world has it.
    pub fn evaluate(&self, formula: &Formula, world: &mut dyn World) -> Result<Option<f64>, Box<Diagnostic>> {
        let control = self.shared.control;
        let mut cx = Cx { shared: &self.shared, control, deck: formula.deck(), world };
        let value = match self.state.value(&mut cx, formula.root()) {
            Err(Trap::Sync) => State { synced: true, ..self.state.clone() }.value(&mut cx, formula.root()),
            value => value,
        };
        match value {
            // -0 is 0.
            Ok(value) => Ok(shown(value + 0.0)),
            Err(Trap::Sync) => Ok(None),
            Err(Trap::Alarm(fault)) => {
                let mut diagnostic = fault.diagnostic(&self.shared.parsed, Place::default());
                diagnostic.place = None;
                Err(Box::new(diagnostic))
            }
        }
    }

    /// What is other than it was in an earlier state of the same run: variables in the order of their numbers, then codes and words.
    pub fn changes_since(&self, earlier: &Interp, world: &mut dyn World) -> Vec<Change> {
        let (now, then, index) = (&self.state, &earlier.state, &self.shared.index);
        let (shared, control, deck) = (&*self.shared, self.shared.control, self.shared.parsed.deck());
        let mut cx = Cx { shared, control, deck, world };
        let (level, was) = (now.vars.level(), then.vars.level());
        let locals = now.vars.locals_of(level).into_iter().zip(if level <= was {
            then.vars.locals_of(level)
        } else {
            [VACANT; LOCALS]
        });
        let mut changes: Vec<Change> =
            (1..).zip(locals).filter_map(|(number, (now, then))| change(What::Local(number), then, now)).collect();
        for (at, row) in self.shared.control.vars.iter().enumerate() {
            for number in row.first..=row.last {
                let Some(slot) = index.stored_at(row, at, number) else { break };
                let [then, now] = [then, now].map(|state| match row.kind {
                    VarKind::Common | VarKind::Retained => state.vars.common(slot),
                    // These have a value from the start.
                    _ => shown(state.vars.common(slot)).unwrap_or(0.0),
                });
                changes.extend(change(What::Variable(number), then, now));
            }
            let clock = match row.kind {
                VarKind::PowerOnTime(_) => 0,
                VarKind::RunTime(_) => 1,
                _ => continue,
            };
            if now.clock_zero[clock] != then.clock_zero[clock] {
                let after = now.read(&mut cx, row.first).ok().and_then(shown);
                changes.push(Change { what: What::Variable(row.first), before: None, after });
            }
        }
        for (group, (&now, &then)) in now.modal.codes.iter().zip(&then.modal.codes).enumerate() {
            // G00 is a motion; in every other group 0 is none.
            let [then, now] = [then, now].map(|code| match code {
                0 if group != Group::Motion as usize => VACANT,
                code => f64::from(code) / 10.0,
            });
            changes.extend(change(What::Code, then, now));
        }
        let word = |state: &State, letter: u8| state.modal.words[usize::from(letter - b'A')];
        changes.extend(WORDS.iter().filter_map(|&l| change(What::Word(l), word(then, l), word(now, l))));
        changes
    }
}
