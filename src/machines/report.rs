//! The report of any machine: its form, its results, its sheets, and the open points of its control.

use super::form::{FieldInfo, FieldKindInfo, Origins, Provenance, Value, Values};
use super::machine::{AnyMachine, ControlContext, PreparedMachine};
use super::open_points::open_points;
use crate::msg;
use crate::text::catalog::{number_text, sentence, words};
use crate::text::{Diagnostic, listed, units};
use crate::view::report::{Input, ListedPart, Report, RunReport, SizingReport, TitleBlock};
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
    let machine_and_control =
        sentence(&msg!("form.report.machine", machine = words(machine.name()), control = control.name));
    Report {
        title: match name {
            "" => machine_and_control,
            name => sentence(&msg!("form.report.titled", name, machine = machine_and_control)),
        },
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
        open: open_points(control, switches),
    }
}

/// The customer that the form names.
fn customer(machine: &dyn AnyMachine, values: &Values) -> String {
    match machine.info().customer.and_then(|field| values.get(field)) {
        Some(Value::Text(customer)) => customer.clone(),
        _ => String::new(),
    }
}

/// The parts list: data from the inputs that apply on the control, each marked as given or assumed.
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

/// The inputs that apply on the control, in the order of the form.
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
