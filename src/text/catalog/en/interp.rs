//! Sentences about running a program.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[];
