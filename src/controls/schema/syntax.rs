//! Spelling, characters and file form of programs.

use super::address::{Address, AddressSet};
use crate::text::{Citation, Phrase};

/// Meaning of round brackets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoundBrackets {
    /// `( … )` is a comment, ended by the first `)`; `;` ends a block.
    Comment,
    /// `( … )` groups in formulas; a comment goes from `;` to the end of the line.
    Group,
}

/// Operands of the arc tangent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcTangent {
    /// One: `ATAN[y/x]`.
    OfOne,
    /// Two: `ATAN[y]/[x]`.
    OfTwo,
    /// One or two numbers: `ATAN[y/x]`, `ATAN[y]/[x]`, `ATAN[y,x]`.
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

/// Position of the `%` in a program file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Percent {
    /// In its first and its last line.
    Both,
    /// In its last line only.
    End,
    /// In the first line, in front of the program name.
    Head,
}

/// Spelling rules of a language with named programs, labels, codes and addresses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Names {
    /// Addresses of several letters with their codes.
    pub addresses: &'static [(&'static str, Address)],
    /// Codes that are names; a code's index is its number in [`Address::Name`] words.
    pub codes: &'static [&'static str],
    /// Addresses that allow an extension number: `S1=500`.
    pub extended: AddressSet,
    /// Statements known only to other controls of the maker.
    pub foreign: &'static [&'static str],
    /// Statements that the control has and the simulation lacks: a run stops there.
    pub left_out: &'static [&'static str],
    /// Statements that the control may have; no manual at hand has them, and a run stops there.
    pub unsimulated: &'static [&'static str],
    /// `DEF` defines variables of a program; otherwise it is a foreign statement.
    pub local_data: bool,
    /// Endings and directories of program names, main program first, then subprogram: `MPF`, `SPF`.
    pub endings: [&'static str; 2],
    /// Letters in front of a numeric program name.
    pub numbered: &'static [&'static str],
    /// Maximum characters of a program name.
    pub program_chars: usize,
    /// Minimum characters of a label.
    pub label_least: usize,
    /// Largest whole number written without a decimal point.
    pub whole_max: i64,
    /// Maximum auxiliary words of a block: M, H, D, and all together.
    pub auxiliary: [u8; 4],
}

impl Names {
    /// Index in [`Names::codes`] of a name in capitals.
    pub fn code(&self, name: &str) -> Option<usize> {
        self.codes.iter().position(|code| *code == name)
    }

    /// Whether a name in capitals is a statement that other controls have, or that the simulation lacks.
    pub fn lists(&self, name: &str) -> bool {
        [self.foreign, self.left_out, self.unsimulated].iter().any(|list| list.contains(&name))
    }
}

/// Spelling, characters and file form of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Syntax {
    /// Meaning of round brackets.
    pub round: RoundBrackets,
    /// Sign in front of a variable number.
    pub variable: char,
    /// Rules for names; `None` for a language without names.
    pub names: Option<Names>,
    /// Letter of a program number (`O`), followed by further letters accepted when reading.
    pub program_letters: &'static [u8],
    /// Position of the `%` in a program file.
    pub percent: Percent,
    /// Maximum digits of a sequence number.
    pub sequence_digits: u8,
    /// Sequence number 0 is read; otherwise it is an alarm.
    pub sequence_zero: bool,
    /// Programs may have names in `< >` in place of numbers.
    pub bracket_names: bool,
    /// Maximum digits of a program number.
    pub program_digits: u8,
    /// Maximum characters of a block written by the emitter.
    pub block_chars: usize,
    /// Maximum characters of a message or comment.
    pub message_chars: usize,
    /// Maximum nesting of square brackets, functions included.
    pub bracket_depth: u8,
    /// `IF [ ] THEN` exists.
    pub if_then: bool,
    /// `MOD` exists.
    pub modulo: bool,
    /// Comparisons may also be written as symbols: `==`, `<>`, `>`, `>=`, `<`, `<=`.
    pub comparison_signs: bool,
    /// A function may be written without brackets: `SIN30`, `SQRT#1`.
    pub bare_functions: bool,
    /// Operands of the arc tangent.
    pub atan: ArcTangent,
    /// `##5` means `#[#5]`.
    pub double_hash: bool,
    /// `#9nnn` means `#[#nnn]`.
    pub nine_hash: bool,
    /// Of the absolute and the incremental address of one axis in a block, the absolute counts; otherwise the later one.
    pub absolute_holds: bool,
    /// Address of the threads per inch of a thread, besides F for its lead.
    pub threads_per_inch: Option<Address>,
    /// The lead of a thread is the I, J or K of its axis; otherwise it is F.
    pub lead_by_axis: bool,
    /// Addresses of a dwell: P in milliseconds, S in spindle revolutions, others in seconds.
    pub dwell_addresses: AddressSet,
    /// The same address twice in a block is an alarm (except G and M codes and macro arguments); otherwise the last one counts.
    pub address_twice: bool,
    /// Maximum characters of a block that the control reads, without comments.
    pub block_read_chars: u32,
    /// Maximum words of a block that the control reads.
    pub block_words: u32,
    /// Maximum characters of a word with a number, its letter included.
    pub word_chars: u32,
    /// Largest number of a `DO`.
    pub do_max: u32,
    /// Maximum nesting of `DO` … `END`.
    pub do_depth: u8,
    /// Functions that give random numbers; the simulation rejects them.
    pub random: &'static [&'static str],
    /// Function names: `(spelling, function)`; programs are written with a function's first spelling.
    pub functions: &'static [(&'static str, Function)],
    /// Address letters besides the axes; macro calls accept every letter.
    pub addresses: AddressSet,
    /// Addresses of integer words.
    pub integer_addresses: AddressSet,
    /// A decimal point after an integer address is an alarm; otherwise the decimals are dropped.
    pub point_alarm: bool,
    /// Addresses whose words without a decimal point count increments.
    pub increment_addresses: AddressSet,
    /// Addresses that insert a corner after a straight line or an arc, with the kind of corner. The simulation ignores them.
    pub corners: &'static [(Address, Phrase)],
    /// Addresses allowed after a comma; the simulation ignores them.
    pub comma_addresses: AddressSet,
    /// Extension of a program file, without the dot.
    pub extension: &'static str,
    /// Source and grade.
    pub cite: Citation,
}

impl Syntax {
    /// Rules for names of programs, labels and codes; `None` for a language without names.
    #[inline]
    pub const fn names(&self) -> Option<&Names> {
        self.names.as_ref()
    }

    /// Whether the macro language has a function.
    pub fn has(&self, function: Function) -> bool {
        self.functions.iter().any(|row| row.1 == function)
    }

    /// Range of sequence numbers: from 1, below the end.
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
    /// Round toward zero.
    Fix,
    /// Round away from zero.
    Fup,
    /// Natural logarithm.
    Ln,
    /// Exponential.
    Exp,
    /// `POW[base,exponent]`; parsed as a binary operator.
    Power,
    /// `ADP[#n]`: argument in `#n` with the point added: `X10` passed without a decimal point counts 10 units, not 10 increments.
    AddPoint,
}

impl Function {
    /// Name in the language where the function is usual, for a control without a name of its own.
    pub fn usual_name(self) -> &'static str {
        match self {
            Function::Sin => "SIN",
            Function::Cos => "COS",
            Function::Tan => "TAN",
            Function::Asin => "ASIN",
            Function::Acos => "ACOS",
            Function::Atan => "ATAN",
            Function::Sqrt => "SQRT",
            Function::Abs => "ABS",
            Function::Bin => "BIN",
            Function::Bcd => "BCD",
            Function::Round => "ROUND",
            Function::Square => "POT",
            Function::Fix => "FIX",
            Function::Fup => "FUP",
            Function::Ln => "LN",
            Function::Exp => "EXP",
            Function::Power => "POW",
            Function::AddPoint => "ADP",
        }
    }
}

/// Operation of `G65 Hnn`: result P, operands Q and R.
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
    /// Jumps to sequence number P.
    Goto,
    /// Jumps to P if `Q = R`.
    IfEqual,
    /// Jumps to P if `Q ≠ R`.
    IfNotEqual,
    /// Jumps to P if `Q > R`.
    IfGreater,
    /// Jumps to P if `Q < R`.
    IfLess,
    /// Jumps to P if `Q ≥ R`.
    IfGreaterEqual,
    /// Jumps to P if `Q ≤ R`.
    IfLessEqual,
    /// User alarm P.
    Alarm,
}

impl Operation {
    /// Required operands among P, Q, R.
    pub fn operands(self) -> &'static [Address] {
        use Operation::*;
        match self {
            Goto | Alarm => &[Address::P],
            Assign | Sqrt | Abs | Bin | Bcd => &[Address::P, Address::Q],
            _ => &[Address::P, Address::Q, Address::R],
        }
    }

    /// Whether the operation can jump to sequence number P.
    pub fn jumps(self) -> bool {
        use Operation::*;
        matches!(self, Goto | IfEqual | IfNotEqual | IfGreater | IfLess | IfGreaterEqual | IfLessEqual)
    }
}
