//! Failures and findings of a block while it is read.

use crate::controls::{Address, Alarm, CodeId};
use crate::text::{Diagnostic, Span};

/// A block that does not parse, and the reason.
pub(super) struct ParseFailure {
    pub(super) alarm: Alarm,
    /// Position of the error, in bytes from the start of the block.
    pub(super) from: usize,
    pub(super) finding: Diagnostic,
    /// The error is at the start of a word, so the rest may be an unbracketed comment.
    pub(super) at_word: bool,
}

impl ParseFailure {
    /// Marks the error as one at the start of a word.
    pub(super) fn at_word(mut self: Box<Self>) -> Box<ParseFailure> {
        self.at_word = true;
        self
    }
}

pub(super) type Read<T> = Result<T, Box<ParseFailure>>;

/// A feature ignored by the simulation, reported once per file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum IgnoredFeature {
    Code(CodeId),
    /// Definitions of variables of a program.
    LocalData,
    /// A range of variables by its first number.
    Variables(u32),
    /// An external input or output statement, by its index.
    Statement(usize),
    Address(Address),
    /// An address after a comma.
    Comma(Address),
}

/// A variable that is missing or read-only on the control.
#[derive(Debug)]
pub(super) struct Misused {
    pub(super) number: u32,
    pub(super) alarm: Alarm,
    pub(super) span: Span,
}

/// Fix of a mistake in a line.
pub(super) enum LineFix<'t> {
    /// Replaces some bytes.
    Write(usize, usize, &'t str),
    /// Puts some bytes in square brackets.
    Enclose(usize, usize),
    /// Replaces look-alikes by characters of the control, if this one is a look-alike.
    Plain(char),
}
