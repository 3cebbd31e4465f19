//! Alarms of the E60 that macroline can raise.

use super::sources::MEMORY;
use crate::controls::Alarm::*;
use crate::controls::AlarmDef;
use crate::controls::alarm::alarm;
use crate::text::{Citation, Grade};

/// One row per kind.
pub(super) const ALARMS: &[AlarmDef] = &[
    alarm(
        IllegalAddress,
        "P32",
        "Illegal address",
        Citation::new("M700V/M70V programming manual, p.19", Grade::Sister),
    ),
    alarm(Format, "P33", "Format error", MEMORY),
    alarm(UnknownCode, "P34", "Illegal G code", MEMORY),
    alarm(OutOfRange, "P35", "Setting value range over", MEMORY),
    alarm(NoProgramEnd, "P36", "Program end error", MEMORY),
    alarm(NumberZero, "P37", "O, N number zero", MEMORY),
    alarm(NoFeed, "P62", "No F command", Citation::new("M700V/M70V programming manual, p.52", Grade::Sister)),
    alarm(Arc, "P70", "Arc end point deviation large", MEMORY),
    alarm(SubNesting, "P230", "Subprogram nesting over", MEMORY),
    alarm(NoSequence, "P231", "No sequence number", MEMORY),
    alarm(NoProgram, "P232", "No program number", MEMORY),
    alarm(
        VariableRange,
        "P241",
        "No variable number",
        Citation::new("M700V/M70V programming manual, p.401; #2000 by the MELDAS 64 list", Grade::Sister),
    ),
    alarm(NoEquals, "P242", "= not defined at variable set", MEMORY),
    alarm(VariableSide, "P243", "Variable cannot be used on this side", MEMORY),
    alarm(Mixed, "P272", "NC and macro text in one block", MEMORY),
    alarm(MacroNesting, "P273", "Macro call nests over", MEMORY),
    alarm(ArgumentSets, "P275", "Macro argument sets over", MEMORY),
    alarm(NoModalCall, "P276", "Calling cancel by itself", MEMORY),
    alarm(User, "P277", "Macro alarm", MEMORY),
    alarm(BracketDepth, "P280", "Brackets [ ] nesting over", MEMORY),
    alarm(BracketPair, "P281", "Brackets [ ] not paired", MEMORY),
    alarm(Calculation, "P282", "Calculation impossible", MEMORY),
    alarm(
        DivisionByZero,
        "P283",
        "Divided by zero",
        Citation::new("nc-program.s-projects.net operator page; number from memory", Grade::Open),
    ),
    alarm(IfSentence, "P290", "IF sentence error", MEMORY),
    alarm(WhileSentence, "P291", "WHILE sentence error", MEMORY),
    alarm(DoNesting, "P293", "DO-END nesting over", Citation::new("cnc.wiki; number from memory", Grade::Open)),
    alarm(DoPair, "P294", "DO and END not paired", MEMORY),
    alarm(
        NotSimulated,
        "NOT SIMULATED",
        "The simulation does not know this",
        Citation::new("no alarm of the control", Grade::Inferred),
    )
    .in_our_words(),
    alarm(SoftLimit, "M01 0007", "S/W stroke end", MEMORY),
    alarm(EmergencyStop, "EMG", "Emergency", MEMORY).in_our_words(),
];
