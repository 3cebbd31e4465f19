//! Failures and findings of a block while it is read.

use crate::controls::{Address, Alarm, CodeId};
use crate::text::{Diagnostic, Span};

/// A block that does not read, and why.
pub(in crate::nc) struct Failure {
    pub(in crate::nc) alarm: Alarm,
    /// Where it shows, in bytes behind the start of the block.
    pub(in crate::nc) from: usize,
    pub(in crate::nc) finding: Diagnostic,
    /// The error is at the start of a word, so the rest may be an unbracketed comment.
    pub(in crate::nc) at_word: bool,
}

pub(in crate::nc) type Read<T> = Result<T, Box<Failure>>;

/// A feature that the simulation leaves out, reported once a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::nc) enum LeftOut {
    Code(CodeId),
    /// A cycle by the number in its name.
    Cycle(u32),
    /// A range of variables by its first number.
    Variables(u32),
    /// An external input or output statement, by its index.
    Statement(usize),
    Address(Address),
    /// An address behind a comma.
    Comma(Address),
}

#[derive(Debug)]
/// A variable that the control does not have, or that cannot be written.
pub(in crate::nc) struct Misused {
    pub(in crate::nc) number: u32,
    pub(in crate::nc) alarm: Alarm,
    pub(in crate::nc) span: Span,
}

/// Fix of a mistake in a line.
pub(in crate::nc) enum Mend<'t> {
    /// Other text in place of some bytes.
    Write(usize, usize, &'t str),
    /// Square brackets around some bytes.
    Enclose(usize, usize),
    /// `DO` at a byte, with the number of the `END` that has no other.
    Do(usize),
    /// The characters of the control, where this one is only another shape of one of them.
    Plain(char),
}
