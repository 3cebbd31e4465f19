//! Running and stepping: a project, or bare programs on the control's bench.

use std::io::{self, IsTerminal};
use std::rc::Rc;

use macroline::controls::{Control, Dialect, Switches};
use macroline::interp::StartProgram;
use macroline::motion::{Budget, Panel, Retention, RunEnd};
use macroline::msg;
use macroline::nc;
use macroline::project::check::{not_reached, review, with_run};
use macroline::project::console::{Console, Outcome};
use macroline::project::run::{self, AtStop, Run, RunOptions, Setting};
use macroline::project::suppress::silence;
use macroline::text::Diagnostic;
use serde_json::{Value as Json, json};

use crate::args::RunArgs;
use crate::findings::{Findings, Sources, list_json};
use crate::input;
use crate::output::{Failure, Printer, refuse, say, tell, verdict};
use crate::requested::{control, known, only_project, switched, tell_silenced};

/// A run before its start.
struct Prepared {
    run: Run,
    /// The program that runs.
    parsed: Rc<nc::Parsed>,
    /// Findings about project and panel files.
    files: Vec<Findings>,
    /// Findings about the program.
    program: Findings,
    /// Ids of warnings that are left out.
    silenced: Vec<String>,
    /// Names of the axes that the PLC turns.
    turned: &'static [&'static str],
}

/// Variables and inputs that can be set on this control.
fn settable(settings: &[Setting], control: &Control, dialect: &Dialect) -> Result<(), Failure> {
    match settings.iter().find(|setting| setting.action(control, dialect).is_none()) {
        Some(setting) => Err(Failure::usage(&msg!("cli.not-settable", setting.name.as_str()))),
        None => Ok(()),
    }
}

/// Arguments of a run, read and checked as far as no program is needed.
struct Request<'a> {
    args: &'a RunArgs,
    panel: Panel,
    settings: Vec<Setting>,
    keep: Retention,
    json: bool,
}

impl Request<'_> {
    /// The program of `--start`, if it is given.
    fn start(&self, parsed: &nc::Parsed) -> Result<Option<StartProgram>, Failure> {
        let Some(name) = self.args.start.as_deref() else { return Ok(None) };
        let meant = run::program_meant(name, parsed);
        meant.map(Some).ok_or_else(|| Failure::usage(&msg!("cli.start", name)))
    }

    fn options(&self, start: Option<StartProgram>) -> RunOptions<'_> {
        let limits = Budget { blocks: self.args.blocks, seconds: self.args.seconds };
        RunOptions { start, settings: &self.settings, limits, keep: self.keep }
    }

    /// The run of a project file; `files` are findings about earlier files, `silenced` the suppressed ids.
    fn project(&self, mut files: Vec<Findings>, mut silenced: Vec<String>) -> Result<Prepared, Failure> {
        let (project, file) = input::project(only_project(&self.args.files)?)?;
        files.push(file);
        let Some(mut project) = project else { return Err(refuse(&files, self.json)) };
        project.switches = switched(project.switches, &self.args.switch, project.control)?;
        project.panel = Panel::new(project.panel.events().iter().chain(self.panel.events()).cloned());
        let mut list = project.design().diagnostics;
        let written = project.written();
        settable(&self.settings, project.control, written.parsed.dialect())?;
        list.extend(written.diagnostics.iter().cloned());
        list.extend(project.advice(&written));
        Diagnostic::in_order(&mut list);
        silenced.extend(project.silenced.iter().cloned());
        let run = run::of_project(&project, &written, &self.options(self.start(&written.parsed)?));
        let program = Findings { sources: Sources::written(written.files.clone()), list };
        let turned = project.prepared().turned_axes();
        Ok(Prepared { run, parsed: Rc::clone(&written.parsed), files, program, silenced, turned })
    }

    /// The run of bare programs on a control: on its bench, or on the plant of a project.
    fn programs(
        &self,
        control: &'static Control,
        mut files: Vec<Findings>,
        mut silenced: Vec<String>,
    ) -> Result<Prepared, Failure> {
        let plant = match &self.args.plant {
            None => None,
            Some(path) => {
                let (project, file) = input::project(path)?;
                files.push(file);
                let Some(project) = project else { return Err(refuse(&files, self.json)) };
                silenced.extend(project.silenced.iter().cloned());
                Some(project)
            }
        };
        let switches = plant.as_ref().map_or_else(Switches::default, |project| project.switches.clone());
        let switches = switched(switches, &self.args.switch, control)?;
        let mut program = input::programs(&self.args.files, self.json)?;
        let parsed = Rc::new(nc::parse_with(&program.sources.files, control, &switches));
        settable(&self.settings, control, parsed.dialect())?;
        let start = self.start(&parsed)?;
        let programs = &parsed.deck().programs;
        let started = match start {
            Some(StartProgram::Program(number)) => Some(number),
            Some(StartProgram::Nth(at)) => programs.get(at as usize).map(|program| program.number),
            _ => programs.first().map(|program| program.number),
        };
        let set = run::set_by_operator(&self.settings, &self.panel, control);
        program.list.extend(review(&parsed, started, &set));
        let run = run::of_programs(Rc::clone(&parsed), plant.as_ref(), self.panel.clone(), &self.options(start));
        let turned = plant.as_ref().map_or(&[][..], |project| project.prepared().turned_axes());
        Ok(Prepared { run, parsed, files, program, silenced, turned })
    }
}

fn prepare(args: &RunArgs, keep: Retention, json: bool) -> Result<Prepared, Failure> {
    if args.seconds.is_nan() || args.seconds < 0.0 {
        return Err(Failure::usage(&msg!("cli.seconds")));
    }
    let silenced = known(&args.silence)?;
    let mut files = Vec::new();
    let panel = match &args.panel {
        None => Panel::default(),
        Some(path) => {
            let (panel, findings) = input::panel(path)?;
            files.push(findings);
            panel
        }
    };
    let settings = args.set.iter().map(|text| Setting::read(text)).collect::<Option<Vec<_>>>();
    let Some(settings) = settings else {
        return Err(Failure::usage(&msg!("cli.set")));
    };
    let request = Request { args, panel, settings, keep, json };
    match &args.control {
        None => request.project(files, silenced),
        Some(id) => request.programs(control(id)?, files, silenced),
    }
}

/// Runs to the end; prints the log where it is `wanted`.
pub(crate) fn run(args: &RunArgs, at_stop: AtStop, wanted: bool, json: bool) -> Result<(), Failure> {
    let Prepared { run: mut planner, parsed, mut files, mut program, silenced, turned } =
        prepare(args, Retention::Log, json)?;
    let mut out = Printer::new();
    let mut canon: Vec<Json> = Vec::new();
    let mut text = String::new();
    let outcome = run::to_end(&mut planner, at_stop, |line| {
        if !wanted {
            return Ok(());
        }
        text.clear();
        // Writing to a string never fails.
        let _ = line.write(&mut text);
        if json {
            canon.push(json!(text));
            return Ok(());
        }
        text.push('\n');
        out.text(&text)
    })?;
    let outcome = outcome.with_turned(turned);
    program.list = with_run(program.list, &outcome.diagnostics);
    if !matches!(outcome.ended, RunEnd::Alarm(_)) {
        not_reached(&mut program.list, &parsed, &outcome.diagnostics);
    }
    let count = silence(&mut program.list, &silenced);
    files.push(program);
    if json {
        let mut object = outcome.json();
        object["diagnostics"] = list_json(&files);
        if wanted {
            object["canon"] = Json::Array(canon);
        }
        out.json(&object)?;
    }
    out.flush()?;
    if !json {
        tell(&files)?;
        tell_silenced(count)?;
        say(&(outcome.text() + "\n"))?;
    }
    verdict(&files)?;
    match outcome.ended {
        RunEnd::Blocks | RunEnd::Seconds => Err(Failure::Exhausted),
        RunEnd::Stop => Err(Failure::Waits),
        RunEnd::ProgramEnd | RunEnd::Alarm(_) => Ok(()),
    }
}

/// Steps from block to block. Wrong commands are reported and make the exit status 2.
pub(crate) fn step(args: &RunArgs) -> Result<(), Failure> {
    let Prepared { run, mut files, mut program, silenced, .. } = prepare(args, Retention::Both, false)?;
    let count = silence(&mut program.list, &silenced);
    files.push(program);
    tell(&files)?;
    tell_silenced(count)?;
    let terminal = io::stdin().is_terminal();
    let Some(program) = files.last() else { return Ok(()) };
    let mut console = Console::new(run, program.sources.renderer());
    let mut out = Printer::new();
    let mut wrong: u32 = 0;
    let mut last = String::new();
    out.text(&console.place())?;
    out.flush()?;
    for line in prompted(terminal) {
        let line = line?;
        // On a terminal an empty line repeats the last command.
        let line = if terminal && line.trim().is_empty() { last } else { line };
        let (said, answer) = console.line(&line);
        out.text(&answer)?;
        out.flush()?;
        match said {
            Outcome::Quit => break,
            Outcome::Wrong => wrong += 1,
            Outcome::Done => {}
        }
        last = line;
    }
    let found = Findings { sources: Sources::default(), list: console.diagnostics().to_vec() };
    if wrong > 0 && !terminal {
        return Err(Failure::usage(&msg!("cli.commands-failed", wrong)));
    }
    files.push(found);
    verdict(&files)
}

/// The lines of standard input, each asked for where a person types them.
fn prompted(terminal: bool) -> impl Iterator<Item = io::Result<String>> {
    let mut lines = io::stdin().lines();
    std::iter::from_fn(move || {
        if terminal {
            let _ = say("> ");
        }
        lines.next()
    })
}
