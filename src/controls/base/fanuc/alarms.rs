//! Alarms of the 0i-F that macroline can raise, in the numbers and words of the alarm list of its sister, the 30i.

use super::sources::{ALARM_LIST, MEMORY};
use crate::controls::Alarm::*;
use crate::controls::AlarmDef;
use crate::controls::alarm::alarm;
use crate::controls::schema::table::extended;
use crate::text::{Citation, Grade};

/// One row per kind. The grade is open where the list leaves the choice between two numbers.
pub const ALARMS: &[AlarmDef] = &[
    alarm(Digits, "PS0003", "Too many digit", ALARM_LIST),
    alarm(OutOfRange, "PS0003", "Too many digit", MEMORY),
    alarm(Format, "PS0004", "Invalid break point of words", ALARM_LIST),
    alarm(NoNumber, "PS0005", "No data after address", ALARM_LIST),
    alarm(PointNotAllowed, "PS0007", "Illegal use of decimal point", ALARM_LIST),
    alarm(IllegalAddress, "PS0009", "Improper NC-address", ALARM_LIST),
    alarm(NumberZero, "PS0009", "Improper NC-address", MEMORY),
    alarm(UnknownCode, "PS0010", "Improper G-code", ALARM_LIST),
    alarm(NoFeed, "PS0011", "Feed zero (command)", ALARM_LIST),
    alarm(Arc, "PS0020", "Over tolerance of radius", ALARM_LIST),
    alarm(ArcRadius, "PS0023", "Illegal radius command", MEMORY),
    alarm(NoProgram, "PS0076", "Program not found", ALARM_LIST),
    alarm(SubNesting, "PS0077", "Too many sub,macro nesting", ALARM_LIST),
    alarm(NoSequence, "PS0078", "Sequence number not found", ALARM_LIST),
    alarm(Overflow, "PS0111", "Overflow: floating", ALARM_LIST),
    alarm(DivisionByZero, "PS0112", "Zero divide", ALARM_LIST),
    alarm(Tangent, "PS0112", "Zero divide", MEMORY),
    alarm(VariableRange, "PS0115", "Variable No. out of range", ALARM_LIST),
    alarm(UserAlarmRange, "PS0115", "Variable No. out of range", MEMORY),
    alarm(ReadOnly, "PS0116", "Write protected variable", ALARM_LIST),
    alarm(BracketDepth, "PS0118", "Too many bracket nesting", ALARM_LIST),
    alarm(Calculation, "PS0119", "Argument value out of range", ALARM_LIST),
    alarm(MacroNesting, "PS0122", "Too many macro nesting", ALARM_LIST),
    alarm(MissingEnd, "PS0124", "Missing END statement", ALARM_LIST),
    alarm(DoPair, "PS0124", "Missing END statement", MEMORY),
    alarm(DoNesting, "PS0124", "Missing END statement", MEMORY),
    alarm(DoNumber, "PS0126", "Illegal loop number", ALARM_LIST),
    alarm(Mixed, "PS0127", "Duplicate NC,macro statement", ALARM_LIST),
    alarm(GotoTarget, "PS0128", "Illegal macro sequence number", ALARM_LIST),
    alarm(ArgumentAddress, "PS0129", "Use 'G' as argument", ALARM_LIST),
    alarm(ArgumentSets, "PS1095", "Too many type-2 argument", ALARM_LIST),
    alarm(NoModalCall, "PS1100", "Cancel without modal call", ALARM_LIST),
    alarm(VariableSide, "PS1115", "Read protected variable", ALARM_LIST),
    alarm(AtanForm, "PS1120", "Illegal argument format", ALARM_LIST),
    alarm(MissingDo, "PS1124", "Missing DO statement", ALARM_LIST),
    alarm(JumpNumber, "PS1128", "Sequence number out of range", ALARM_LIST),
    alarm(BracketPair, "PS1132", "Missing close bracket", MEMORY),
    alarm(NoEquals, "PS1133", "Missing '='", ALARM_LIST),
    alarm(IfSentence, "PS1137", "IF statement format error", ALARM_LIST),
    alarm(WhileSentence, "PS1138", "WHILE statement format error", ALARM_LIST),
    alarm(BlockWords, "PS5006", "Too many word in one block", ALARM_LIST),
    alarm(NoProgramEnd, "PS5010", "End of record", ALARM_LIST),
    alarm(User, "MC3000", "Macro alarm", MEMORY),
    alarm(SoftLimit, "OT0500", "Overtravel: soft limit 1", MEMORY),
    alarm(EmergencyStop, "EMG", "Emergency stop", MEMORY).in_our_words(),
    alarm(
        NotSimulated,
        "NOT SIMULATED",
        "The simulation does not know this",
        Citation::new("no alarm of the control", Grade::Inferred),
    )
    .in_our_words(),
];

/// Alarms of a lathe: its cycles name their contour.
pub const LATHE: &[AlarmDef] = extended![
    AlarmDef: ALARMS,
    &[alarm(NoContour, "PS0063", "The block of a specified sequence number is not found", MEMORY)],
];
