//! Sources that several files of the polygon lathe cite.

use crate::text::{Citation, Grade};

/// The paper on polygon turning.
pub(super) const PAPER: Citation = Citation::new("polygon turning paper", Grade::Manual);

/// A choice of macroline where the paper is silent.
pub(super) const OURS: Citation = Citation::new("our own choice: the paper is silent", Grade::Open);

/// The run-in that a thread needs in front of it.
pub(super) const RUN_IN: Citation = Citation::new("polygon turning facts 3.10", Grade::Inferred);

/// The run-out that a thread needs in front of a shoulder.
pub(super) const RUN_OUT: Citation = Citation::new("polygon turning facts 3.10; DIN 76-1 from memory", Grade::Open);
