//! A report: title block, drawing, verdicts, results with formulas, inputs with their origin, run, programs, sheets, and open points.

mod html;
mod markdown;

pub use html::html;
pub use markdown::markdown;

use super::sheet::Row;
use super::{Chart, Limit, Readout, Sheet, Verdict};
use crate::text::catalog::{Language, number_text, sentence, words};
use crate::text::{Diagnostic, Grade, Message};

/// An input of the report.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Id of its field.
    pub id: &'static str,
    /// Catalog id of its group.
    pub group: &'static str,
    /// Catalog id of its label.
    pub label: &'static str,
    /// Symbol or variable, or empty.
    pub symbol: &'static str,
    /// Value as it is shown.
    pub value: String,
    /// Unit, or empty.
    pub unit: &'static str,
    /// Catalog id of where a fact comes from; `None` for a choice.
    pub origin: Option<&'static str>,
}

/// A kind of facts about the control that no manual at hand confirms.
#[derive(Debug, Clone, PartialEq)]
pub struct Open {
    /// Catalog id of the kind.
    pub kind: &'static str,
    /// The facts, a few words each.
    pub facts: Vec<String>,
}

/// What a drawing office writes into the title block; an empty entry is filled in by hand.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct TitleBlock {
    /// Who has drawn it up.
    pub author: String,
    /// Number of the document.
    pub number: String,
    /// Revision of the document.
    pub revision: String,
}

/// A figure of the run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figure {
    /// Catalog id of its name.
    pub label: &'static str,
    /// Value in `unit`.
    pub value: f64,
    /// Unit as shown.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
}

/// A program file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Program {
    /// Name of the file.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Check sum of its bytes: CRC-32, eight hexadecimal digits.
    pub checksum: String,
}

/// The machine in motion, as a run of the programs has it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunReport {
    /// The drawing at a moment of the run, SVG.
    pub drawing: String,
    /// Cycle time and what follows from it; empty where the run does not come to the end of the program.
    pub figures: Vec<Figure>,
    /// Charts over the run.
    pub charts: Vec<Chart>,
}

/// Everything that the report says.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// Machine, control, name of the project.
    pub title: String,
    /// Name of the project, may be empty.
    pub project: String,
    /// Whom the machine is for, may be empty.
    pub customer: String,
    /// The title block.
    pub block: TitleBlock,
    /// The date as its reader writes dates, may be empty.
    pub date: String,
    /// Check sum of the settings, as of a program.
    pub checksum: String,
    /// A run of the programs.
    pub run: RunReport,
    /// The programs.
    pub programs: Vec<Program>,
    /// How they are loaded.
    pub loading: Vec<Message>,
    /// Prefix of the control's variables, for instance `#`.
    pub variable: char,
    /// Inputs by group.
    pub inputs: Vec<Input>,
    /// Results with verdicts.
    pub readouts: Vec<Readout>,
    /// Findings about fields and program.
    pub diagnostics: Vec<Diagnostic>,
    /// Tables.
    pub sheets: Vec<Sheet>,
    /// What is open.
    pub open: Vec<Open>,
}

fn verdict(verdict: Verdict, language: Language) -> &'static str {
    match verdict {
        Verdict::None => "",
        Verdict::Ok => words(language, "form.report.ok"),
        Verdict::Warn => words(language, "form.report.warn"),
        Verdict::Fail => words(language, "form.report.fail"),
    }
}

const RESULT_COLUMNS: [&str; 6] = [
    "form.report.result",
    "form.report.value",
    "form.report.limit",
    "form.report.verdict",
    "form.report.formula",
    "form.report.source",
];

const INPUT_COLUMNS: [&str; 5] =
    ["form.report.group", "form.report.input", "form.report.symbol", "form.report.value", "form.report.origin"];

/// A text with the symbol of variables of the control.
fn with_variable(report: &Report, text: &str) -> String {
    text.replace('#', report.variable.encode_utf8(&mut [0; 4]))
}

fn shown(value: f64, decimals: u8, unit: &str) -> String {
    if value.is_finite() {
        format!("{} {unit}", number_text(value, decimals)).trim_end().to_owned()
    } else {
        "-".to_owned()
    }
}

impl Figure {
    /// Value and unit.
    fn shown(&self) -> String {
        shown(self.value, self.decimals, self.unit)
    }
}

/// A limit as a phrase with its unit.
fn limit_words(readout: &Readout, limit: Limit, language: Language) -> String {
    sentence(language, &limit.message(shown(limit.value(), readout.decimals, readout.unit)))
}

/// The cells of a result.
fn cells_of_result(report: &Report, readout: &Readout, language: Language) -> [String; 6] {
    [
        words(language, readout.label).to_owned(),
        shown(readout.value, readout.decimals, readout.unit),
        readout.limit.map_or(String::new(), |limit| limit_words(readout, limit, language)),
        verdict(readout.verdict, language).to_owned(),
        with_variable(report, readout.formula),
        readout.cite.source.to_owned(),
    ]
}

/// The cells of an input.
fn cells_of_input(report: &Report, input: &Input, language: Language) -> [String; 5] {
    [
        words(language, input.group).to_owned(),
        words(language, input.label).to_owned(),
        with_variable(report, input.symbol),
        format!("{} {}", input.value, input.unit).trim_end().to_owned(),
        input.origin.map_or(String::new(), |id| words(language, id).to_owned()),
    ]
}

/// The cells of a row of a sheet, with its source at last.
fn cells_of_row(row: &Row, language: Language) -> Vec<String> {
    let doubt = if row.grade == Grade::Open { words(language, "form.report.unconfirmed") } else { "" };
    row.cells.iter().cloned().chain([format!("{} {doubt}", row.source).trim_end().to_owned()]).collect()
}
