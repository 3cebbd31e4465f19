//! How a program is written for a control.

use crate::text::Citation;

/// What round brackets mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Round {
    /// `( … )` is a comment, ended by the first `)`.
    Comment,
}

/// Spelling, characters and file form of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Syntax {
    /// Round brackets.
    pub round: Round,
    /// Letter of a program number (`O`); further letters are accepted when reading.
    pub program_letters: &'static [u8],
    /// Whether a file starts and ends with `%`.
    pub percent: bool,
    /// Digits of a sequence number at most.
    pub sequence_digits: u8,
    /// Digits of a program number at most.
    pub program_digits: u8,
    /// Characters of a block that the emitter keeps below.
    pub block_chars: usize,
    /// Characters of a message or comment.
    pub message_chars: usize,
    /// Square brackets may be nested this deep, functions included.
    pub bracket_depth: u8,
    /// `IF [ ] THEN` exists.
    pub if_then: bool,
    /// `MOD` exists.
    pub modulo: bool,
    /// Highest number of a `DO`.
    pub do_max: u32,
    /// `DO` … `END` may be nested this deep.
    pub do_depth: u8,
    /// Function names: `(spelling, function)`; the first spelling of a function is the one that is written.
    pub functions: &'static [(&'static str, Function)],
    /// Address letters of words besides the axes; macro calls take every letter.
    pub addresses: &'static [u8],
    /// Addresses whose words take no decimal point: what stands behind it is dropped.
    pub integer_addresses: &'static [u8],
    /// Addresses whose words are read in the command unit where the point is missing.
    pub increment_addresses: &'static [u8],
    /// Ending of a program file without the point.
    pub extension: &'static str,
    /// Source and grade.
    pub cite: Citation,
}

/// A function of the macro language.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Function {
    /// Sine of degrees.
    Sin,
    /// Cosine of degrees.
    Cos,
    /// Tangent of degrees.
    Tan,
    /// Arc sine in degrees.
    Asin,
    /// Arc cosine in degrees.
    Acos,
    /// Arc tangent in degrees.
    Atan,
    /// Square root.
    Sqrt,
    /// Absolute value.
    Abs,
    /// BCD to binary.
    Bin,
    /// Binary to BCD.
    Bcd,
    /// Round half away from zero.
    Round,
    /// Toward zero.
    Fix,
    /// Away from zero.
    Fup,
    /// Natural logarithm.
    Ln,
    /// Exponential.
    Exp,
}
