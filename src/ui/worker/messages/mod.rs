//! Messages between page and worker, sent as structured clones. Both ends are of one build, so the messages have no version.

mod documents;
mod findings;
mod program;
mod shelf;

use serde::{Deserialize, Serialize};
use web_sys::Blob;

use crate::view::Theme;
pub(crate) use documents::{
    ExportDocuments, ExportedDocument, FoundHelp, FoundRepairs, HelpPageHtml, Hit, ReadParts, Remark, Sheets,
    ShownSection, TextReport,
};
pub(crate) use findings::{Finding, Range};
pub(crate) use program::{Caret, NamedPlace, Places, Proposals, SHOWN};
use shelf::SentTheme;
pub(crate) use shelf::{
    BEFORE_PROGRAM, BEFORE_VERSION, ListedProject, ListedStep, ListedVersion, OTHER_TAB, Shelf, ShelfPlace, ShelfState,
};

/// A request about a project, with the number that its answer carries.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Question {
    /// Number of the request.
    pub number: u32,
    /// The project as the text of its file.
    pub project: String,
    /// The work to do.
    pub request: Request,
}

/// Work of the worker.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) enum Request {
    /// Errors and warnings of the project's program.
    Review,
    /// Parameter sheet, interface and ladder.
    Sheets,
    /// Motors, operating envelope, limits and bill of materials.
    Sizing,
    /// Chance that every verdict holds, with the assumed facts within a tenth of their values.
    Chance,
    /// Assumed facts of the form whose change by a tenth flips a verdict.
    Flips,
    /// Ways to change the form so that the failing results hold.
    Repairs,
    /// The present settings beside the variants of the project.
    Variants,
    /// A project beside another one: the names of both, and the text of the other one's file.
    Compare([String; 2], String),
    /// The list of the projects that this browser keeps, the present one first.
    Shelf(Shelf),
    /// Pictures of the examples of all machines.
    Gallery {
        /// Colours of the pictures.
        #[serde(with = "SentTheme")]
        theme: Theme,
    },
    /// Documents that are exported with the programs.
    Export,
    /// A page of help.
    Help {
        /// Id of the page, or of a section or entry of it.
        id: String,
        /// Colours of its drawing.
        #[serde(with = "SentTheme")]
        theme: Theme,
    },
    /// Search results of help for a query.
    FindHelp(String),
    /// The project with the parts of a table, by the name of its file and its text.
    Parts(String, String),
    /// Completion proposals at a place.
    Complete(Caret),
    /// Definition of the symbol at a place.
    Definition(Caret),
    /// All places of the symbol at a place.
    Uses(Caret),
    /// Programs of all files; below each of them its labels, calls, targets of jumps and variables.
    Outline,
    /// Errors and warnings of a text that is too large for the page, on the project's control.
    Check(#[serde(with = "serde_wasm_bindgen::preserve")] Blob),
}

/// A message from the worker.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) enum Reply {
    /// The worker is ready. A request sent earlier would be lost.
    Ready,
    /// Progress of the request with this number: the share of [`Request::Sizing`] and [`Request::Chance`], the bytes of [`Request::Check`].
    Progress(u32, f64),
    /// The answer to the request with this number.
    Answer(u32, Response),
}

/// The result of a request.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) enum Response {
    /// Of [`Request::Review`].
    Review(Vec<Finding>),
    /// Of [`Request::Sheets`].
    Sheets(Sheets),
    /// Of [`Request::Sizing`].
    Sizing(Vec<ShownSection>),
    /// Of [`Request::Chance`]: a sheet as HTML. Of [`Request::Variants`]: rows of a table, without its head. Of [`Request::Compare`]: with it.
    Html(String),
    /// Of [`Request::Shelf`].
    Projects(Vec<ListedProject>),
    /// Of [`Request::Gallery`]: a picture per example as the address of an image, in the order of machines and examples.
    Pictures(Vec<String>),
    /// Of [`Request::Flips`]: ids of the fields, the worst first.
    Flips(Vec<String>),
    /// Of [`Request::Repairs`]: the ways, the first one with the fewest faults left.
    Repairs(Vec<FoundRepairs>),
    /// Of [`Request::Export`].
    Export(ExportDocuments),
    /// Of [`Request::Help`].
    Help(HelpPageHtml),
    /// Of [`Request::FindHelp`].
    Found(FoundHelp),
    /// The texts of the help cannot be loaded.
    NoHelp,
    /// Of [`Request::Parts`].
    Parts(ReadParts),
    /// Of [`Request::Complete`].
    Proposals(Proposals),
    /// Of [`Request::Definition`], [`Request::Uses`] and [`Request::Outline`].
    Places(Places),
    /// Of [`Request::Check`].
    Check(TextReport),
}
