//! Sources that rows of the SINUMERIK family share.

use crate::text::{Citation, Grade};

/// Arithmetic: operators, their order, equality.
pub const ARITHMETIC: Citation = Citation::new("840D sl NC programming 12/2019, p.392 and 444", Grade::Sister);
/// Memory of Siemens controls without any document.
pub const MEMORY: Citation = Citation::new("usage of Siemens controls, unverified", Grade::Open);
