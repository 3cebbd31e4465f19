//! Running and stepping: a project, or bare programs on the control's bench.

use std::io::{self, IsTerminal};

use macroline::motion::{Budget, Retention, RunEnd};
use macroline::msg;
use macroline::project::debugger::console::{Console, Outcome};
use macroline::project::findings::file_findings::{FileFindings, Sources};
use macroline::project::findings::silence::silence;
use macroline::project::requests::run_request::{ReadyRun, RunRequest};
use macroline::project::run::{AtStop, Setting};
use serde_json::{Value as Json, json};

use crate::args::RunArgs;
use crate::input;
use crate::output::{Failure, Printer, fail_on_errors, print_error, print_findings, refused, tell_silenced};

fn ready(args: &RunArgs, keep: Retention, json: bool) -> Result<ReadyRun, Failure> {
    let settings = args.set.iter().map(|text| Setting::read(text)).collect::<Option<Vec<_>>>();
    let request = RunRequest {
        subject: input::subject(&args.files, args.control.as_deref(), json)?,
        plant: args.plant.as_deref().map(input::project).transpose()?,
        panel: args.panel.as_deref().map(input::panel).transpose()?.unwrap_or_default(),
        start: args.start.clone(),
        settings: settings.ok_or_else(|| Failure::usage(&msg!("request.setting")))?,
        choices: input::choices(&args.switch, &args.silence)?,
        limits: Budget { blocks: args.blocks, seconds: args.seconds },
        keep,
    };
    request.ready().map_err(|why| refused(why, json))
}

/// Runs to the end; prints the log if it is requested.
pub(crate) fn run(args: &RunArgs, at_stop: AtStop, wanted: bool, json: bool) -> Result<(), Failure> {
    let ready = ready(args, Retention::Log, json)?;
    let mut out = Printer::new();
    let mut canon: Vec<Json> = Vec::new();
    let mut text = String::new();
    let finished = ready.to_end(at_stop, |line| {
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
    if json {
        out.json(&finished.json(wanted.then_some(canon)))?;
    }
    out.flush()?;
    if !json {
        print_findings(&finished.findings)?;
        tell_silenced(finished.silenced)?;
        print_error(&(finished.summary.text() + "\n"))?;
    }
    fail_on_errors(&finished.findings)?;
    match finished.summary.ended {
        RunEnd::Blocks | RunEnd::Seconds => Err(Failure::Exhausted),
        RunEnd::Stop => Err(Failure::Waits),
        RunEnd::ProgramEnd | RunEnd::Alarm(_) => Ok(()),
    }
}

/// Steps from block to block. Wrong commands are reported and make the exit status 2.
pub(crate) fn step(args: &RunArgs) -> Result<(), Failure> {
    let ReadyRun { run, mut files, mut program, silenced, .. } = ready(args, Retention::Both, false)?;
    let count = silence(&mut program.list, &silenced);
    files.push(program);
    print_findings(&files)?;
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
        let (outcome, answer) = console.line(&line);
        out.text(&answer)?;
        out.flush()?;
        match outcome {
            Outcome::Quit => break,
            Outcome::Wrong => wrong += 1,
            Outcome::Done => {}
        }
        last = line;
    }
    let found = FileFindings { sources: Sources::default(), list: console.diagnostics().to_vec() };
    if wrong > 0 && !terminal {
        return Err(Failure::usage(&msg!("cli.commands-failed", count = wrong)));
    }
    files.push(found);
    fail_on_errors(&files)
}

/// The lines of standard input, each asked for where a person types them.
fn prompted(terminal: bool) -> impl Iterator<Item = io::Result<String>> {
    let mut lines = io::stdin().lines();
    std::iter::from_fn(move || {
        if terminal {
            let _ = print_error("> ");
        }
        lines.next()
    })
}
