//! Checks that a shell requests: of a project or of bare programs, with choices that are checked against the control.

use std::rc::Rc;

use crate::controls::{self, Control, Dialect, Switches};
use crate::msg;
use crate::nc;
use crate::project::Project;
use crate::project::findings::check::review;
use crate::project::findings::file_findings::{FileFindings, FileRead, Sources};
use crate::project::findings::silence::silence;
use crate::project::list;
use crate::project::origins;
use crate::text::{Diagnostic, Message, catalog, listed};

/// Reason for refusing a request.
pub enum Refused {
    /// A choice is wrong.
    Choice(Message),
    /// A file has errors.
    Files(Vec<FileFindings>),
}

impl From<Message> for Refused {
    fn from(message: Message) -> Refused {
        Refused::Choice(message)
    }
}

/// Source of the programs to check or to run.
pub enum ProgramSource {
    /// A project; none if its findings are errors.
    Project(Box<FileRead<Project>>),
    /// Bare programs on a control, with the findings of decoding them.
    Programs(&'static Control, FileFindings),
}

/// Choices of a check and of a run.
#[derive(Debug, Clone, Default)]
pub struct Choices {
    /// Settings of open points of the control, by id.
    pub switches: Vec<(String, String)>,
    /// Ids of warnings that are left out.
    pub silenced: Vec<String>,
}

impl Choices {
    /// The ids of the warnings that are left out, where there are warnings with these ids.
    pub fn known_silenced(&self) -> Result<Vec<String>, Message> {
        match self.silenced.iter().find(|id| catalog::id(id).is_none()) {
            Some(id) => Err(msg!("request.no-warning", id = id.as_str())),
            None => Ok(self.silenced.clone()),
        }
    }

    /// Switches of a control with the chosen settings.
    pub fn switched(&self, mut switches: Switches, control: &Control) -> Result<Switches, Message> {
        for (id, value) in &self.switches {
            let (id, value) = (id.as_str(), value.as_str());
            let Some(row) = control.switch(id) else {
                let known = control.switches.iter().map(|row| row.id());
                return Err(msg!("request.no-switch", control = control.name, switch = id, switches = listed(known)));
            };
            if !row.takes(value) {
                let values = list::switch_values(row);
                return Err(msg!("request.switch-value", switch = id, value, values));
            }
            switches.set(row, value);
        }
        Ok(switches)
    }
}

/// The control with this id.
pub fn control(id: &str) -> Result<&'static Control, Message> {
    controls::find(id).ok_or_else(|| {
        let known = controls::ALL.iter().map(|control| control.id);
        msg!("request.no-control", control = id, controls = listed(known))
    })
}

/// Refuses more files than a [`Place`](crate::text::Place) can number.
pub fn few_files(count: usize) -> Result<(), Message> {
    let most = usize::from(u16::MAX);
    if count > most { Err(msg!("request.too-many-files", count = count as u32, most = most as u32)) } else { Ok(()) }
}

/// Diagnostics of a check, and how many warnings were left out.
pub struct Checked {
    /// Diagnostics by their files.
    pub findings: Vec<FileFindings>,
    /// Number of warnings that were left out.
    pub silenced: usize,
}

/// Diagnostics of programs or of a project, nothing run.
pub fn check(subject: ProgramSource, choices: &Choices) -> Result<Checked, Refused> {
    let mut silenced = choices.known_silenced()?;
    let mut findings = match subject {
        ProgramSource::Programs(control, mut programs) => {
            let switches = choices.switched(Switches::default(), control)?;
            programs.sources.read_in(Dialect::resolve(control, &switches).comment_characters());
            let parsed = Rc::new(nc::parse_with(&programs.sources.files, control, &switches));
            programs.list.extend(review(&parsed, None, &[]));
            vec![programs]
        }
        ProgramSource::Project(read) => {
            let (project, mut file) = *read;
            let Some(mut project) = project else { return Err(Refused::Files(vec![file])) };
            project.switches = choices.switched(project.switches, project.control)?;
            // Findings about the form are at places in the file of the project.
            file.list.extend(origins::findings(&project));
            let written = project.written();
            let mut list = project.advice(&written);
            list.extend(written.diagnostics);
            Diagnostic::in_order(&mut list);
            silenced.extend(project.silenced);
            vec![file, FileFindings { sources: Sources::written(written.files), list }]
        }
    };
    let count = findings.iter_mut().map(|findings| silence(&mut findings.list, &silenced)).sum();
    Ok(Checked { findings, silenced: count })
}
