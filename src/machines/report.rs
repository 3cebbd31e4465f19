//! The report of any machine: its form, its results, its sheets, and the open points of its control.

use super::form::{FieldInfo, FieldKindInfo, Origins, Provenance, Value, Values};
use super::machine::{AnyMachine, ControlContext, PreparedMachine};
use crate::controls::options::SwitchOption;
use crate::controls::{Control, Switch, Switches};
use crate::msg;
use crate::text::catalog::{number_text, sentence, words};
use crate::text::{Citation, Diagnostic, Grade, headed, listed, units};
use crate::view::report::{Input, ListedPart, OpenPoints, Report, RunReport, SizingReport, TitleBlock};
use crate::view::{DrawnPart, Readout, Repairs};

/// Gathers the parts of the report that machine and control supply. `name` is the project's and may be empty; `further` are findings beyond
/// those of the design, for instance about the program. The project fills in title block, run and programs.
pub fn report(
    machine: &dyn AnyMachine,
    prepared: &PreparedMachine,
    name: &str,
    (values, origins): (&Values, &Origins),
    on: ControlContext,
    further: &[Diagnostic],
) -> Report {
    let ControlContext { control, switches } = on;
    let design = prepared.design(origins);
    let inputs = inputs(machine, prepared, values, origins);
    let title = [words(machine.name()), control.name, name];
    Report {
        title: listed(title.into_iter().filter(|part| !part.is_empty())),
        project: name.to_owned(),
        customer: customer(machine, values),
        block: TitleBlock::default(),
        date: String::new(),
        checksum: String::new(),
        run: RunReport::default(),
        programs: Vec::new(),
        loading: Vec::new(),
        variable: control.syntax.variable,
        parts: parts(prepared, &inputs),
        inputs,
        summary: prepared.summary(),
        readouts: design.readouts.into_iter().map(Readout::shown).collect(),
        diagnostics: design.diagnostics.into_iter().chain(further.iter().cloned()).collect(),
        repairs: Repairs::default(),
        sizing: SizingReport::default(),
        variants: None,
        sheets: prepared.sheets(),
        open: open(control, switches),
    }
}

/// The customer that the form names.
fn customer(machine: &dyn AnyMachine, values: &Values) -> String {
    match machine.info().customer.and_then(|field| values.get(field)) {
        Some(Value::Text(customer)) => customer.clone(),
        _ => String::new(),
    }
}

/// The parts list: data from the inputs that have a meaning, and whether they are given or only assumed.
fn parts(prepared: &PreparedMachine, inputs: &[Input]) -> Vec<ListedPart> {
    let part = |part: DrawnPart| {
        let of = |(sign, id): &(&'static str, &'static str)| {
            let input = inputs.iter().find(|input| input.id == *id).filter(|input| !input.value.is_empty())?;
            let unit = if input.unit.is_empty() { String::new() } else { format!(" {}", input.unit) };
            Some(((format!("{sign}{}", input.value), unit), input.origin == Some(Provenance::Assumed)))
        };
        let data: Vec<((String, String), bool)> = part.data.iter().filter_map(of).collect();
        let assumed = data.iter().filter(|(_, assumed)| *assumed).count();
        let origin = match assumed {
            _ if data.is_empty() => None,
            0 => Some("form.report.given"),
            all if all == data.len() => Some("form.report.assumed"),
            _ => Some("form.report.partly"),
        };
        let mut shown: Vec<(String, String)> = Vec::new();
        for ((text, unit), _) in data {
            match shown.last_mut() {
                // A length by a width is one datum, with its unit once.
                Some((length, same)) if text.starts_with('×') && *same == unit => *length += &format!(" {text}"),
                _ => shown.push((text, unit)),
            }
        }
        let data = listed(shown.into_iter().map(|(text, unit)| text + &unit));
        ListedPart { name: part.name, quantity: part.quantity, data, origin }
    };
    prepared.parts().into_iter().map(part).collect()
}

/// The inputs that have a meaning on the control, in the order of the form.
pub fn inputs(machine: &dyn AnyMachine, prepared: &PreparedMachine, values: &Values, origins: &Origins) -> Vec<Input> {
    let fields = machine.fields();
    let shown = fields.iter().filter(|field| !prepared.hidden().contains(&field.id));
    shown.map(|field| input(field, values, origins)).collect()
}

fn input(field: &FieldInfo, values: &Values, origins: &Origins) -> Input {
    let value = values.get(field.id).cloned().unwrap_or_else(|| field.default());
    let (text, unit) = match (&field.kind, value) {
        (FieldKindInfo::Number { unit, decimals, .. }, Value::Number(number)) => {
            (units::exact(number, *decimals, unit), units::unit(unit))
        }
        (_, Value::Number(number)) => (number_text(number, 6), ""),
        (_, value) => (field.word(&value).map_or_else(|| field.text(&value), str::to_owned), ""),
    };
    let origin = origins.get(field.id).copied().unwrap_or_default();
    Input {
        id: field.id,
        group: field.group,
        label: field.label,
        symbol: field.symbol,
        value: text,
        unit,
        origin: field.role.is_fact().then_some(origin),
        essential: field.essential,
    }
}

/// Rows of each table that no manual confirms; of the switches also those that differ from their default.
fn open(control: &Control, switches: &Switches) -> Vec<OpenPoints> {
    let doubtful = |cite: &Citation| cite.grade == Grade::Open;
    let code = |row: &&crate::controls::CodeDef| control.code_name(row.id);
    let tables: [(&'static str, Vec<String>); 9] = [
        (
            "form.open.switches",
            control
                .switches
                .iter()
                .map(|row| (row, switches.setting(row)))
                .filter(|(row, set)| doubtful(&row.cite) || *set != row.default())
                .map(|(row, set)| open_switch(row, set))
                .collect(),
        ),
        (
            "form.open.timing",
            [
                (control.syntax.cite, "form.open.syntax"),
                (control.macros.cite, "form.open.macros"),
                (control.limits.cite, "form.open.ranges"),
                (control.timing.cite, "form.open.block-times"),
                (control.feed_knob.cite, "form.open.feed-knob"),
                (control.spindle.cite, "form.open.spindle"),
            ]
            .into_iter()
            .chain([(control.analog_output.cite, "form.open.analog-output")])
            .chain(control.scaling.map(|row| (row.cite, "form.open.scaling")))
            .chain(control.zero_return.map(|cite| (cite, "form.open.zero-return")))
            .filter(|(cite, _)| doubtful(cite))
            .map(|(cite, what)| format!("{} ({})", words(what), cite.source))
            .collect(),
        ),
        (
            "form.open.axes",
            control.axes.iter().filter(|row| doubtful(&row.cite)).map(|row| row.letter.to_string()).collect(),
        ),
        (
            "form.open.drives",
            control.drives.iter().filter(|row| doubtful(&row.cite)).map(|row| row.series.to_owned()).collect(),
        ),
        (
            "form.open.params",
            control
                .params
                .iter()
                .filter(|row| doubtful(&row.cite))
                .map(|row| format!("{} {}", row.number, row.name))
                .collect(),
        ),
        (
            "form.open.signals",
            control.interface.iter().filter(|row| doubtful(&row.cite)).map(|row| row.device.to_owned()).collect(),
        ),
        ("form.open.codes", control.codes.iter().filter(|row| doubtful(&row.cite)).map(|row| code(&row)).collect()),
        (
            "form.open.vars",
            ranges(control, control.vars.iter().filter(|row| doubtful(&row.cite)).map(|row| (row.first, row.last))),
        ),
        ("form.open.alarms", numbers(control.alarms.iter().filter(|row| doubtful(&row.cite)).map(|row| row.number))),
    ];
    tables.into_iter().filter(|(_, facts)| !facts.is_empty()).map(|(kind, facts)| OpenPoints { kind, facts }).collect()
}

/// A switch with its setting and its options.
fn open_switch(row: &Switch, set: &str) -> String {
    let label = row.text();
    if row.is_text() {
        return headed(label, format!("\"{set}\""));
    }
    let options = row.options();
    let name = |option: &SwitchOption| words(option.label);
    let chosen = options.iter().find(|option| option.id == set).map_or(set, name);
    headed(label, format!("{chosen} ({})", options.iter().map(name).collect::<Vec<_>>().join(" | ")))
}

/// Ranges of variables as words; adjacent ranges are merged.
fn ranges(control: &Control, rows: impl Iterator<Item = (u32, u32)>) -> Vec<String> {
    let mut all: Vec<(u32, u32)> = Vec::new();
    for (first, last) in rows {
        match all.last_mut() {
            Some(before) if before.1 + 1 == first => before.1 = last,
            _ => all.push((first, last)),
        }
    }
    let range = |(first, last): (u32, u32)| match control.variable(first) {
        name if first == last => name,
        first => sentence(&msg!("form.open.range", first, last = control.variable(last))),
    };
    all.into_iter().map(range).collect()
}

/// Each number once: several kinds of alarm may share one.
fn numbers(rows: impl Iterator<Item = &'static str>) -> Vec<String> {
    let mut all: Vec<String> = rows.map(str::to_owned).collect();
    all.dedup();
    all
}
