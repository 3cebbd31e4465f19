//! Programs that the machines write raise no finding: every machine, every control of it, every choice of its form.

use std::convert::Infallible;

use macroline::controls;
use macroline::controls::options::{DwellUnit, SwitchChoice};
use macroline::machines::form::{FieldKindInfo, Value};
use macroline::machines::{self, AnyMachine};
use macroline::motion::{Budget, Retention};
use macroline::project::Project;
use macroline::project::run::{self, AtStop, RunOptions};
use macroline::text::catalog::sentence;

/// Maximum programs checked for each machine and control; of more choices every n-th is checked.
const MOST: usize = 2000;

/// Every field with a choice, and its values.
fn choices(machine: &dyn AnyMachine) -> Vec<(&'static str, Vec<Value>)> {
    let fields = machine.fields().into_iter();
    let values = fields.map(|field| match field.kind {
        FieldKindInfo::Choice(options) => (field.id, options.iter().map(|row| Value::Text(row.0.to_owned())).collect()),
        FieldKindInfo::Flag(_) => (field.id, vec![Value::Flag(false), Value::Flag(true)]),
        _ => (field.id, Vec::new()),
    });
    values.filter(|(_, values)| !values.is_empty()).collect()
}

/// The forms of a machine on a control with every n-th combination of its choices, at most `most`.
fn chosen<'a>(machine: &'a dyn AnyMachine, control: &'a str, most: usize) -> impl Iterator<Item = Project> + 'a {
    let choices = choices(machine);
    let all: usize = choices.iter().map(|(_, values)| values.len()).product();
    (0..all).step_by(all.div_ceil(most)).map(move |at| {
        let mut project = Project::of(machine.id(), Some(control)).unwrap();
        let mut rest = at;
        for (id, values) in &choices {
            project.values.insert((*id).to_owned(), values[rest % values.len()].clone());
            rest /= values.len();
        }
        project
    })
}

/// The dwells of a project's run, as lines of the canonical log.
fn dwells(project: &Project) -> Vec<String> {
    let limits = Budget { blocks: 20_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Log };
    let mut planner = run::of_project(project, &project.written(), &begin);
    let mut found = Vec::new();
    run::to_end(&mut planner, AtStop::CycleStart, |line| {
        found.extend(Some(line.to_string()).filter(|line| line.contains("dwell")));
        Ok::<(), Infallible>(())
    })
    .unwrap();
    found
}

#[test]
fn dwells_are_seconds_on_a_control_that_counts_revolutions() {
    let mut switched = 0;
    for machine in machines::ALL {
        for control in machine.controls() {
            let Some(row) = controls::find(control).unwrap().switch(DwellUnit::SWITCH) else { continue };
            for mut project in chosen(*machine, control, 120) {
                let in_seconds = dwells(&project);
                project.switches.set(row, DwellUnit::Revolutions.option().id);
                assert_eq!(dwells(&project), in_seconds, "{} on {control}, {:?}", machine.id(), project.values);
                switched += in_seconds.len();
            }
        }
    }
    assert!(switched > 1000, "{switched} dwells");
}

#[test]
fn written_programs_have_no_findings() {
    for machine in machines::ALL {
        for control in machine.controls() {
            for project in chosen(*machine, control, MOST) {
                let written = project.written();
                let found: Vec<_> = written.diagnostics.iter().cloned().chain(project.advice(&written)).collect();
                let line = |d: &macroline::text::Diagnostic| format!("{}: {}", d.message.id, sentence(&d.message));
                let lines: Vec<String> = found.iter().map(line).collect();
                assert!(lines.is_empty(), "{} on {control}, {:?}: {lines:#?}", machine.id(), project.values);
            }
        }
    }
}

#[test]
fn alarm_of_the_program_that_sets_the_values_is_in_the_run() {
    let mut project = Project::of("ribbon-line", Some("mitsubishi-e60")).unwrap();
    let mut files = project.written().files.clone();
    let setup = files.0.iter_mut().find(|file| file.name.contains("O9102")).unwrap();
    setup.text = setup.text.replacen("N5", "#3000=5(STOP)\nN5", 1);
    project.edited = Some(files);
    let limits = Budget { blocks: 20_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Log };
    let mut planner = run::of_project(&project, &project.written(), &begin);
    let summary = run::to_end(&mut planner, AtStop::End, |_| Ok::<(), Infallible>(())).unwrap();
    let first = summary.diagnostics.first().map(|found| sentence(&found.message));
    assert_eq!(first.as_deref(), Some("The program raises its alarm 5: STOP"), "{:?}", summary.diagnostics);
}
