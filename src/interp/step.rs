//! The outcome of a step, the start of a run and its end.

use super::canon::Canon;
use crate::text::{Diagnostic, Place};

/// The outcome of one step of the interpreter.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// A command for the machine, from the block at the place.
    Command(Canon, Place),
    /// A block that only computed or jumped.
    Logic(Place),
    /// The program needs the machine at rest before it goes on: the block at the place reads positions, or it has stopped the machine
    /// (M00, M01, `#3006`) and nothing behind it may be read before. Step again when the machine rests.
    Sync(Place),
    /// The program is over; further steps say the same.
    Ended(End),
}

/// Why a program is over.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// M02 or M30.
    Program,
    /// An alarm of the control; the diagnostic carries number and place.
    Alarm(Box<Diagnostic>),
}

/// Which program a run starts with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StartProgram {
    /// The first program of the first file.
    #[default]
    First,
    /// The program with this number.
    Program(u32),
    /// The program at this place of the deck.
    Nth(u32),
}

/// How many blocks a run has read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Blocks with NC words.
    pub nc: u64,
    /// Blocks that are over when they are read: macro statements, calls and returns alone, skipped and empty blocks.
    pub macros: u64,
    /// Those of them that are skipped or empty: the block behind one is next to the block before it.
    pub empty: u64,
}
