//! The report as Markdown.

use core::fmt::Write;

use super::cells::{
    INPUT_COLUMNS, PART_COLUMNS, RESULT_COLUMNS, SETTING_COLUMNS, cells_of_input, cells_of_part, cells_of_result,
    cells_of_row, cells_of_setting, has_sources, verdict,
};
use super::document::{OpenSetting, Report};
use crate::text::catalog::{sentence, words};
use crate::text::escape;
use crate::text::{clauses, headed};
use crate::view::{Comparison, Sheet, Verdict};

/// The report as Markdown, readable as plain text too.
pub fn markdown(report: &Report) -> String {
    let mut out = format!("# {}\n", escape::markdown(&report.title));
    let say = |id| words(id);
    block(&mut out, report);
    section(&mut out, say("form.report.parts"));
    parts(&mut out, report);
    section(&mut out, say("form.report.findings"));
    findings(&mut out, report);
    for sheet in &report.sizing.tables {
        section(&mut out, say(sheet.title));
        self::sheet(&mut out, sheet);
    }
    if let Some(comparison) = &report.variants {
        section(&mut out, say("variants.title"));
        variants(&mut out, comparison);
    }
    section(&mut out, say("form.report.results"));
    results(&mut out, report);
    section(&mut out, say("form.report.inputs"));
    inputs(&mut out, report);
    section(&mut out, say("form.report.programs"));
    run(&mut out, report);
    for sheet in &report.sheets {
        section(&mut out, say(sheet.title));
        self::sheet(&mut out, sheet);
    }
    section(&mut out, say("form.report.open"));
    settings(&mut out, &report.open.settings);
    for open in &report.open.facts {
        let _ = writeln!(out, "- {}", headed(say(open.kind), escape::markdown(&clauses(&open.facts))));
    }
    out
}

fn section(out: &mut String, title: &str) {
    let _ = write!(out, "\n## {title}\n\n");
}

fn line(out: &mut String, cells: &[String]) {
    let cells: Vec<_> = cells.iter().map(|cell| escape::markdown(cell).replace('|', "\\|")).collect();
    let _ = writeln!(out, "| {} |", cells.join(" | "));
}

fn head(out: &mut String, ids: &[&'static str]) {
    line(out, &ids.iter().map(|id| words(id).to_owned()).collect::<Vec<_>>());
    let _ = writeln!(out, "|{}", "---|".repeat(ids.len()));
}

/// Errors and remarks, the advice of the verdicts, then the changes with which the failing results hold.
fn findings(out: &mut String, report: &Report) {
    for finding in report.diagnostics.iter().chain(&report.sizing.exceeded) {
        let _ = writeln!(out, "- {}", escape::markdown(&sentence(&finding.message)));
        for hint in &finding.hints {
            let _ = writeln!(out, "  - {}", escape::markdown(&sentence(hint)));
        }
    }
    for readout in report.readouts.iter().filter(|readout| readout.verdict >= Verdict::Warn) {
        let _ = writeln!(out, "- {}", headed(words(readout.label), verdict(readout.verdict)));
        for advice in &readout.advice {
            let _ = writeln!(out, "  - {}", escape::markdown(&sentence(&advice.message)));
        }
    }
    for message in report.repairs.messages() {
        let _ = writeln!(out, "\n{}", escape::markdown(&sentence(&message)));
    }
}

fn parts(out: &mut String, report: &Report) {
    head(out, &PART_COLUMNS);
    for (item, part) in (1..).zip(&report.parts) {
        line(out, &cells_of_part(item, part));
    }
}

fn results(out: &mut String, report: &Report) {
    head(out, &RESULT_COLUMNS);
    for readout in &report.readouts {
        line(out, &cells_of_result(report, readout));
    }
}

fn inputs(out: &mut String, report: &Report) {
    head(out, &INPUT_COLUMNS);
    for input in &report.inputs {
        line(out, &cells_of_input(report, input));
    }
}

/// Settings of the control and the empty line behind their table.
fn settings(out: &mut String, settings: &[OpenSetting]) {
    if settings.is_empty() {
        return;
    }
    head(out, &SETTING_COLUMNS);
    for setting in settings {
        let [label, chosen, others] = cells_of_setting(setting);
        line(out, &[label, chosen, others, setting.cite.source.words().to_owned()]);
    }
    out.push('\n');
}

fn sheet(out: &mut String, sheet: &Sheet) {
    let mut columns: Vec<&str> = sheet.columns.iter().map(|column| column.head()).collect();
    if !has_sources(sheet) {
        columns.push("form.report.source");
    }
    head(out, &columns);
    for row in &sheet.rows {
        let mut cells = cells_of_row(row);
        cells.truncate(columns.len());
        line(out, &cells);
    }
}

/// Rows with differences between variants.
fn variants(out: &mut String, comparison: &Comparison) {
    let groups = comparison.differences();
    if groups.is_empty() {
        let _ = writeln!(out, "{}", words("variants.same"));
        return;
    }
    let heads = ["form.report.group", "variants.row", "form.report.unit"].map(words);
    let heads = heads.into_iter().chain(comparison.names.iter().map(String::as_str));
    let heads: Vec<String> = heads.map(str::to_owned).collect();
    line(out, &heads);
    let _ = writeln!(out, "|{}", "---|".repeat(heads.len()));
    for (title, rows) in groups {
        for row in rows {
            let cells = [words(title), &row.label, row.unit].map(str::to_owned);
            line(out, &cells.into_iter().chain(row.marked()).collect::<Vec<_>>());
        }
    }
}

fn run(out: &mut String, report: &Report) {
    for figure in &report.run.figures {
        let _ = writeln!(out, "- {}", headed(words(figure.label), figure.shown()));
    }
    for program in &report.programs {
        let _ = writeln!(out, "- {}, CRC-32 {}", escape::markdown(&program.name), program.checksum);
    }
    for step in &report.loading {
        let _ = writeln!(out, "- {}", escape::markdown(&sentence(step)));
    }
}

/// Filled entries of the title block.
fn block(out: &mut String, report: &Report) {
    let entries = [
        ("form.report.customer", &report.customer),
        ("form.report.date", &report.date),
        ("form.report.author", &report.block.author),
        ("form.report.number", &report.block.number),
        ("form.report.revision", &report.block.revision),
        ("form.report.checksum", &report.checksum),
    ];
    out.push('\n');
    for (label, value) in entries.into_iter().filter(|(_, value)| !value.is_empty()) {
        let _ = writeln!(out, "- {}", headed(words(label), escape::markdown(value)));
    }
}
