//! Parameters of the 980TDc that a machine has to set.

use super::sources::{AXES, PARAMETERS, SPINDLE};
use crate::controls::ParamDef;
use crate::controls::ParamRole::*;
use crate::controls::ParamUnit::*;
use crate::controls::params::param;
use crate::text::{Citation, Grade};

const RANGES: Citation = Citation::new("GSK980TDi parameter list; range GSK980MDi manual, p.374", Grade::Sister);

pub(super) const SCALING: Citation = Citation::new("GSK980MDi manual, p.385, 401 and 402: CMR and CMD", Grade::Sister);

const PLC_DATA: Citation = Citation::new("GSK980TDi PLC data list; bits counted from 0", Grade::Sister);

const RESET: Citation = Citation::new("GSK980MDi manual, p.457, 469 and 481: K10.RESB; its bit is open", Grade::Sister);

/// One row per parameter, by number.
pub(super) const PARAMS: &[ParamDef] = &[
    param(CommandUnit, "No.001#1", "", Plain, "0: 0.001 mm (IS-B), 1: 0.0001 mm (IS-C)", PARAMETERS).answered("0", "1"),
    param(AxisDiameter, "No.001#2", "", Plain, "words of X: 0 diameters, 1 radii", PARAMETERS).answered("0", "1"),
    param(SpindleConnection, "No.001#4", "", Plain, "1: analog voltage, 0: gears by contacts", PARAMETERS),
    param(RewindAtEnd, "No.005#4", "", Plain, "M30: 1 goes back to the first block, 0 stays at the end", PARAMETERS),
    param(
        ExactStopCheck,
        "No.007#6",
        "",
        Plain,
        "0: smooth from block to block, 1: each block ends in position",
        PARAMETERS,
    ),
    param(CountsOver, "No.015", "CMR", Plain, "numerator: counts of the encoder per turn of the motor", SCALING),
    param(
        CountsUnder,
        "No.016",
        "CMD",
        Plain,
        "denominator: output units of 0.001 mm per turn (X by diameters: 0.0005 mm), both in lowest terms",
        SCALING,
    ),
    param(
        SpindleOffsetRated,
        "No.021",
        "",
        Millivolts,
        "offset of the analog output at its highest speed (10 V)",
        PARAMETERS,
    ),
    param(AxisRapid, "No.022", "", MmPerMinute, "rapid traverse", RANGES),
    param(AxisClamp, "No.027", "", MmPerMinute, "upper limit of the cutting feed; of X as diameter", RANGES)
        .in_diameters(),
    param(
        AxisTimeConstant,
        "No.029",
        "",
        Milliseconds,
        "time constant of acceleration, cutting feed, 10 to 4000",
        RANGES,
    )
    .within(10.0, 4000.0),
    param(
        SpindleOffsetZero,
        "No.036",
        "",
        Millivolts,
        "offset of the analog output at speed 0 (the manual's \"10 V\" is a slip)",
        PARAMETERS,
    ),
    param(SpindleLimit, "No.037", "", TurnsPerMinute, "spindle speed at 10 V, gear 1", SPINDLE),
    param(SpindleGear(2), "No.038", "", TurnsPerMinute, "spindle speed at 10 V, gear 2", SPINDLE),
    param(SpindleGear(3), "No.039", "", TurnsPerMinute, "spindle speed at 10 V, gear 3", SPINDLE),
    param(SpindleGear(4), "No.040", "", TurnsPerMinute, "spindle speed at 10 V, gear 4", SPINDLE),
    param(SpindleMinimum, "No.043", "", TurnsPerMinute, "smallest spindle speed at constant surface speed", PARAMETERS),
    param(AxisSoftLimits, "No.045/046", "", ThousandthMm, "soft limits 1, machine coordinates", PARAMETERS)
        .answered("", ""),
    param(SpindleShiftVolts, "No.067", "", Millivolts, "analog output while gears are shifted", PARAMETERS),
    param(SpindleEncoder, "No.069", "", Plain, "1: spindle encoder fitted", PARAMETERS),
    param(SpindleEncoderLines, "No.070", "", Plain, "lines of the spindle encoder, 100 to 10000", PARAMETERS)
        .within(100.0, 10_000.0),
    param(
        SpindleReachedDelay,
        "No.072",
        "",
        Milliseconds,
        "delay until the signal of reached speed is looked at",
        PARAMETERS,
    ),
    param(SpindleMaximum, "No.075", "", TurnsPerMinute, "spindle speed clamp, 0: none", PARAMETERS),
    param(SpindleReached, "No.175#6", "", Plain, "1: cuts wait for the signal of reached speed", PARAMETERS),
    param(AxisRotary, "No.187#0", "", Plain, "kind of the additional axes: 00 linear, 01 and 11 rotary, 10 none", AXES)
        .answered("01", "00"),
    param(SpindleCount, "No.196#4", "", Plain, "1: several spindles", PARAMETERS).answered("0", "1"),
    param(AxisInPosition, "No.248", "", Pulses, "in-position width", PARAMETERS),
    param(AxisAcceleration, "No.252", "", Plain, "acceleration of cutting feed: 0 linear, 1 S-shaped", PARAMETERS)
        .answered("0", "1"),
    param(
        TurnsThroughReset,
        "K10.1",
        "",
        Plain,
        "1: the spindle turns on through reset; for the maker's own ladder",
        PLC_DATA,
    ),
    param(
        RewindAtReset,
        "K10 RESB",
        "",
        Plain,
        "reset: 1 goes back to the first block, 0 stays in the program; for the maker's own ladder",
        RESET,
    ),
    param(GearShift, "K15.0", "", Plain, "1: gears are shifted by M41 to M44; for the maker's own ladder", PLC_DATA),
    param(
        StopLast,
        "K16.5",
        "",
        Plain,
        "M05 beside a motion: 0 at its end, 1 at once; for the maker's own ladder",
        PLC_DATA,
    )
    .answered("0", "1"),
    param(
        VoltsOffAtStop,
        "K17.3",
        "",
        Plain,
        "analog output at M05: 0 kept, 1 off; for the maker's own ladder",
        PLC_DATA,
    ),
    param(
        GearShiftBefore,
        "DT000",
        "",
        Milliseconds,
        "delay until the old gear goes out; for the maker's own ladder",
        PLC_DATA,
    ),
    param(GearShiftAfter, "DT001", "", Milliseconds, "delay behind the new gear; for the maker's own ladder", PLC_DATA),
];
