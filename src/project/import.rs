//! Recognises a dropped, pasted or opened text: a project, a program that macroline wrote, or any other program.

use super::Project;
use crate::controls;
use crate::machines::{self, settings};
use crate::msg;
use crate::nc::{self, File, Files};
use crate::text::Diagnostic;

pub use super::saved::{MAX_PROGRAM, MAX_PROGRAMS};

/// Result of an import.
pub struct Opened {
    /// The project to go on with; `None` where nothing could be made of the text.
    pub project: Option<Project>,
    /// Reasons of a refusal, and parts that were left out.
    pub diagnostics: Vec<Diagnostic>,
}

/// Opens a text beside the present project: a project file replaces it, a program that macroline wrote restores its form, any other
/// program becomes the edited program of the present project.
pub fn open(present: &Project, name: &str, text: &str) -> Opened {
    if text.trim_start().starts_with('{') {
        let loaded = Project::from_json(text);
        return Opened { project: loaded.project, diagnostics: loaded.diagnostics };
    }
    let opened = |project, diagnostics| Opened { project, diagnostics };
    let file = File { name: name.to_owned(), text: text.to_owned() };
    let edited = match programs(std::slice::from_ref(&file)) {
        Ok(files) => files,
        Err(finding) => return opened(None, vec![finding]),
    };
    let form = settings::read(text)
        .and_then(|found| Some((machines::find(found.machine)?, controls::find(found.control)?, found.values)));
    if let Some((machine, control, values)) = form {
        let mut project = Project::new(machine, control);
        project.name.clone_from(&present.name);
        project.values = machine.fields().iter().map(|field| (field.id.to_owned(), field.default())).collect();
        project.values.extend(values);
        if present.control.id == control.id {
            project.switches.clone_from(&present.switches);
        }
        project.edited = differing(&project, name, text);
        let told = if project.edited.is_some() {
            msg!("project.form-restored-edited", name)
        } else {
            msg!("project.form-restored", name)
        };
        return opened(Some(project), vec![Diagnostic::info(told)]);
    }
    let mut project = present.clone();
    project.edited = Some(edited);
    opened(Some(project), Vec::new())
}

/// Programs as the edited files of a project; an error where they are too many or too large, and then none is taken.
pub fn programs(files: &[File]) -> Result<Files, Diagnostic> {
    let bytes: usize = files.iter().map(|file| file.text.len()).sum();
    if files.len() > MAX_PROGRAMS {
        let message = msg!("project.too-many-programs", files.len() as u32, MAX_PROGRAMS as u32);
        return Err(Diagnostic::error(message));
    }
    if bytes > MAX_PROGRAM {
        let message = msg!("project.program-too-large", (bytes as f64 / 1e6, 1), (MAX_PROGRAM as f64 / 1e6, 0));
        return Err(Diagnostic::error(message));
    }
    Ok(Files(files.to_vec()))
}

/// The project's files with this text in its place, if the text was edited since macroline wrote it; else `None`.
fn differing(project: &Project, name: &str, text: &str) -> Option<Files> {
    let mut files = project.written().files;
    let number = |text: &str| {
        nc::parse_with(&Files::one("", text), project.control, &project.switches)
            .deck()
            .programs
            .first()
            .map(|p| p.number)
    };
    let own = number(text);
    let slot = files.0.iter().position(|file| number(&file.text) == own);
    // Line ends and the version of macroline are no edits.
    let lines = |text: &str| -> Vec<String> {
        text.lines()
            .filter(|line| !line.contains("WRITTEN BY MACROLINE"))
            .map(|line| line.trim_end().to_owned())
            .collect()
    };
    match slot.and_then(|at| files.0.get_mut(at)) {
        Some(file) if lines(&file.text) == lines(text) => return None,
        Some(file) => text.clone_into(&mut file.text),
        None => files.0.push(File { name: name.to_owned(), text: text.to_owned() }),
    }
    Some(files)
}
