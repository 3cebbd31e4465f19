//! The requests, each with the type of its answer.

use leptos::wasm_bindgen::JsValue;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use web_sys::Blob;

use super::documents::{
    ComparedVariants, ExportDocuments, FoundHelp, FoundRepairs, HelpPageHtml, ReadParts, Sheets, ShownSection,
    TextReport,
};
use super::findings::Finding;
use super::program::{Caret, Places, Proposals};
use super::shelf::{ListedProject, SentTheme, Shelf};
use crate::view::Theme;

/// A request about a project.
pub(crate) trait Ask {
    /// What answers it.
    type Answer: Serialize + DeserializeOwned;

    /// The request as it is sent.
    fn request(self) -> Request;

    /// The answer as it is sent; `None` if it cannot be sent.
    fn answer(&self, answer: &Self::Answer) -> Option<JsValue> {
        serde_wasm_bindgen::to_value(answer).ok()
    }

    /// The received answer.
    fn received(answer: JsValue) -> Option<Self::Answer> {
        serde_wasm_bindgen::from_value(answer).ok()
    }
}

/// Declares what can be asked, and what answers it.
macro_rules! requests {
    ($($ask:ident -> $answer:ty,)*) => {
        /// Work of the worker.
        #[derive(Debug, Serialize, Deserialize)]
        pub(crate) enum Request {
            $($ask($ask),)*
        }

        $(impl Ask for $ask {
            type Answer = $answer;

            fn request(self) -> Request {
                Request::$ask(self)
            }
        })*
    };
}

requests! {
    ReviewProgram -> Vec<Finding>,
    WriteSheets -> Sheets,
    SizeProject -> Vec<ShownSection>,
    DrawMachines -> ShownSection,
    FindFlips -> Vec<String>,
    FindRepairs -> Vec<FoundRepairs>,
    CompareVariants -> ComparedVariants,
    CompareProjects -> String,
    ListProjects -> Vec<ListedProject>,
    DrawExamples -> Vec<String>,
    ExportProject -> ExportDocuments,
    WriteReport -> Option<String>,
    ReadHelp -> Option<HelpPageHtml>,
    SearchHelp -> Option<FoundHelp>,
    ReadPartsTable -> ReadParts,
    Complete -> Proposals,
    FindDefinition -> Places,
    FindUses -> Places,
    WriteOutline -> Places,
    CheckText -> TextReport,
}

/// Asks for the errors and warnings of the project's program.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct ReviewProgram;

/// Asks for the parameter sheet, the interface and the ladder.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct WriteSheets;

/// Asks for motors, operating envelope, limits and bill of materials. The worker reports the share that is done.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct SizeProject;

/// Asks for the chance that every verdict holds, with the assumed facts within a tenth of their values: a sheet as HTML. The worker reports
/// the share that is done.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct DrawMachines;

/// Asks for the assumed facts of the form whose change by a tenth flips a verdict: ids of the fields, the worst first.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct FindFlips;

/// Asks for ways to change the form so that the failing results hold, the one with the fewest faults left first.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct FindRepairs;

/// Asks for the differences between the present settings and the variants of the project.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct CompareVariants;

/// Asks for the differences between the project and another one: the content of a table as HTML.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct CompareProjects {
    /// Names of the project and of the other one.
    pub names: [String; 2],
    /// The other one as the text of its file.
    pub other: String,
}

/// Asks for the list of the projects that this browser keeps, the present one first.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct ListProjects(pub Shelf);

/// Asks for a picture of each example as the address of an image, in the order of machines and examples.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct DrawExamples {
    /// Colours of the pictures.
    #[serde(with = "SentTheme")]
    pub theme: Theme,
}

/// Asks for the documents that are exported with the programs.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct ExportProject;

/// Asks for the report as HTML, or for its draft where the export is refused.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct WriteReport;

/// Asks for a page of help. Without an answer the texts of help cannot be loaded.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct ReadHelp {
    /// Id of the page, or of a section or entry of it.
    pub id: String,
    /// Colours of its drawing.
    #[serde(with = "SentTheme")]
    pub theme: Theme,
}

/// Searches the help for the words of a query. Without an answer the texts of help cannot be loaded.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct SearchHelp(pub String);

/// Asks for the project with the parts of a table.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct ReadPartsTable {
    /// Name of the table's file.
    pub name: String,
    /// Text of the file.
    pub text: String,
}

/// Asks for completion proposals at a place.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Complete(pub Caret);

/// Asks for the definition of the symbol at a place.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct FindDefinition(pub Caret);

/// Asks for all places of the symbol at a place.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct FindUses(pub Caret);

/// Asks for the programs of all files; below each of them its labels, calls, targets of jumps and variables.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct WriteOutline;

/// Asks for errors and warnings of a text that is too large for the page, on the project's control. The worker reports the bytes that are
/// read.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct CheckText(#[serde(with = "serde_wasm_bindgen::preserve")] pub Blob);

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;

    /// A request after its way to the worker.
    fn sent(ask: impl Ask) -> Request {
        serde_wasm_bindgen::from_value(serde_wasm_bindgen::to_value(&ask.request()).unwrap()).unwrap()
    }

    #[wasm_bindgen_test]
    fn request_without_values_is_sent() {
        assert!(matches!(sent(SizeProject), Request::SizeProject(SizeProject)));
    }

    #[wasm_bindgen_test]
    fn request_with_values_is_sent() {
        let Request::ReadHelp(ReadHelp { id, theme }) = sent(ReadHelp { id: "keys".to_owned(), theme: Theme::Dark })
        else {
            panic!("another request")
        };
        assert_eq!((id.as_str(), theme == Theme::Dark), ("keys", true));
    }

    #[wasm_bindgen_test]
    fn missing_answer_is_sent() {
        let none = WriteReport.answer(&None).unwrap();
        assert_eq!(WriteReport::received(none), Some(None));
        assert!(WriteSheets::received(JsValue::from_f64(1.0)).is_none());
    }
}
