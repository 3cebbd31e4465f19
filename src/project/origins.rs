//! Origins of a project's values, and the facts that are only assumed: for people and for programs.

use serde_json::{Value as Json, json};

use super::Project;
use super::list::{verdict_text, verdict_word};
use super::sensitivity::{Flip, Sensitivity};
use crate::machines::form::fill::assumed;
use crate::machines::report::inputs;
use crate::msg;
use crate::text::catalog::{sentence, words};
use crate::text::columns::left;
use crate::text::{Diagnostic, DiagnosticKind, Provenance, headed, listed};
use crate::view::report::Input;

/// Origin of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// A choice that differs from that of a new project.
    Entered,
    /// A choice with the value of a new project.
    Default,
    /// A choice with the value of the named example whose values the project has.
    Example,
    /// A fact whose source the project does not name.
    Assumed,
    /// A fact that was measured on the machine.
    Measured,
    /// A fact from a data sheet.
    DataSheet,
}

impl Origin {
    /// Id of the origin in JSON.
    fn id(self) -> &'static str {
        match self {
            Origin::Entered => "entered",
            Origin::Default => "default",
            Origin::Example => "example",
            Origin::Assumed => "assumed",
            Origin::Measured => "measured",
            Origin::DataSheet => "data sheet",
        }
    }

    /// The origin in a word or two.
    fn words(self) -> &'static str {
        match self {
            Origin::Entered => words("project.origin.entered"),
            Origin::Default => words("project.origin.default"),
            Origin::Example => words("project.origin.example"),
            Origin::Assumed => Provenance::Assumed.words(),
            Origin::Measured => Provenance::Measured.words(),
            Origin::DataSheet => Provenance::DataSheet.words(),
        }
    }
}

/// Every value that has a meaning on the control, in the order of the form, with its origin.
pub fn values(project: &Project) -> Vec<(Input, Origin)> {
    let fresh = Project::new(project.machine, project.control);
    let is_example = project.present_example().is_some();
    let origin = |input: &Input| match input.origin {
        Some(Provenance::Assumed) => Origin::Assumed,
        Some(Provenance::Measured) => Origin::Measured,
        Some(Provenance::DataSheet) => Origin::DataSheet,
        None if project.values.get(input.id).is_none_or(|value| fresh.values.get(input.id) == Some(value)) => {
            Origin::Default
        }
        None if is_example => Origin::Example,
        None => Origin::Entered,
    };
    let all = inputs(project.machine, &project.prepared(), &project.values, &project.provenance);
    let with_origin = |input: Input| {
        let origin = origin(&input);
        (input, origin)
    };
    all.into_iter().map(with_origin).collect()
}

/// Ids of the facts that are only assumed, in the order of the form.
pub fn assumed_facts(project: &Project) -> Vec<&'static str> {
    assumed(project.prepared().facts(), &project.provenance)
}

/// Assumed facts that a finding names; more of them are counted.
const NAMED: usize = 5;

/// Findings about the values of the form, [shortened](shorten).
pub fn findings(project: &Project) -> Vec<Diagnostic> {
    let mut list = project.design().diagnostics;
    shorten(project, &mut list);
    list
}

/// Shortens a long list of assumed facts to those to measure first, and refers to [`text`] for the others.
pub fn shorten(project: &Project, list: &mut [Diagnostic]) {
    let assumed = assumed_facts(project).len();
    let many = |found: &&mut Diagnostic| found.kind == DiagnosticKind::AssumedFacts && assumed > NAMED;
    if let Some(found) = list.iter_mut().find(many) {
        let (flips, fields) = (Sensitivity::new(project).flips(), project.machine.fields());
        let label = |flip: &Flip| fields.iter().find(|field| field.id == flip.field).map(|field| words(field.label));
        let first: Vec<&str> = flips.iter().take(NAMED).filter_map(label).collect();
        let others = (assumed - first.len()) as u32;
        let fields = if first.is_empty() {
            words("project.assumed-listed").to_owned()
        } else {
            sentence(&msg!("project.assumed-first", fields = listed(first), count = others))
        };
        found.message = msg!("form.assumed", count = assumed as u32, fields);
    }
}

/// Values with origins, the example that they are, and the assumed facts: first those that flip a verdict.
pub fn json(project: &Project) -> Json {
    let value = |(input, origin): &(Input, Origin)| json!({ "id": input.id, "value": input.value, "unit": input.unit, "origin": origin.id() });
    let flip = |flip: &Flip| {
        let to = json!({ "readout": flip.readout, "factor": flip.factor, "from": verdict_word(flip.from), "to": verdict_word(flip.to) });
        json!({ "field": flip.field, "flips": to })
    };
    let found = Sensitivity::new(project).flips();
    let first: Vec<&str> = found.iter().map(|flip| flip.field).collect();
    let others = assumed_facts(project).into_iter().filter(|id| !first.contains(id));
    let others = others.map(|id| json!({ "field": id, "flips": null }));
    let faults = project.faults();
    let faults = faults.iter().map(|(readout, fault)| json!({ "readout": readout.id, "reason": words(fault.reason) }));
    json!({
        "example": project.present_example().map(|example| example.id),
        "faults": faults.collect::<Vec<_>>(),
        "values": values(project).iter().map(value).collect::<Vec<_>>(),
        "assumed": found.iter().map(flip).chain(others).collect::<Vec<_>>(),
        "measure_first": first,
    })
}

/// Sources of the values as text for people.
pub fn text(project: &Project) -> String {
    let all = values(project);
    let label = |input: &Input| [words(input.label), input.symbol].join(" ").trim_end().to_owned();
    let named =
        |id: &str| all.iter().find(|(input, _)| input.id == id).map_or(String::new(), |(input, _)| label(input));
    let mut out = format!("\n{}\n", words("project.origin.title"));
    for (input, origin) in &all {
        let (origin, label) = (left(origin.words(), 12), left(&label(input), 44));
        out += &format!("{origin} {label} {} {}", input.value, input.unit);
        out.truncate(out.trim_end().len());
        out.push('\n');
    }
    let readouts = project.design().readouts;
    let found = Sensitivity::new(project).flips();
    if !found.is_empty() {
        out += &format!("\n{}\n", words("project.flip.title"));
    }
    for flip in &found {
        let result = readouts.iter().find(|readout| readout.id == flip.readout);
        let result = result.map_or(flip.readout, |readout| words(readout.label));
        let change = words(if flip.factor < 1.0 { "project.flip.less" } else { "project.flip.more" });
        let change =
            msg!("project.flip", change, result, before = verdict_text(flip.from), after = verdict_text(flip.to));
        out += &format!("  {} {}\n", left(&named(flip.field), 44), sentence(&change));
    }
    let others = assumed_facts(project).into_iter().filter(|id| found.iter().all(|flip| flip.field != *id));
    let others: Vec<String> = others.map(named).collect();
    if !others.is_empty() {
        out += &format!("\n{}\n", sentence(&msg!("project.assumed-as-well", fields = listed(others))));
    }
    out
}

/// The example that the values are and the reason of each fault; nothing where there is no fault.
pub fn faults_text(project: &Project) -> String {
    let say = |id| words(id);
    let faults = project.faults();
    let Some(example) = project.present_example().filter(|_| !faults.is_empty()) else { return String::new() };
    let mut out = headed(say(example.name), say(example.about)) + "\n";
    for (readout, fault) in faults {
        let fault = headed(say(readout.label), say(fault.reason));
        out += &format!("{}  {}\n", words("project.verdict.sign-fail"), fault);
    }
    out
}
