//! A printed table of a project: parameters, interface, ladder list.

use super::field_entry::FieldEntry;
use crate::text::{Grade, Phrase};

/// A row of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Cells in the order of the columns.
    pub cells: Vec<String>,
    /// Grade of its evidence.
    pub grade: Grade,
    /// Source of the row.
    pub source: Phrase,
    /// Form entries set by choosing the row; empty for a row that is not a choice.
    pub entries: Vec<FieldEntry>,
}

impl Sheet {
    /// The first row, if all of several rows have the same source and grade.
    pub fn common_source(&self) -> Option<&Row> {
        let first = self.rows.first()?;
        let shared = self.rows.iter().all(|row| (row.source, row.grade) == (first.source, first.grade));
        (shared && self.rows.len() > 1).then_some(first)
    }
}

/// A sheet with special treatment by views.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SheetKind {
    /// Any other table.
    Plain,
    /// Parameters to set on the control.
    Parameters,
    /// Bill of materials: rows for purchasing, each with a source.
    Bill,
    /// Limits of the machine as a quantity grows.
    Limits,
    /// The worst values of operation: a digest for the page, where documents have every event.
    Worst,
    /// Products to choose from, suitable ones before many unsuitable ones; views show the first rows.
    Choice,
}

/// A column by the kind of its cells, with the catalog id of its head.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// Figures and words, including registers and variables.
    Plain(&'static str),
    /// Sentences.
    Prose(&'static str),
    /// Names of products; their letters and digits are not registers.
    Product(&'static str),
    /// Numbers of the control's parameters.
    Parameter(&'static str),
    /// Sources of the rows.
    Source(&'static str),
}

impl Column {
    /// Catalog id of the head.
    pub fn head(self) -> &'static str {
        match self {
            Column::Plain(head)
            | Column::Prose(head)
            | Column::Product(head)
            | Column::Parameter(head)
            | Column::Source(head) => head,
        }
    }
}

/// A table with a title.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Id, for instance `parameters`, used as the name of its file.
    pub id: &'static str,
    /// Kind for special treatment by views.
    pub kind: SheetKind,
    /// Catalog id of the title.
    pub title: &'static str,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows.
    pub rows: Vec<Row>,
    /// Drawing of the rows: SVG with the classes of the page (`s-ink`, `f-dim` …); empty for most.
    pub drawing: String,
}
