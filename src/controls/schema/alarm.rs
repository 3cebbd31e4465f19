//! The alarms that macroline can raise, and the number and wording each control has for them.

use super::table::{Key, single};
use crate::text::{Citation, Phrase};

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
    /// A sequence number that does not open its block.
    SequencePlace,
    /// A sequence number with too many digits.
    SequenceDigits,
    /// Cutting feed without F, or F0.
    NoFeed,
    /// A cutting feed of 0.
    FeedZero,
    /// F outside its range.
    FeedRange,
    /// An arc that cannot be.
    Arc,
    /// Subprograms nested too deep.
    SubNesting,
    /// A sequence number that is not in the program.
    NoSequence,
    /// A GOTO to a sequence number that is not in the program.
    GotoTarget,
    /// A jump to a number that no block can have.
    JumpNumber,
    /// A program that is not there.
    NoProgram,
    /// A variable number that the control does not have.
    VariableRange,
    /// `=` is missing.
    NoEquals,
    /// A variable that cannot stand on this side.
    VariableSide,
    /// A variable that cannot be written.
    ReadOnly,
    /// NC words and macro text in one block.
    Mixed,
    /// Macro calls nested too deep.
    MacroNesting,
    /// Too many I, J, K sets of arguments.
    ArgumentSets,
    /// End of a modal call without a modal call, where that is an alarm ([`Control::raises`](super::Control::raises)).
    NoModalCall,
    /// A call of the program that is running, where that is an alarm.
    OwnCall,
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
    /// A DO without its END.
    MissingEnd,
    /// An END without its DO.
    MissingDo,
    /// The program runs and never ends (budget of the simulation, no alarm of a control).
    Budget,
    /// An axis beyond its soft limit.
    SoftLimit,
    /// A programmed end point beyond the working area.
    WorkingArea,
    /// An end point beyond the range of the coordinates.
    CoordinateRange,
    /// Emergency stop.
    EmergencyStop,
    /// An address without a number.
    NoNumber,
    /// More digits than the address takes.
    Digits,
    /// A decimal point behind an address that takes none.
    PointNotAllowed,
    /// The same address twice in a block.
    AddressTwice,
    /// A block with more characters than the control reads.
    BlockTooLong,
    /// A block with more words than the control reads.
    BlockWords,
    /// A comment bracket that is not closed.
    CommentBracket,
    /// A macro call without a program.
    NoCallProgram,
    /// A macro call that does not open its block.
    CallNotFirst,
    /// A call together with words that cannot stand beside it.
    CallMixed,
    /// A subprogram call or return jump while a modal macro call is on.
    ReturnInModal,
    /// An address that is no argument of a macro.
    ArgumentAddress,
    /// A `G65 H` function that the control does not have.
    CallFunction,
    /// A `G65 H` function with too few operands, or operands of the wrong kind.
    CallOperands,
    /// The number of a user alarm is out of its range.
    UserAlarmRange,
    /// `#0` on the left side.
    VacantWritten,
    /// A variable of the system is given a vacant value, where that is an alarm.
    VacantValue,
    /// Root of a negative number.
    SquareRoot,
    /// Logarithm of a number that is not positive.
    Logarithm,
    /// Tangent of 90 degrees.
    Tangent,
    /// Arc sine or arc cosine outside ±1.
    ArcFunction,
    /// `ATAN` in a form that the control does not have.
    AtanForm,
    /// A result beyond the range of numbers.
    Overflow,
    /// A number that has to be whole for a calculation bit by bit.
    NotWhole,
    /// The number of a DO or END.
    DoNumber,
    /// A jump into a loop.
    IntoLoop,
    /// An arc whose radius is shorter than half its chord.
    ArcRadius,
    /// A spindle that cannot be brought to an angle.
    NoPositioning,
    /// Constant surface speed before any cutting speed was given, where that is an alarm.
    NoSurfaceSpeed,
    /// A cutting speed outside its range.
    SurfaceRange,
    /// An angle of the spindle outside a turn.
    SpindleAngle,
    /// A code whose block can hold nothing else.
    NotAlone,
    /// Two codes of one modal group in a block.
    GroupTwice,
    /// Two codes in a block that both say what its words mean.
    SyntaxTwice,
    /// Two auxiliary functions of one group in a block.
    AuxiliaryTwice,
    /// More auxiliary functions in a block than it can hold.
    Auxiliaries,
    /// A label that stands twice, where that is an alarm.
    LabelTwice,
    /// A name that nothing has.
    UnknownName,
    /// A return in the main program, where that is an alarm.
    MainReturn,
    /// Two messages without a block between them that does anything, where that is an alarm.
    MessageBlocks,
    /// An address that says nothing to the motion in force, where that is an alarm.
    IdleAddress,
    /// A repeat count that cannot be.
    RepeatRange,
    /// A spindle speed that cannot be.
    SpeedRange,
    /// A speed limit that cannot be.
    SpeedLimitRange,
    /// A thread without a lead.
    NoLead,
    /// The lead of a thread stands behind the address of another axis.
    LeadAxis,
    /// The shortest way to an angle, of an axis that does not turn, where that is an alarm.
    ShortestWay,
    /// The positive way to an angle, likewise.
    PositiveWay,
    /// The negative way to an angle, likewise.
    NegativeWay,
    /// M04 while M03 is put out, or the other way round, where the PLC makes an alarm of it.
    SpindleReversal,
    /// A gear that is not in position in time.
    GearTimeout,
    /// A fault of the spindle's inverter; its number is the builder's.
    InverterFault,
}

/// An alarm as one control shows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AlarmDef {
    /// Which.
    pub kind: Alarm,
    /// Number, for instance `P283`.
    pub number: &'static str,
    /// The control's wording.
    pub text: Phrase,
    /// Source and grade.
    pub cite: Citation,
}

/// A row of an alarm.
pub(in crate::controls) const fn alarm(
    kind: Alarm,
    number: &'static str,
    text: &'static str,
    cite: Citation,
) -> AlarmDef {
    AlarmDef { kind, number, text: Phrase::new(text), cite }
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
        Alarm::SequencePlace,
        Alarm::SequenceDigits,
        Alarm::NoFeed,
        Alarm::FeedZero,
        Alarm::FeedRange,
        Alarm::Arc,
        Alarm::SubNesting,
        Alarm::NoSequence,
        Alarm::GotoTarget,
        Alarm::JumpNumber,
        Alarm::NoProgram,
        Alarm::VariableRange,
        Alarm::NoEquals,
        Alarm::VariableSide,
        Alarm::ReadOnly,
        Alarm::Mixed,
        Alarm::MacroNesting,
        Alarm::ArgumentSets,
        Alarm::NoModalCall,
        Alarm::OwnCall,
        Alarm::User,
        Alarm::BracketDepth,
        Alarm::BracketPair,
        Alarm::Calculation,
        Alarm::DivisionByZero,
        Alarm::IfSentence,
        Alarm::WhileSentence,
        Alarm::DoNesting,
        Alarm::DoPair,
        Alarm::MissingEnd,
        Alarm::MissingDo,
        Alarm::Budget,
        Alarm::SoftLimit,
        Alarm::WorkingArea,
        Alarm::CoordinateRange,
        Alarm::EmergencyStop,
        Alarm::NoNumber,
        Alarm::Digits,
        Alarm::PointNotAllowed,
        Alarm::AddressTwice,
        Alarm::BlockTooLong,
        Alarm::BlockWords,
        Alarm::CommentBracket,
        Alarm::NoCallProgram,
        Alarm::CallNotFirst,
        Alarm::CallMixed,
        Alarm::ReturnInModal,
        Alarm::ArgumentAddress,
        Alarm::CallFunction,
        Alarm::CallOperands,
        Alarm::UserAlarmRange,
        Alarm::VacantWritten,
        Alarm::VacantValue,
        Alarm::SquareRoot,
        Alarm::Logarithm,
        Alarm::Tangent,
        Alarm::ArcFunction,
        Alarm::AtanForm,
        Alarm::Overflow,
        Alarm::NotWhole,
        Alarm::DoNumber,
        Alarm::IntoLoop,
        Alarm::ArcRadius,
        Alarm::NoPositioning,
        Alarm::NoSurfaceSpeed,
        Alarm::SurfaceRange,
        Alarm::SpindleAngle,
        Alarm::NotAlone,
        Alarm::GroupTwice,
        Alarm::SyntaxTwice,
        Alarm::AuxiliaryTwice,
        Alarm::Auxiliaries,
        Alarm::LabelTwice,
        Alarm::UnknownName,
        Alarm::MainReturn,
        Alarm::MessageBlocks,
        Alarm::IdleAddress,
        Alarm::RepeatRange,
        Alarm::SpeedRange,
        Alarm::SpeedLimitRange,
        Alarm::NoLead,
        Alarm::LeadAxis,
        Alarm::ShortestWay,
        Alarm::PositiveWay,
        Alarm::NegativeWay,
        Alarm::SpindleReversal,
        Alarm::GearTimeout,
        Alarm::InverterFault,
    ];

    /// The wider kind that a control shows where it has no number for this one; `None` for the widest.
    pub fn wider(self) -> Option<Alarm> {
        use Alarm::*;
        Some(match self {
            SquareRoot | Logarithm | Tangent | ArcFunction | Overflow | NotWhole => Calculation,
            ArcRadius => Arc,
            NoLead | LeadAxis | FeedZero => NoFeed,
            WorkingArea => SoftLimit,
            RepeatRange | SpeedRange | SpeedLimitRange | CoordinateRange => OutOfRange,
            DoNumber => WhileSentence,
            IntoLoop | MissingEnd | MissingDo => DoPair,
            NoCallProgram => NoProgram,
            Digits | SequenceDigits | FeedRange | UserAlarmRange | SurfaceRange | SpindleAngle => OutOfRange,
            NoSurfaceSpeed => NoFeed,
            NoPositioning => UnknownCode,
            SpindleReversal | GearTimeout => EmergencyStop,
            BlockWords => BlockTooLong,
            JumpNumber | GotoTarget => NoSequence,
            ReadOnly => VariableSide,
            VacantWritten | VacantValue => ReadOnly,
            OwnCall => SubNesting,
            NoNumber | SequencePlace | AtanForm | PointNotAllowed | AddressTwice | BlockTooLong | CommentBracket
            | CallNotFirst | CallMixed | ReturnInModal | ArgumentAddress | CallFunction | CallOperands | NotAlone
            | ShortestWay | PositiveWay | NegativeWay | GroupTwice | SyntaxTwice | AuxiliaryTwice | Auxiliaries
            | UnknownName | IdleAddress => Format,
            _ => return None,
        })
    }
}

impl AlarmDef {
    /// Whether its table is sorted, for searches by halves.
    pub const SORTED: bool = false;

    /// What the row is about, for tables that are made of a family's rows and a control's own.
    pub const fn key(&self) -> Key {
        single(self.kind as u64)
    }
}
