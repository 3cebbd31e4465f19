//! Parameters of the E60 that a machine has to set.

use super::sources::MEMORY;
use crate::controls::ParamDef;
use crate::controls::ParamRole::*;
use crate::controls::ParamUnit::*;
use crate::controls::params::param;
use crate::text::{Citation, Grade};

const HEADER: Citation = Citation::new("Mitsubishi Custom-API header, parameter table", Grade::Sister);
const NAME: Citation = Citation::new("name: Custom-API header; number by order, unverified", Grade::Open);
const M800: Citation = Citation::new("M800 parameter names and Custom-API header", Grade::Sister);
const ROLL_OVER: Citation = Citation::new("names: Custom-API header; effect on rotary axes unverified", Grade::Open);
pub(super) const SCALING: Citation =
    Citation::new("Custom-API header: PC1, PC2, PIT by name; numbers M800; formula inferred", Grade::Inferred);
const RESOLUTION: Citation =
    Citation::new("Custom-API header: RNG1, RNG2 by name; unit of older drives unverified", Grade::Open);
const DECIMALS: Citation = Citation::new("M700V/M70V programming manual, p.40", Grade::Sister);

/// One row per parameter, by number.
pub(super) const PARAMS: &[ParamDef] = &[
    param(CommandUnit, "#1015", "cunit", TenthMicrometre, "command unit: 10 is 0.001 mm", DECIMALS).answered("10", "1"),
    param(AxisRotary, "#1017", "rot", Plain, "1: rotary axis, in degrees", HEADER),
    param(
        SpindleCount,
        "#1039",
        "spinno",
        Plain,
        "number of spindles, 0: none",
        Citation::new("ribbon dot-printing paper, E60; Custom-API header", Grade::Manual),
    ),
    param(DecimalPoint, "#1078", "Decpt2", Plain, "word without a point: 0 in command units, 1 in mm", DECIMALS),
    param(FeedOneDigit, "#1079", "f1digt", Plain, "F1-digit feed; keep 0, or F0 is rapid traverse", HEADER),
    param(AxisShortWay, "#1089", "Cut_RT", Plain, "rotary axis, absolute words: 1 by the shorter way", ROLL_OVER),
    param(AxisRollOver, "#1090", "Lin_RT", Plain, "1: linear-type rotary axis, which counts past 360", ROLL_OVER)
        .answered("0", "1"),
    param(EditLock, "#1121", "edlk_c", Plain, "1: programs 9000 to 9999 cannot be edited; 0 to load O9100", HEADER),
    param(VariablesAtReset, "#1128", "RstVC1", Plain, "1: #100 and up become vacant at reset", HEADER),
    param(VariablesAtPowerOn, "#1129", "PwrVC1", Plain, "1: #100 and up become vacant at power-on", HEADER),
    param(
        ExactStopCheck,
        "#1193",
        "inpos",
        Plain,
        "check method of G09 and G61: deceleration time or in-position",
        Citation::new("M700V/M70V programming manual, p.143", Grade::Sister),
    ),
    param(AxisRapid, "#2001", "rapid", MmPerMinute, "rapid traverse", M800),
    param(AxisClamp, "#2002", "clamp", MmPerMinute, "cutting feed clamp; above it the whole vector is slowed", M800),
    param(
        AxisAcceleration,
        "#2003",
        "smgst",
        Hexadecimal,
        "acceleration; high digit cutting, low digit rapid: 0 step, 1 linear, 2 primary delay, F soft",
        Citation::new("types: Custom-API header; digits unverified", Grade::Open),
    )
    .answered("11", "22"),
    param(
        RapidTimeConstant,
        "#2004",
        "G0tL",
        Milliseconds,
        "time constant of linear acceleration, rapid traverse",
        HEADER,
    ),
    param(
        AxisTimeConstant,
        "#2007",
        "G1tL",
        Milliseconds,
        "time constant of linear acceleration, cutting feed",
        HEADER,
    ),
    param(
        AxisSoftLimits,
        "#2013/#2014",
        "OT-/OT+",
        Mm,
        "soft limits; both equal: none",
        Citation::new("names: Custom-API header; \"equal: none\" unverified", Grade::Open),
    )
    .answered("", "0 / 0"),
    param(AxisInPosition, "#2078", "G1inps", Mm, "in-position width, cutting feed", HEADER),
    param(LoadTurns, "#2201", "PC1", Plain, "gear: turns of screw or roller for those of #2202", SCALING),
    param(MotorTurns, "#2202", "PC2", Plain, "gear: turns of the motor for those of #2201", SCALING),
    param(AxisPositionGain, "#2203", "PGN1", PerSecond, "position loop gain", MEMORY),
    param(WholeLead, "#2218", "PIT", Mm, "travel per turn of screw or roller; rotary axis: 360", SCALING),
    param(EncoderCounts, "#2219", "RNG1", KilopulsesPerTurn, "resolution of the position detector", RESOLUTION),
    param(EncoderCounts, "#2220", "RNG2", KilopulsesPerTurn, "resolution of the speed detector", RESOLUTION),
    param(
        SpindleLimit,
        "#3001",
        "slimt1",
        TurnsPerMinute,
        "spindle speed at 10 V, gear 00 (the paper prints it as #1001)",
        Citation::new("Custom-API header and M800 names; 10 V by the paper", Grade::Sister),
    ),
    param(SpindleGear(2), "#3002", "slimt2", TurnsPerMinute, "spindle speed at 10 V, gear 01", HEADER),
    param(SpindleGear(3), "#3003", "slimt3", TurnsPerMinute, "spindle speed at 10 V, gear 10", HEADER),
    param(SpindleGear(4), "#3004", "slimt4", TurnsPerMinute, "spindle speed at 10 V, gear 11", HEADER),
    param(
        SpindleGearMaximum(1),
        "#3005",
        "smax1",
        TurnsPerMinute,
        "spindle speed clamp, gear 00; at most slimt1",
        NAME,
    ),
    param(SpindleGearMaximum(2), "#3006", "smax2", TurnsPerMinute, "spindle speed clamp, gear 01", HEADER),
    param(SpindleGearMaximum(3), "#3007", "smax3", TurnsPerMinute, "spindle speed clamp, gear 10", HEADER),
    param(SpindleGearMaximum(4), "#3008", "smax4", TurnsPerMinute, "spindle speed clamp, gear 11", HEADER),
    param(SpindleMinimum, "#3023", "smini", TurnsPerMinute, "smallest spindle speed", NAME),
    param(
        SpindleConnection,
        "#3024",
        "sout",
        Plain,
        "spindle connection: 0 none, 1 bus, 2 to 5 analog (the paper prints it as #1024)",
        Citation::new("name: Custom-API header; number and values unverified", Grade::Open),
    )
    .answered("2", "1"),
    param(SpindleEncoder, "#3025", "enc-on", Plain, "1: spindle encoder fitted", NAME),
    param(
        MacroSingle,
        "#8101",
        "MACRO SINGLE",
        Plain,
        "1: macro blocks stop in single block",
        Citation::new("number: Custom-API header; meaning of 0 and 1 unverified", Grade::Open),
    ),
    param(EditLock, "#8105", "EDIT LOCK B", Plain, "1: programs 8000 to 9999 cannot be edited", HEADER),
];
