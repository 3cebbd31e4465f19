//! The alarms that macroline can raise, and the number and wording each control has for them.

use super::table::{Key, single};
use crate::text::{Citation, Phrase, with_all};

with_all! {
/// Cause of a stop, independent of the alarm number that a control gives it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Alarm {
    /// A character or address that the control does not have.
    IllegalAddress,
    /// A block that cannot be read.
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
    /// An arc without a solution, for instance with the wrong centre or end point.
    Arc,
    /// Subprograms nested too deep.
    SubNesting,
    /// A sequence number that is not in the program.
    NoSequence,
    /// A GOTO to a sequence number that is not in the program.
    GotoTarget,
    /// A jump to a number outside the range of sequence numbers.
    JumpNumber,
    /// A contour of a cycle that is not in the program, or whose last block is ahead of its first.
    NoContour,
    /// A missing program.
    NoProgram,
    /// A variable number that the control does not have.
    VariableRange,
    /// `=` is missing.
    NoEquals,
    /// A variable not allowed on this side of `=`.
    VariableSide,
    /// A variable that cannot be written.
    ReadOnly,
    /// NC words and macro text in one block.
    Mixed,
    /// Macro calls nested too deep.
    MacroNesting,
    /// Too many I, J, K sets of arguments.
    ArgumentSets,
    /// End of a modal call without a modal call. Only some controls have this alarm ([`Control::raises`](super::Control::raises)).
    NoModalCall,
    /// A program that calls itself. Only some controls have this alarm.
    OwnCall,
    /// User alarm by `#3000`.
    User,
    /// Brackets nested too deep.
    BracketDepth,
    /// Brackets not paired.
    BracketPair,
    /// A calculation without a result, for instance the root of a negative number.
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
    /// A command that the control executes and the simulation does not; no alarm of a control.
    NotSimulated,
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
    /// More digits than the address allows.
    Digits,
    /// A decimal point after an address that allows none.
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
    /// A macro call with words in front of it.
    CallNotFirst,
    /// A call in one block with words that exclude it.
    CallMixed,
    /// A subprogram call or return jump while a modal macro call is on.
    ReturnInModal,
    /// An address that cannot pass a macro argument.
    ArgumentAddress,
    /// A `G65 H` function that the control does not have.
    CallFunction,
    /// A `G65 H` function with too few operands, or operands of the wrong kind.
    CallOperands,
    /// A user alarm number outside its range.
    UserAlarmRange,
    /// An assignment to `#0`.
    VacantWritten,
    /// A vacant value assigned to a system variable. Only some controls have this alarm.
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
    /// A number with decimals as the operand of a bitwise operator.
    NotWhole,
    /// A DO or END number outside its range.
    DoNumber,
    /// A jump into a loop.
    IntoLoop,
    /// An arc whose radius is shorter than half its chord.
    ArcRadius,
    /// A spindle that cannot be positioned.
    NoPositioning,
    /// Constant surface speed before the first cutting speed. Only some controls have this alarm.
    NoSurfaceSpeed,
    /// A cutting speed outside its range.
    SurfaceRange,
    /// An angle of the spindle outside a turn.
    SpindleAngle,
    /// Other words beside a code that has to be alone in its block.
    NotAlone,
    /// Two codes of one modal group in a block.
    GroupTwice,
    /// Two codes in a block that both define the meaning of its words.
    SyntaxTwice,
    /// Two auxiliary functions of one group in a block.
    AuxiliaryTwice,
    /// More auxiliary functions in a block than the control allows.
    Auxiliaries,
    /// The same label twice in a program. Only some controls have this alarm.
    LabelTwice,
    /// An undefined name.
    UnknownName,
    /// RET in the main program. Only some controls have this alarm.
    MainReturn,
    /// Two messages without an executable block between them. Only some controls have this alarm.
    MessageBlocks,
    /// An address without effect on the motion in force. Only some controls have this alarm.
    IdleAddress,
    /// A repeat count outside its range.
    RepeatRange,
    /// A spindle speed outside its range.
    SpeedRange,
    /// A speed limit outside its range.
    SpeedLimitRange,
    /// A thread without a lead.
    NoLead,
    /// The lead of a thread is given by the address of another axis.
    LeadAxis,
    /// The shortest way to an angle (DC) for a linear axis. Only some controls have this alarm.
    ShortestWay,
    /// The positive way to an angle (ACP) for a linear axis. Only some controls have this alarm.
    PositiveWay,
    /// The negative way to an angle (ACN) for a linear axis. Only some controls have this alarm.
    NegativeWay,
    /// M04 while the PLC puts out M03, or M03 while it puts out M04. Only some PLCs raise this alarm.
    SpindleReversal,
    /// A gear that does not engage within its time.
    GearTimeout,
    /// A fault of the spindle inverter, with a number of the machine builder.
    InverterFault,
}
}

/// Number and wording of an alarm on one control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AlarmDef {
    /// Cause of the alarm.
    pub kind: Alarm,
    /// Number, for instance `P283`.
    pub number: &'static str,
    /// Wording.
    pub text: Phrase,
    /// The wording is the control's own, from memory or from a source; otherwise it is ours, and no screen of a control shows it.
    pub own_wording: bool,
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
    AlarmDef { kind, number, text: Phrase::new(text), own_wording: true, cite }
}

impl Alarm {
    /// The wider kind to show on a control without a number for this one; `None` for the widest.
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
            JumpNumber | GotoTarget | NoContour => NoSequence,
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

    /// Whether only a control with a row for this kind raises it; other controls continue.
    pub fn needs_row(self) -> bool {
        use Alarm::*;
        matches!(
            self,
            LabelTwice
                | MessageBlocks
                | CallMixed
                | ArgumentAddress
                | NoModalCall
                | NoLead
                | LeadAxis
                | NoSurfaceSpeed
                | VacantValue
                | OwnCall
                | ReturnInModal
                | IdleAddress
                | ShortestWay
                | PositiveWay
                | NegativeWay
                | SpindleReversal
                | MainReturn
        )
    }
}

impl AlarmDef {
    /// The row, with a wording that is not the control's own.
    pub(in crate::controls) const fn in_our_words(self) -> AlarmDef {
        AlarmDef { own_wording: false, ..self }
    }

    /// Whether the table is sorted, for binary search.
    pub const SORTED: bool = false;

    /// Key for replacing a family's row by the control's own row of the same kind.
    pub const fn key(&self) -> Key {
        single(self.kind as u64)
    }
}
