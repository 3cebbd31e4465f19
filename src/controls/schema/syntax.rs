//! How a program is written for a control.

use super::address::{Address, AddressSet};
use crate::text::Citation;

/// What round brackets mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoundBrackets {
    /// `( … )` is a comment, ended by the first `)`; `;` ends a block.
    Comment,
    /// `( … )` groups in formulas; a comment goes from `;` to the end of the line.
    Group,
}

/// How many numbers the arc tangent takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcTangent {
    /// One: `ATAN[y/x]`.
    OfOne,
    /// Two: `ATAN[y]/[x]`.
    OfTwo,
    /// One or two: `ATAN[y/x]`, `ATAN[y]/[x]`, `ATAN[y,x]`.
    OfOneOrTwo,
}

impl ArcTangent {
    /// Whether `ATAN[y/x]` exists.
    pub fn takes_one(self) -> bool {
        self != ArcTangent::OfTwo
    }

    /// Whether `ATAN[y]/[x]` exists.
    pub fn takes_two(self) -> bool {
        self != ArcTangent::OfOne
    }
}

/// Where a file has its `%`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Percent {
    /// In its first and its last line.
    Both,
    /// In its last line only.
    End,
    /// In front of the name of a program, in its first line.
    Head,
}

/// What a language has in which programs, labels, codes and addresses carry names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Names {
    /// Addresses of several letters with their codes.
    pub addresses: &'static [(&'static str, Address)],
    /// Codes that are names, in the order of the numbers that stand for them.
    pub codes: &'static [&'static str],
    /// The one of them behind which stands a number: cycles.
    pub cycle: &'static str,
    /// Addresses that can be extended by a number: `S1=500`.
    pub extended: AddressSet,
    /// Statements of the maker's other controls.
    pub foreign: &'static [&'static str],
    /// What makes a name a subprogram's in its head, and a main program's: endings and directories.
    pub endings: [&'static str; 2],
    /// Letters of a program name that is a number.
    pub numbered: &'static [&'static str],
    /// Characters of a program name.
    pub program_chars: usize,
    /// Characters of a label at least.
    pub label_least: usize,
    /// Largest whole number without a point.
    pub whole_max: i64,
    /// Auxiliary words of a block: M, H, D, and all together.
    pub auxiliary: [u8; 4],
}

impl Names {
    /// The place of a code that is a name in capitals; a cycle has a number behind it.
    pub fn code(&self, name: &str) -> Option<usize> {
        let family = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let name = if family == self.cycle && family.len() < name.len() { family } else { name };
        self.codes.iter().position(|code| *code == name)
    }
}

/// Spelling, characters and file form of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Syntax {
    /// Round brackets.
    pub round: RoundBrackets,
    /// What stands in front of the number of a variable.
    pub variable: char,
    /// Names, where the language has them.
    pub names: Option<Names>,
    /// Letter of a program number (`O`); further letters are accepted when reading.
    pub program_letters: &'static [u8],
    /// Where a file has its `%`.
    pub percent: Percent,
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
    /// Comparisons may be written as signs too: `==`, `<>`, `>`, `>=`, `<`, `<=`.
    pub comparison_signs: bool,
    /// A function may do without brackets: `SIN30`, `SQRT#1`.
    pub bare_functions: bool,
    /// Numbers that the arc tangent takes.
    pub atan: ArcTangent,
    /// `##5` is `#[#5]`.
    pub double_hash: bool,
    /// `#9nnn` is `#[#nnn]`.
    pub nine_hash: bool,
    /// Where a block has the absolute and the incremental address of an axis, the absolute holds; else the later one.
    pub absolute_holds: bool,
    /// Address of the threads per inch of a thread, beside F for its lead.
    pub threads_per_inch: Option<Address>,
    /// The lead of a thread stands behind the I, J, K of its axis; else behind F.
    pub lead_by_axis: bool,
    /// Addresses of a dwell: P in milliseconds, S in spindle revolutions, others in seconds.
    pub dwell_addresses: AddressSet,
    /// The same address twice in a block is an alarm (G and M codes and macro arguments apart); else the last one holds.
    pub address_twice: bool,
    /// Characters of a block that the control reads, without comments.
    pub block_read_chars: u32,
    /// Words of a block that the control reads.
    pub block_words: u32,
    /// Characters of a word with a number, its letter among them.
    pub word_chars: u32,
    /// Highest number of a `DO`.
    pub do_max: u32,
    /// `DO` … `END` may be nested this deep.
    pub do_depth: u8,
    /// Functions that give random numbers, which no run here has.
    pub random: &'static [&'static str],
    /// Function names: `(spelling, function)`; the first spelling of a function is the one that is written.
    pub functions: &'static [(&'static str, Function)],
    /// Address letters of words besides the axes; macro calls take every letter.
    pub addresses: AddressSet,
    /// Addresses of whole numbers.
    pub integer_addresses: AddressSet,
    /// A decimal point behind the address of a whole number is an alarm; else what stands behind it is dropped.
    pub point_alarm: bool,
    /// Addresses whose words are read in the command unit where the point is missing.
    pub increment_addresses: AddressSet,
    /// Addresses that put a corner behind a straight line or an arc, with what they put there. They are not simulated.
    pub corners: &'static [(Address, &'static str)],
    /// Addresses that may stand behind a comma; none of them is simulated.
    pub comma_addresses: AddressSet,
    /// Ending of a program file without the point.
    pub extension: &'static str,
    /// Source and grade.
    pub cite: Citation,
}

impl Syntax {
    /// Names of programs, labels and variables, in a language that has them.
    #[inline]
    pub const fn names(&self) -> Option<&Names> {
        self.names.as_ref()
    }

    /// Whether the macro language has a function.
    pub fn has(&self, function: Function) -> bool {
        self.functions.iter().any(|row| row.1 == function)
    }

    /// The sequence numbers that a block can have.
    pub fn sequence_numbers(&self) -> core::ops::Range<f64> {
        1.0..f64::from(10_u32.pow(self.sequence_digits.min(9).into()))
    }
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
    /// Square.
    Square,
    /// Toward zero.
    Fix,
    /// Away from zero.
    Fup,
    /// Natural logarithm.
    Ln,
    /// Exponential.
    Exp,
    /// `POW[base,exponent]`; the tree has it as an operator of two numbers.
    Power,
    /// `ADP[#n]`: the argument in `#n` as its number was written, where it came without a decimal point.
    AddPoint,
}

/// What a `G65 Hnn` does with its operands: P is the result, Q and R are what it is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Operation {
    /// `P = Q`.
    Assign,
    /// `P = Q + R`.
    Add,
    /// `P = Q - R`.
    Subtract,
    /// `P = Q * R`.
    Multiply,
    /// `P = Q / R`.
    Divide,
    /// `P = Q OR R`.
    Or,
    /// `P = Q AND R`.
    And,
    /// `P = Q XOR R`.
    Xor,
    /// `P = SQRT[Q]`.
    Sqrt,
    /// `P = ABS[Q]`.
    Abs,
    /// `P = Q - FIX[Q/R]*R`.
    Remainder,
    /// `P = BIN[Q]`.
    Bin,
    /// `P = BCD[Q]`.
    Bcd,
    /// `P = P*Q/R`.
    MultiplyDivide,
    /// `P = SQRT[Q*Q + R*R]`.
    Hypotenuse,
    /// `P = Q*SIN[R]`.
    Sin,
    /// `P = Q*COS[R]`.
    Cos,
    /// `P = Q*TAN[R]`.
    Tan,
    /// `P = ATAN[Q]/[R]`.
    Atan,
    /// Goes on at sequence number P.
    Goto,
    /// Goes on at P if `Q = R`.
    IfEqual,
    /// Goes on at P if `Q ≠ R`.
    IfNotEqual,
    /// Goes on at P if `Q > R`.
    IfGreater,
    /// Goes on at P if `Q < R`.
    IfLess,
    /// Goes on at P if `Q ≥ R`.
    IfGreaterEqual,
    /// Goes on at P if `Q ≤ R`.
    IfLessEqual,
    /// User alarm P.
    Alarm,
}

impl Operation {
    /// The operands that it needs: P, Q, R.
    pub fn operands(self) -> &'static [Address] {
        use Operation::*;
        match self {
            Goto | Alarm => &[Address::P],
            Assign | Sqrt | Abs | Bin | Bcd => &[Address::P, Address::Q],
            _ => &[Address::P, Address::Q, Address::R],
        }
    }

    /// Whether it goes on at the sequence number P.
    pub fn jumps(self) -> bool {
        use Operation::*;
        matches!(self, Goto | IfEqual | IfNotEqual | IfGreater | IfLess | IfGreaterEqual | IfLessEqual)
    }
}
