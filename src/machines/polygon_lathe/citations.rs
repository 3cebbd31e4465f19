//! Sources that several files of the polygon lathe cite.

use crate::text::{Citation, Grade};

/// The paper on polygon turning.
pub(super) const PAPER: Citation = Citation::new("polygon turning paper", Grade::Manual);

/// A choice of macroline where the paper is silent.
pub(super) const OURS: Citation = Citation::new("our own choice: the paper is silent", Grade::Open);
