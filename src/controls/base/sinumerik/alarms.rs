//! Alarms of the SINUMERIK family that macroline can raise, in the numbers common to its controls.

use super::sources::MEMORY;
use crate::controls::Alarm::*;
use crate::controls::AlarmDef;
use crate::controls::alarm::alarm;
use crate::text::{Citation, Grade};

/// The diagnostics manuals of 808D and 828D, whose numbers agree.
const LIST: Citation = Citation::new("808D diagnostics 07/2018 and 828D diagnostics 03/2013", Grade::Sister);
/// The closest alarm in the list, with another wording.
const NEAREST: Citation = Citation::new("808D diagnostics 07/2018: the nearest in the list", Grade::Open);
const LIMIT: Citation =
    Citation::new("840D sl function manual 08/2005, p.2-9; range 808D diagnostics, p.217", Grade::Sister);
const DOMAIN: Citation = Citation::new("14051 names overflow and division; 14020 would fit as well", Grade::Open);
const RANGE: Citation =
    Citation::new("828D diagnostics, p.118; for numbers too large 17020 would fit as well", Grade::Open);

const IDLE: Citation = Citation::new(
    "808D diagnostics, p.141, of G1 I10; for CR beside I and K no list at hand has a number, and 14040 would fit as well",
    Grade::Open,
);

/// One row per kind.
pub const ALARMS: &[AlarmDef] = &[
    alarm(EmergencyStop, "3000", "Emergency stop", MEMORY),
    alarm(SoftLimit, "10720", "Programmed end point lies behind a software limit", NEAREST),
    alarm(WorkingArea, "10730", "Programmed end point lies behind a working area limit", MEMORY),
    alarm(NoFeed, "10860", "No feedrate programmed", LIST),
    alarm(NoSurfaceSpeed, "10900", "No S value programmed for constant cutting speed", LIST),
    alarm(AddressTwice, "12000", "Address programmed repeatedly", LIST),
    alarm(GroupTwice, "12060", "Same G group programmed repeatedly", LIST),
    alarm(SyntaxTwice, "12070", "Too many syntax-defining G functions", LIST),
    alarm(Format, "12080", "Syntax error in text", LIST),
    alarm(NoEquals, "12080", "Syntax error in text", LIST),
    alarm(Mixed, "12080", "Syntax error in text", LIST),
    alarm(IfSentence, "12080", "Syntax error in text", LIST),
    alarm(WhileSentence, "12080", "Syntax error in text", NEAREST),
    alarm(DoNesting, "12080", "Syntax error in text", NEAREST),
    alarm(DoPair, "12080", "Syntax error in text", NEAREST),
    alarm(BracketPair, "12080", "Syntax error in text", LIST),
    alarm(ArgumentSets, "12080", "Syntax error in text", NEAREST),
    alarm(NumberZero, "12080", "Syntax error in text", NEAREST),
    alarm(IdleAddress, "12110", "Block syntax cannot be interpreted", IDLE),
    alarm(NotAlone, "12120", "Special G function not programmed separately", LIST),
    alarm(OutOfRange, "12160", "Value lies beyond the value range", LIST),
    alarm(VariableRange, "12290", "Arithmetic variable not defined", RANGE),
    alarm(VariableSide, "12290", "Arithmetic variable not defined", NEAREST),
    alarm(LabelTwice, "12450", "Label defined twice", LIST),
    alarm(UnknownCode, "12470", "G function is unknown", LIST),
    alarm(BlockTooLong, "12540", "Block is too long or too complex", NEAREST),
    alarm(UnknownName, "12550", "Name not defined or option not available", LIST),
    alarm(IllegalAddress, "12550", "Name not defined or option not available", NEAREST),
    alarm(NoProgramEnd, "14000", "Illegal end of file", LIST),
    alarm(NoProgram, "14011", "Program does not exist", LIST),
    alarm(SubNesting, "14012", "Lowest subprogram level exceeded", LIST),
    alarm(MacroNesting, "14012", "Lowest subprogram level exceeded", NEAREST),
    alarm(RepeatRange, "14013", "Number of subprogram passes invalid", LIST),
    alarm(Arc, "14040", "Error in end point of circle", LIST),
    alarm(BracketDepth, "14050", "Nesting depth for arithmetic operations exceeded", LIST),
    alarm(Calculation, "14051", "Arithmetic error in part program", DOMAIN),
    alarm(DivisionByZero, "14051", "Arithmetic error in part program", LIST),
    alarm(NoSequence, "14080", "Jump destination not found", LIST),
    alarm(MainReturn, "14091", "Function not permitted: RET on the main program level", LIST),
    alarm(AuxiliaryTwice, "14760", "Auxiliary function of a group programmed repeatedly", LIST),
    alarm(Auxiliaries, "14770", "Auxiliary function programmed incorrectly", LIST),
    alarm(FeedZero, "14800", "Programmed path velocity less than or equal to zero", LIST),
    alarm(FeedRange, "14800", "Programmed path velocity less than or equal to zero", NEAREST),
    alarm(
        SpeedLimitRange,
        "14820",
        "Negative value for maximum spindle speed programmed with constant cutting speed",
        LIMIT,
    ),
    alarm(SurfaceRange, "14840", "Value for constant cutting speed out of range", LIST),
    alarm(NoLead, "16720", "Thread lead is zero", LIST),
    alarm(LeadAxis, "16730", "Wrong parameter for the thread lead", LIST),
    alarm(SpeedRange, "16763", "Programmed speed is illegal (zero or negative)", LIST),
    alarm(NoPositioning, "16770", "Axis has no measuring system", LIST),
    alarm(ShortestWay, "16800", "DC is for rotary axes", LIST),
    alarm(PositiveWay, "16810", "ACP is for modulo axes", LIST),
    alarm(NegativeWay, "16820", "ACN is for modulo axes", LIST),
    alarm(SpindleAngle, "16830", "Incorrect position programmed for axis or spindle", LIST),
    alarm(MessageBlocks, "16930", "Blocks must be separated by an executable block", LIST),
    alarm(
        NotSimulated,
        "NOT SIMULATED",
        "The simulation does not know this",
        Citation::new("no alarm of the control", Grade::Inferred),
    )
    .in_our_words(),
];
