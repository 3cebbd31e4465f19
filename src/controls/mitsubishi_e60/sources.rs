//! Sources that rows of the E60 share.

use crate::text::{Citation, Grade};

/// Nothing but memory of the MELDAS manuals.
pub(super) const MEMORY: Citation = Citation::new("MELDAS M-type usage, unverified", Grade::Open);
/// The published paper about the ribbon line, on this very control.
pub(super) const PAPER: Citation = Citation::new("ribbon dot-printing paper, E60", Grade::Manual);
