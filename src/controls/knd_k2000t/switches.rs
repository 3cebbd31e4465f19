//! Points of the K2000T that no manual at hand settles, and parameters that change what a program means.

use super::{MEMORY, PAPER};
use crate::controls::Switch;
use crate::controls::options::*;
use crate::controls::switch::switch;
use crate::text::{Citation, Grade};

/// The samples show what is meant; the parameter's number is FANUC's.
const SAMPLE: Citation = Citation::new("sample of the polygon turning paper; parameter by FANUC 0i-T", Grade::Inferred);

/// One row per point; the first option is the default.
pub(super) const SWITCHES: &[Switch] = &[
    switch(DecimalPoint::of(&[DecimalPoint::Millimetres, DecimalPoint::Increments]), SAMPLE).parameter("3401#0"),
    switch(ArgumentPoint::of(&[ArgumentPoint::AsWritten, ArgumentPoint::Increments]), SAMPLE),
    switch(PointBehindVariable::of(&[PointBehindVariable::Alarm, PointBehindVariable::Ignored]), MEMORY),
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
    switch(Diameter::of(&[Diameter::Diameter, Diameter::Radius]), SAMPLE).parameter("1006#3"),
    switch(MCodes::of(&[MCodes::LastActs, MCodes::LastThreeAct, MCodes::Alarm]), MEMORY)
        .label("switch.m-codes-more")
        .parameter("3404#7"),
    switch(StartupMotion::of(&[StartupMotion::G00, StartupMotion::G01]), MEMORY).parameter("3402#0"),
    switch(StartupFeed::of(&[StartupFeed::G98, StartupFeed::G99]), SAMPLE).parameter("3402#4"),
    switch(AngleRange::of(&[AngleRange::AtanTurnAsinWithinTurn, AngleRange::AtanHalfTurnAsinAroundZero]), MEMORY)
        .parameter("6004#0"),
    switch(SpeedReached::of(&[SpeedReached::NoWait, SpeedReached::Wait]), MEMORY).parameter("3708#0"),
    switch(OverrideOrder::of(&[OverrideOrder::BeforeLimits, OverrideOrder::BehindLimits]), MEMORY),
    switch(M5Timing::of(&[M5Timing::Before, M5Timing::End]), MEMORY),
    switch(SpindleAtReset::of(&[SpindleAtReset::Stops, SpindleAtReset::Turns]), MEMORY),
    switch(CallParameters::of("4120=512 4121=502"), PAPER).label("switch.call-parameters-each"),
    switch(PmcOverride::of(&[PmcOverride::ActsNot, PmcOverride::Acts]), MEMORY),
    switch(CommonAtReset::of(&[CommonAtReset::Vacant, CommonAtReset::Kept]), MEMORY).parameter("6001#6"),
    switch(LocalsOfCalls::of(&[LocalsOfCalls::Vacant, LocalsOfCalls::Kept]), MEMORY),
    switch(OverrideSuppression::of(&[OverrideSuppression::Yes, OverrideSuppression::No]), MEMORY),
];
