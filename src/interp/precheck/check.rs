//! [`Precheck`]: state of the check, and findings that are the same in every modal state.

use std::cell::RefCell;

use super::super::context::BlockContext;
use super::super::error::{BlockResult, Trap};
use super::super::modal::Modal;
use super::super::state::RunState;
use super::super::world::{MachineAtRest, MachineClock, World};
use super::clean::Clean;
use super::modal_states;
use crate::controls::{Alarm, VarKind};
use crate::nc::{Block, Expr, ExprId, Word, WordValue};
use crate::text::{Diagnostic, Place};

/// A machine at rest that records warnings of the run.
pub(super) struct Listener<'a> {
    pub(super) machine: MachineAtRest,
    pub(super) heard: &'a RefCell<Vec<Diagnostic>>,
}

impl World for Listener<'_> {
    fn input(&mut self, variable: u32) -> f64 {
        self.machine.input(variable)
    }

    fn clock_ms(&mut self, clock: MachineClock) -> f64 {
        self.machine.clock_ms(clock)
    }

    fn position(&mut self, axis: usize) -> f64 {
        self.machine.position(axis)
    }

    fn block_skip(&mut self, number: u8) -> bool {
        self.machine.block_skip(number)
    }

    fn remark(&mut self, remark: Diagnostic) {
        self.heard.borrow_mut().push(remark);
    }
}

/// State of the check, block by block.
pub(super) struct Precheck<'a> {
    pub(super) cx: BlockContext<'a>,
    /// Warnings recorded since they were last taken.
    pub(super) heard: &'a RefCell<Vec<Diagnostic>>,
    /// State of a run that reads blocks in the order of the text without executing them.
    pub(super) state: RunState,
    /// For each expression: it has the same value in every run.
    pub(super) constant: Vec<bool>,
    /// Modal states in which blocks may be read, reduced to the parts that matter.
    pub(super) modals: Vec<Modal>,
    /// Words of blocks are commands: no modal call uses them as arguments.
    pub(super) words_as_commands: bool,
    /// Findings about the present block.
    pub(super) found: Vec<Diagnostic>,
    /// Cache: the preceding block of words, if it had no findings.
    pub(super) clean: Vec<Clean>,
}

impl<'a> Precheck<'a> {
    pub(super) fn new(cx: BlockContext<'a>, state: RunState, heard: &'a RefCell<Vec<Diagnostic>>) -> Precheck<'a> {
        let mut constant: Vec<bool> = Vec::with_capacity(cx.deck.exprs.len());
        for expr in &cx.deck.exprs {
            let known = |id: &ExprId| constant.get(id.0 as usize).copied().unwrap_or(false);
            constant.push(match expr {
                Expr::Number(_) => true,
                Expr::Var(number) => cx.control.var(*number).is_some_and(|row| row.kind == VarKind::Vacant),
                Expr::Label(_) | Expr::Indirect(_) => false,
                Expr::Negate(x) | Expr::Call(_, x) => known(x),
                Expr::Binary(_, left, right) => known(left) && known(right),
            });
        }
        let modals = modal_states::reachable(&cx, state.modal.clone());
        let words_as_commands = modal_states::takes_words_as_commands(&cx);
        Precheck { cx, heard, state, constant, modals, words_as_commands, found: Vec::new(), clean: Vec::new() }
    }

    pub(super) fn is_constant(&self, id: ExprId) -> bool {
        self.constant.get(id.0 as usize).copied().unwrap_or(false)
    }

    pub(super) fn is_known(&self, word: &Word) -> bool {
        match word.value {
            WordValue::Number(_) => true,
            WordValue::Expr(id) => self.is_constant(id),
        }
    }

    /// Alarm and finding of an outcome with one of these alarms; any alarm if the list is empty.
    pub(super) fn finding(
        &self,
        block: &Block,
        outcome: BlockResult<()>,
        alarms: &[Alarm],
    ) -> Option<(Alarm, Diagnostic)> {
        let Err(Trap::Alarm(mut fault)) = outcome else { return None };
        let kind = fault.kind();
        if !alarms.is_empty() && !alarms.contains(&kind) {
            return None;
        }
        fault.locate(self.cx.deck, block);
        let here = Place { file: self.state.file, span: block.span };
        Some((kind, fault.diagnostic(&self.cx.shared.parsed, here)))
    }

    pub(super) fn report(&mut self, block: &Block, outcome: BlockResult<()>, alarms: &[Alarm]) {
        let finding = self.finding(block, outcome, alarms);
        self.note(finding.map(|(_, finding)| finding));
    }

    /// Adds a finding, unless its place has one.
    pub(super) fn note(&mut self, finding: Option<Diagnostic>) {
        self.found.extend(finding.filter(|finding| self.found.iter().all(|other| other.place != finding.place)));
    }

    /// The finding common to all modal states, the first in text order; `None` if they differ.
    pub(super) fn always(
        &mut self,
        block: &Block,
        alarms: &[Alarm],
        run: &mut dyn FnMut(&mut RunState, &mut BlockContext) -> BlockResult<()>,
    ) -> Option<Diagnostic> {
        let mut common: Option<(Alarm, Diagnostic)> = None;
        for at in 0..=self.modals.len() {
            let mut state = self.state.clone();
            if let Some(modal) = at.checked_sub(1).and_then(|at| self.modals.get(at)) {
                state.modal.clone_from(modal);
            }
            let outcome = run(&mut state, &mut self.cx);
            let finding = self.finding(block, outcome, alarms)?;
            let fact = |(kind, finding): &(Alarm, Diagnostic)| (*kind, finding.place);
            if common.as_ref().is_some_and(|common| fact(common) != fact(&finding)) {
                return None;
            }
            common.get_or_insert(finding);
        }
        common.map(|(_, finding)| finding)
    }
}
