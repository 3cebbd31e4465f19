//! The outcome of a step, the start of a run and its end.

use super::canon::Canon;
use crate::text::{Diagnostic, Place};

/// The outcome of one step of the interpreter.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// A command for the machine, with the place of its block.
    Command(Canon, Place),
    /// A block that only computed or jumped.
    Logic(Place),
    /// The program needs the machine at rest: the block at the place reads positions, or has stopped the machine (M00, M01, `#3006`), and
    /// no further block may be read before. Step again when the machine rests.
    Sync(Place),
    /// The program has ended; further steps return the same.
    Ended(End),
}

/// Cause of the end of a program.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// M02 or M30.
    Program,
    /// An alarm of the control; the diagnostic carries number and place.
    Alarm(Box<Diagnostic>),
}

/// Start program of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StartProgram {
    /// The first program of the first file.
    #[default]
    First,
    /// The program with this number.
    Program(u32),
    /// The program with this index in the deck.
    Nth(u32),
}

/// Number of blocks read by a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Blocks with NC words.
    pub nc: u64,
    /// Blocks that end when they are read: macro statements, calls and returns alone, skipped and empty blocks.
    pub macros: u64,
    /// Skipped and empty blocks among [`Counts::macros`]. They do not separate the blocks before and after them.
    pub empty: u64,
}
