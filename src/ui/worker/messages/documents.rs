//! Messages with the readable results of a project: sheets, help, repairs, and the documents of an export.

use super::findings::Range;
use serde::{Deserialize, Serialize};

use crate::ui::words::Tone;

/// Changes of the form with which the failing results hold, as one of several ways.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct FoundRepairs {
    /// The changes in words.
    pub changes: Vec<String>,
    /// Headline results that differ, before and after: `Line speed 7578 → 3789 mm/min`.
    pub consequences: Vec<String>,
    /// Id of each field and its new text, in the order in which they are taken.
    pub entries: Vec<(String, String)>,
    /// Number of results that still fail with all of them.
    pub still_failing: u32,
    /// Number of errors of the form that stay.
    pub errors: u32,
    /// The results that are to be checked then and were not before, as a sentence; empty without any.
    pub warning: String,
}

/// Sheets as HTML, by the tab that shows them.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(crate) struct Sheets {
    /// Parameters of the control.
    pub parameters: String,
    /// Interface and ladder.
    pub plc: String,
    /// Sheets whose rows can be taken into the form.
    pub ways: String,
}

/// A section of a sizing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct ShownSection {
    /// Id of the section.
    pub id: String,
    /// Title of the section.
    pub title: String,
    /// Tone of its answer.
    pub tone: Tone,
    /// The answer in a line.
    pub answer: String,
    /// Sheets of the section as HTML.
    pub html: String,
}

/// The differences between the present settings and the variants of a project.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ComparedVariants {
    /// Names of the variants, by column.
    pub names: Vec<String>,
    /// Rows of the table as HTML.
    pub rows: String,
}

/// A page of help.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct HelpPageHtml {
    /// Id of the page of help.
    pub page: String,
    /// Title of the page of help.
    pub title: String,
    /// `id` of the element that was asked for; empty for the page as a whole.
    pub anchor: String,
    /// Content as HTML; elements with `data-help` lead to the id that they name.
    pub html: String,
    /// Id and title of every page.
    pub pages: Vec<(String, String)>,
}

/// Places in the help that a search has found.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct FoundHelp {
    /// Whether they have all words of the query; otherwise no place has, and these have some.
    pub has_all_words: bool,
    /// The places, the best first.
    pub hits: Vec<Hit>,
}

/// A place in the help that a search has found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Hit {
    /// Id of the place.
    pub id: String,
    /// Word and title.
    pub title: String,
    /// Title of its page.
    pub page: String,
    /// The beginning of its text.
    pub text: String,
}

/// Parts that were read from a table.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct ReadParts {
    /// The project with these parts, as the text of its file.
    pub project: String,
    /// How many were added.
    pub added: u32,
    /// Findings: whether each refuses a row, and the sentence with its line.
    pub remarks: Vec<(bool, String)>,
}

/// The documents of an export. The page exports the programs that it runs; it has no table of GBK.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct ExportDocuments {
    /// Bytes of the programs, in their order, where the control reads them in GBK.
    pub programs: Vec<Vec<u8>>,
    /// Report, sheets, drawings, the project itself.
    pub files: Vec<ExportedDocument>,
    /// The report without programs, as HTML, where the export is refused.
    pub draft: Option<String>,
    /// Findings about fields and program.
    pub remarks: Vec<Remark>,
}

/// A document of an export.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct ExportedDocument {
    /// Name of the file.
    pub name: String,
    /// Kind of the document, in words.
    pub meaning: String,
    /// The file.
    pub text: String,
}

/// A finding as the export dialog shows it.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct Remark {
    /// Whether the finding refuses the export.
    pub refuses: bool,
    /// Weight.
    pub tone: Tone,
    /// Number of the alarm, or empty.
    pub alarm: String,
    /// The sentence.
    pub text: String,
    /// Id of the field, or empty.
    pub field: String,
    /// The place in the programs.
    pub place: Option<Range>,
}

/// The findings of a large text.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct TextReport {
    /// Lines of the text.
    pub lines: u32,
    /// Count of findings by severity, as one line.
    pub counts: String,
    /// The first lines.
    pub head: String,
    /// The first findings: weight and sentence.
    pub rows: Vec<(Tone, String)>,
}
