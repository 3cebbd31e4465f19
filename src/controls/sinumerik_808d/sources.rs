//! Sources that rows of the 808D share.

use crate::text::{Citation, Grade};

/// The list of alarms.
pub(super) const DIAGNOSTICS: Citation = Citation::new("808D diagnostics 07/2018", Grade::Manual);
/// Ranges of F, surface speed and LIMS, depth of calls; the ranges of S, T and leads are from memory.
pub(super) const RANGES: Citation =
    Citation::new("808D diagnostics, p.175, 216 and 217 (depth, F, S, LIMS); S, T and leads unverified", Grade::Manual);
