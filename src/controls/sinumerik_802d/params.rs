//! Machine and setting data of the 802D that a machine has to set.

use crate::controls::ParamDef;
use crate::controls::ParamRole::*;
use crate::controls::params::param;
use crate::text::{Citation, Grade};

const SPINDLE: Citation = Citation::new("808D function manual 01/2017, p.168", Grade::Sister);
const TRANSVERSE: Citation = Citation::new("alarm 10870 of the 840D sl, function manual 08/2005, p.2-9", Grade::Sister);
const VELOCITY: Citation = Citation::new("alarm 22270 of the 828D, p.338", Grade::Sister);
const ENCODER: Citation = Citation::new("alarm 16770 of the 808D, p.243", Grade::Sister);
const OUTPUT: Citation = Citation::new("start-up of Siemens controls, unverified", Grade::Open);

/// One row per parameter, by number.
pub(in super::super) const PARAMS: &[ParamDef] = &[
    param(AxisDiameter, "MD20100", "DIAMETER_AX_DEF", "", "transverse axis, for diameters and G96", TRANSVERSE)
        .answered("X", ""),
    param(SpindleConnection, "MD30130", "CTRLOUT_TYPE", "", "0 simulation, 1 output to the drive", OUTPUT),
    param(SpindleEncoder, "MD30200", "NUM_ENCS", "", "measuring systems of the spindle", ENCODER),
    param(AxisClamp, "MD32000", "MAX_AX_VELO", "mm/min", "largest axis velocity", VELOCITY),
    param(AxisPositionGain, "MD32200", "POSCTRL_GAIN", "1000/min", "servo gain", OUTPUT),
    param(SpindleLimit, "MD32260", "RATED_VELO", "r/min", "motor speed at the output of MD32250", OUTPUT),
    param(SpindleMaximum, "MD35100", "SPIND_VELO_LIMIT", "r/min", "largest spindle speed, of the chuck", SPINDLE),
    param(SpindleMinimum, "MD35140", "GEAR_STEP_MIN_VELO_LIMIT", "r/min", "least spindle speed of a gear", SPINDLE),
];
