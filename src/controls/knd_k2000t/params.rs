//! Parameters of the K2000T that a machine has to set.

use super::MEMORY;
use crate::controls::ParamDef;
use crate::controls::ParamRole::*;
use crate::controls::params::param;

/// One row per parameter, by number.
pub(super) const PARAMS: &[ParamDef] = &[
    param(AxisRapid, "1420", "", "mm/min", "rapid traverse", MEMORY),
    param(AxisClamp, "1422", "", "mm/min", "upper limit of the cutting feed", MEMORY),
    param(AxisTimeConstant, "1622", "", "ms", "time constant of acceleration, cutting feed", MEMORY),
    param(SpindleLimit, "3741", "", "r/min", "spindle speed at 10 V, gear 1", MEMORY),
];
