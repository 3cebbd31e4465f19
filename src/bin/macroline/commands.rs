//! All commands except `run` and `step`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use macroline::controls::Control;
use macroline::machines;
use macroline::msg;
use macroline::project::chance::chance;
use macroline::project::findings::file_findings::list_json;
use macroline::project::findings::render::summary;
use macroline::project::help::texts::Texts;
use macroline::project::help::{Help, explain, pages};
use macroline::project::meaning::{Meaning, Subject, Table, Words};
use macroline::project::repairs::repairs;
use macroline::project::requests::check_request;
use macroline::project::run::AtStop;
use macroline::project::size::words::sheet_text;
use macroline::project::{Project, answers, drawing, list, origins, parts, variants};
use macroline::text::catalog::{self, words};
use macroline::text::units;
use macroline::view::Theme;
use macroline::view::svg::picture;

use crate::args::{Command, Format, Paper};
use crate::input;
use crate::language::{self, failed};
use crate::output::{
    self, Failure, fail_on_errors, print, print_diagnostics, print_error, print_findings, print_json, refuse, refused,
    tell_silenced,
};
use crate::{export, lsp, pdf, run};

pub(crate) fn main() -> ExitCode {
    let line = match language::line() {
        Ok(line) => line,
        Err(status) => return status,
    };
    if !line.command.is_for_programs() {
        units::show(line.lengths.into());
    }
    output::status(match line.command {
        Command::List { json: true } => print_json(&list::json()),
        Command::List { json: false } => print(&list::text()),
        Command::Parts { table, control, add_to, json } => {
            parts(table.as_deref(), control.as_deref(), add_to.as_deref(), json)
        }
        Command::New { machine, control, example } => new(&machine, control.as_deref(), example.as_deref()),
        Command::Design { project, json } => design(&project, json),
        Command::Size { project, draws, seed, json } => size(&project, (draws, seed), json),
        Command::Compare { projects, json } => compare(&projects, json),
        Command::Export { project, out, date, pdf, browser, paper } => {
            export(&project, &out, &date, pdf.then_some((paper, browser.as_deref())))
        }
        Command::Draw { project, at, dark, out } => draw(&project, at, dark, &out),
        Command::Check { files, control, switch, silence, json, format } => {
            let format = if json { Format::Json } else { format };
            check(&files, control.as_deref(), &switch, &silence, format)
        }
        Command::Explain { word, project, control, json } => {
            explain(&word, project.as_deref(), control.as_deref(), json)
        }
        Command::Lsp { project, control, switch, silence } => {
            lsp::serve(control.as_deref(), project.as_deref(), &switch, &silence)
        }
        Command::Run { args, goes_on, no_canon, json } => {
            let at_stop = if goes_on { AtStop::CycleStart } else { AtStop::End };
            run::run(&args, at_stop, !no_canon, json)
        }
        Command::Step(args) => run::step(&args),
    })
}

impl Command {
    /// Whether the command prints JSON or CSV.
    fn is_for_programs(&self) -> bool {
        match self {
            Command::List { json }
            | Command::Parts { json, .. }
            | Command::Design { json, .. }
            | Command::Size { json, .. }
            | Command::Compare { json, .. }
            | Command::Explain { json, .. }
            | Command::Run { json, .. } => *json,
            Command::Check { json, format, .. } => *json || *format != Format::Text,
            Command::New { .. }
            | Command::Export { .. }
            | Command::Draw { .. }
            | Command::Lsp { .. }
            | Command::Step(_) => false,
        }
    }
}

/// The control with this id, if one is given; an error for an unknown id.
fn control(id: Option<&str>) -> Result<Option<&'static Control>, Failure> {
    id.map(check_request::control).transpose().map_err(|message| Failure::usage(&message))
}

fn parts(table: Option<&Path>, id: Option<&str>, into: Option<&Path>, json: bool) -> Result<(), Failure> {
    let control = control(id)?;
    let (read, mut all) = match table {
        Some(path) => {
            let (parts, file) = input::parts(path)?;
            (parts, vec![file])
        }
        None => (parts::shipped().to_vec(), Vec::new()),
    };
    match into {
        Some(path) => {
            let (project, file) = input::project(path)?;
            all.push(file);
            let Some(mut project) = project else { return Err(refuse(&all, false)) };
            project.add_parts(read);
            output::print_data(&project.to_json())?;
        }
        None => {
            let chosen = read.iter().filter(|part| control.is_none_or(|control| parts::goes_with(part, control)));
            output::print_data(&if json { parts::write_json(chosen) } else { parts::write(chosen) })?;
        }
    }
    print_findings(&all)?;
    fail_on_errors(&all)
}

fn new(machine: &str, control: Option<&str>, example: Option<&str>) -> Result<(), Failure> {
    let made = Project::named(machine, control, example);
    let project = made.map_err(|unknown| Failure::usage(&unknown.message(machine, control, example)))?;
    output::print_data(&project.to_json())?;
    print_error(&origins::faults_text(&project))
}

fn design(path: &Path, json: bool) -> Result<(), Failure> {
    let (project, file) = input::project(path)?;
    let Some(project) = project else { return Err(refuse(&[file], json)) };
    let (answer, all) = answers::design_with_findings(&project, file);
    if json {
        print_json(&answer)?;
    } else {
        let readouts = list::readouts_text(&project.design().readouts);
        let repairs = list::repairs_text(&repairs(&project));
        print(&(origins::faults_text(&project) + &readouts + &repairs + &origins::text(&project)))?;
        print_findings(&all)?;
    }
    fail_on_errors(&all)
}

fn size(path: &Path, (draws, seed): (u32, u64), json: bool) -> Result<(), Failure> {
    let (project, file) = input::project(path)?;
    let Some(project) = project else { return Err(refuse(&[file], json)) };
    let (sizing, all) = answers::size_with_findings(&project, file);
    let chance = (draws > 0).then(|| chance(&project, draws, seed));
    if json {
        print_json(&answers::sizing_json(&sizing, chance.as_ref(), &all))?;
    } else {
        print(&(sizing.text() + &chance.map_or(String::new(), |chance| sheet_text(&chance.sheet(), usize::MAX))))?;
        print_findings(&all)?;
    }
    fail_on_errors(&all)
}

fn compare(paths: &[PathBuf], json: bool) -> Result<(), Failure> {
    let (mut variants, mut all) = (Vec::new(), Vec::new());
    for path in paths {
        let (project, file) = input::project(path)?;
        all.push(file);
        let Some(project) = project else { return Err(refuse(&all, json)) };
        let file = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        variants.push((if project.name.is_empty() { file } else { project.name.clone() }, project));
    }
    let comparison = match variants.as_slice() {
        [(_, alone)] => {
            alone.compared_variants(words("variants.now")).ok_or_else(|| Failure::usage(&msg!("cli.compare")))?
        }
        _ => variants::compare(&variants),
    };
    if json {
        let mut answer = variants::comparison_json(&comparison);
        answer["diagnostics"] = list_json(&all);
        print_json(&answer)?;
    } else {
        print(&variants::comparison_text(&comparison))?;
        print_findings(&all)?;
    }
    fail_on_errors(&all)
}

/// `pdf` requests report and summary as PDF on this paper size, printed by the named browser if there is one.
fn export(path: &Path, folder: &Path, date: &str, pdf: Option<(Paper, Option<&Path>)>) -> Result<(), Failure> {
    let (project, file) = input::project(path)?;
    let Some(project) = project else { return Err(refuse(&[file], false)) };
    let (export, all) = answers::export_with_findings(&project, date, file);
    print_findings(&all)?;
    fail_on_errors(&all)?;
    let mut files: Vec<_> = export.bytes().collect();
    for (document, print) in pdf::PRINTS {
        if let (Some((paper, browser)), Some((_, html))) = (pdf, files.iter().find(|(name, _)| *name == document)) {
            files.push((print, pdf::print(html, paper, browser).map_err(Failure::Outside)?));
        }
    }
    export::write(folder, &files).map_err(Failure::Outside)?;
    let paths = files.iter().map(|(name, _)| format!("{}\n", folder.join(name).display()));
    print(&paths.collect::<String>())
}

fn explain(word: &str, path: Option<&Path>, id: Option<&str>, json: bool) -> Result<(), Failure> {
    let project = match (path, id) {
        (Some(path), _) => {
            let (project, file) = input::project(path)?;
            let Some(project) = project else { return Err(refuse(&[file], json)) };
            project
        }
        (None, id) => {
            let control = control(id)?;
            let machine = control.map_or_else(|| machines::ALL.first().copied(), pages::machine_on);
            let project = machine.and_then(|machine| Project::of(machine.id(), control.map(|control| control.id)));
            project.ok_or_else(|| {
                Failure::usage(&msg!("request.no-control", control = id.unwrap_or_default(), controls = ""))
            })?
        }
    };
    let help = Help::new(project.machine, project.control, &Texts::shipped(catalog::spoken()));
    // Codes, variables and alarms have their entries in the help; words of the language have their meaning alone.
    let is_of_language =
        |meaning: &Meaning| matches!(meaning.subject, Subject::Axis(_) | Subject::Address(_) | Subject::Keyword);
    let is_whole = |meaning: &Meaning| meaning.word.eq_ignore_ascii_case(word);
    let own = Words::of(&project).meaning(word, Table::Program).filter(|it| is_whole(it) && is_of_language(it));
    let found = explain::found(&help, word);
    if found.is_empty() && own.is_none() {
        return Err(Failure::Outside(catalog::sentence(&msg!("help.nothing", word))));
    }
    if json {
        return print_json(&explain::json(own.as_ref(), &found));
    }
    print(&explain::text(own.as_ref(), &found))
}

fn draw(path: &Path, at: f64, dark: bool, out: &Path) -> Result<(), Failure> {
    if at.is_nan() || at < 0.0 {
        return Err(Failure::usage(&msg!("cli.at")));
    }
    let (project, file) = input::project(path)?;
    let Some(project) = project else { return Err(refuse(&[file], false)) };
    print_findings(&[file])?;
    let (scene, pose) = drawing::at(&project, at);
    let theme = if dark { Theme::Dark } else { Theme::Light };
    std::fs::write(out, picture(&scene, &pose, theme)).map_err(|error| Failure::Outside(failed(out, &error)))
}

fn check(
    paths: &[PathBuf],
    control: Option<&str>,
    switches: &[String],
    silenced: &[String],
    format: Format,
) -> Result<(), Failure> {
    let choices = input::choices(switches, silenced)?;
    let subject = input::subject(paths, control, format)?;
    let checked = check_request::check(subject, &choices).map_err(|why| refused(why, format))?;
    print_diagnostics(format, &checked.findings)?;
    if format == Format::Text {
        if checked.findings.iter().all(|findings| findings.list.is_empty()) {
            print_error(&(summary(&[]) + "\n"))?;
        }
        tell_silenced(checked.silenced)?;
    }
    fail_on_errors(&checked.findings)
}
