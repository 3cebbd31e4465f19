//! Sentences about the page.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[];
