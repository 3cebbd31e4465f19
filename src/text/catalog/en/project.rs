//! Sentences about files, links, the command line.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[];
