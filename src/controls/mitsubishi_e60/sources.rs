//! Sources that rows of the E60 share.

use crate::text::{Citation, Grade};

/// MELDAS manuals from memory, without a document.
pub(super) const MEMORY: Citation = Citation::new("MELDAS M-type usage, unverified", Grade::Open);
/// The published paper about the ribbon line, which has an E60.
pub(super) const PAPER: Citation = Citation::new("ribbon dot-printing paper, E60", Grade::Manual);
