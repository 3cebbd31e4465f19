//! Sources that rows of the 802D share.

use crate::text::{Citation, Grade};

/// The page about S, M3, G25, SPOS and G96 in the 802D's own manual.
pub(super) const SPINDLE: Citation =
    Citation::new("SINUMERIK 802D spindle commands, Shenyang No. 1 Machine Tool, 2010", Grade::Manual);
/// Block layout, words, comments, block skip.
pub(super) const BLOCKS: Citation = Citation::new("802D turning BP-D 08/2005, p.133", Grade::Manual);
/// Words, ranges, one G code per group.
pub(super) const WORDS: Citation =
    Citation::new("802D sl BP-N 06/2006, p.8-122 and 8-126; grinding 07/2009, p.225", Grade::Manual);
/// Ranges of words; the ranges of T and of leads are from memory.
pub(super) const RANGES: Citation = Citation::new(
    "802D sl BP-N 06/2006, p.8-126 (F, D); 808D diagnostics, p.217 (S, LIMS); S, T and leads unverified",
    Grade::Manual,
);
