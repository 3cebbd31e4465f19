//! The report as Markdown.

use core::fmt::Write;

use super::cells::{
    INPUT_COLUMNS, PART_COLUMNS, RESULT_COLUMNS, cells_of_input, cells_of_part, cells_of_result, cells_of_row, verdict,
};
use super::document::Report;
use crate::text::catalog::{Language, sentence, words};
use crate::text::escape;
use crate::view::{Comparison, Sheet, Verdict};

/// The report as Markdown, readable as plain text too.
pub fn markdown(report: &Report, language: Language) -> String {
    let mut out = format!("# {}\n", escape::markdown(&report.title));
    let say = |id| words(language, id);
    block(&mut out, report, language);
    section(&mut out, say("form.report.parts"));
    parts(&mut out, report, language);
    section(&mut out, say("form.report.findings"));
    findings(&mut out, report, language);
    for sheet in &report.sizing {
        section(&mut out, say(sheet.title));
        self::sheet(&mut out, sheet, language);
    }
    if let Some(comparison) = &report.variants {
        section(&mut out, say("variants.title"));
        variants(&mut out, comparison, language);
    }
    section(&mut out, say("form.report.results"));
    results(&mut out, report, language);
    section(&mut out, say("form.report.inputs"));
    inputs(&mut out, report, language);
    section(&mut out, say("form.report.programs"));
    run(&mut out, report, language);
    for sheet in &report.sheets {
        section(&mut out, say(sheet.title));
        self::sheet(&mut out, sheet, language);
    }
    section(&mut out, say("form.report.open"));
    for open in &report.open {
        let _ = writeln!(out, "- {}: {}", say(open.kind), escape::markdown(&open.facts.join("; ")));
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

fn head(out: &mut String, language: Language, ids: &[&'static str]) {
    line(out, &ids.iter().map(|id| words(language, id).to_owned()).collect::<Vec<_>>());
    let _ = writeln!(out, "|{}", "---|".repeat(ids.len()));
}

/// Errors and remarks, then what the verdicts advise.
fn findings(out: &mut String, report: &Report, language: Language) {
    for finding in report.diagnostics.iter().chain(&report.exceeded) {
        let _ = writeln!(out, "- {}", escape::markdown(&sentence(language, &finding.message)));
        for hint in &finding.hints {
            let _ = writeln!(out, "  - {}", escape::markdown(&sentence(language, hint)));
        }
    }
    for readout in report.readouts.iter().filter(|readout| readout.verdict >= Verdict::Warn) {
        let _ = writeln!(out, "- {}: {}", words(language, readout.label), verdict(readout.verdict, language));
        for advice in &readout.advice {
            let _ = writeln!(out, "  - {}", escape::markdown(&sentence(language, &advice.message)));
        }
    }
}

fn parts(out: &mut String, report: &Report, language: Language) {
    head(out, language, &PART_COLUMNS);
    for (item, part) in (1..).zip(&report.parts) {
        line(out, &cells_of_part(item, part, language));
    }
}

fn results(out: &mut String, report: &Report, language: Language) {
    head(out, language, &RESULT_COLUMNS);
    for readout in &report.readouts {
        line(out, &cells_of_result(report, readout, language));
    }
}

fn inputs(out: &mut String, report: &Report, language: Language) {
    head(out, language, &INPUT_COLUMNS);
    for input in &report.inputs {
        line(out, &cells_of_input(report, input, language));
    }
}

fn sheet(out: &mut String, sheet: &Sheet, language: Language) {
    let mut columns = sheet.columns.clone();
    columns.push("form.report.source");
    head(out, language, &columns);
    for row in &sheet.rows {
        line(out, &cells_of_row(row, language));
    }
}

/// The rows in which the variants differ.
fn variants(out: &mut String, comparison: &Comparison, language: Language) {
    let groups = comparison.differences();
    if groups.is_empty() {
        let _ = writeln!(out, "{}", words(language, "variants.same"));
        return;
    }
    let heads = ["form.report.group", "variants.row", "form.report.unit"].map(|id| words(language, id));
    let heads = heads.into_iter().chain(comparison.names.iter().map(String::as_str));
    let heads: Vec<String> = heads.map(str::to_owned).collect();
    line(out, &heads);
    let _ = writeln!(out, "|{}", "---|".repeat(heads.len()));
    for (title, rows) in groups {
        for row in rows {
            let cells = [words(language, title), &row.label, row.unit].map(str::to_owned);
            line(out, &cells.into_iter().chain(row.marked()).collect::<Vec<_>>());
        }
    }
}

fn run(out: &mut String, report: &Report, language: Language) {
    for figure in &report.run.figures {
        let _ = writeln!(out, "- {}: {}", words(language, figure.label), figure.shown());
    }
    for program in &report.programs {
        let _ = writeln!(out, "- {}, CRC-32 {}", escape::markdown(&program.name), program.checksum);
    }
    for told in &report.loading {
        let _ = writeln!(out, "- {}", escape::markdown(&sentence(language, told)));
    }
}

/// Entries of the title block that are filled in.
fn block(out: &mut String, report: &Report, language: Language) {
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
        let _ = writeln!(out, "- {}: {}", words(language, label), escape::markdown(value));
    }
}
