//! Sources of facts with their grade of evidence, and origins of the entries of a form.

use serde::Serialize;

use super::{Phrase, catalog};

/// Quality of evidence for a fact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Grade {
    /// The manual of the control itself, or the published paper about the machine.
    Manual,
    /// The manual of a sister control of the same maker.
    Sister,
    /// Measured on a machine.
    Measured,
    /// Derived from other facts, or from a secondary source.
    Inferred,
    /// From memory or unknown: shown to the user as open.
    Open,
}

impl Grade {
    /// Name of the grade, in the language in use.
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

/// Origin of an entry of a form that states a fact of the machine; the report lists the assumed ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Provenance {
    /// Measured on the machine.
    Measured,
    /// From a data sheet.
    DataSheet,
    /// Assumed: the default.
    #[default]
    Assumed,
}

impl Provenance {
    /// The origin in a word or two, in the language in use.
    pub fn words(self) -> &'static str {
        match self {
            Provenance::Measured => catalog::words("form.report.measured"),
            Provenance::DataSheet => catalog::words("form.report.data-sheet"),
            Provenance::Assumed => catalog::words("form.report.assumed"),
        }
    }
}

/// Source and grade of one row of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Citation {
    /// Manual, page, header line; short enough for a table cell. Identical to a line of `docs/reference/sources.md`.
    pub source: Phrase,
    /// Quality of the source.
    pub grade: Grade,
}

impl Citation {
    /// A citation.
    pub const fn new(source: &'static str, grade: Grade) -> Citation {
        Citation { source: Phrase::new(source), grade }
    }
}
