//! The open points of a control: its settings and facts that no manual at hand confirms.

use crate::controls::options::SwitchOption;
use crate::controls::{CodeDef, Control, Switch, Switches};
use crate::msg;
use crate::text::catalog::{sentence, words};
use crate::text::{Citation, Grade, clauses, with_aside};
use crate::view::report::{OpenFacts, OpenPoints, OpenSetting};

/// Settings and facts of a control that no manual confirms, and settings that differ from their default.
pub(super) fn open_points(control: &Control, switches: &Switches) -> OpenPoints {
    let set = control.switches.iter().map(|row| (row, switches.setting(row)));
    let settings = set.filter(|(row, set)| is_open(&row.cite) || *set != row.default());
    OpenPoints { settings: settings.map(|(row, set)| setting(row, set)).collect(), facts: facts(control) }
}

fn is_open(cite: &Citation) -> bool {
    cite.grade == Grade::Open
}

fn setting(row: &Switch, set: &str) -> OpenSetting {
    let options = row.options();
    let (chosen, others): (Vec<&SwitchOption>, Vec<&SwitchOption>) =
        options.iter().partition(|option| option.id == set);
    let chosen = match (chosen.first(), set) {
        (Some(option), _) => words(option.label),
        (None, "") => words("form.open.empty"),
        (None, text) => text,
    };
    let others = clauses(others.into_iter().map(|option| words(option.label)));
    OpenSetting { label: row.text(), chosen: chosen.to_owned(), others, cite: row.cite }
}

/// Rows of each table of the control that no manual confirms.
fn facts(control: &Control) -> Vec<OpenFacts> {
    let code = |row: &CodeDef| control.code_name(row.id);
    let tables: [(&'static str, Vec<String>); 8] = [
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
            .filter(|(cite, _)| is_open(cite))
            .map(|(cite, what)| with_aside(words(what), cite.source.words()))
            .collect(),
        ),
        (
            "form.open.axes",
            control.axes.iter().filter(|row| is_open(&row.cite)).map(|row| row.letter.to_string()).collect(),
        ),
        (
            "form.open.drives",
            control.drives.iter().filter(|row| is_open(&row.cite)).map(|row| row.series.to_owned()).collect(),
        ),
        (
            "form.open.params",
            control
                .params
                .iter()
                .filter(|row| is_open(&row.cite))
                .map(|row| format!("{} {}", row.number, row.name))
                .collect(),
        ),
        (
            "form.open.signals",
            control.interface.iter().filter(|row| is_open(&row.cite)).map(|row| row.device.to_owned()).collect(),
        ),
        ("form.open.codes", control.codes.iter().filter(|row| is_open(&row.cite)).map(code).collect()),
        (
            "form.open.vars",
            ranges(control, control.vars.iter().filter(|row| is_open(&row.cite)).map(|row| (row.first, row.last))),
        ),
        ("form.open.alarms", numbers(control.alarms.iter().filter(|row| is_open(&row.cite)).map(|row| row.number))),
    ];
    tables.into_iter().filter(|(_, facts)| !facts.is_empty()).map(|(kind, facts)| OpenFacts { kind, facts }).collect()
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
