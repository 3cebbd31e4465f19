//! The core for other programs: requests and answers are JSON. Total: any text gets an answer, and an error is a sentence in it.

mod interpret;
mod refusal;
mod requests;
mod steps;

use serde_json::{Value as Json, json};

use self::refusal::refused;
pub use self::refusal::{EarlyRefusal, MAX_REQUEST};
use self::requests::{
    CheckRequest, ExportRequest, InterpretRequest, NewRequest, NoRequest, ProjectRequest, RunArguments, SizeRequest,
    read_request,
};
pub use self::steps::StepAnswers;
use super::findings::file_findings::{has_errors, list_json};
use super::requests::check_request::{Refused, check};
use super::run::AtStop;
use super::{Project, answers, list};
use crate::motion::Retention;
use crate::msg;

/// Answers a request: `ask` is one of `list`, `new`, `design`, `size`, `export`, `check`, `run` and `interpret`.
pub fn answer(ask: &str, request: &str) -> String {
    answered(ask, request).unwrap_or_else(|why| refused(&why)).to_string()
}

fn answered(ask: &str, request: &str) -> Result<Json, Refused> {
    match ask {
        "list" => read_request(request).map(|NoRequest {}| list::json()),
        "new" => {
            let NewRequest { machine, control, example } = read_request(request)?;
            let (control, example) = (control.as_deref(), example.as_deref());
            let project = Project::named(&machine, control, example);
            let project = project.map_err(|unknown| unknown.message(&machine, control, example))?;
            // The text of a project is always JSON.
            Ok(serde_json::from_str(&project.to_json()).unwrap_or_default())
        }
        "design" => {
            let (project, file) = read_request::<ProjectRequest>(request)?.project()?;
            Ok(answers::design_with_findings(&project, file).0)
        }
        "size" => {
            let request: SizeRequest = read_request(request)?;
            let (project, file) = request.project()?;
            let (sizing, all) = answers::size_with_findings(&project, file);
            Ok(answers::sizing_json(&sizing, request.chance(&project).as_ref(), &all))
        }
        "export" => {
            let request: ExportRequest = read_request(request)?;
            let (project, file) = request.project()?;
            let (export, all) = answers::export_with_findings(&project, request.date(), file);
            // Errors in the file of the project refuse the export as those of its program do.
            let files = if has_errors(&all) { Vec::new() } else { export.into_files() };
            let files: Vec<Json> = files.iter().map(|file| json!({ "name": file.name, "text": file.text })).collect();
            Ok(json!({ "files": files, "diagnostics": list_json(&all) }))
        }
        "check" => {
            let CheckRequest { subject, choices } = read_request(request)?;
            let checked = check(subject.read()?, &choices.choices())?;
            Ok(json!({ "diagnostics": list_json(&checked.findings), "silenced": checked.silenced }))
        }
        "run" => {
            let arguments: RunArguments = read_request(request)?;
            let (at_stop, is_logged) = (arguments.at_stop(), arguments.is_logged());
            run(arguments, at_stop, is_logged)
        }
        "interpret" => interpret::interpret(&read_request::<InterpretRequest>(request)?),
        _ => Err(msg!("request.unreadable").into()),
    }
}

fn run(arguments: RunArguments, at_stop: AtStop, is_logged: bool) -> Result<Json, Refused> {
    let ready = arguments.request(Retention::Log)?.ready()?;
    let mut canon = Vec::new();
    let finished = ready.to_end(at_stop, |line| {
        if is_logged {
            canon.push(Json::from(line.to_string()));
        }
        Ok::<(), Refused>(())
    })?;
    Ok(finished.json(is_logged.then_some(canon)))
}
