//! Switches of the 980TDc: points that no manual at hand settles, and parameters that change the meaning of a program.

use super::sources::{MACRO, MEMORY, OVERRIDE, PARAMETERS, STATEMENT};
use crate::controls::Switch;
use crate::controls::options::*;
use crate::controls::switch::switch;
use crate::text::{Citation, Grade};

const LADDER: Citation = Citation::new("GSK980MDi manual, ladder 3.1", Grade::Sister);
const PLC_DATA: Citation = Citation::new("GSK980TDi PLC data list, K16.5 and K17.3", Grade::Sister);
const ESCD: Citation =
    Citation::new("GSK980TDc manual, 2.2.2: kept; parameter GSK980MDi manual 2022, p.374", Grade::Sister);
const RAPID: Citation = Citation::new(
    "GSK980TDc manual, 2.2.2: in cutting feed alone; of the end point GSK980TDi manual, 3.25",
    Grade::Manual,
);
const REST: Citation = Citation::new(
    "GSK980TDc manual, 2.2.2: 0 V after power-on and at S0; No.036 is an offset at speed 0",
    Grade::Manual,
);
const CALLS: Citation = Citation::new("GSK980TDi manual, 3.32; M codes: notes on new functions", Grade::Sister);
const ALARMS: Citation =
    Citation::new("GSK980TDi manual, 3.28: 5900 + n; an older list has 500 + n for H99", Grade::Sister);
/// All samples in the manuals omit the decimal point.
const SAMPLES: Citation =
    Citation::new("samples of the 980TDi manual: G00 X100 Z50 is 100 mm and 50 mm", Grade::Inferred);

/// One row per switch; the first option is the default.
pub(super) const SWITCHES: &[Switch] = &[
    switch(DecimalPoint::of(&[DecimalPoint::Millimetres, DecimalPoint::Increments]), SAMPLES),
    switch(ArgumentPoint::of(&[ArgumentPoint::AsWritten, ArgumentPoint::Increments]), MACRO),
    switch(PointAfterVariable::of(&[PointAfterVariable::Alarm, PointAfterVariable::Ignored]), MEMORY),
    switch(Assignments::of(&[Assignments::One, Assignments::Several]), MEMORY),
    switch(WordFormula::of(&[WordFormula::AsIs, WordFormula::InBrackets]), MEMORY),
    switch(
        RoundInWord::of(&[RoundInWord::WholeNumber, RoundInWord::AddressStep]),
        Citation::new("GSK980TDi manual, 3.29, tells of statements, IF and WHILE alone", Grade::Open),
    ),
    switch(Diameter::of(&[Diameter::Diameter, Diameter::Radius]), PARAMETERS).parameter("No.001#2"),
    switch(
        CoordinateRange::of(&[CoordinateRange::Program, CoordinateRange::Machine, CoordinateRange::NoAlarm]),
        MEMORY,
    ),
    switch(CommentCharacters::of(&[CommentCharacters::Ascii, CommentCharacters::Gbk, CommentCharacters::Utf8]), MEMORY),
    switch(MCodes::of(&[MCodes::Alarm, MCodes::LastActs]), MEMORY),
    switch(StartupFeed::of(&[StartupFeed::G98, StartupFeed::G99]), PARAMETERS).parameter("No.182#0"),
    switch(
        AngleRange::of(&[AngleRange::AtanTurnAsinAroundZero, AngleRange::AtanHalfTurnAsinAroundHalfTurn]),
        STATEMENT,
    )
    .parameter("No.180#7"),
    switch(
        SpeedLimitSetsZero::of(&[
            SpeedLimitSetsZero::ReferencePoint,
            SpeedLimitSetsZero::WorkZero,
            SpeedLimitSetsZero::Nothing,
        ]),
        Citation::new(
            "GSK980TDc manual, 2.2.3: the program reference point; on the TDi it sets nothing",
            Grade::Manual,
        ),
    ),
    switch(SpeedInRapid::of(&[SpeedInRapid::Kept, SpeedInRapid::OfEnd]), RAPID),
    switch(OffsetAtRest::of(&[OffsetAtRest::Off, OffsetAtRest::PutOut]), REST),
    switch(SpeedReached::of(&[SpeedReached::NoWait, SpeedReached::Wait]), PARAMETERS).parameter("No.175#6"),
    switch(SurfaceSpeedInInch::of(&[SurfaceSpeedInInch::FeetPerMinute, SurfaceSpeedInInch::MetresPerMinute]), MEMORY),
    switch(OverrideOrder::of(&[OverrideOrder::BeforeLimits, OverrideOrder::AfterLimits]), MEMORY),
    switch(OverrideCode::of(&[OverrideCode::Switch, OverrideCode::Tens]), OVERRIDE),
    switch(ManualS::of(&[ManualS::Refused, ManualS::Taken]), MEMORY),
    switch(M5Timing::of(&[M5Timing::End, M5Timing::Before]), PLC_DATA).parameter("PLC K16.5"),
    switch(VoltsAtStop::of(&[VoltsAtStop::Kept, VoltsAtStop::Off]), PLC_DATA).parameter("PLC K17.3"),
    switch(VoltsAtEmergencyStop::of(&[VoltsAtEmergencyStop::Kept, VoltsAtEmergencyStop::Off]), ESCD)
        .parameter("No.173#0"),
    switch(Reversal::of(&[Reversal::Alarm, Reversal::TurnsBack]), LADDER).parameter("A0.3"),
    switch(SpindleAtReset::of(&[SpindleAtReset::Stops, SpindleAtReset::Turns]), LADDER).parameter("K10.1 RSJG"),
    switch(SpindleAtEnd::of(&[SpindleAtEnd::Turns, SpindleAtEnd::Stops]), LADDER)
        .parameter("K10 MTSS of the milling control"),
    switch(SpindleWord::of(&[SpindleWord::Round, SpindleWord::Truncate]), MEMORY),
    switch(UserAlarmBase::of(&[UserAlarmBase::From5900, UserAlarmBase::From500]), ALARMS),
    switch(CallParameters::of(""), CALLS).label("switch.call-parameters-ranges"),
    switch(CommonAtReset::of(&[CommonAtReset::Kept, CommonAtReset::Vacant]), MEMORY),
    switch(LocalsOfCalls::of(&[LocalsOfCalls::Vacant, LocalsOfCalls::Kept]), MACRO),
];
