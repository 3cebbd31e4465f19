//! Runs that a shell requests, at once or by steps: of a project, or of bare programs on the control's bench.

use std::rc::Rc;

use serde_json::Value as Json;

use super::check_request::{Choices, ProgramSource, Refused};
use crate::controls::{Control, Dialect, Switches};
use crate::interp::StartProgram;
use crate::interp::canon::Line;
use crate::motion::{Budget, Panel, Retention, RunEnd};
use crate::msg;
use crate::nc;
use crate::project::Project;
use crate::project::findings::check::{not_reached, review, with_run};
use crate::project::findings::file_findings::{FileFindings, FileRead, Sources, list_json};
use crate::project::findings::silence::silence;
use crate::project::origins;
use crate::project::run::{self, AtStop, Run, RunOptions, RunSummary, Setting};
use crate::text::{Diagnostic, Message};

/// Default budget of a run: blocks, and seconds of machine time.
pub const BUDGET: Budget = Budget { blocks: 10_000_000, seconds: 3600.0 };

/// Request of a run.
pub struct RunRequest {
    /// Project or programs to run.
    pub subject: ProgramSource,
    /// Project whose plant runs bare programs, instead of the control's bench.
    pub plant: Option<FileRead<Project>>,
    /// Events of the operator, beside those of a project.
    pub panel: FileRead<Panel>,
    /// Program to start, as its name is written.
    pub start: Option<String>,
    /// Variables and inputs that are set before the start.
    pub settings: Vec<Setting>,
    /// Switches, and warnings that are left out.
    pub choices: Choices,
    /// Budget of the run.
    pub limits: Budget,
    /// Records of the run that are kept.
    pub keep: Retention,
}

/// A run before its start.
pub struct ReadyRun {
    /// The run.
    pub run: Run,
    /// The program that runs.
    pub parsed: Rc<nc::Parsed>,
    /// Findings about project and panel files.
    pub files: Vec<FileFindings>,
    /// Findings about the program.
    pub program: FileFindings,
    /// Ids of warnings that are left out.
    pub silenced: Vec<String>,
    /// Names of the axes that the PLC turns.
    turned: &'static [&'static str],
}

/// A run at its end.
pub struct FinishedRun {
    /// Reason of the end, and final state of the machine.
    pub summary: RunSummary,
    /// Diagnostics by their files: of reading and of the run.
    pub findings: Vec<FileFindings>,
    /// Number of warnings that were left out.
    pub silenced: usize,
}

/// The program of a name, if one is given.
pub(in crate::project) fn program_of_name(
    name: Option<&str>,
    parsed: &nc::Parsed,
) -> Result<Option<StartProgram>, Message> {
    let Some(name) = name else { return Ok(None) };
    run::program_meant(name, parsed).map(Some).ok_or_else(|| msg!("request.start", program = name))
}

/// Refuses variables and inputs that cannot be set on this control.
fn settable(settings: &[Setting], control: &Control, dialect: &Dialect) -> Result<(), Message> {
    match settings.iter().find(|setting| setting.action(control, dialect).is_none()) {
        Some(setting) => Err(msg!("request.not-settable", name = setting.name.as_str())),
        None => Ok(()),
    }
}

impl RunRequest {
    /// Reads the program and makes its run.
    pub fn ready(self) -> Result<ReadyRun, Refused> {
        if self.limits.seconds.is_nan() || self.limits.seconds < 0.0 {
            return Err(msg!("request.seconds").into());
        }
        let silenced = self.choices.known_silenced()?;
        let RunRequest { subject, plant, panel: (panel, panel_file), start, settings, choices, limits, keep } = self;
        let operated = OperatorInputs { panel: panel.unwrap_or_default(), start, settings, choices, limits, keep };
        let files = vec![panel_file];
        match subject {
            ProgramSource::Project(read) => operated.project(*read, files, silenced),
            ProgramSource::Programs(control, program) => operated.programs((control, program), plant, files, silenced),
        }
    }
}

/// Actions, settings and choices of the operator.
struct OperatorInputs {
    panel: Panel,
    start: Option<String>,
    settings: Vec<Setting>,
    choices: Choices,
    limits: Budget,
    keep: Retention,
}

impl OperatorInputs {
    fn options(&self, start: Option<StartProgram>) -> RunOptions<'_> {
        RunOptions { start, settings: &self.settings, limits: self.limits, keep: self.keep }
    }

    /// The run of a project; `files` are findings about earlier files, `silenced` the silenced ids.
    fn project(
        &self,
        (project, file): FileRead<Project>,
        mut files: Vec<FileFindings>,
        mut silenced: Vec<String>,
    ) -> Result<ReadyRun, Refused> {
        files.push(file);
        let Some(mut project) = project else { return Err(Refused::Files(files)) };
        project.switches = self.choices.switched(project.switches, project.control)?;
        project.panel = Panel::new(project.panel.events().iter().chain(self.panel.events()).cloned());
        let mut list = origins::findings(&project);
        let written = project.written();
        settable(&self.settings, project.control, written.parsed.dialect())?;
        list.extend(written.diagnostics.iter().cloned());
        list.extend(project.advice(&written));
        Diagnostic::in_order(&mut list);
        silenced.extend(project.silenced.iter().cloned());
        let start = program_of_name(self.start.as_deref(), &written.parsed)?;
        let run = run::of_project(&project, &written, &self.options(start));
        let program = FileFindings { sources: Sources::written(written.files.clone()), list };
        let turned = project.prepared().turned_axes();
        Ok(ReadyRun { run, parsed: Rc::clone(&written.parsed), files, program, silenced, turned })
    }

    /// The run of bare programs on a control: on its bench, or on the plant of a project.
    fn programs(
        &self,
        (control, mut program): (&'static Control, FileFindings),
        plant: Option<FileRead<Project>>,
        mut files: Vec<FileFindings>,
        mut silenced: Vec<String>,
    ) -> Result<ReadyRun, Refused> {
        let plant = match plant {
            None => None,
            Some((project, file)) => {
                files.push(file);
                let Some(project) = project else { return Err(Refused::Files(files)) };
                silenced.extend(project.silenced.iter().cloned());
                Some(project)
            }
        };
        let switches = plant.as_ref().map_or_else(Switches::default, |project| project.switches.clone());
        let switches = self.choices.switched(switches, control)?;
        program.sources.read_in(Dialect::resolve(control, &switches).comment_characters());
        let parsed = Rc::new(nc::parse_with(&program.sources.files, control, &switches));
        settable(&self.settings, control, parsed.dialect())?;
        let start = program_of_name(self.start.as_deref(), &parsed)?;
        let programs = &parsed.deck().programs;
        let number = match start {
            Some(StartProgram::Program(number)) => Some(number),
            Some(StartProgram::Nth(at)) => programs.get(at as usize).map(|program| program.number),
            _ => programs.first().map(|program| program.number),
        };
        let set = run::set_by_operator(&self.settings, &self.panel, control);
        program.list.extend(review(&parsed, number, &set));
        let run = run::of_programs(Rc::clone(&parsed), plant.as_ref(), self.panel.clone(), &self.options(start));
        let turned = plant.as_ref().map_or(&[][..], |project| project.prepared().turned_axes());
        Ok(ReadyRun { run, parsed, files, program, silenced, turned })
    }
}

impl ReadyRun {
    /// Runs to the end and hands every command, as a line of the canonical log, to `log` as it begins. Fails only where `log` does.
    pub fn to_end<E>(self, at_stop: AtStop, log: impl FnMut(Line) -> Result<(), E>) -> Result<FinishedRun, E> {
        let ReadyRun { mut run, parsed, mut files, mut program, silenced, turned } = self;
        let summary = run::to_end(&mut run, at_stop, log)?.with_turned(turned);
        program.list = with_run(program.list, &summary.diagnostics);
        if !matches!(summary.ended, RunEnd::Alarm(_)) {
            not_reached(&mut program.list, &parsed, &summary.diagnostics);
        }
        let silenced = silence(&mut program.list, &silenced);
        files.push(program);
        Ok(FinishedRun { summary, findings: files, silenced })
    }
}

impl FinishedRun {
    /// The end as an object, with its diagnostics, and with the log where it is given.
    pub fn json(&self, canon: Option<Vec<Json>>) -> Json {
        let mut object = self.summary.json();
        object["diagnostics"] = list_json(&self.findings);
        if let Some(canon) = canon {
            object["canon"] = Json::Array(canon);
        }
        object
    }
}
