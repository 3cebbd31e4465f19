//! Parameters of the K2000T that a machine has to set, in the numbers of FANUC.

use super::MEMORY;
use crate::controls::ParamDef;
use crate::controls::ParamRole::*;
use crate::controls::params::param;

/// One row per parameter, by number.
pub(super) const PARAMS: &[ParamDef] = &[
    param(AxisRotary, "1006#0", "ROT", "", "1: rotary axis, in degrees", MEMORY),
    param(AxisDiameter, "1006#3", "DIA", "", "1: words of the axis count diameters", MEMORY),
    param(AxisSoftLimits, "1320/1321", "", "0.001 mm", "soft limits 1, machine coordinates", MEMORY).answered("", ""),
    param(AxisRapid, "1420", "", "mm/min", "rapid traverse", MEMORY),
    param(AxisClamp, "1422", "", "mm/min", "upper limit of the cutting feed", MEMORY),
    param(ExactStopCheck, "1601#5", "NCI", "", "0: in-position check at deceleration, 1: none", MEMORY),
    param(AxisAcceleration, "1610#0", "CTL", "", "acceleration of cutting feed: 0 exponential, 1 linear", MEMORY),
    param(AxisTimeConstant, "1622", "", "ms", "time constant of acceleration, cutting feed", MEMORY),
    param(AxisPositionGain, "1825", "", "0.01/s", "servo loop gain", MEMORY),
    param(AxisInPosition, "1826", "", "0.001 mm", "in-position width", MEMORY),
    param(EditLock, "3202#4", "NE9", "", "1: programs 9000 to 9999 cannot be edited; 0 to load O9120", MEMORY),
    param(DecimalPoint, "3401#0", "DPI", "", "word without a point: 0 in command units, 1 in mm", MEMORY),
    param(SpindleConnection, "3701#1", "ISI", "", "0: serial spindle, 1: analog", MEMORY),
    param(SpindleReached, "3708#0", "SAR", "", "1: cuts wait for the signal of reached speed", MEMORY),
    param(SpindleOffsetRated, "3730", "", "0.1 %", "gain of the analog output", MEMORY),
    param(SpindleOffsetZero, "3731", "", "", "offset of the analog output", MEMORY),
    param(SpindleReachedDelay, "3740", "", "ms", "delay until the signal of reached speed is looked at", MEMORY),
    param(SpindleLimit, "3741", "", "r/min", "spindle speed at 10 V, gear 1", MEMORY),
    param(SpindleGear(2), "3742", "", "r/min", "spindle speed at 10 V, gear 2", MEMORY),
    param(SpindleGear(3), "3743", "", "r/min", "spindle speed at 10 V, gear 3", MEMORY),
    param(SpindleGear(4), "3744", "", "r/min", "spindle speed at 10 V, gear 4", MEMORY),
    param(SpindleMinimum, "3771", "", "r/min", "smallest spindle speed at constant surface speed", MEMORY),
    param(SpindleMaximum, "3772", "", "r/min", "spindle speed clamp, 0: none", MEMORY),
    param(SpindleEncoder, "4002#1", "", "", "1: spindle encoder fitted", MEMORY),
    param(MacroSingle, "6000#5", "SBM", "", "1: macro blocks stop in single block", MEMORY),
    param(VariablesAtReset, "6001#6", "CCV", "", "0: #100 to #199 become vacant at reset", MEMORY).answered("0", "1"),
];
