//! A table for people: parameters, interface, ladder list.

use crate::text::{Grade, Phrase};

/// A row of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Cells in the order of the columns.
    pub cells: Vec<String>,
    /// How well it is known.
    pub grade: Grade,
    /// Where it comes from.
    pub source: Phrase,
    /// What it sets in the form: id of a field, and what is typed there. A row that is no choice sets nothing.
    pub sets: Vec<(&'static str, String)>,
}

impl Sheet {
    /// The first row, where all of several rows have its source and grade.
    pub fn common_source(&self) -> Option<&Row> {
        let first = self.rows.first()?;
        let shared = self.rows.iter().all(|row| (row.source, row.grade) == (first.source, first.grade));
        (shared && self.rows.len() > 1).then_some(first)
    }
}

/// A table with a title.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Id, for instance `parameters`.
    pub id: &'static str,
    /// Catalog id of the title.
    pub title: &'static str,
    /// Catalog ids of the column heads.
    pub columns: Vec<&'static str>,
    /// Rows.
    pub rows: Vec<Row>,
    /// What the rows tell, drawn: SVG with the classes of the page (`s-ink`, `f-dim` …); empty for most.
    pub drawing: String,
}
