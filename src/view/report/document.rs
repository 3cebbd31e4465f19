//! What a report says, as data.

use crate::text::{Diagnostic, Message};
use crate::view::{Chart, Comparison, Readout, Sheet};

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

/// A row of the parts list; its item number is its place in the list, from 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ListedPart {
    /// Catalog id of its name.
    pub name: &'static str,
    /// How many there are.
    pub quantity: u32,
    /// Its data as they are shown.
    pub data: String,
    /// Catalog id of where the data come from; `None` without data.
    pub origin: Option<&'static str>,
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
pub struct PrintedProgram {
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
    pub programs: Vec<PrintedProgram>,
    /// How they are loaded.
    pub loading: Vec<Message>,
    /// Prefix of the control's variables, for instance `#`.
    pub variable: char,
    /// Inputs by group.
    pub inputs: Vec<Input>,
    /// The parts list, in the order of the item numbers in the drawing.
    pub parts: Vec<ListedPart>,
    /// Results with verdicts.
    pub readouts: Vec<Readout>,
    /// Findings about fields and program.
    pub diagnostics: Vec<Diagnostic>,
    /// What exceeds its limit in the operating envelope; empty where the machine was not sized.
    pub exceeded: Vec<Diagnostic>,
    /// Tables of the sizing: what there is to buy, what limits the machine, what happens in operation, the motors; empty where it was not sized.
    pub sizing: Vec<Sheet>,
    /// The offer, first, and the variants of the project; none where it has no variant.
    pub variants: Option<Comparison>,
    /// Tables.
    pub sheets: Vec<Sheet>,
    /// What is open.
    pub open: Vec<Open>,
}
