//! Modal history per queued command, for variables that read the executing block.

use std::collections::VecDeque;
use std::rc::Rc;

use super::canon::Canon;
use super::modal::Modal;
use crate::controls::{Control, VarKind};
use crate::nc::{Deck, Expr};

/// Number of commands kept, more than any control reads ahead.
const COMMANDS: usize = 256;

/// Modal states of the newest commands, in order.
#[derive(Debug, Clone, Default)]
pub(super) struct ModalHistory(VecDeque<Rc<Modal>>);

impl ModalHistory {
    /// Records the modal state of an issued command.
    pub(super) fn note(&mut self, canon: &Canon, modal: &Modal) {
        if canon.acts_when_read() {
            return;
        }
        if self.0.len() == COMMANDS {
            self.0.pop_front();
        }
        self.0.push_back(Rc::new(modal.clone()));
    }

    /// Modal state of the command that has this many commands waiting after it; the oldest state kept if its own is dropped.
    pub(super) fn of_queued(&self, waiting: usize) -> Option<&Modal> {
        let at = self.0.len().checked_sub(1)?.saturating_sub(waiting);
        self.0.get(at).map(Rc::as_ref)
    }
}

/// Whether the program reads modal data of the executing block.
pub(super) fn is_asked(deck: &Deck, control: &Control) -> bool {
    let executing = |kind| matches!(kind, VarKind::ExecutingCode(_) | VarKind::ExecutingWord(_));
    control.vars.iter().any(|row| executing(row.kind))
        && deck.exprs.iter().any(|expr| match expr {
            Expr::Var(number) => control.var(*number).is_some_and(|row| executing(row.kind)),
            Expr::Indirect(_) => true,
            _ => false,
        })
}
