//! Machine and setting data of the SINUMERIK family that a machine has to set.

use crate::controls::ParamDef;
use crate::controls::ParamRole::*;
use crate::controls::ParamUnit::*;
use crate::controls::params::param;
use crate::text::{Citation, Grade};

const SPINDLE: Citation = Citation::new("808D function manual 01/2017, p.168", Grade::Sister);
const TRANSVERSE: Citation = Citation::new("alarm 10870 of the 840D sl, function manual 08/2005, p.2-9", Grade::Sister);
const VELOCITY: Citation = Citation::new("alarm 22270 of the 828D, p.338", Grade::Sister);
const ENCODER: Citation = Citation::new("alarm 16770 of the 808D, p.243", Grade::Sister);
const MODULO: Citation = Citation::new("808D parameter manual, p.225 and 227: modulo axes", Grade::Sister);
pub(super) const SCALING: Citation =
    Citation::new("840D sl basic functions 01/2015, p.349: encoder, lead and gear", Grade::Sister);
const CODED: Citation =
    Citation::new("840D sl basic functions 01/2015, p.1338: MD12060, binary or Gray code", Grade::Sister);
const OUTPUT: Citation = Citation::new("start-up of Siemens controls, unverified", Grade::Open);

const GEARS: Citation = Citation::new("802S start-up, p.4-48", Grade::Sister);
const TOLERANCE: Citation = Citation::new("840D sl axes and spindles 06/2019, p.828", Grade::Sister);
const ANGLE: Citation = Citation::new("840D sl axes and spindles 06/2019, p.754", Grade::Sister);

/// One row per parameter, by number.
pub const PARAMS: &[ParamDef] = &[
    param(
        OverrideIsCoded,
        "MD12060",
        "OVR_SPIND_IS_GRAY_CODE",
        Plain,
        "0: the byte of the spindle override is a number of percent, as the ladder writes it; 1: Gray code",
        CODED,
    ),
    param(AxisDiameter, "MD20100", "DIAMETER_AX_DEF", Plain, "transverse axis, for diameters and G96", TRANSVERSE)
        .answered("X", ""),
    param(SpindleConnection, "MD30130", "CTRLOUT_TYPE", Plain, "0 simulation, 1 output to the drive", OUTPUT),
    param(SpindleEncoder, "MD30200", "NUM_ENCS", Plain, "measuring systems of the spindle", ENCODER),
    param(SpindleUnipolar, "MD30134", "IS_UNIPOLAR_OUTPUT", Plain, "0: -10 to 10 V, 1: 0 to 10 V", OUTPUT),
    param(
        AxisRotary,
        "MD30300",
        "IS_ROT_AX",
        Plain,
        "1: rotary axis, in degrees; no geometry axis (alarm 4200)",
        MODULO,
    ),
    param(AxisRollOver, "MD30310", "ROT_IS_MODULO", Plain, "1: modulo axis, endless, without software limits", MODULO),
    param(AxisRollDisplay, "MD30320", "DISPLAY_IS_MODULO", Plain, "1: its display begins anew with each turn", MODULO),
    param(AxisTurn, "MD30330", "MODULO_RANGE", Degrees, "size of a turn of a modulo axis", MODULO),
    param(EncoderCounts, "MD31020", "ENC_RESOL", PulsesPerTurn, "marks of the encoder per turn of the motor", SCALING),
    param(SpindleEncoderLines, "MD31020", "ENC_RESOL", Plain, "lines of the spindle encoder per turn", SCALING),
    param(Lead, "MD31030", "LEADSCREW_PITCH", Mm, "travel per turn of screw or roller; linear axes", SCALING),
    param(SpindleEncoderDirect, "MD31040", "ENC_IS_DIRECT", Plain, "1: the encoder is beside the spindle", SCALING),
    param(LoadTurns, "MD31050", "DRIVE_AX_RATIO_DENOM", Plain, "gear of an axis: turns of screw or roller", SCALING),
    param(SpindleRatioSpindle, "MD31050", "DRIVE_AX_RATIO_DENOM", Plain, "turns of the spindle, by gear stage", GEARS),
    param(MotorTurns, "MD31060", "DRIVE_AX_RATIO_NUMERA", Plain, "gear of an axis: turns of the motor", SCALING),
    param(SpindleRatioMotor, "MD31060", "DRIVE_AX_RATIO_NUMERA", Plain, "turns of the motor, by gear stage", GEARS),
    param(SpindleEncoderTurns, "MD31070", "DRIVE_ENC_RATIO_DENOM", Plain, "turns of the spindle encoder", SCALING),
    param(
        SpindleEncoderSpindleTurns,
        "MD31080",
        "DRIVE_ENC_RATIO_NUMERA",
        Plain,
        "turns of the spindle meanwhile, with MD31040 = 1",
        SCALING,
    ),
    param(
        AxisRapid,
        "MD32000",
        "MAX_AX_VELO",
        MmOrTurnsPerMinute,
        "largest axis velocity, in cutting feed, too",
        VELOCITY,
    ),
    param(AxisPositionGain, "MD32200", "POSCTRL_GAIN", ThousandPerMinute, "servo gain", OUTPUT),
    param(SpindleRatedVolts, "MD32250", "RATED_OUTVAL", Percent, "part of 10 V at the motor speed of MD32260", OUTPUT),
    param(SpindleLimit, "MD32260", "RATED_VELO", TurnsPerMinute, "motor speed at the output of MD32250", OUTPUT),
    param(
        AxisGreatestAcceleration,
        "MD32300",
        "MAX_AX_ACCEL",
        MetresPerSecondSquared,
        "acceleration of the axis: greatest of rapid traverse and feed by time constant",
        OUTPUT,
    ),
    param(
        GearShift,
        "MD35010",
        "GEAR_STEP_CHANGE_ENABLE",
        Plain,
        "1: gear stages are changed; at 0 only the first one counts",
        OUTPUT,
    ),
    param(
        SpindleMaximum,
        "MD35100",
        "SPIND_VELO_LIMIT",
        TurnsPerMinute,
        "largest spindle speed, of the chuck",
        SPINDLE,
    ),
    param(
        SpindleStageMaximum,
        "MD35130",
        "GEAR_STEP_MAX_VELO_LIMIT",
        TurnsPerMinute,
        "largest spindle speed, by gear stage",
        SPINDLE,
    ),
    param(
        SpindleMinimum,
        "MD35140",
        "GEAR_STEP_MIN_VELO_LIMIT",
        TurnsPerMinute,
        "least spindle speed, by gear stage",
        SPINDLE,
    ),
    param(
        SpindleTolerance,
        "MD35150",
        "SPIND_DES_VELO_TOL",
        Plain,
        "part of the speed that counts as reached",
        TOLERANCE,
    ),
    param(
        PositioningAcceleration,
        "MD35210",
        "GEAR_STEP_POSCTRL_ACCEL",
        TurnsPerSecondSquared,
        "acceleration to an angle",
        ANGLE,
    ),
    param(PositioningSpeed, "MD35300", "SPIND_POSCTRL_VELO", TurnsPerMinute, "speed to an angle (SPOS)", ANGLE),
    param(
        PositioningClockwise,
        "MD35350",
        "SPIND_POSITIONING_DIR",
        Plain,
        "first way to the zero mark: 3 as M3, 4 as M4",
        OUTPUT,
    )
    .answered("3", "4"),
    param(
        MotorShiftSpeed,
        "MD35400",
        "SPIND_OSCILL_DES_VELO",
        TurnsPerMinute,
        "motor speed while gears are shifted",
        OUTPUT,
    ),
    param(SpindleReached, "MD35500", "SPIND_ON_SPEED_AT_IPO_START", Plain, "1: cuts wait for the speed", TOLERANCE),
    param(SpindleLowerSet, "SD43210", "SPIND_MIN_VELO_G25", TurnsPerMinute, "lower limit, overwritten by G25", OUTPUT),
    param(SpindleUpperSet, "SD43220", "SPIND_MAX_VELO_G26", TurnsPerMinute, "upper limit, overwritten by G26", OUTPUT),
    param(
        SpindleSurfaceLimit,
        "SD43230",
        "SPIND_MAX_VELO_LIMS",
        TurnsPerMinute,
        "upper limit at G96, overwritten by LIMS",
        OUTPUT,
    ),
];
