//! Content of a report, as data.

use crate::text::{Citation, Diagnostic, Message, Provenance};
use crate::view::{Chart, Comparison, Readout, Repairs, Sheet};

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
    /// Value as shown.
    pub value: String,
    /// Unit, or empty.
    pub unit: &'static str,
    /// Origin of a fact; `None` for a choice.
    pub origin: Option<Provenance>,
    /// Whether the input is one of the product, shown first.
    pub essential: bool,
}

/// Settings and facts of the control that no manual at hand confirms.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenPoints {
    /// Settings, also confirmed ones that differ from their default.
    pub settings: Vec<OpenSetting>,
    /// Facts by kind.
    pub facts: Vec<OpenFacts>,
}

/// A setting of the control.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenSetting {
    /// Label, with the control's own parameter.
    pub label: String,
    /// Option or text as set.
    pub chosen: String,
    /// The other options; empty for a text.
    pub others: String,
    /// Source of the default.
    pub cite: Citation,
}

/// Facts of one kind about the control that no manual at hand confirms.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenFacts {
    /// Catalog id of the kind.
    pub kind: &'static str,
    /// Short texts of the facts.
    pub facts: Vec<String>,
}

/// A row of the parts list; its item number is its index from 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ListedPart {
    /// Catalog id of its name.
    pub name: &'static str,
    /// Number of pieces.
    pub quantity: u32,
    /// Data of the part as shown.
    pub data: String,
    /// Catalog id of the origin of the data; `None` without data.
    pub origin: Option<&'static str>,
}

/// Entries of the title block; an empty entry is filled in by hand.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct TitleBlock {
    /// Name of the customer in full, where the form's name, which is a comment of the program, is too short for it.
    pub customer: String,
    /// Author of the document.
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
pub struct PrintedProgram {
    /// Name of the file.
    pub name: String,
    /// Text of the file.
    pub text: String,
    /// Checksum of its bytes: CRC-32, eight hexadecimal digits.
    pub checksum: String,
}

/// The machine in motion, from a run of the programs.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunReport {
    /// The drawing at one time of the run, SVG.
    pub drawing: String,
    /// The time of the drawing, in seconds from the start.
    pub drawn_at: f64,
    /// Cycle time, mean time of a part where it differs, and parts per hour; empty if the run does not reach the end of the program.
    pub figures: Vec<Figure>,
    /// Charts over the run.
    pub charts: Vec<Chart>,
}

/// The sizing in a report.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SizingReport {
    /// Bill of materials, limits of the machine, operation, motors.
    pub tables: Vec<Sheet>,
    /// Findings about limits exceeded in the operating envelope.
    pub exceeded: Vec<Diagnostic>,
}

/// Everything in the report.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// Machine, control, name of the project.
    pub title: String,
    /// Name of the project, may be empty.
    pub project: String,
    /// Customer of the machine, may be empty.
    pub customer: String,
    /// The title block.
    pub block: TitleBlock,
    /// The date in the reader's format, may be empty.
    pub date: String,
    /// Checksum of the settings, like that of a program.
    pub checksum: String,
    /// A run of the programs.
    pub run: RunReport,
    /// The programs.
    pub programs: Vec<PrintedProgram>,
    /// Instructions for loading them.
    pub loading: Vec<Message>,
    /// Prefix of the control's variables, for instance `#`.
    pub variable: char,
    /// Inputs by group.
    pub inputs: Vec<Input>,
    /// The parts list, in the order of the item numbers in the drawing.
    pub parts: Vec<ListedPart>,
    /// Sentence about the work of the machine; none if the machine does not work.
    pub summary: Option<Message>,
    /// Results with verdicts.
    pub readouts: Vec<Readout>,
    /// Changes with which the failing results hold.
    pub repairs: Repairs,
    /// Findings about fields and program.
    pub diagnostics: Vec<Diagnostic>,
    /// The sizing; empty without one.
    pub sizing: SizingReport,
    /// The offer, first, and the variants of the project; `None` without variants.
    pub variants: Option<Comparison>,
    /// Tables.
    pub sheets: Vec<Sheet>,
    /// Open points.
    pub open: OpenPoints,
}
