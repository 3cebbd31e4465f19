//! The control that programs are read for: named by the command line, else by the editor's settings, else by the folder.

use std::path::Path;

use macroline::controls::{Control, Switches};
use macroline::machines::ControlContext;
use macroline::project::Project;
use macroline::project::import::restored;
use macroline::project::meaning::Words;
use macroline::project::requests::check_request::{Choices, control};
use macroline::project::run::set_by_operator;
use macroline::text::Message;
use serde_json::Value as Json;

use crate::input;
use crate::output::{Failure, refuse};

/// File of a project beside its programs, as an export writes it.
const PROJECT: &str = "project.json";

/// A control with its settings, and the machine where there is one.
#[derive(Clone)]
pub(super) struct ControlSetup {
    pub(super) control: &'static Control,
    pub(super) switches: Switches,
    /// Ids of warnings that are left out.
    pub(super) silenced: Vec<String>,
    project: Option<Project>,
}

impl ControlSetup {
    /// Setup from the ids and the project file of the command line; `None` if neither is named.
    pub(super) fn asked(
        id: Option<&str>,
        project: Option<&Path>,
        choices: &Choices,
    ) -> Result<Option<ControlSetup>, Failure> {
        let usage = |message: Message| Failure::usage(&message);
        let mut setup = match (id, project) {
            (Some(id), _) => ControlSetup {
                control: control(id).map_err(usage)?,
                switches: Switches::default(),
                silenced: Vec::new(),
                project: None,
            },
            (None, Some(path)) => {
                let (project, file) = input::project(path)?;
                ControlSetup::of(project.ok_or_else(|| refuse(&[file], false))?)
            }
            (None, None) => return Ok(None),
        };
        setup.switches = choices.switched(setup.switches, setup.control).map_err(usage)?;
        if let Some(project) = &mut setup.project {
            project.switches = setup.switches.clone();
        }
        setup.silenced.extend(choices.known_silenced().map_err(usage)?);
        Ok(Some(setup))
    }

    /// Setup from the settings of an editor: `control`, `project`, `switches`, `silence`.
    pub(super) fn of_settings(settings: &Json) -> Result<Option<ControlSetup>, Failure> {
        let text = |name: &str| settings.get(name).and_then(Json::as_str).filter(|text| !text.is_empty());
        let switches = settings.get("switches").and_then(Json::as_object).into_iter().flatten();
        let switches = switches.filter_map(|(id, value)| Some((id.clone(), value.as_str()?.to_owned()))).collect();
        let silenced = settings.get("silence").and_then(Json::as_array).into_iter().flatten();
        let silenced = silenced.filter_map(|id| Some(id.as_str()?.to_owned())).collect();
        ControlSetup::asked(text("control"), text("project").map(Path::new), &Choices { switches, silenced })
    }

    /// The project file of a folder.
    pub(super) fn of_folder(folder: &Path) -> Option<ControlSetup> {
        let path = folder.join(PROJECT);
        let file = path.is_file().then(|| input::project(&path).ok())?;
        Some(ControlSetup::of(file?.0?))
    }

    /// Setup from the project in the header comment of a program that macroline wrote.
    pub(super) fn of_program(text: &str) -> Option<ControlSetup> {
        restored(text).map(ControlSetup::of)
    }

    fn of(project: Project) -> ControlSetup {
        ControlSetup {
            control: project.control,
            switches: project.switches.clone(),
            silenced: project.silenced.clone(),
            project: Some(project),
        }
    }

    /// The tables that words are looked up in.
    pub(super) fn words(&self) -> Words<'_> {
        match &self.project {
            Some(project) => Words::of(project),
            None => Words::bare(ControlContext { control: self.control, switches: &self.switches }),
        }
    }

    /// Variables that the operator sets.
    pub(super) fn set_by_operator(&self) -> Vec<u32> {
        self.project.as_ref().map_or_else(Vec::new, |project| set_by_operator(&[], &project.panel, self.control))
    }
}
