//! Sources that rows of the K2000T share.

use crate::text::{Citation, Grade};

/// The published paper about the polygon lathe, on this very control.
pub(super) const PAPER: Citation = Citation::new("polygon turning paper, K2000T", Grade::Manual);
