//! Sentences about time, axes, spindle, panel.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[];
