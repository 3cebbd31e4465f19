//! Switches of the E60: points that no manual at hand settles.

use super::sources::MEMORY;
use crate::controls::Switch;
use crate::controls::options::*;
use crate::controls::switch::switch;
use crate::text::{Citation, Grade};

const DECIMALS: Citation = Citation::new("M700V/M70V programming manual, p.40: parameter #1078", Grade::Sister);

/// Decimal points after variables in the paper's listing, which the control cannot read for other reasons too.
const LISTING: Citation = Citation::new("ribbon dot-printing paper, E60, against MELDAS usage", Grade::Open);

/// Functions introduced with the M700; the E60 is assumed to lack them.
const LATER: Citation = Citation::new("MELDAS usage, unverified: only from the M700 on", Grade::Open);

/// One row per switch; the first option is the default.
pub(super) const SWITCHES: &[Switch] = &[
    switch(
        MacroInputBase::of(&[
            MacroInputBase::R72,
            MacroInputBase::R172,
            MacroInputBase::R24,
            MacroInputBase::R124,
            MacroInputBase::R6436,
        ]),
        Citation::new("MELDAS 64 list and the paper (R74) against the M60 device map", Grade::Open),
    ),
    switch(
        CommonVariables::of(&[
            CommonVariables::Sets100,
            CommonVariables::Sets200,
            CommonVariables::Sets300,
            CommonVariables::Sets600,
        ]),
        Citation::new("MELDAS option list, unverified: 100 sets are the standard of the E60", Grade::Open),
    ),
    switch(OffsetValues::of(&[OffsetValues::AsWritten, OffsetValues::Increments]), MEMORY),
    switch(DecimalPoint::of(&[DecimalPoint::Increments, DecimalPoint::Millimetres]), DECIMALS).parameter("#1078"),
    switch(ArgumentPoint::of(&[ArgumentPoint::Increments, ArgumentPoint::AsWritten]), MEMORY),
    switch(PointAfterVariable::of(&[PointAfterVariable::Alarm, PointAfterVariable::Ignored]), LISTING),
    switch(IfThen::of(&[IfThen::Alarm, IfThen::Read]), LATER),
    switch(Modulo::of(&[Modulo::Alarm, Modulo::Read]), LATER),
    switch(Assignments::of(&[Assignments::One, Assignments::Several]), MEMORY),
    switch(
        RoundInWord::of(&[RoundInWord::WholeNumber, RoundInWord::AddressStep]),
        Citation::new("MELDAS usage, unverified, tells of whole numbers alone", Grade::Open),
    ),
    switch(
        CoordinateRange::of(&[CoordinateRange::Program, CoordinateRange::Machine, CoordinateRange::NoAlarm]),
        Citation::new("M700V/M70V programming manual, p.40: range of words; of coordinates unverified", Grade::Open),
    ),
    switch(StartupDistance::of(&[StartupDistance::G90, StartupDistance::G91]), MEMORY).parameter("#1073"),
    switch(StartupMotion::of(&[StartupMotion::G01, StartupMotion::G00]), MEMORY).parameter("#1075"),
    switch(ThreadE::of(&[ThreadE::ThreadsPerInch, ThreadE::Lead]), MEMORY).parameter("#8156"),
    switch(DwellUnit::of(&[DwellUnit::Seconds, DwellUnit::Revolutions]), MEMORY),
    switch(FeedZero::of(&[FeedZero::Alarm, FeedZero::Rapid]), MEMORY).parameter("#1079"),
    switch(SpindleWord::of(&[SpindleWord::Truncate, SpindleWord::Round]), DECIMALS),
    switch(
        SpeedReached::of(&[SpeedReached::NoWait, SpeedReached::Wait]),
        Citation::new("MELDAS 50 practice with an inverter: no such signal", Grade::Open),
    )
    .parameter("SAR"),
    switch(ManualS::of(&[ManualS::Refused, ManualS::Taken]), MEMORY),
    switch(M5Timing::of(&[M5Timing::Before, M5Timing::End]), MEMORY),
    switch(CallParameters::of(""), MEMORY),
    switch(CommonAtReset::of(&[CommonAtReset::Kept, CommonAtReset::Vacant]), MEMORY)
        .label("switch.common-at-reset-all")
        .parameter("#1128"),
    switch(LocalsOfCalls::of(&[LocalsOfCalls::Vacant, LocalsOfCalls::Kept]), MEMORY).parameter("#1114"),
    switch(OverrideSuppression::of(&[OverrideSuppression::Yes, OverrideSuppression::No]), MEMORY),
];
