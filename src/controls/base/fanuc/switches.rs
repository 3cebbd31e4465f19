//! Switches of the FANUC family: points that no manual at hand settles, and parameters that change the meaning of a program.

use super::sources::{ARGUMENTS, MEMORY};
use crate::controls::Switch;
use crate::controls::options::*;
use crate::controls::schema::table::joined;
use crate::controls::switch::switch;
use crate::text::{Citation, Grade};

/// Reading of numbers; the first option is the default.
const NUMBERS: &[Switch] = &[
    switch(DecimalPoint::of(&[DecimalPoint::Increments, DecimalPoint::Millimetres]), MEMORY).parameter("3401#0"),
    switch(ArgumentPoint::of(&[ArgumentPoint::Increments, ArgumentPoint::AsWritten]), ARGUMENTS),
    switch(CommentCharacters::of(&[CommentCharacters::Ascii, CommentCharacters::Gbk, CommentCharacters::Utf8]), MEMORY),
    switch(PointAfterVariable::of(&[PointAfterVariable::Alarm, PointAfterVariable::Ignored]), MEMORY),
    switch(Assignments::of(&[Assignments::One, Assignments::Several]), MEMORY),
    switch(WordFormula::of(&[WordFormula::AsIs, WordFormula::InBrackets]), MEMORY),
    switch(
        RoundInWord::of(&[RoundInWord::AddressStep, RoundInWord::WholeNumber]),
        Citation::new("custom macro B of FANUC, by secondary sources", Grade::Inferred),
    ),
    switch(
        NumberDigits::of(&[NumberDigits::Twelve, NumberDigits::Eight]),
        Citation::new("8 on older FANUC controls by a forum, 12 on newer ones from memory", Grade::Open),
    ),
];

/// Diameter or radius words of a lathe's X.
const DIAMETER: &[Switch] =
    &[switch(Diameter::of(&[Diameter::Diameter, Diameter::Radius]), MEMORY).parameter("1006#3")];

/// Codes, spindle, calls and variables.
const RUNNING: &[Switch] = &[
    switch(MCodes::of(&[MCodes::LastActs, MCodes::LastThreeAct, MCodes::Alarm]), MEMORY)
        .label("switch.m-codes-more")
        .parameter("3404#7"),
    switch(
        CoordinateRange::of(&[CoordinateRange::Program, CoordinateRange::Machine, CoordinateRange::NoAlarm]),
        MEMORY,
    ),
    switch(StartupMotion::of(&[StartupMotion::G00, StartupMotion::G01]), MEMORY).parameter("3402#0"),
    switch(StartupFeed::of(&[StartupFeed::G99, StartupFeed::G98]), MEMORY).parameter("3402#4"),
    switch(DwellUnit::of(&[DwellUnit::Seconds, DwellUnit::Revolutions]), MEMORY).parameter("3405#1"),
    switch(AngleRange::of(&[AngleRange::AtanTurnAsinWithinTurn, AngleRange::AtanHalfTurnAsinAroundZero]), MEMORY)
        .parameter("6004#0"),
    switch(SpeedReached::of(&[SpeedReached::NoWait, SpeedReached::Wait]), MEMORY).parameter("3708#0"),
    switch(SurfaceSpeedInInch::of(&[SurfaceSpeedInInch::FeetPerMinute, SurfaceSpeedInInch::MetresPerMinute]), MEMORY),
    switch(OverrideOrder::of(&[OverrideOrder::BeforeLimits, OverrideOrder::AfterLimits]), MEMORY),
    switch(ManualS::of(&[ManualS::Refused, ManualS::Taken]), MEMORY),
    switch(M5Timing::of(&[M5Timing::Before, M5Timing::End]), MEMORY),
    switch(SpindleAtReset::of(&[SpindleAtReset::Stops, SpindleAtReset::Turns]), MEMORY),
    switch(CallParameters::of(""), MEMORY).label("switch.call-parameters-9010"),
    switch(PmcOverride::of(&[PmcOverride::ActsNot, PmcOverride::Acts]), MEMORY),
    switch(CommonAtReset::of(&[CommonAtReset::Vacant, CommonAtReset::Kept]), MEMORY).parameter("6001#6"),
    switch(LocalsOfCalls::of(&[LocalsOfCalls::Vacant, LocalsOfCalls::Kept]), MEMORY),
    switch(OverrideSuppression::of(&[OverrideSuppression::Yes, OverrideSuppression::No]), MEMORY),
];

/// Feed of a helix on a mill.
const HELIX: &[Switch] = &[switch(
    HelixFeed::of(&[HelixFeed::Arc, HelixFeed::Path]),
    Citation::new("FANUC operator's manual B-63783EN, p.571: HTG", Grade::Sister),
)
.parameter("1403#5")];

/// Switches of a lathe.
pub const LATHE: &[Switch] = joined![Switch: NUMBERS, DIAMETER, RUNNING];

/// Switches of a mill.
pub const MILL: &[Switch] = joined![Switch: NUMBERS, RUNNING, HELIX];
