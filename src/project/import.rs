//! Recognises a dropped, pasted or opened text: a project, a program that macroline wrote, or any other program.

use super::{Project, parts};
use crate::controls::{self, Control};
use crate::machines;
use crate::machines::program::{header, settings};
use crate::msg;
use crate::nc::{self, File, Files, Stmt};
use crate::text::catalog::Language;
use crate::text::{Diagnostic, without_byte_order_mark};

pub use super::saved::{MAX_PROGRAM, MAX_PROGRAMS};

/// Kind of a file, by the beginning of its text; a byte order mark does not count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// A project: an object in JSON.
    Project,
    /// A panel file: a list of objects, or an empty one, that is no list of parts.
    Panel,
    /// A table of parts, as CSV or JSON.
    Parts,
    /// A program, or any other text.
    Program,
}

impl FileKind {
    /// Kind of a file with this text.
    pub fn of(text: &str) -> FileKind {
        let begin = bare(text);
        let list = begin.strip_prefix('[').map(str::trim_start);
        // A project in one line may name the columns of its own parts.
        if begin.starts_with('{') {
            FileKind::Project
        } else if parts::is_table(text) {
            FileKind::Parts
        } else if list.is_some_and(|list| list.starts_with(['{', ']'])) {
            FileKind::Panel
        } else {
            FileKind::Program
        }
    }
}

/// Result of an import.
pub struct Opened {
    /// The project opened; `None` if the text is neither a project nor a program.
    pub project: Option<Project>,
    /// Reasons of a refusal, and parts that were left out.
    pub diagnostics: Vec<Diagnostic>,
}

/// Ends of the names of an export's documents, all files but programs and project (a test compares them with [`Project::export`]).
const DOCUMENTS: [&str; 6] = [".csv", ".dxf", ".html", ".md", ".svg", "own-code.nc"];

fn is_document(file: &File) -> bool {
    let name = file.name.to_ascii_lowercase();
    DOCUMENTS.iter().any(|end| name.ends_with(end))
}

/// Whether the control reads at least one line of a text as a block: prose and lists are no programs.
pub fn is_program(control: &'static Control, file: &File) -> bool {
    let parsed = nc::parse(&Files(vec![file.clone()]), control);
    parsed.deck().blocks.iter().any(|block| !matches!(block.stmt, Stmt::Bad(_) | Stmt::Empty))
}

/// Opens texts beside the present project, all of them or none: a project file replaces it, a program that macroline wrote restores its
/// form, and all programs together are the edited program of that project, unless they are what its form writes.
pub fn open(present: &Project, files: &[File]) -> Opened {
    let is_project = |file: &&File| FileKind::of(&file.text) == FileKind::Project;
    let (projects, others): (Vec<&File>, Vec<&File>) = files.iter().partition(is_project);
    let refused = |diagnostics| Opened { project: None, diagnostics };
    let error = |message| refused(vec![Diagnostic::error(message)]);
    if let [first, second, ..] = projects[..] {
        return error(msg!("project.several-projects", file = first.name.as_str(), other = second.name.as_str()));
    }
    if let Some(file) = others.iter().find(|file| !is_text(&file.text)) {
        return error(msg!("project.not-a-text", file = file.name.as_str()));
    }
    if let Some(file) = others.iter().find(|file| bare(&file.text).is_empty()) {
        return error(msg!("project.empty-file", file = file.name.as_str()));
    }
    if let Some(file) = others.iter().find(|file| file.name.to_ascii_lowercase().ends_with(".json")) {
        return error(msg!("project.no-project-file", file = file.name.as_str()));
    }
    let given: Vec<File> =
        others.iter().map(|file| File { name: file.name.clone(), text: bare(&file.text).to_owned() }).collect();
    let given = match programs(&given) {
        Ok(files) => files,
        Err(finding) => return refused(vec![finding]),
    };
    if let Some(file) = projects.first() {
        let loaded = Project::from_json(&file.text);
        let Some(mut project) = loaded.project else { return refused(loaded.diagnostics) };
        let (given, left_aside) = without_documents(given);
        if !given.0.is_empty() {
            project.edited = differing(&project, &given);
        }
        return Opened {
            project: Some(project),
            diagnostics: loaded.diagnostics.into_iter().chain(left_aside).collect(),
        };
    }
    let restored = given.0.iter().find_map(|file| Some((restored_beside(present, &file.text)?, file.name.clone())));
    match restored {
        Some((mut project, from)) => {
            let (given, left_aside) = without_documents(given);
            project.edited = differing(&project, &given);
            let message = if project.edited.is_some() {
                msg!("project.form-restored-edited", file = from)
            } else {
                msg!("project.form-restored", file = from)
            };
            Opened {
                project: Some(project),
                diagnostics: core::iter::once(Diagnostic::info(message)).chain(left_aside).collect(),
            }
        }
        None => {
            let mut project = present.clone();
            project.edited = Some(given);
            Opened { project: Some(project), diagnostics: Vec::new() }
        }
    }
}

/// The programs without the documents of an export beside them, and a finding about the documents.
fn without_documents(given: Files) -> (Files, Option<Diagnostic>) {
    let (left, programs): (Vec<File>, Vec<File>) = given.0.into_iter().partition(is_document);
    let remark =
        (!left.is_empty()).then(|| Diagnostic::info(msg!("project.documents-left", count = left.len() as u32)));
    (Files(programs), remark)
}

/// A text without the byte order mark and the space before it.
fn bare(text: &str) -> &str {
    without_byte_order_mark(text).trim_start()
}

/// Whether a text has none of the characters that only other kinds of files have.
fn is_text(text: &str) -> bool {
    !text.contains('\0')
}

/// Project from the form settings in the comments of a program that macroline wrote.
pub fn restored(text: &str) -> Option<Project> {
    let found = settings::read(text)?;
    let (machine, control) = (machines::find(found.machine)?, controls::find(found.control)?);
    let mut project = Project::of_form(machine, control);
    project.values = machine.fields().iter().map(|field| (field.id.to_owned(), field.default())).collect();
    project.values.extend(found.values);
    Some(project)
}

/// Project of a program that macroline wrote, with name and settings of the present project.
fn restored_beside(present: &Project, text: &str) -> Option<Project> {
    let mut project = restored(text)?;
    project.name.clone_from(&present.name);
    // A program written from the form has non-ASCII characters only in comments.
    project.comments = if text.is_ascii() { Language::English } else { Language::Chinese };
    if present.control.id == project.control.id {
        project.switches.clone_from(&present.switches);
    }
    Some(project)
}

/// Programs as the edited files of a project; an error where they are too many or too large, and then none is taken.
pub fn programs(files: &[File]) -> Result<Files, Diagnostic> {
    let bytes: usize = files.iter().map(|file| file.text.len()).sum();
    if files.len() > MAX_PROGRAMS {
        let message = msg!("project.too-many-programs", count = files.len() as u32, most = MAX_PROGRAMS as u32);
        return Err(Diagnostic::error(message));
    }
    if bytes > MAX_PROGRAM {
        let message =
            msg!("project.program-too-large", size = (bytes as f64 / 1e6, 1), most = (MAX_PROGRAM as f64 / 1e6, 0));
        return Err(Diagnostic::error(message));
    }
    Ok(Files(files.to_vec()))
}

/// The project's files with these texts in the places of those with the same program, if one was edited since macroline wrote it; else
/// `None`.
fn differing(project: &Project, given: &Files) -> Option<Files> {
    let mut generated = project.clone();
    generated.edited = None;
    let mut files = generated.written().files;
    let number = |text: &str| {
        nc::parse_with(&Files::one("", text), project.control, &project.switches)
            .deck()
            .programs
            .first()
            .map(|p| p.number)
    };
    // Different line ends and another version of macroline do not count as edits.
    let lines = |text: &str| -> Vec<String> {
        text.lines().filter(|line| !header::is_version_line(line)).map(|line| line.trim_end().to_owned()).collect()
    };
    let mut edited = false;
    for File { name, text } in &given.0 {
        let own = number(text);
        match files.0.iter_mut().find(|file| number(&file.text) == own) {
            Some(file) if lines(&file.text) == lines(text) => continue,
            Some(file) => file.text.clone_from(text),
            None => files.0.push(File { name: name.clone(), text: text.clone() }),
        }
        edited = true;
    }
    edited.then_some(files)
}
