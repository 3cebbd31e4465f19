//! Axis positions read from the words of a program, for checks that follow the tool through it.

use super::super::ast::{Dimensioning, Stmt, Word};
use super::context::{Lint, measure};
use super::roles::{CALL, CURVED, INCH, RETURN, SPECIAL, SUB};
use crate::controls::AddressSet;

/// Codes after which positions are unknown.
pub(super) const UNKNOWN: u32 = CALL | CURVED | INCH | RETURN | SPECIAL | SUB;

/// Reads positions from words.
#[derive(Clone, Copy)]
pub(super) struct PositionReader {
    increments: AddressSet,
    least: f64,
}

impl PositionReader {
    pub(super) fn new(lint: &Lint) -> PositionReader {
        PositionReader { increments: lint.increments()[0], least: lint.control.limits.increment }
    }

    /// The position that a word says, in mm as words count; `None` if it is calculated or incremental.
    pub(super) fn position(self, word: &Word) -> Option<f64> {
        match word.form {
            Dimensioning::Plain => measure(word, self.increments, self.least),
            _ => None,
        }
    }
}

/// Whether positions are as known after a block without words as before it.
pub(super) fn keeps_positions(stmt: Stmt) -> bool {
    matches!(stmt, Stmt::Empty | Stmt::Assign { .. } | Stmt::Message(_))
}
