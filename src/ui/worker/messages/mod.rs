//! Messages between page and worker, sent as structured clones. Both ends are of one build, so the messages have no version.

mod documents;
mod findings;
mod program;
mod requests;
mod shelf;

use leptos::wasm_bindgen::JsValue;
use serde::{Deserialize, Serialize};

pub(crate) use documents::{
    ComparedVariants, ExportDocuments, ExportedDocument, FoundHelp, FoundRepairs, HelpPageHtml, Hit, ReadParts, Remark,
    Sheets, ShownSection, TextReport,
};
pub(crate) use findings::{Finding, Range};
pub(crate) use program::{Caret, NamedPlace, Places, Proposals, SHOWN};
pub(crate) use requests::{
    Ask, CheckText, CompareProjects, CompareVariants, Complete, DrawExamples, DrawMachines, ExportProject,
    FindDefinition, FindFlips, FindRepairs, FindUses, ListProjects, ReadHelp, ReadPartsTable, Request, ReviewProgram,
    SearchHelp, SizeProject, WriteOutline, WriteReport, WriteSheets,
};
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

/// A message from the worker.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) enum Reply {
    /// The worker is ready. A request sent earlier would be lost.
    Ready,
    /// Progress of the request with this number.
    Progress(u32, f64),
    /// The answer to the request with this number; `undefined` if there is none.
    Answer(u32, #[serde(with = "serde_wasm_bindgen::preserve")] JsValue),
}
