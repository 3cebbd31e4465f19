//! The alarms that macroline can raise, and the number and wording each control has for them.

use crate::text::Citation;

/// Why a control stops, independent of its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Alarm {
    /// A character or address that the control does not have.
    IllegalAddress,
    /// A block that does not read as one.
    Format,
    /// A G code that the control does not have.
    UnknownCode,
    /// A value outside the range of its address.
    OutOfRange,
    /// End of file without M02, M30 or M99.
    NoProgramEnd,
    /// A program or sequence number 0.
    NumberZero,
    /// Cutting feed without F, or F0.
    NoFeed,
    /// An arc that cannot be.
    Arc,
    /// Subprograms nested too deep.
    SubNesting,
    /// A sequence number that is not in the program.
    NoSequence,
    /// A program that is not there.
    NoProgram,
    /// A variable number that the control does not have.
    VariableRange,
    /// `=` is missing.
    NoEquals,
    /// A variable that cannot stand on this side.
    VariableSide,
    /// NC words and macro text in one block.
    Mixed,
    /// Macro calls nested too deep.
    MacroNesting,
    /// Too many I, J, K sets of arguments.
    ArgumentSets,
    /// End of a modal call without a modal call.
    NoModalCall,
    /// `#3000`.
    User,
    /// Brackets nested too deep.
    BracketDepth,
    /// Brackets not paired.
    BracketPair,
    /// A calculation without a result: root of a negative number …
    Calculation,
    /// Division by zero.
    DivisionByZero,
    /// A faulty IF or GOTO.
    IfSentence,
    /// A faulty WHILE, DO or END.
    WhileSentence,
    /// DO … END nested too deep.
    DoNesting,
    /// DO and END not paired, or crossing.
    DoPair,
    /// The program runs and never ends (budget of the simulation, no alarm of a control).
    Budget,
    /// An axis beyond its soft limit.
    SoftLimit,
    /// Emergency stop.
    EmergencyStop,
}

/// An alarm as one control shows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AlarmDef {
    /// Which.
    pub kind: Alarm,
    /// Number, for instance `P283`.
    pub number: &'static str,
    /// The control's wording.
    pub text: &'static str,
    /// Source and grade.
    pub cite: Citation,
}

/// A row of an alarm.
pub(super) const fn alarm(kind: Alarm, number: &'static str, text: &'static str, cite: Citation) -> AlarmDef {
    AlarmDef { kind, number, text, cite }
}

impl Alarm {
    /// Every kind.
    pub const ALL: &[Alarm] = &[
        Alarm::IllegalAddress,
        Alarm::Format,
        Alarm::UnknownCode,
        Alarm::OutOfRange,
        Alarm::NoProgramEnd,
        Alarm::NumberZero,
        Alarm::NoFeed,
        Alarm::Arc,
        Alarm::SubNesting,
        Alarm::NoSequence,
        Alarm::NoProgram,
        Alarm::VariableRange,
        Alarm::NoEquals,
        Alarm::VariableSide,
        Alarm::Mixed,
        Alarm::MacroNesting,
        Alarm::ArgumentSets,
        Alarm::NoModalCall,
        Alarm::User,
        Alarm::BracketDepth,
        Alarm::BracketPair,
        Alarm::Calculation,
        Alarm::DivisionByZero,
        Alarm::IfSentence,
        Alarm::WhileSentence,
        Alarm::DoNesting,
        Alarm::DoPair,
        Alarm::Budget,
        Alarm::SoftLimit,
        Alarm::EmergencyStop,
    ];
}
