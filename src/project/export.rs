//! Export: program files, sheets and report; nothing if the control would refuse or misread a program.

use std::collections::BTreeMap;

use super::Project;
use super::files::encode;
use super::findings::silence::silence;
use super::program::Written;
use super::size::Sizing;
use crate::controls::options::CommentCharacters;
use crate::machines::{MachineFile, PreparedMachine};
use crate::msg;
use crate::nc::{File, Files};
use crate::text::Diagnostic;
use crate::text::units::in_millimetres;
use crate::view::{self, report};

/// Names of the documents for people, which are printed: the report, and its summary for those who decide.
pub const REPORT: &str = "report.html";
/// See [`REPORT`].
pub const SUMMARY: &str = "summary.html";

/// Options of an export.
#[derive(Debug, Clone, Copy, Default)]
pub struct ExportOptions<'a> {
    /// Findings about the programs, as [`Project::advice`] gives them: for diagnostics and report.
    pub advice: &'a [Diagnostic],
    /// Date in the title block, in the reader's date format; may be empty.
    pub date: &'a str,
    /// Sizing for the report; without one the report has none.
    pub sizing: Option<&'a Sizing>,
}

/// A file of an export.
#[derive(Debug, Clone, PartialEq)]
pub struct ExportFile {
    /// Name and text of the file.
    pub file: File,
    /// Role of the file in the export.
    pub role: FileRole,
}

/// Role of a file in an export.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileRole {
    /// A program, in the control's characters.
    Program(CommentCharacters),
    /// A file beside the programs: report, sheet, drawing, the project itself.
    Document {
        /// Catalog id of the words for its kind.
        meaning: &'static str,
    },
}

impl ExportFile {
    fn document(file: File, meaning: &'static str) -> ExportFile {
        ExportFile { file, role: FileRole::Document { meaning } }
    }
}

/// The files of an export, or the reasons why there is none.
#[derive(Debug, Clone)]
pub struct Export {
    /// Programs, then documents; empty where a diagnostic is an error.
    pub files: Vec<ExportFile>,
    /// The report without programs, as HTML, where there are no files because of an error.
    pub draft: Option<String>,
    /// Invalid fields, findings about the program, and limits that operation exceeds.
    pub diagnostics: Vec<Diagnostic>,
    /// The program files that places of diagnostics point into.
    pub about: Files,
}

/// An error for each file with the name of an earlier one; capitals, and points and blanks at the end, do not distinguish names on the cards
/// that controls read.
fn same_names(files: &[ExportFile]) -> Vec<Diagnostic> {
    let mut known = BTreeMap::new();
    let mut found = Vec::new();
    for ExportFile { file, .. } in files {
        let name = file.name.to_lowercase().trim_end_matches(['.', ' ']).to_owned();
        if let Some(first) = known.insert(name, &file.name) {
            found.push(Diagnostic::error(msg!("project.same-name", file = first.as_str(), other = file.name.as_str())));
        }
    }
    found
}

impl Export {
    /// Name and bytes of each exported file: programs in the control's encoding, all others in UTF-8.
    pub fn bytes(&self) -> impl Iterator<Item = (&str, Vec<u8>)> {
        self.files.iter().map(|ExportFile { file, role }| {
            let characters = match role {
                FileRole::Program(characters) => *characters,
                FileRole::Document { .. } => CommentCharacters::Utf8,
            };
            (file.name.as_str(), encode::bytes(&file.text, characters))
        })
    }

    /// The documents, each with the catalog id of the words for its kind.
    pub fn documents(&self) -> impl Iterator<Item = (&File, &'static str)> {
        self.files.iter().filter_map(|ExportFile { file, role }| match role {
            FileRole::Program(_) => None,
            FileRole::Document { meaning } => Some((file, *meaning)),
        })
    }

    /// Names and texts of all files.
    pub fn into_files(self) -> Vec<File> {
        self.files.into_iter().map(|exported| exported.file).collect()
    }
}

impl Project {
    /// The files for the machine. Errors refuse the export; verdicts are in the report and do not.
    pub fn export(&self) -> Export {
        self.export_with(&self.written(), &ExportOptions::default())
    }

    /// The files for the machine, with programs that are already written.
    pub fn export_with(&self, written: &Written, options: &ExportOptions) -> Export {
        let (prepared, design) = (self.prepared(), self.design());
        let mut found = written.diagnostics.clone();
        found.extend_from_slice(options.advice);
        Diagnostic::in_order(&mut found);
        silence(&mut found, &self.silenced);
        let mut diagnostics = design.diagnostics.clone();
        silence(&mut diagnostics, &self.silenced);
        diagnostics.extend(found.iter().cloned());
        diagnostics.extend(options.sizing.iter().flat_map(|sizing| sizing.findings()));
        let mut files = Vec::new();
        let mut draft = None;
        let options = ExportOptions { advice: &found, ..*options };
        if diagnostics.iter().any(|d| d.is_error()) {
            let without_programs = Written { files: Files::default(), ..written.clone() };
            draft = Some(report::html(&self.report(&prepared, &without_programs, &options)));
        } else {
            let role = FileRole::Program(self.characters());
            files.extend(written.files.0.iter().map(|file| ExportFile { file: file.clone(), role }));
            files.extend(self.documents_of(&prepared, written, &options));
            let same = same_names(&files);
            if !same.is_empty() {
                files.clear();
                diagnostics.extend(same);
            }
        }
        Export { files, draft, diagnostics, about: written.files.clone() }
    }

    /// The files beside the programs.
    fn documents_of(&self, prepared: &PreparedMachine, written: &Written, options: &ExportOptions) -> Vec<ExportFile> {
        let file = |name: String, text, meaning| ExportFile::document(File { name, text }, meaning);
        let report = self.report(prepared, written, options);
        let mut files = vec![
            file(SUMMARY.to_owned(), report::summary(&report), "page.file.summary"),
            file(REPORT.to_owned(), report::html(&report), "page.file.report"),
            file("report.md".to_owned(), report::markdown(&report), "page.file.report-text"),
            file("drawing.svg".to_owned(), report.run.drawing.clone(), "page.file.machine"),
        ];
        let of_sizing = options.sizing.map(|sizing| [sizing.bill_sheet(), sizing.terminal_sheet()]);
        // Files that other programs read are in millimetres.
        for sheet in of_sizing.iter().flatten().chain(&in_millimetres(|| prepared.sheets())) {
            files.push(file(format!("{}.csv", sheet.id), view::csv::sheet(sheet), sheet.title));
            if !sheet.drawing.is_empty() {
                files.push(file(format!("{}.svg", sheet.id), view::svg::alone(&sheet.drawing), sheet.title));
            }
        }
        let own = prepared.files().into_iter();
        files.extend(own.map(|MachineFile { file, meaning }| ExportFile::document(file, meaning)));
        files.push(file("project.json".to_owned(), self.to_json(), "page.file.project"));
        files
    }
}
