//! Messages between page and worker, sent as structured clones. Both ends are of one build, so the messages have no version.

use serde::{Deserialize, Serialize};
use web_sys::Blob;

use crate::controls::Control;
use crate::text::{Diagnostic, DiagnosticKind, FileId, Fix, Message, MessageValue, Place, Severity, Span, catalog};
use crate::ui::words::Tone;
use crate::view::Theme;

/// Greatest number of shown lines of a program.
pub(crate) const SHOWN: u32 = 5000;

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

/// Form in which a [`Theme`] is sent.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Theme")]
enum SentTheme {
    Light,
    Dark,
    Line,
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

/// Changes of the form with which the failing results hold, as one of several ways.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct FoundRepairs {
    /// The changes in words.
    pub changes: Vec<String>,
    /// What becomes of the headline results that differ: `Line speed 7578 → 3789 mm/min`.
    pub consequences: Vec<String>,
    /// Id of each field and its new text, in the order in which they are taken.
    pub entries: Vec<(String, String)>,
    /// Number of results that still fail with all of them.
    pub still_failing: u32,
    /// Number of errors of the form that stay.
    pub errors: u32,
}

/// A place in the editor.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Caret {
    /// The file.
    pub file: u16,
    /// UTF-16 units of its text before the place.
    pub units: u32,
}

/// Completion proposals for the typed prefix.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Proposals {
    /// UTF-16 units before the text that a proposal replaces.
    pub from: u32,
    /// Whether the first of them name a program or a block: these are few, and are shown before anything is typed.
    pub few: bool,
    /// Texts, and the line beside each of them.
    pub rows: Vec<(String, String)>,
}

/// Places of a program.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Places {
    /// Number of all places; greater than the number of rows if the list is cut.
    pub count: u32,
    /// The first places.
    pub rows: Vec<NamedPlace>,
}

/// A place as a row of a list.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct NamedPlace {
    /// Name of a program, block or variable; or file and line.
    pub name: String,
    /// Text of the block or of the line.
    pub text: String,
    /// Whether the row is nested below the place before it, as a block below its program.
    pub below: bool,
    /// The place.
    pub place: Range,
}

/// Note of a version that was kept before a program was opened.
pub(crate) const BEFORE_PROGRAM: &str = "auto:program";

/// Note of a version that was kept before another one was opened.
pub(crate) const BEFORE_VERSION: &str = "auto:version";

/// Note of a project of another tab that this tab replaced.
pub(crate) const OTHER_TAB: &str = "auto:other-tab";

/// A project that this browser keeps, or a version of one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct ShelfState {
    /// Its id.
    pub id: String,
    /// Id of the project that it is a version of; empty for a project.
    pub of: String,
    /// Milliseconds since 1970 at which it was kept.
    pub at: f64,
    /// Version of the page's states.
    pub version: f64,
    /// Note of the person or of the page.
    pub note: String,
    /// The project as the text of its file.
    pub text: String,
}

/// Content of the list of projects.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Shelf {
    /// Id of the present project.
    pub present: String,
    /// Projects and versions on the shelf.
    pub states: Vec<ShelfState>,
    /// States that were set aside and are not on the shelf: their ids are keys of the browser's other store, their notes the sentences about them.
    pub aside: Vec<ShelfState>,
    /// Steps of undo as project files: before the present project, the oldest first, and after it, the next one last.
    pub steps: [Vec<String>; 2],
    /// Colours of the pictures.
    #[serde(with = "SentTheme")]
    pub theme: Theme,
}

/// Store of a listed project.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum ShelfPlace {
    /// On the page: the present project.
    #[default]
    Present,
    /// On the shelf.
    Shelf,
    /// In the browser's other store, set aside.
    Aside,
}

/// A project of the list of projects, in words.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct ListedProject {
    /// Id of its state.
    pub id: String,
    /// Its store.
    pub place: ShelfPlace,
    /// Its name; empty where it has none.
    pub name: String,
    /// The reason why its text is no project; none for a project.
    pub unread: Option<String>,
    /// Machine and control; empty where its text is no project.
    pub kind: String,
    /// When it was kept, and the note.
    pub kept: String,
    /// Address of its picture; empty where it has none.
    pub picture: String,
    /// Its versions, the last kept first.
    pub versions: Vec<ListedVersion>,
    /// Steps of undo and redo of the present project, the last one first; none where nothing was changed.
    pub steps: Vec<ListedStep>,
}

/// A version of a listed project.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct ListedVersion {
    /// Id of its state.
    pub id: String,
    /// Its note, or the day where it has none.
    pub name: String,
    /// The day; empty where the name is the day.
    pub kept: String,
    /// Changes since; empty where its text is no project.
    pub changes: String,
    /// The reason why its text is no project; none for a project.
    pub unread: Option<String>,
}

/// A step of undo or redo.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct ListedStep {
    /// Steps from the present state: below 0 to be undone, above 0 to be done again.
    pub steps: i32,
    /// Changes that it made.
    pub changes: String,
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
    /// Its id.
    pub id: String,
    /// Its title.
    pub title: String,
    /// Tone of its answer.
    pub tone: Tone,
    /// The answer in a line.
    pub answer: String,
    /// Its sheets as HTML.
    pub html: String,
}

/// A page of help.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct HelpPageHtml {
    /// Its id.
    pub page: String,
    /// Its title.
    pub title: String,
    /// `id` of the element that was asked for; empty for the page as a whole.
    pub anchor: String,
    /// Its content; elements with `data-help` lead to the id that they name.
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
    /// Its id.
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
    /// What it is, in words.
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

/// A [`Diagnostic`] with its static texts as owned ones.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Finding {
    message: Sentence,
    /// Place in [`Severity::ALL`].
    severity: u8,
    /// Place in [`DiagnosticKind::ALL`].
    kind: u8,
    alarm: Option<String>,
    wording: Option<u16>,
    place: Option<Range>,
    hints: Vec<Sentence>,
    fixes: Vec<(Sentence, Vec<(Range, String)>)>,
}

/// Id of a message, and the names of its places with their values as they are shown.
#[derive(Debug, Serialize, Deserialize)]
struct Sentence(String, Vec<(String, String)>);

/// File, start and end of a place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Range(u16, u32, u32);

impl From<&Message> for Sentence {
    fn from(message: &Message) -> Sentence {
        let shown = |(name, value): &(&str, MessageValue)| ((*name).to_owned(), catalog::plain(value).into_owned());
        Sentence(message.id.to_owned(), message.values.iter().map(shown).collect())
    }
}

impl Sentence {
    /// The message; `None` where the catalog lacks its id. Values without a place in its sentence are left out.
    fn message(self) -> Option<Message> {
        let id = catalog::id(&self.0)?;
        let values = self.1.into_iter();
        let values = values.filter_map(|(name, text)| Some((catalog::place(id, &name)?, MessageValue::Text(text))));
        Some(Message { id, values: values.collect() })
    }
}

impl From<Place> for Range {
    fn from(place: Place) -> Range {
        Range(place.file.0, place.span.start, place.span.end)
    }
}

impl From<Range> for Place {
    fn from(Range(file, start, end): Range) -> Place {
        Place { file: FileId(file), span: Span { start, end } }
    }
}

impl Finding {
    /// The diagnostic as a message; its wording is the number of the row in the control's table of alarms.
    pub(super) fn new(found: &Diagnostic, control: &Control) -> Finding {
        let shown = (found.alarm.as_deref(), found.wording);
        let row = control.alarms.iter().position(|row| (Some(row.number), Some(row.text)) == shown);
        let edits = |fix: &Fix| fix.edits.iter().map(|(place, text)| ((*place).into(), text.clone())).collect();
        Finding {
            message: (&found.message).into(),
            severity: found.severity as u8,
            kind: found.kind as u8,
            alarm: found.alarm.as_deref().map(str::to_owned),
            wording: row.and_then(|row| u16::try_from(row).ok()),
            place: found.place.map(Range::from),
            hints: found.hints.iter().map(Sentence::from).collect(),
            fixes: found.fixes.iter().map(|fix| ((&fix.title).into(), edits(fix))).collect(),
        }
    }

    /// The diagnostic; its wording is that of the control's own row. `None` where the catalog lacks its sentence.
    pub(super) fn diagnostic(self, control: &Control) -> Option<Diagnostic> {
        let message = self.message.message()?;
        let (severity, kind) = (usize::from(self.severity), usize::from(self.kind));
        let mut found = Diagnostic::error(message).kind(*DiagnosticKind::ALL.get(kind)?);
        found.severity = *Severity::ALL.get(severity)?;
        found.place = self.place.map(Place::from);
        found.alarm = self.alarm.map(Into::into);
        found.wording = self.wording.and_then(|row| control.alarms.get(usize::from(row))).map(|row| row.text);
        found.hints.extend(self.hints.into_iter().filter_map(Sentence::message));
        for (title, edits) in self.fixes {
            let Some(title) = title.message() else { continue };
            found.fixes.push(Fix { title, edits: edits.into_iter().map(|(at, text)| (at.into(), text)).collect() });
        }
        Some(found)
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::project;

    #[wasm_bindgen_test]
    fn finding_is_the_same_on_both_ends() {
        let control = project().control;
        let place = Place { file: FileId(1), span: Span { start: 2, end: 5 } };
        let row = control.alarms.last().map(|row| (row.number, row.text));
        let sent = Diagnostic::warning(crate::msg!("page.more-findings", count = 5.0))
            .at(place)
            .alarm(row)
            .hint(crate::msg!("page.taken"))
            .kind(DiagnosticKind::Starved)
            .fix(crate::msg!("page.mended"), vec![(place, "X1.".to_owned())]);
        let wire = serde_wasm_bindgen::to_value(&Finding::new(&sent, control)).unwrap();
        let got = serde_wasm_bindgen::from_value::<Finding>(wire).unwrap().diagnostic(control).unwrap();
        assert_eq!(crate::ui::words::tell_alarm(&got), crate::ui::words::tell_alarm(&sent));
        assert_eq!((got.severity, got.kind, got.place), (sent.severity, sent.kind, sent.place));
        assert_eq!(got.fixes[0].edits, sent.fixes[0].edits);
    }

    #[wasm_bindgen_test]
    fn value_crosses_only_by_a_name_of_its_sentence() {
        let values = [("count", "5"), ("speed", "7")].map(|(name, text)| (name.to_owned(), text.to_owned()));
        let got = Sentence("page.more-findings".to_owned(), values.into()).message().unwrap();
        assert_eq!(got.values, [("count", MessageValue::Text("5".to_owned()))]);
    }
}
