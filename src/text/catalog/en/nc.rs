//! Sentences about the language: reading and writing programs.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[];
