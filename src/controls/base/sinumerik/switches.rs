//! Switches of the SINUMERIK family: points that no manual at hand settles, and data that change the meaning of a program.

use super::sources::MEMORY;
use crate::controls::Switch;
use crate::controls::options::*;
use crate::controls::switch::switch;
use crate::text::{Citation, Grade};

const REACHED: Citation = Citation::new("808D parameter manual: MD35500 and MD35150", Grade::Sister);
const ACTIVATION: Citation = Citation::new("no source says it", Grade::Open);
const LOOK_AHEAD: Citation =
    Citation::new("840D/810D programming fundamentals 10.2004, p.7-40: the next block", Grade::Sister);
const SMALL: Citation =
    Citation::new("the page on 802D spindle commands, 4: small offsets on X, without a number", Grade::Open);
const ANGLE: Citation = Citation::new("alarm 16830 of the 808D, p.245; MD30455 by a secondary page", Grade::Sister);
/// Override knobs of the machine control panels.
pub(super) const KNOB: Citation =
    Citation::new("840D sl basic functions 01/2015, p.1338 and 1666; panels by usage", Grade::Sister);
const LABELS: Citation = Citation::new("2 to 8 characters by usage of the 802D; 32 on larger controls", Grade::Open);
const ENDS: Citation = Citation::new("808D milling guide, p.79: M2 returns; M30 by usage", Grade::Open);
const LEVELS: Citation =
    Citation::new("808D milling guide, p.79, and 828D: 8; 808D diagnostics 07/2018, p.175: 16", Grade::Sister);
const JUMPS: Citation = Citation::new("alarm 14080 of the 808D, p.184: asks for a label, not a number", Grade::Sister);
const RANGE: Citation = Citation::new("R0 to R249 on 802S and 802C", Grade::Sister);

/// One row per switch; the first option is the default.
pub const SWITCHES: &[Switch] = &[
    switch(Diameter::of(&[Diameter::Diameter, Diameter::Radius]), MEMORY).parameter("MD20100"),
    switch(CommentCharacters::of(&[CommentCharacters::Ascii, CommentCharacters::Gbk, CommentCharacters::Utf8]), MEMORY),
    switch(StartupMotion::of(&[StartupMotion::G1, StartupMotion::G0]), MEMORY).label("switch.startup-motion-named"),
    switch(StartupFeed::of(&[StartupFeed::G95, StartupFeed::G94]), MEMORY),
    switch(StartupPath::of(&[StartupPath::G60, StartupPath::G64]), MEMORY),
    switch(SpeedReached::of(&[SpeedReached::Wait, SpeedReached::NoWait]), REACHED).parameter("MD35500"),
    switch(ManualS::of(&[ManualS::Refused, ManualS::Taken]), MEMORY),
    switch(M5Timing::of(&[M5Timing::Before, M5Timing::End]), MEMORY).label("switch.m5-timing-stops"),
    switch(LimitInG97::of(&[LimitInG97::No, LimitInG97::Yes]), MEMORY),
    switch(CrossedLimits::of(&[CrossedLimits::UpperHolds, CrossedLimits::LowerHolds]), ACTIVATION),
    switch(G96AtOnce::of(&[G96AtOnce::Yes, G96AtOnce::No]), ACTIVATION),
    switch(RapidLookAhead::of(&[RapidLookAhead::NextBlock, RapidLookAhead::NextMotion]), LOOK_AHEAD),
    switch(SurfaceSpeedInInch::of(&[SurfaceSpeedInInch::MetresPerMinute, SurfaceSpeedInInch::FeetPerMinute]), MEMORY),
    switch(SmallOffset::of(&[SmallOffset::Tenth, SmallOffset::Half, SmallOffset::Nothing]), SMALL),
    switch(FeedCodeWithoutS::of(&[FeedCodeWithoutS::LastProgrammed, FeedCodeWithoutS::Hold]), MEMORY),
    switch(SpindleKnob::of(&[SpindleKnob::From0To200, SpindleKnob::From50To120]), KNOB),
    switch(SposOutOfRange::of(&[SposOutOfRange::Alarm, SposOutOfRange::Modulo]), ANGLE).parameter("MD30455"),
    switch(SpindleLock::of(""), MEMORY),
    switch(DrivenTool::of(""), MEMORY),
    switch(RParameters::of(&[RParameters::All300, RParameters::All250]), RANGE).parameter("MD28050"),
    switch(EndInSubprogram::of(&[EndInSubprogram::Return, EndInSubprogram::EndProgram]), ENDS),
    switch(SubprogramLevels::of(&[SubprogramLevels::Eight, SubprogramLevels::Sixteen]), LEVELS),
    switch(RotaryAxes::of(""), MEMORY),
    switch(
        CoordinateRange::of(&[CoordinateRange::Program, CoordinateRange::Machine, CoordinateRange::NoAlarm]),
        MEMORY,
    ),
    switch(WorkingArea::of(&[WorkingArea::Limit, WorkingArea::NoLimit]), MEMORY).parameter("SD43400, SD43410"),
    switch(ReferencePoint::of(""), MEMORY),
    switch(FixedPoint::of(""), MEMORY),
    switch(LabelLength::of(&[LabelLength::Eight, LabelLength::ThirtyTwo]), LABELS),
    switch(BlockLength::of(&[BlockLength::Chars200, BlockLength::Chars512]), MEMORY),
    switch(BlockNumberJumps::of(&[BlockNumberJumps::No, BlockNumberJumps::Yes]), JUMPS),
];
