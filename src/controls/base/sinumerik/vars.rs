//! Variables of the SINUMERIK family: its R parameters.

use crate::controls::VarKind::Retained;
use crate::controls::VarRange;
use crate::controls::vars::range;
use crate::text::{Citation, Grade};

/// The 802S and 802C have R0 to R249.
const RANGE: Citation =
    Citation::new("R0 to R299 by a secondary page on Siemens controls; see the switch", Grade::Open);

/// Every range; a number in none of them does not exist.
pub const VARS: &[VarRange] = &[range(0, 299, Retained, "", "arithmetic parameters, kept, 0 until set", RANGE)];
