//! Parameters of the 980TDc that a machine has to set.

use super::{PARAMETERS, SPINDLE};
use crate::controls::ParamDef;
use crate::controls::ParamRole::*;
use crate::controls::params::param;

/// One row per parameter, by number.
pub(super) const PARAMS: &[ParamDef] = &[
    param(SpindleConnection, "No.001#4", "", "", "1: analog voltage, 0: gears by contacts", PARAMETERS),
    param(AxisRapid, "No.022", "", "mm/min", "rapid traverse", PARAMETERS),
    param(AxisClamp, "No.027", "", "mm/min", "upper limit of the cutting feed", PARAMETERS),
    param(AxisTimeConstant, "No.029", "", "ms", "time constant of acceleration, cutting feed", PARAMETERS),
    param(SpindleLimit, "No.037", "", "r/min", "spindle speed at 10 V, gear 1", SPINDLE),
];
