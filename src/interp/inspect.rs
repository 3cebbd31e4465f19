//! Inspection of a run between two blocks: next block, call levels, values of expressions, changes.

use super::Interp;
use super::context::BlockContext;
use super::error::Trap;
use super::state::RunState;
use super::vars::{LOCALS, Locals, VACANT};
use super::world::{MachineClock, World};
use crate::controls::{CodeId, Control, Group, VarKind};
use crate::nc::{Block, ParsedFormula};
use crate::text::{Diagnostic, FileId, Place, Span};

/// Kind of call into a level.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Entered {
    /// The start program of the run.
    Start,
    /// Subprogram: shares the local variables of its caller.
    Subprogram,
    /// Macro, with its own local variables.
    Macro,
}

/// A level of the call stack.
#[derive(Debug, Clone)]
pub struct CallLevel {
    /// Number of the program; 0 if it has none.
    pub program: u32,
    /// Name of the program; empty if it has none.
    pub name: String,
    /// Kind of call.
    pub entered: Entered,
    /// The next block, or the calling block.
    pub place: Place,
    /// Number of repeats left after this run.
    pub again: u32,
    /// Level of the local variables in force, from 0.
    pub local_level: usize,
    values: Locals,
}

impl CallLevel {
    /// Local variables that are not vacant, by number; empty for a subprogram, because its caller's level lists them.
    pub fn locals(&self) -> impl Iterator<Item = (u32, f64)> + '_ {
        let own = self.entered != Entered::Subprogram;
        (1..).zip(self.values).filter(move |(_, value)| own && !value.is_nan())
    }
}

/// The subject of a change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChangeSubject {
    /// A variable common to all levels, by number.
    Variable(u32),
    /// A local variable of the running level.
    Local(u32),
    /// A code of a modal group; the values are code numbers.
    Code,
    /// F.
    Feed,
}

impl ChangeSubject {
    /// Name on the control: `#105`, `G`, `F`.
    pub fn name(self, control: &Control) -> String {
        match self {
            ChangeSubject::Variable(number) | ChangeSubject::Local(number) => control.variable(number),
            ChangeSubject::Code => "G".to_owned(),
            ChangeSubject::Feed => "F".to_owned(),
        }
    }
}

/// A change of a value; `None` is vacant or not yet set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// Variable, code or feed.
    pub subject: ChangeSubject,
    /// Old value.
    pub before: Option<f64>,
    /// New value.
    pub after: Option<f64>,
}

/// Index of F among the modal words.
const FEED: usize = (b'F' - b'A') as usize;

/// A value for display: `None` is vacant.
fn shown(value: f64) -> Option<f64> {
    (!value.is_nan()).then_some(value)
}

impl Interp {
    /// The next block to read; `None` while commands of the last block are left, while the program waits for standstill, and at the end.
    pub fn next_block(&self) -> Option<(Place, &Block)> {
        let state = &self.state;
        let between = state.queue.is_empty() && state.ended.is_none() && !state.pause && !state.synced;
        let block =
            self.shared.parsed.deck().blocks.get(state.at as usize).filter(|_| between && state.at < state.end)?;
        Some((Place { file: state.file, span: block.span }, block))
    }

    /// Call levels, innermost first.
    pub fn levels(&self) -> Vec<CallLevel> {
        let (state, deck) = (&self.state, self.shared.parsed.deck());
        let mut levels = Vec::with_capacity(state.frames.len() + 1);
        let mut local_level = 0;
        for at in 0..=state.frames.len() {
            let by = at.checked_sub(1).and_then(|at| state.frames.get(at));
            let arguments = by.is_some_and(|frame| frame.arguments.is_some());
            local_level += usize::from(arguments);
            let (program, place) = match state.frames.get(at) {
                // The return continues with the block after the call.
                Some(frame) => (frame.program, self.place_of(frame.program, frame.back.saturating_sub(1))),
                None => (state.program, self.next_block().map_or(state.place, |(place, _)| place)),
            };
            let entered = match by {
                None => Entered::Start,
                Some(_) if arguments => Entered::Macro,
                Some(_) => Entered::Subprogram,
            };
            levels.push(CallLevel {
                program: deck.programs.get(program as usize).map_or(0, |program| program.number),
                name: deck.text(deck.programs.get(program as usize).and_then(|program| program.name)).to_owned(),
                entered,
                place,
                again: by.map_or(0, |frame| frame.again),
                local_level,
                values: state.vars.locals_of(local_level),
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

    /// Value of an expression in the present state, 1 or 0 for a condition; `None` is vacant. Values that a program may only read at
    /// standstill are read at once.
    pub fn evaluate(&self, formula: &ParsedFormula, world: &mut dyn World) -> Result<Option<f64>, Box<Diagnostic>> {
        let control = self.shared.control;
        let mut cx = BlockContext { shared: &self.shared, control, deck: formula.deck(), world, parts: 1.0 };
        let value = match self.state.value(&mut cx, formula.root()) {
            Err(Trap::Sync) => RunState { synced: true, ..self.state.clone() }.value(&mut cx, formula.root()),
            value => value,
        };
        match value {
            // Adding 0 turns -0 into 0.
            Ok(value) => Ok(shown(value + 0.0)),
            Err(Trap::Sync) => Ok(None),
            Err(Trap::Alarm(fault)) => {
                let mut diagnostic = fault.diagnostic(&self.shared.parsed, Place::default());
                diagnostic.place = None;
                Err(Box::new(diagnostic))
            }
        }
    }

    /// Differences from an earlier state of the same run: variables in the order of their numbers, then codes and words.
    pub fn changes_since(&self, earlier: &Interp, world: &mut dyn World) -> Vec<Change> {
        let (now, then, index) = (&self.state, &earlier.state, &self.shared.index);
        let (shared, control, deck) = (&*self.shared, self.shared.control, self.shared.parsed.deck());
        let mut cx = BlockContext { shared, control, deck, world, parts: 1.0 };
        let mut changes = Vec::new();
        let mut compare = |subject: ChangeSubject, then: f64, now: f64| {
            let (before, after) = (shown(then), shown(now));
            if before != after {
                changes.push(Change { subject, before, after });
            }
        };
        let level = now.vars.level();
        // On a new level every local variable is a change.
        let (values, vacant) = (now.vars.locals_of(level), [VACANT; LOCALS]);
        let given = if level <= then.vars.level() { then.vars.locals_of(level) } else { vacant };
        for (number, (&then, &now)) in (1..).zip(given.iter().zip(&values)) {
            compare(ChangeSubject::Local(number), then, now);
        }
        for (at, row) in self.shared.control.vars.iter().enumerate() {
            for number in row.first..=row.last {
                let Some(slot) = index.stored_at(row, at, number) else { break };
                let zero = if matches!(row.kind, VarKind::Common | VarKind::Retained) { VACANT } else { 0.0 };
                // Other variables start with a value.
                let value = |state: &RunState| shown(state.vars.common(slot)).unwrap_or(zero);
                compare(ChangeSubject::Variable(number), value(then), value(now));
            }
            let clock = match row.kind {
                VarKind::PowerOnTime(_) => MachineClock::PowerOn as usize,
                VarKind::RunTime(_) => MachineClock::AutomaticRun as usize,
                _ => continue,
            };
            if now.clock_zero[clock] != then.clock_zero[clock] {
                compare(ChangeSubject::Variable(row.first), VACANT, now.read(&mut cx, row.first).unwrap_or(VACANT));
            }
        }
        for (group, (&then, &now)) in then.modal.codes.iter().zip(&now.modal.codes).enumerate() {
            // In the motion group 0 is G00; in every other group 0 means no code.
            let none = if group == Group::Motion as usize { 0.0 } else { VACANT };
            let code = |code: CodeId| if code.to_f64() == 0.0 { none } else { code.to_f64() };
            compare(ChangeSubject::Code, code(then), code(now));
        }
        // S, M and T appear in their commands.
        compare(ChangeSubject::Feed, then.modal.words[FEED], now.modal.words[FEED]);
        changes
    }
}
