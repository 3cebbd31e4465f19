//! Sources of facts, with their grade of evidence.

use serde::Serialize;

use super::{Phrase, catalog};

/// How well a fact is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Grade {
    /// The manual of this very control, or the published paper about this machine.
    Manual,
    /// The manual of a sister control of the same maker.
    Sister,
    /// Measured on a machine.
    Measured,
    /// Derived from other facts, or from a secondary source.
    Inferred,
    /// Known from memory or not at all: shown to the user as open.
    Open,
}

impl Grade {
    /// In the language that is spoken.
    pub fn words(self) -> &'static str {
        match self {
            Grade::Manual => catalog::words("page.grade-manual"),
            Grade::Sister => catalog::words("page.grade-sister"),
            Grade::Measured => catalog::words("page.grade-measured"),
            Grade::Inferred => catalog::words("page.grade-inferred"),
            Grade::Open => catalog::words("page.grade-open"),
        }
    }
}

/// Source and grade of one row of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Citation {
    /// Manual, page, header line; short enough for a table cell. Word for word a line of `docs/reference/sources.md`.
    pub source: Phrase,
    /// How far it carries.
    pub grade: Grade,
}

impl Citation {
    /// A citation.
    pub const fn new(source: &'static str, grade: Grade) -> Citation {
        Citation { source: Phrase::new(source), grade }
    }
}
