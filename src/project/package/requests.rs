//! The requests of the package: read from JSON, and checked.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::value::RawValue;

use crate::motion::{Budget, Panel, Retention};
use crate::msg;
use crate::nc::{File, Files};
use crate::project::chance::{Chance, SEED, chance};
use crate::project::files::json::reason;
use crate::project::findings::file_findings::{FileFindings, FileRead, Sources};
use crate::project::requests::check_request::{self, Choices, ProgramSource, Refused};
use crate::project::requests::run_request::{BUDGET, RunRequest};
use crate::project::run::{AtStop, Setting};
use crate::project::{Project, saved};
use crate::text::Diagnostic;

/// Reads a request.
pub(super) fn read<'t, T: Deserialize<'t>>(text: &'t str) -> Result<T, Refused> {
    serde_json::from_str(text).map_err(|error| msg!("request.shape", reason = reason(&error)).into())
}

/// Reads the request of a function: an object.
pub(super) fn read_request<'t, T: Deserialize<'t>>(text: &'t str) -> Result<T, Refused> {
    // serde would accept a list in place of a struct.
    read::<BTreeMap<String, IgnoredAny>>(text)?;
    read(text)
}

/// A text of JSON that is itself given as JSON, or as the text of a file.
#[derive(Deserialize)]
pub(super) struct JsonOrText<'t>(#[serde(borrow)] &'t RawValue);

impl JsonOrText<'_> {
    /// The JSON, or the text where a text is given.
    fn text(&self) -> String {
        serde_json::from_str(self.0.get()).unwrap_or_else(|_| self.0.get().to_owned())
    }

    /// Reads it as a file of this name.
    fn file<T>(&self, name: &str, from: impl Fn(&str) -> (Option<T>, Vec<Diagnostic>)) -> FileRead<T> {
        let text = self.text();
        let (made, list) = from(&text);
        (made, FileFindings { sources: Sources::written(Files::one(name, text.as_str())), list })
    }

    fn project(&self) -> FileRead<Project> {
        self.file("project.json", |text| {
            let loaded = Project::from_json(text);
            (loaded.project, loaded.diagnostics)
        })
    }

    fn panel(&self) -> FileRead<Panel> {
        self.file("panel.json", |text| {
            let (panel, found) = saved::panel_from_json(text);
            (Some(panel), found)
        })
    }

    /// The project, unless its errors leave none.
    fn sound_project(&self) -> Result<(Project, FileFindings), Refused> {
        match self.project() {
            (Some(project), file) => Ok((project, file)),
            (None, file) => Err(Refused::Files(vec![file])),
        }
    }
}

/// A project, or programs with their control.
#[derive(Deserialize)]
pub(super) struct RequestSubject<'t>(#[serde(borrow)] JsonOrText<'t>);

/// Programs on a control.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Programs {
    control: String,
    files: Vec<ProgramFile>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ProgramFile {
    name: String,
    text: String,
}

/// Marker of programs: an object with `files` is no project.
#[derive(Deserialize)]
struct HasFiles {
    files: Option<IgnoredAny>,
}

impl RequestSubject<'_> {
    pub(super) fn read(&self) -> Result<ProgramSource, Refused> {
        let json = self.0.0.get();
        let has_files = serde_json::from_str::<HasFiles>(json).is_ok_and(|subject| subject.files.is_some());
        if !json.starts_with('{') || !has_files {
            return Ok(ProgramSource::Project(Box::new(self.0.project())));
        }
        let Programs { control, files } = read(json)?;
        check_request::few_files(files.len())?;
        let files = files.into_iter().map(|file| File { name: file.name, text: file.text });
        let sources = Sources::written(Files(files.collect()));
        Ok(ProgramSource::Programs(check_request::control(&control)?, FileFindings { sources, list: Vec::new() }))
    }
}

/// A request without arguments.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct NoRequest {}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct NewRequest {
    pub(super) machine: String,
    pub(super) control: Option<String>,
    pub(super) example: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ProjectRequest<'t> {
    #[serde(borrow)]
    project: JsonOrText<'t>,
}

impl ProjectRequest<'_> {
    pub(super) fn project(&self) -> Result<(Project, FileFindings), Refused> {
        self.project.sound_project()
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SizeRequest<'t> {
    #[serde(borrow)]
    project: JsonOrText<'t>,
    draws: Option<u32>,
    seed: Option<u64>,
}

impl SizeRequest<'_> {
    pub(super) fn project(&self) -> Result<(Project, FileFindings), Refused> {
        self.project.sound_project()
    }

    /// Chance by the requested draws.
    pub(super) fn chance(&self, project: &Project) -> Option<Chance> {
        let draws = self.draws.filter(|draws| *draws > 0)?;
        Some(chance(project, draws, self.seed.unwrap_or(SEED)))
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ExportRequest<'t> {
    #[serde(borrow)]
    project: JsonOrText<'t>,
    date: Option<String>,
}

impl ExportRequest<'_> {
    pub(super) fn project(&self) -> Result<(Project, FileFindings), Refused> {
        self.project.sound_project()
    }

    pub(super) fn date(&self) -> &str {
        self.date.as_deref().unwrap_or_default()
    }
}

/// Switches by id, and ids of warnings that are left out.
#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields, default)]
pub(super) struct GivenChoices {
    switches: BTreeMap<String, String>,
    silence: Vec<String>,
}

impl GivenChoices {
    pub(super) fn choices(&self) -> Choices {
        let switches = self.switches.iter().map(|(id, value)| (id.clone(), value.clone())).collect();
        Choices { switches, silenced: self.silence.clone() }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CheckRequest<'t> {
    #[serde(borrow)]
    pub(super) subject: RequestSubject<'t>,
    #[serde(default)]
    pub(super) choices: GivenChoices,
}

/// Arguments of a run: project or programs, panel, start, and budget.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RunArguments<'t> {
    #[serde(borrow)]
    subject: RequestSubject<'t>,
    #[serde(default)]
    choices: GivenChoices,
    #[serde(borrow)]
    plant: Option<JsonOrText<'t>>,
    #[serde(borrow)]
    panel: Option<JsonOrText<'t>>,
    start: Option<String>,
    #[serde(default)]
    set: BTreeMap<String, f64>,
    blocks: Option<f64>,
    seconds: Option<f64>,
    #[serde(rename = "continue", default)]
    goes_on: bool,
    canon: Option<bool>,
}

/// Variables and inputs by name.
fn settings(set: &BTreeMap<String, f64>) -> Result<Vec<Setting>, Refused> {
    let setting = |(name, value): (&String, &f64)| Setting::new(name, *value);
    let all: Option<Vec<Setting>> = set.iter().map(setting).collect();
    all.ok_or_else(|| msg!("request.setting").into())
}

impl RunArguments<'_> {
    pub(super) fn at_stop(&self) -> AtStop {
        if self.goes_on { AtStop::CycleStart } else { AtStop::End }
    }

    /// Whether the request wants the log in the answer.
    pub(super) fn is_logged(&self) -> bool {
        self.canon.unwrap_or(true)
    }

    pub(super) fn request(self, keep: Retention) -> Result<RunRequest, Refused> {
        let limits = Budget {
            blocks: self.blocks.map_or(BUDGET.blocks, |blocks| blocks as u64),
            seconds: self.seconds.unwrap_or(BUDGET.seconds),
        };
        Ok(RunRequest {
            subject: self.subject.read()?,
            plant: self.plant.map(|project| project.project()),
            panel: self.panel.map(|panel| panel.panel()).unwrap_or_default(),
            settings: settings(&self.set)?,
            start: self.start,
            choices: self.choices.choices(),
            limits,
            keep,
        })
    }
}

/// A program for a machine at rest.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct InterpretRequest<'t> {
    #[serde(borrow)]
    pub(super) subject: RequestSubject<'t>,
    #[serde(default)]
    pub(super) choices: GivenChoices,
    pub(super) start: Option<String>,
    #[serde(default)]
    set: BTreeMap<String, f64>,
    /// Positions of axes by letter, mm or degrees.
    #[serde(default)]
    pub(super) positions: BTreeMap<String, f64>,
    blocks: Option<f64>,
}

impl InterpretRequest<'_> {
    pub(super) fn settings(&self) -> Result<Vec<Setting>, Refused> {
        settings(&self.set)
    }

    pub(super) fn blocks(&self) -> u64 {
        self.blocks.map_or(BUDGET.blocks, |blocks| blocks as u64)
    }
}
