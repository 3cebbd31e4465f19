//! Parameters of the FANUC family that a machine has to set.

use super::sources::{CMR, CODER, COMMANDS, MEMORY, ROLL_OVER, SPEED_REACHED};
use crate::controls::ParamDef;
use crate::controls::ParamRole::*;
use crate::controls::ParamUnit::*;
use crate::controls::params::param;
use crate::controls::schema::table::without;

/// Parameters of a lathe, by number.
pub const LATHE: &[ParamDef] = &[
    param(AxisRotary, "1006#0", "ROT", Plain, "1: rotary axis, in degrees", MEMORY),
    param(AxisDiameter, "1006#3", "DIA", Plain, "1: words of the axis count diameters", MEMORY),
    param(AxisRollOver, "1008#0", "ROA", Plain, "1: coordinates of a rotary axis roll over: it is endless", ROLL_OVER),
    param(AxisShortWay, "1008#1", "RAB", Plain, "absolute words: 0 by the shorter way, 1 by their sign", ROLL_OVER)
        .answered("0", "1"),
    param(AxisRollDisplay, "1008#2", "RRL", Plain, "1: relative coordinates roll over, too", ROLL_OVER),
    param(AxisTurn, "1260", "", ThousandthMm, "travel of a rotary axis per turn", ROLL_OVER),
    param(AxisSoftLimits, "1320/1321", "", ThousandthMm, "soft limits 1, machine coordinates", MEMORY).answered("", ""),
    param(AxisRapid, "1420", "", MmPerMinute, "rapid traverse", MEMORY),
    param(PathClamp, "1422", "", MmPerMinute, "upper limit of the cutting feed along the path", MEMORY),
    param(AxisClamp, "1430", "", MmPerMinute, "upper limit of the cutting feed of an axis", MEMORY),
    param(ExactStopCheck, "1601#5", "NCI", Plain, "0: in-position check at deceleration, 1: none", MEMORY),
    param(AxisAcceleration, "1610#0", "CTL", Plain, "acceleration of cutting feed: 0 exponential, 1 linear", MEMORY),
    param(RapidTimeConstant, "1620", "", Milliseconds, "time constant of acceleration, rapid traverse", MEMORY)
        .within(0.0, 4000.0),
    param(AxisTimeConstant, "1622", "", Milliseconds, "time constant of acceleration, cutting feed", MEMORY)
        .within(0.0, 4000.0),
    param(CommandMultiplier, "1820", "CMR", Plain, "command to detection units: 2 is 1, 102 is 1/2 (diameters)", CMR),
    param(ReferenceCounts, "1821", "", Plain, "reference counter: detection units per turn of the motor", MEMORY),
    param(AxisPositionGain, "1825", "", HundredthPerSecond, "servo loop gain", MEMORY),
    param(AxisInPosition, "1826", "", ThousandthMm, "in-position width", MEMORY),
    param(
        FeedGearOver,
        "2084",
        "N",
        Plain,
        "flexible feed gear, numerator: detection units per turn of the motor",
        MEMORY,
    ),
    param(FeedGearUnder, "2085", "M", Plain, "its denominator: 1 000 000 counts, both in lowest terms", MEMORY),
    param(
        ReferenceCountsUnder,
        "2179",
        "",
        Plain,
        "denominator of the reference counter, where it is no whole number",
        MEMORY,
    ),
    param(EditLock, "3202#4", "NE9", Plain, "1: programs 9000 to 9999 cannot be edited", MEMORY),
    param(DecimalPoint, "3401#0", "DPI", Plain, "word without a point: 0 in command units, 1 in mm", MEMORY),
    param(
        SpindleConnection,
        "3701#1",
        "ISI",
        Plain,
        "0: serial spindle, 1: analog; or 3716#0, where 0 is analog",
        MEMORY,
    ),
    param(ShiftBySignal, "3705#1", "GST", Plain, "1: SOR turns the spindle at the speed of a gear change", MEMORY),
    param(SpindleEncoderLow, "3706#0", "PG1", Plain, "turns of the spindle per turn of its encoder, low bit", CODER),
    param(
        SpindleEncoderHigh,
        "3706#1",
        "PG2",
        Plain,
        "high bit: 00 one turn, 01 two, 10 four, 11 eight; an encoder of 1024 lines",
        CODER,
    ),
    param(SpindleReached, "3708#0", "SAR", Plain, "1: cuts wait for the signal of reached speed", SPEED_REACHED),
    param(SpindleOffsetRated, "3730", "", TenthPercent, "gain of the analog output", MEMORY),
    param(SpindleOffsetZero, "3731", "", Plain, "offset of the analog output", MEMORY),
    param(SpindleShiftCode, "3732", "", Plain, "output at SOR, of 4095 at 10 V", MEMORY),
    param(
        SpindleReachedDelay,
        "3740",
        "",
        Milliseconds,
        "delay until the signal of reached speed is looked at",
        SPEED_REACHED,
    ),
    param(SpindleLimit, "3741", "", TurnsPerMinute, "spindle speed at 10 V, gear 1", COMMANDS),
    param(SpindleGear(2), "3742", "", TurnsPerMinute, "spindle speed at 10 V, gear 2", COMMANDS),
    param(SpindleGear(3), "3743", "", TurnsPerMinute, "spindle speed at 10 V, gear 3", COMMANDS),
    param(SpindleGear(4), "3744", "", TurnsPerMinute, "spindle speed at 10 V, gear 4", COMMANDS),
    param(SpindleMinimum, "3771", "", TurnsPerMinute, "smallest spindle speed at constant surface speed", MEMORY),
    param(SpindleMaximum, "3772", "", TurnsPerMinute, "spindle speed clamp, 0: none", MEMORY),
    param(SpindleEncoder, "4002#1", "", Plain, "1: encoder of a serial spindle fitted; an analog one has none", MEMORY),
    param(MacroSingle, "6000#5", "SBM", Plain, "1: macro blocks stop in single block", MEMORY),
    param(VariablesAtReset, "6001#6", "CCV", Plain, "0: #100 to #199 become vacant at reset", MEMORY)
        .answered("0", "1"),
];

/// Parameters of a mill: the parameters of a lathe without the one for diameter words.
pub const MILL: &[ParamDef] = without![ParamDef: LATHE, "1006#3"];
