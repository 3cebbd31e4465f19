//! A program on a machine at rest: its commands without time, for tests of macro programs.

use std::rc::Rc;

use serde_json::{Map, Value as Json, json};

use super::requests::InterpretRequest;
use crate::controls::{Address, Control, Switches};
use crate::interp::canon::AXES;
use crate::interp::world::MachineAtRest;
use crate::interp::{End, Interp, StartProgram, run};
use crate::motion::{Action, InputName, WordPart};
use crate::msg;
use crate::nc::{self, Parsed};
use crate::project::findings::file_findings::Sources;
use crate::project::requests::check_request::{ProgramSource, Refused};
use crate::project::requests::run_request::program_of_name;

/// Program of a request, program to start, and the files of its diagnostics.
fn program(request: &InterpretRequest) -> Result<(Rc<Parsed>, StartProgram, Sources), Refused> {
    let choices = request.choices.choices();
    let (parsed, first, sources) = match request.subject.read()? {
        ProgramSource::Programs(control, programs) => {
            let switches = choices.switched(Switches::default(), control)?;
            let parsed = nc::parse_with(&programs.sources.files, control, &switches);
            (Rc::new(parsed), StartProgram::First, programs.sources)
        }
        ProgramSource::Project(read) => {
            let (project, file) = *read;
            let Some(mut project) = project else { return Err(Refused::Files(vec![file])) };
            project.switches = choices.switched(project.switches, project.control)?;
            let written = project.written();
            (written.parsed, StartProgram::Program(written.main), Sources::written(written.files))
        }
    };
    let start = program_of_name(request.start.as_deref(), &parsed)?.unwrap_or(first);
    Ok((parsed, start, sources))
}

/// The machine at rest, with positions and inputs of the request.
fn machine(request: &InterpretRequest, control: &Control) -> Result<MachineAtRest, Refused> {
    let mut positions = [0.0; AXES];
    for (letter, at) in &request.positions {
        let axis = match letter.as_bytes() {
            [letter] => Address::of(*letter).and_then(|letter| control.axis(letter)),
            _ => None,
        };
        match axis.and_then(|axis| positions.get_mut(axis)) {
            Some(position) => *position = *at,
            None => return Err(msg!("request.no-axis", control = control.name, axis = letter.as_str()).into()),
        }
    }
    Ok(MachineAtRest { positions, ..MachineAtRest::default() })
}

/// Executes the program and answers with its commands and how it ended.
pub(super) fn interpret(request: &InterpretRequest) -> Result<Json, Refused> {
    let (parsed, start, sources) = program(request)?;
    let control = parsed.control();
    let mut world = machine(request, control)?;
    let mut interp = Interp::new(Rc::clone(&parsed), start);
    for setting in request.settings()? {
        let refused = || Refused::from(msg!("request.not-settable", name = setting.name.as_str()));
        match setting.action(control, parsed.dialect()).ok_or_else(refused)? {
            Action::Variable(number, value) => drop(interp.set_variable(number, value)),
            Action::Input(InputName::Variable(number, WordPart::Whole), value) => world.inputs.push((number, value)),
            _ => return Err(refused()),
        }
    }
    let names = interp.names();
    let mut canon = Vec::new();
    let end = run(&mut interp, &mut world, request.blocks(), |command, _| {
        canon.push(Json::from(command.line(names).to_string()));
    });
    world.remarks.dedup();
    let (ended, alarm) = match end {
        None => ("blocks", None),
        Some(End::Program) => ("program-end", None),
        Some(End::Alarm(alarm)) => ("alarm", Some(alarm)),
    };
    let blocks = interp.blocks();
    let variables: Map<String, Json> = interp.variables().map(|(name, value)| (name, json!(value + 0.0))).collect();
    let renderer = sources.renderer();
    let all = |list: &[crate::text::Diagnostic]| list.iter().map(|found| renderer.json(found)).collect::<Vec<_>>();
    Ok(json!({
        "ended": ended,
        "blocks": blocks.nc + blocks.macros,
        "canon": canon,
        "variables": variables,
        "alarm": alarm.map(|alarm| renderer.json(&alarm)),
        "remarks": all(&world.remarks),
        "diagnostics": all(parsed.diagnostics()),
    }))
}
