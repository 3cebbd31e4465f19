//! [`Interp`]: a run of a program, stepped by its caller.

use std::rc::Rc;

use super::canon::{AXES, Canon, CanonNames};
use super::context::Shared;
use super::index::{Index, VariableSlot};
use super::rules::{Rules, Units};
use super::state::RunState;
use super::step::{Counts, End, StartProgram, Step};
use super::world::World;
use super::{modal_history, vars};
use crate::controls::{Control, VarKind};
use crate::nc::Parsed;
use crate::text::DiagnosticKind;
use crate::text::Place;

/// A run of a program. A clone is a checkpoint and shares unchanged data with the original.
#[derive(Debug, Clone)]
pub struct Interp {
    pub(super) shared: Rc<Shared>,
    pub(super) state: RunState,
}

impl Interp {
    /// Starts a run: axes at machine zero, variables vacant, on the control and settings that the program was parsed for.
    pub fn new(parsed: Rc<Parsed>, start: StartProgram) -> Interp {
        let control = parsed.control();
        let index = Index::new(parsed.deck(), control, parsed.dialect());
        let start = match start {
            StartProgram::First if parsed.deck().programs.is_empty() => Err(0),
            StartProgram::First => Ok(0),
            StartProgram::Nth(at) => Ok(at),
            StartProgram::Program(number) => index.program(number).ok_or(number),
        };
        let rules = Rules::new(control, parsed.dialect());
        let executing = modal_history::is_asked(parsed.deck(), control);
        let refuses = parsed.diagnostics().iter().any(|finding| finding.kind == DiagnosticKind::RefusedBlock);
        let units = Units::new(control);
        let shared = Rc::new(Shared { parsed, control, index, rules, units, start, refuses, executing });
        Interp { state: RunState::new(&shared), shared }
    }

    /// Reads at most one block, or returns one more command of the preceding block.
    #[inline]
    pub fn step(&mut self, world: &mut dyn World) -> Step {
        self.state.step(&self.shared, world)
    }

    /// Number of blocks read since the start. A block counts when its first command is returned.
    pub fn blocks(&self) -> Counts {
        self.state.counts
    }

    /// The parsed program.
    pub fn parsed(&self) -> &Rc<Parsed> {
        &self.shared.parsed
    }

    /// The control.
    pub fn control(&self) -> &'static Control {
        self.shared.control
    }

    /// Names for canonical lines of this run.
    pub fn names(&self) -> CanonNames<'static> {
        CanonNames { axes: self.shared.control.axes, increment: self.shared.control.limits.increment }
    }

    /// The block with a sequence number in the start program.
    pub fn numbered(&self, sequence: u32) -> Option<Place> {
        let deck = self.shared.parsed.deck();
        let program = deck.programs.get(*self.shared.start.as_ref().ok()? as usize)?;
        let block = deck.blocks_of(program).iter().find(|block| block.number == Some(sequence))?;
        Some(Place { file: program.file, span: block.span })
    }

    /// Value of a variable; `None` if vacant or not stored by the interpreter.
    pub fn variable(&self, number: u32) -> Option<f64> {
        let value = match self.shared.index.slot(self.shared.control, number) {
            VariableSlot::Local(index) => self.state.vars.local(index),
            VariableSlot::Common(slot) => self.state.vars.common(slot),
            VariableSlot::Row(_) | VariableSlot::None => return None,
        };
        (!value.is_nan()).then_some(value)
    }

    /// Sets a local or common variable, as on the control's screen; `None` makes it vacant. Returns whether the control has the variable.
    pub fn set_variable(&mut self, number: u32, value: Option<f64>) -> bool {
        let value = value.filter(|value| value.is_finite()).unwrap_or(vars::VACANT);
        match self.shared.index.slot(self.shared.control, number) {
            VariableSlot::Local(index) => self.state.vars.set_local(index, value),
            VariableSlot::Common(slot) => self.state.vars.set_common(slot, value),
            VariableSlot::Row(_) | VariableSlot::None => return false,
        }
        true
    }

    /// Local variables of the running level and common variables that are not vacant, in rising order, in the control's spelling.
    pub fn variables(&self) -> impl Iterator<Item = (String, f64)> + '_ {
        let kept = |kind| matches!(kind, VarKind::Local | VarKind::Common | VarKind::Retained);
        let rows = self.shared.control.vars.iter().filter(move |row| kept(row.kind));
        let numbers = rows.flat_map(|row| row.first..=row.last);
        numbers.filter_map(|number| Some((self.shared.control.variable(number), self.variable(number)?)))
    }

    /// Axis positions after all blocks read so far, in command increments of the machine frame.
    pub fn position(&self) -> [i64; AXES] {
        self.state.position
    }

    /// Sets the positions of the axes, for instance after a reset during a motion.
    pub fn set_position(&mut self, position: [i64; AXES]) {
        self.state.position = position;
    }

    /// Number of nested subprogram and macro calls.
    pub fn depth(&self) -> usize {
        self.state.frames.len()
    }

    /// Reset key: back to the start of the program with the codes in force after power-on. Positions stay, and the variables that the
    /// control keeps at reset.
    pub fn reset(&mut self) {
        self.state.reset(&self.shared);
    }
}

/// Steps until the program ends or `blocks` blocks are read (`None`), and returns every command. Time does not pass: every wait is over at
/// once.
pub fn run(
    interp: &mut Interp,
    world: &mut dyn World,
    blocks: u64,
    mut each: impl FnMut(&Canon, Place),
) -> Option<End> {
    loop {
        match interp.step(world) {
            Step::Command(canon, place) => each(&canon, place),
            Step::Logic(_) | Step::Sync(_) => {}
            Step::Ended(end) => return Some(end),
        }
        let counts = interp.blocks();
        if counts.nc + counts.macros >= blocks {
            return None;
        }
    }
}
