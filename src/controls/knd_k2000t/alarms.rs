//! Alarms of the K2000T that macroline can raise, in the numbers of FANUC lathe controls.

use crate::controls::Alarm::*;
use crate::controls::AlarmDef;
use crate::controls::alarm::alarm;
use crate::controls::base::fanuc::MEMORY;
use crate::text::{Citation, Grade};

/// Numbers confirmed by a second source.
const KNOWN: Citation = Citation::new("FANUC 16i/0i-F alarm names, sheet section 4", Grade::Inferred);

/// One row per kind.
pub(super) const ALARMS: &[AlarmDef] = &[
    alarm(Digits, "003", "Too many digits", MEMORY),
    alarm(SequenceDigits, "003", "Too many digits", MEMORY),
    alarm(Format, "004", "Address not found", MEMORY),
    alarm(NoNumber, "005", "No data after address", MEMORY),
    alarm(PointNotAllowed, "007", "Illegal use of decimal point", MEMORY),
    alarm(NumberZero, "009", "Illegal address input", MEMORY),
    alarm(IllegalAddress, "009", "Illegal address input", MEMORY),
    alarm(UnknownCode, "010", "Improper G code", MEMORY),
    alarm(Auxiliaries, "009", "Illegal address input", MEMORY),
    alarm(NoFeed, "011", "No feedrate commanded", MEMORY),
    alarm(Arc, "020", "Over tolerance of radius", MEMORY),
    alarm(ArcRadius, "023", "Illegal radius command", MEMORY),
    alarm(NoContour, "063", "Sequence number is not found", MEMORY),
    alarm(NoCallProgram, "076", "Address P not defined", MEMORY),
    alarm(SubNesting, "077", "Subprogram nesting error", MEMORY),
    alarm(MacroNesting, "077", "Subprogram nesting error", MEMORY),
    alarm(NoSequence, "078", "Number not found", MEMORY),
    alarm(NoProgram, "078", "Number not found", MEMORY),
    alarm(OutOfRange, "110", "Data overflow", MEMORY),
    alarm(Calculation, "111", "Calculated data overflow", KNOWN),
    alarm(DivisionByZero, "112", "Divided by zero", MEMORY),
    alarm(Tangent, "112", "Divided by zero", MEMORY),
    alarm(NoEquals, "114", "Format error in macro", KNOWN),
    alarm(IfSentence, "114", "Format error in macro", KNOWN),
    alarm(WhileSentence, "114", "Format error in macro", KNOWN),
    alarm(AtanForm, "114", "Format error in macro", MEMORY),
    alarm(VariableRange, "115", "Illegal variable number", KNOWN),
    alarm(VariableSide, "115", "Illegal variable number", MEMORY),
    alarm(UserAlarmRange, "115", "Illegal variable number", MEMORY),
    alarm(ReadOnly, "116", "Write protected variable", MEMORY),
    alarm(BracketDepth, "118", "Parenthesis nesting error", KNOWN),
    alarm(BracketPair, "118", "Parenthesis nesting error", MEMORY),
    alarm(SquareRoot, "119", "Illegal argument", MEMORY),
    alarm(Logarithm, "119", "Illegal argument", MEMORY),
    alarm(ArcFunction, "119", "Illegal argument", MEMORY),
    alarm(DoPair, "124", "Missing end statement", MEMORY),
    alarm(DoNesting, "124", "Missing end statement", MEMORY),
    alarm(DoNumber, "126", "Illegal loop number", MEMORY),
    alarm(Mixed, "127", "NC and macro statement in same block", MEMORY),
    alarm(JumpNumber, "128", "Illegal macro sequence number", MEMORY),
    alarm(ArgumentSets, "129", "Illegal argument address", MEMORY),
    alarm(ArgumentAddress, "129", "Illegal argument address", MEMORY),
    alarm(SoftLimit, "500", "Over travel: stored stroke check", MEMORY),
    alarm(User, "3000", "Macro alarm", MEMORY),
    alarm(NoProgramEnd, "5010", "End of record", MEMORY),
    alarm(EmergencyStop, "ESP", "Emergency stop", MEMORY).in_our_words(),
    alarm(
        NotSimulated,
        "NOT SIMULATED",
        "The simulation does not know this",
        Citation::new("no alarm of the control", Grade::Inferred),
    )
    .in_our_words(),
];
