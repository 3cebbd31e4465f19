//! Alarms of the 980TDc that macroline can raise.

use crate::controls::Alarm::*;
use crate::controls::AlarmDef;
use crate::controls::alarm::alarm;
use crate::text::{Citation, Grade};

/// The list of the milling sister; the numbers of the 980T family agree where both are known.
const LIST: Citation = Citation::new("GSK980MDi manual 2022, appendix 5, p.437", Grade::Sister);
const USER: Citation = Citation::new("GSK980TDi manual, 3.28; older lists have 500 + n", Grade::Sister);
/// The closest alarm in the list, with another wording.
const NEAREST: Citation = Citation::new("GSK980MDi manual 2022, p.437: the nearest in the list", Grade::Open);

/// Alarms of the standard ladder.
const LADDER: Citation = Citation::new("GSK980MDi manual 2022, ladder 3.1 and 3.3", Grade::Sister);

/// One row per kind.
pub(super) const ALARMS: &[AlarmDef] = &[
    alarm(SpindleReversal, "A0.3", "M03 and M04 without M05 between them", LADDER),
    alarm(GearTimeout, "A1.0", "Gear shift takes too long", LADDER),
    alarm(EmergencyStop, "0000", "Emergency stop", LIST),
    alarm(NoProgram, "0001", "Called program does not exist", LIST),
    alarm(UnknownCode, "0002", "Illegal G code", LIST),
    alarm(IllegalAddress, "0003", "Characters of a word fewer than 2 or more than 11", NEAREST),
    alarm(NoNumber, "0003", "Characters of a word fewer than 2 or more than 11", LIST),
    alarm(Digits, "0003", "Characters of a word fewer than 2 or more than 11", LIST),
    alarm(NumberZero, "0006", "Sequence number of wrong form or out of range", LIST),
    alarm(SequencePlace, "0006", "Sequence number of wrong form or out of range", LIST),
    alarm(SequenceDigits, "0006", "Sequence number of wrong form or out of range", LIST),
    alarm(AddressTwice, "0010", "Same address twice in a block", LIST),
    alarm(Auxiliaries, "0010", "Same address twice in a block", NEAREST),
    alarm(BlockWords, "0011", "More than 100 words in a block", LIST),
    alarm(OutOfRange, "0012", "Value illegal or out of range", LIST),
    alarm(Arc, "0018", "Arc data wrong or beyond the radius tolerance", LIST),
    alarm(FeedRange, "0023", "F wrong or above parameter No.027", LIST),
    alarm(NoFeed, "0023", "F wrong or above parameter No.027", NEAREST),
    alarm(BlockTooLong, "0037", "Block of more than 256 characters", LIST),
    alarm(CommentBracket, "0041", "Comment brackets not paired", LIST),
    alarm(Calculation, "0043", "Result of a macro calculation out of range", LIST),
    alarm(RepeatRange, "0092", "Repeats of a call outside 1 to 9999", LIST),
    alarm(SubNesting, "0096", "Subprograms nested deeper than 4", LIST),
    alarm(MacroNesting, "0096", "Subprograms nested deeper than 4", NEAREST),
    alarm(OwnCall, "0097", "Called program is the running one", LIST),
    alarm(Format, "0101", "Macro statement of wrong form", LIST),
    alarm(NoEquals, "0101", "Macro statement of wrong form", LIST),
    alarm(Mixed, "0101", "Macro statement of wrong form", NEAREST),
    alarm(IfSentence, "0101", "Macro statement of wrong form", LIST),
    alarm(DoNumber, "0102", "Number of DO or END is not 1, 2, 3", LIST),
    alarm(WhileSentence, "0103", "DO and END of wrong form, or a jump into a loop", LIST),
    alarm(DoNesting, "0103", "DO and END of wrong form, or a jump into a loop", LIST),
    alarm(DoPair, "0103", "DO and END of wrong form, or a jump into a loop", LIST),
    alarm(BracketDepth, "0104", "Brackets not paired or of wrong form", NEAREST),
    alarm(BracketPair, "0104", "Brackets not paired or of wrong form", LIST),
    alarm(DivisionByZero, "0105", "Divisor is 0", LIST),
    alarm(AtanForm, "0106", "ATAN of wrong form", LIST),
    alarm(Logarithm, "0107", "LN of 0 or less", LIST),
    alarm(SquareRoot, "0108", "Root of a negative number", LIST),
    alarm(Tangent, "0109", "Tangent is infinite", LIST),
    alarm(ArcFunction, "0110", "ASIN or ACOS outside -1 to 1", LIST),
    alarm(VariableRange, "0111", "No such variable, or of wrong kind", LIST),
    alarm(VariableSide, "0111", "No such variable, or of wrong kind", LIST),
    alarm(NoSequence, "0112", "Sequence number of GOTO or M99 is missing or out of range", LIST),
    alarm(ReturnInModal, "0113", "M98 or M99 P while a modal macro call (G66) is on", LIST),
    alarm(CallNotFirst, "0114", "G65 or G66 does not open its block", LIST),
    alarm(
        CallMixed,
        "0116",
        "G65 together with M00, M01, M02, M30, M98 or M99",
        Citation::new("GSK980MDi notes on alarms", Grade::Sister),
    ),
    alarm(VacantWritten, "0117", "#0 cannot take a result", LIST),
    alarm(ArgumentSets, "0118", "More than 10 of I, J, K", LIST),
    alarm(ReadOnly, "0120", "Variable is read-only", LIST),
    alarm(VacantValue, "0121", "System variable set to null", LIST),
    alarm(NoCallProgram, "0122", "G65 or G66 without P, or G65 without H", LIST),
    alarm(CallFunction, "0124", "Illegal H behind G65", LIST),
    alarm(CallOperands, "0125", "Operands missing or wrong", LIST),
    alarm(UserAlarmRange, "0126", "Number of G65 H99 or #3000 outside 0 to 99", LIST),
    alarm(NotWhole, "0127", "Operand is not whole", LIST),
    alarm(SoftLimit, "3011", "Beyond the soft limit", LIST),
    alarm(User, "5900", "User alarm", USER),
    alarm(
        NoProgramEnd,
        "END",
        "The program runs out of blocks",
        Citation::new("what the control does is not known", Grade::Open),
    )
    .in_our_words(),
    alarm(
        NotSimulated,
        "NOT SIMULATED",
        "The simulation does not know this",
        Citation::new("no alarm of the control", Grade::Inferred),
    )
    .in_our_words(),
];
