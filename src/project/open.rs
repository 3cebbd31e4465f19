//! What a dropped, pasted or opened text is: a project, a program that macroline wrote, or any other program.

use super::Project;
use crate::controls;
use crate::machines::{self, settings};
use crate::msg;
use crate::nc::{File, Files};
use crate::text::Diagnostic;

/// Bytes of a program that is taken into a project at most; larger ones are only looked at.
pub const MAX_PROGRAM: usize = 2_000_000;

/// What a text came to.
pub struct Opened {
    /// The project to go on with; `None` where nothing could be made of the text.
    pub project: Option<Project>,
    /// Why, or what was left out.
    pub diagnostics: Vec<Diagnostic>,
}

/// Opens a text beside the present project: a project file replaces it, a program that macroline wrote restores its form, any other
/// program becomes the edited program of the present project.
pub fn open(present: &Project, name: &str, text: &str) -> Opened {
    if text.trim_start().starts_with('{') {
        let loaded = Project::from_json(text);
        return Opened { project: loaded.project, diagnostics: loaded.diagnostics };
    }
    if text.len() > MAX_PROGRAM {
        let message = msg!("project.program-too-large", (text.len() as f64 / 1e6, 1), (MAX_PROGRAM as f64 / 1e6, 0));
        return Opened { project: None, diagnostics: vec![Diagnostic::error(message)] };
    }
    let found = settings::read(text, |id| machines::find(id).map(|machine| machine.fields()));
    if let Some((machine, values)) = found.and_then(|(id, values)| Some((machines::find(&id)?, values))) {
        let goes = machine.controls().contains(&present.control.id);
        let control =
            if goes { Some(present.control) } else { machine.controls().first().and_then(|id| controls::find(id)) };
        if let Some(control) = control {
            let mut project = Project::new(machine, control);
            project.name.clone_from(&present.name);
            project.values.extend(values);
            let told = Diagnostic::info(msg!("project.form-restored", name));
            return Opened { project: Some(project), diagnostics: vec![told] };
        }
    }
    let mut project = present.clone();
    project.edited = Some(Files(vec![File { name: name.to_owned(), text: text.to_owned() }]));
    Opened { project: Some(project), diagnostics: Vec::new() }
}
