//! Programs that the machines write raise no finding: every machine, every control of it, every choice of its form.

use macroline::machines::form::{FieldKindInfo, Value};
use macroline::machines::{self, AnyMachine};
use macroline::project::Project;
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

#[test]
fn written_programs_have_no_findings() {
    for machine in machines::ALL {
        for control in machine.controls() {
            let choices = choices(*machine);
            let all: usize = choices.iter().map(|(_, values)| values.len()).product();
            for at in (0..all).step_by(all.div_ceil(MOST)) {
                let mut project = Project::of(machine.id(), Some(control)).unwrap();
                let mut rest = at;
                for (id, values) in &choices {
                    project.values.insert((*id).to_owned(), values[rest % values.len()].clone());
                    rest /= values.len();
                }
                let written = project.written();
                let found: Vec<_> = written.diagnostics.iter().cloned().chain(project.advice(&written)).collect();
                let said = |d: &macroline::text::Diagnostic| format!("{}: {}", d.message.id, sentence(&d.message));
                let said: Vec<String> = found.iter().map(said).collect();
                assert!(said.is_empty(), "{} on {control}, {:?}: {said:#?}", machine.id(), project.values);
            }
        }
    }
}
