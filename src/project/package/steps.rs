//! A session of the debugger for other programs: commands and stops are JSON.

use serde::Deserialize;
use serde_json::{Map, Value as Json, json};

use super::refusal::{error, refused};
use super::requests::{RunArguments, read, read_request};
use crate::interp::inspect::{CallLevel, Change, Entered};
use crate::motion::{Action, Retention, RunEnd};
use crate::msg;
use crate::project::debugger::session::{Session, SessionStop};
use crate::project::debugger::stepping::{Goal, Stop};
use crate::project::findings::file_findings::{FileFindings, Sources, list_json};
use crate::project::findings::render::Renderer;
use crate::project::findings::silence::silence;
use crate::project::requests::check_request::Refused;
use crate::project::requests::run_request::ReadyRun;
use crate::project::run::Setting;
use crate::text::Diagnostic;
use crate::text::catalog::sentence;

/// A command of a session.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Command {
    Into,
    Over,
    Out,
    Continue,
    Back,
    Start,
    Reset,
    Breakpoints,
    Variables,
    To(String),
    Break { place: String, condition: Option<String> },
    Clear(Option<u32>),
    Watch(String),
    Unwatch(Option<u32>),
    Evaluate(String),
    Set { name: String, value: f64 },
}

/// A session before the next block of its program.
pub struct StepAnswers {
    session: Session,
    sources: Sources,
}

impl StepAnswers {
    /// Begins a session; the answer is its first stop with the diagnostics of reading. `None` if the answer is an error.
    pub fn new(request: &str) -> (Option<StepAnswers>, String) {
        match StepAnswers::begun(request) {
            Ok((steps, answer)) => (Some(steps), answer.to_string()),
            Err(why) => (None, refused(&why).to_string()),
        }
    }

    fn begun(request: &str) -> Result<(StepAnswers, Json), Refused> {
        let ready = read_request::<RunArguments>(request)?.request(Retention::Both)?.ready()?;
        let ReadyRun { run, mut files, mut program, silenced, .. } = ready;
        silence(&mut program.list, &silenced);
        let (session, halt) = Session::new(run);
        let FileFindings { sources, list } = program;
        files.push(FileFindings { sources: Sources::written(sources.files.clone()), list });
        let steps = StepAnswers { session, sources };
        let mut stop = steps.stop(&halt);
        if let (Json::Array(read), Json::Array(found)) = (list_json(&files), &mut stop["diagnostics"]) {
            found.splice(0..0, read);
        }
        Ok((steps, stop))
    }

    /// Carries out a command.
    pub fn answer(&mut self, command: &str) -> String {
        read(command).and_then(|command| self.carried_out(command)).unwrap_or_else(|why| refused(&why)).to_string()
    }

    fn carried_out(&mut self, command: Command) -> Result<Json, Refused> {
        let halt = match command {
            Command::Into => self.session.go(Goal::Into),
            Command::Over => self.session.go(Goal::Over),
            Command::Out => self.session.go(Goal::Out),
            Command::Continue => self.session.go(Goal::Continue),
            Command::To(place) => {
                let (_, place) = self.session.location(&place).ok_or_else(|| no_block(&place))?;
                self.session.go(Goal::To(place))
            }
            Command::Back => self.session.back().ok_or_else(|| msg!("console.no-block-before"))?,
            Command::Start => self.session.press(Action::Start),
            Command::Reset => self.session.press(Action::Reset),
            Command::Breakpoints => return Ok(self.breakpoints()),
            Command::Variables => return Ok(self.variables()),
            Command::Break { place, condition } => {
                let (location, _) = self.session.location(&place).ok_or_else(|| no_block(&place))?;
                let number = self.session.set_break(location, condition.as_deref().unwrap_or_default());
                return Ok(number.map_or_else(|why| self.wrong(&why), |number| json!({ "number": number })));
            }
            Command::Clear(which) => return Ok(json!({ "removed": self.session.clear(which) })),
            Command::Watch(text) => {
                let number = self.session.watch(&text);
                return Ok(number.map_or_else(|why| self.wrong(&why), |number| json!({ "number": number })));
            }
            Command::Unwatch(which) => return Ok(json!({ "removed": self.session.unwatch(which) })),
            Command::Evaluate(text) => {
                let value = self.session.debugger().evaluate(&text);
                return Ok(value.map_or_else(|why| self.wrong(&why), |value| json!({ "value": value })));
            }
            Command::Set { name, value } => {
                let setting = Setting::new(&name, value).ok_or_else(|| msg!("request.setting"))?;
                let is_set = self.session.set(&setting);
                return if is_set { Ok(json!({ "value": value })) } else { Err(not_settable(&name)) };
            }
        };
        Ok(self.stop(&halt))
    }

    /// An expression that does not parse.
    fn wrong(&self, why: &Diagnostic) -> Json {
        // The place is within the expression, which is no file.
        let found = Diagnostic { place: None, ..why.clone() };
        let mut answer = error(&found.message);
        answer["diagnostics"] = json!([self.sources.renderer().json(&found)]);
        answer
    }

    fn breakpoints(&self) -> Json {
        let renderer = self.sources.renderer();
        let points = self.session.points.list().iter();
        let points = points.map(|point| {
            let block = point.place.and_then(|place| renderer.block_json(place));
            json!({ "number": point.number, "block": block, "condition": point.condition, "hits": point.hits })
        });
        json!({ "breakpoints": points.collect::<Vec<_>>() })
    }

    fn variables(&self) -> Json {
        let all = self.session.debugger().run().program().variables();
        let all: Map<String, Json> = all.map(|(name, value)| (name, json!(value + 0.0))).collect();
        json!({ "variables": all })
    }

    /// A stop as an object.
    fn stop(&self, halt: &SessionStop) -> Json {
        let renderer = self.sources.renderer();
        let debugger = self.session.debugger();
        let (reason, point, why) = match &halt.stop {
            Stop::Reached => ("block", None, None),
            Stop::Breakpoint(number) => ("breakpoint", Some(*number), None),
            Stop::Condition(number, why) => ("condition", Some(*number), Some(sentence(&why.message))),
            Stop::Ended(RunEnd::ProgramEnd) => ("program-end", None, None),
            Stop::Ended(RunEnd::Stop) => ("stop", None, None),
            Stop::Ended(RunEnd::Alarm(_)) => ("alarm", None, None),
            Stop::Ended(RunEnd::Blocks) => ("blocks", None, None),
            Stop::Ended(RunEnd::Seconds) => ("seconds", None, None),
        };
        let (earlier, newest) = debugger.run().newest_commands();
        let names = debugger.run().program().names();
        let canon: Vec<String> = newest.map(|canon| canon.line(names).to_string()).collect();
        let block = |place: Option<_>| place.and_then(|place| renderer.block_json(place));
        let watch = |(number, text): (u32, &str)| {
            let (value, why) = match debugger.evaluate(text) {
                Ok(value) => (value, None),
                Err(why) => (None, Some(sentence(&why.message))),
            };
            json!({ "number": number, "expression": text, "value": value, "reason": why })
        };
        json!({
            "stop": reason,
            "breakpoint": point,
            "reason": why,
            "time_s": debugger.t(),
            "block": block(debugger.place()),
            "executing": block(debugger.executing()),
            "stack": debugger.levels().iter().map(|level| self.level(level, &renderer)).collect::<Vec<_>>(),
            "changes": debugger.changes().iter().map(|change| self.change(change)).collect::<Vec<_>>(),
            "canon": canon,
            "canon_before": earlier,
            "watches": self.session.watches().map(watch).collect::<Vec<_>>(),
            "diagnostics": halt.found.iter().map(|found| renderer.json(found)).collect::<Vec<_>>(),
        })
    }

    fn level(&self, level: &CallLevel, renderer: &Renderer) -> Json {
        let entered = match level.entered {
            Entered::Start => "start",
            Entered::Subprogram => "subprogram",
            Entered::Macro => "macro",
        };
        let control = self.session.control();
        let locals: Map<String, Json> =
            level.locals().map(|(number, value)| (control.variable(number), json!(value + 0.0))).collect();
        json!({
            "program": level.program, "name": level.name, "entered": entered, "again": level.again,
            "block": renderer.block_json(level.place), "locals": locals,
        })
    }

    fn change(&self, change: &Change) -> Json {
        json!({ "name": change.subject.name(self.session.control()), "before": change.before, "after": change.after })
    }
}

fn no_block(place: &str) -> Refused {
    msg!("console.no-block", place).into()
}

fn not_settable(name: &str) -> Refused {
    msg!("request.not-settable", name).into()
}
