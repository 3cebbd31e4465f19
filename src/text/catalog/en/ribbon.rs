//! Sentences about the ribbon line.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[];
