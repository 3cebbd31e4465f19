//! The page of a machine: manual, drawing, fields, results with formulas, variables, commissioning, loading.

use std::collections::BTreeMap;

use super::content::{Fact, HelpEntry, HelpKind, HelpPage, HelpSection};
use super::own_alarms;
use super::texts::{Texts, links, plain};
use crate::controls::{self, Control};
use crate::machines::form::{FieldInfo, FieldKindInfo, Value};
use crate::machines::{AnyMachine, MachineVariable};
use crate::project::Project;
use crate::project::dependence::fields_by_result;
use crate::text::catalog::words;
use crate::text::{Phrase, clauses, units};
use crate::view::Readout;

/// The page of a machine on a control.
pub(super) fn page(machine: &'static dyn AnyMachine, control: &'static Control, texts: &Texts) -> HelpPage {
    let id = machine.id();
    let project = Project::new(machine, control);
    let mut about = HelpSection::new("about", texts.words("title.about"));
    about.text = texts.list(&format!("{id}.about"));
    let mut parts = HelpSection::new("parts", texts.words("title.parts"));
    parts.parts = project.prepared().parts().iter().map(|part| words(part.name).to_owned()).collect();
    let mut first = HelpSection::new("first", texts.words("title.first"));
    first.text = texts.list(&format!("{id}.first"));
    let mut commissioning = HelpSection::new("commissioning", texts.words("title.commissioning"));
    commissioning.steps = texts.list(&format!("{id}.step"));
    let mut loading = HelpSection::new("loading", texts.words("title.loading"));
    loading.text = texts.list(&format!("{id}.load"));
    loading.text.push(links(machine.controls().iter().map(|control| format!("{control}/loading"))));
    let mut faults = HelpSection::new("faults", texts.words("title.faults"));
    faults.text = texts.list(&format!("{id}.fault"));
    let depends = fields_by_result(&project);
    let mut sections = vec![about, parts, commissioning, first, loading, faults];
    sections.push(own_alarms::section(&variants(machine, control), texts));
    sections.push(variables(&project, texts));
    sections.push(fields(&project, &depends, texts));
    sections.push(results(&project, &depends, texts));
    HelpPage::new(id, words(machine.name()), control, sections)
}

/// Variables that the operator reads and sets, without those described with their field.
fn variables(project: &Project, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("variables", texts.words("title.variables"));
    let fields: Vec<u32> = project.machine.fields().iter().filter_map(variable).collect();
    for MachineVariable { number, label, unit } in project.prepared().variables() {
        if fields.contains(&number) {
            continue;
        }
        let word = project.control.variable(number);
        let mut entry = HelpEntry::new(HelpKind::Variable, format!("var.{number}"), word, words(label));
        entry.fact(texts.words("fact.unit"), unit);
        entry.facts.push(on_control(project.control, number, texts));
        entry.cite = project.control.var(number).map(|row| row.cite);
        section.entries.push(entry);
    }
    section
}

/// Number of the variable that is the symbol of a field.
fn variable(field: &FieldInfo) -> Option<u32> {
    field.symbol.strip_prefix('#')?.parse().ok()
}

/// The range of the control that a variable is in.
fn on_control(control: &Control, number: u32, texts: &Texts) -> Fact {
    Fact { name: texts.words("fact.kind"), value: links([format!("{}/var.{number}", control.id)]) }
}

fn fields(project: &Project, depends: &BTreeMap<&'static str, Vec<&'static str>>, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("fields", texts.words("title.fields"));
    section.text = texts.list("fields");
    for field in project.machine.fields() {
        let symbol = project.control.written(field.symbol);
        let mut entry = HelpEntry::new(HelpKind::Field, format!("field.{}", field.id), symbol, words(field.label));
        entry.text.push(plain(words(field.help)));
        entry.fact(texts.words("fact.group"), words(field.group));
        range(&mut entry, &field, texts);
        if let Some(number) = variable(&field) {
            entry.also.push(format!("var.{number}"));
            entry.facts.push(on_control(project.control, number, texts));
        }
        if field.role.is_fact() {
            entry.text.push(plain(texts.words("field.fact")));
        }
        let results = depends.iter().filter(|(_, fields)| fields.contains(&field.id));
        let results = links(results.map(|(result, _)| format!("result.{result}")));
        if !results.is_empty() {
            entry.facts.push(Fact { name: texts.words("fact.acts-on"), value: results });
        }
        section.entries.push(entry);
    }
    section
}

fn range(entry: &mut HelpEntry, field: &FieldInfo, texts: &Texts) {
    match &field.kind {
        FieldKindInfo::Number { .. } => {
            entry.fact(texts.words("fact.range"), field.range().unwrap_or_default());
            entry.fact(texts.words("fact.default"), field.text_with_unit(&field.default()));
        }
        FieldKindInfo::Choice(options) => {
            entry.fact(texts.words("fact.choices"), clauses(options.iter().map(|(_, label)| words(label))));
        }
        FieldKindInfo::Flag(default) => {
            let default = words(if *default { "form.report.yes" } else { "form.report.no" });
            entry.fact(texts.words("fact.default"), default);
        }
        FieldKindInfo::Text(max) => entry.fact(texts.words("fact.characters"), max.to_string()),
    }
}

/// Every result that the machine has on any of its controls: in its examples, and with each choice of the form taken.
fn readouts(project: &Project) -> Vec<Readout> {
    let machine = project.machine;
    let mut all = project.prepared().results().readouts;
    let mut add = |other: &Project| {
        for readout in machine.prepare(&other.values, other.control_context()).results().readouts {
            match all.iter_mut().find(|known| known.id == readout.id) {
                Some(known) => known.limit = known.limit.or(readout.limit),
                None => all.push(readout),
            }
        }
    };
    for control in machine.controls().iter().filter_map(|id| controls::find(id)) {
        variants(machine, control).iter().for_each(&mut add);
    }
    all
}

/// The examples of a machine on a control, and new projects with each choice of the form taken.
fn variants(machine: &'static dyn AnyMachine, control: &'static Control) -> Vec<Project> {
    let examples = machine.examples().iter().map(|example| Project::example(machine, control, example));
    let fields = machine.fields().into_iter();
    let chosen = fields.flat_map(|field| choices(&field).into_iter().map(move |value| (field.id.to_owned(), value)));
    let new = Project::new(machine, control);
    let others = chosen.map(|(id, value)| {
        let mut other = new.clone();
        other.values.insert(id, value);
        other
    });
    examples.chain(others).collect()
}

/// Values of a choice, or the other value of a flag; empty for numbers and texts.
fn choices(field: &FieldInfo) -> Vec<Value> {
    match &field.kind {
        FieldKindInfo::Choice(options) => options.iter().map(|(id, _)| Value::Text((*id).to_owned())).collect(),
        FieldKindInfo::Flag(default) => vec![Value::Flag(!default)],
        _ => Vec::new(),
    }
}

fn results(project: &Project, depends: &BTreeMap<&'static str, Vec<&'static str>>, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("results", texts.words("title.results"));
    section.text = texts.list("results");
    for readout in readouts(project) {
        let mut entry = HelpEntry::new(HelpKind::Result, format!("result.{}", readout.id), "", words(readout.label));
        entry.fact(texts.words("fact.formula"), project.control.written(formula(readout.formula)));
        entry.fact(texts.words("fact.unit"), units::unit(readout.unit));
        if let Some(limit) = readout.limit {
            let judged = match limit.bound() {
                "most" => "bound.most",
                "least" => "bound.least",
                "within" => "bound.within",
                _ => "bound.equal",
            };
            entry.fact(texts.words("fact.verdict"), texts.words(judged));
        }
        let fields = depends.get(readout.id).into_iter().flatten();
        let fields = links(fields.map(|field| format!("field.{field}")));
        if !fields.is_empty() {
            entry.facts.push(Fact { name: texts.words("fact.depends"), value: fields });
        }
        entry.cite = Some(readout.cite);
        section.entries.push(entry);
    }
    section
}

fn formula(formula: Phrase) -> &'static str {
    if formula.is_empty() { "" } else { formula.words() }
}
