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

/// A sheet that views treat in a way of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SheetKind {
    /// As any other table.
    Plain,
    /// Parameters to set on the control.
    Parameters,
    /// Bill of materials: rows of a shop, with a source each.
    Bill,
    /// Products to choose from, those that go before many that do not: the first are looked at.
    Choice,
}

/// A column by what its cells hold; each has the catalog id of its head.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// Figures and words, registers and variables among them.
    Plain(&'static str),
    /// Sentences.
    Prose(&'static str),
    /// Names of products, whose letters and digits are no registers.
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
    /// Id, for instance `parameters`: the name of its file.
    pub id: &'static str,
    /// What views treat it as.
    pub kind: SheetKind,
    /// Catalog id of the title.
    pub title: &'static str,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows.
    pub rows: Vec<Row>,
    /// What the rows tell, drawn: SVG with the classes of the page (`s-ink`, `f-dim` …); empty for most.
    pub drawing: String,
}
