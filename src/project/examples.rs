//! Projects from the named examples of a machine, and the example that an unchanged project equals.

use super::Project;
use crate::controls::{self, Control};
use crate::machines::form::{Value, Values};
use crate::machines::machine::{Example, KnownFault};
use crate::machines::{self, AnyMachine};
use crate::msg;
use crate::text::{Message, listed};
use crate::view::{Readout, Verdict};

/// Kind of a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NameKind {
    /// Id of a machine.
    Machine,
    /// Id of a control that the machine can have.
    Control,
    /// Id of an example of the machine.
    Example,
}

/// An unknown name, and the known ones.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unknown {
    /// Kind of the unknown name.
    pub kind: NameKind,
    /// The names that there are.
    pub known: Vec<&'static str>,
}

impl Unknown {
    /// Message with the unknown name and the known ones.
    pub fn message(&self, machine: &str, control: Option<&str>, example: Option<&str>) -> Message {
        let known = listed(&self.known);
        match self.kind {
            NameKind::Machine => msg!("request.no-machine", machine, machines = known),
            NameKind::Control => {
                msg!("request.wrong-control", machine, control = control.unwrap_or_default(), controls = known)
            }
            NameKind::Example => {
                msg!("request.no-example", machine, example = example.unwrap_or_default(), examples = known)
            }
        }
    }
}

impl Project {
    /// A new project: the machine's first example on a control.
    pub fn new(machine: &'static dyn AnyMachine, control: &'static Control) -> Project {
        match machine.examples().first() {
            Some(example) => Project::example(machine, control, example),
            None => Project::of_form(machine, control),
        }
    }

    /// An example of a machine on a control. An entry that the form does not take is left at its default.
    pub fn example(machine: &'static dyn AnyMachine, control: &'static Control, example: &Example) -> Project {
        let mut project = Project::of_form(machine, control);
        for field in machine.fields() {
            let entry = example.entries.iter().find(|(id, _)| *id == field.id);
            if let Some(value) = entry.and_then(|(_, typed)| field.read_metric(typed).ok()) {
                project.values.insert(field.id.to_owned(), value);
            }
        }
        project
    }

    /// An example on a control or, where its form lacks an option that the example switches on, on the machine's first control that has all.
    pub fn whole_example(machine: &'static dyn AnyMachine, control: &'static Control, example: &Example) -> Project {
        let on = |control| Project::example(machine, control, example);
        let project = on(control);
        if project.has_all_of(example) {
            return project;
        }
        let others = machine.controls().iter().filter_map(|id| controls::find(id));
        others.map(on).find(|other| other.has_all_of(example)).unwrap_or(project)
    }

    /// Whether the form has every option that an example switches on.
    fn has_all_of(&self, example: &Example) -> bool {
        let prepared = self.prepared();
        let is_on = |id: &str| self.values.get(id) == Some(&Value::Flag(true));
        !example.entries.iter().any(|(id, _)| is_on(id) && prepared.hidden().contains(id))
    }

    /// A new project, by ids; without a control on the machine's first.
    pub fn of(machine: &str, control: Option<&str>) -> Option<Project> {
        Project::named(machine, control, None).ok()
    }

    /// An example, by ids: without a control on the machine's first, without an example its first.
    pub fn named(machine: &str, control: Option<&str>, example: Option<&str>) -> Result<Project, Unknown> {
        let known = || machines::ALL.iter().map(|machine| machine.id()).collect();
        let machine = machines::find(machine).ok_or_else(|| Unknown { kind: NameKind::Machine, known: known() })?;
        let known = || Unknown { kind: NameKind::Control, known: machine.controls().to_vec() };
        let id = control.or(machine.controls().first().copied()).filter(|id| machine.controls().contains(id));
        let control = id.and_then(controls::find).ok_or_else(known)?;
        let Some(id) = example else { return Ok(Project::new(machine, control)) };
        let known = || machine.examples().iter().map(|example| example.id).collect();
        let example = machine.examples().iter().find(|example| example.id == id);
        let example = example.ok_or_else(|| Unknown { kind: NameKind::Example, known: known() })?;
        Ok(Project::example(machine, control, example))
    }

    /// The example whose values the project has.
    pub fn present_example(&self) -> Option<&'static Example> {
        let form: Values = self.machine.fields().iter().map(|field| (field.id.to_owned(), field.default())).collect();
        let value = |id: &String| self.values.get(id).or(form.get(id));
        let has = |example: &&Example| {
            let made = Project::example(self.machine, self.control, example);
            made.values.iter().all(|(id, made)| value(id) == Some(made))
        };
        self.machine.examples().iter().find(has)
    }

    /// Failed verdicts of the example whose values the project has, each with its reason.
    pub fn faults(&self) -> Vec<(Readout, &'static KnownFault)> {
        let Some(example) = self.present_example() else { return Vec::new() };
        let failed = self.design().readouts.into_iter().filter(|readout| readout.verdict == Verdict::Fail);
        let reason = |id: &str| example.faults.iter().find(|fault| fault.result == id);
        failed
            .filter_map(|readout| Some((reason(readout.id)?, readout)))
            .map(|(fault, readout)| (readout, fault))
            .collect()
    }
}
