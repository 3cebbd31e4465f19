//! A report: inputs with their origin, results with formulas and verdicts, sheets, and open points.

use core::fmt::Write;

use super::{Readout, Sheet, Verdict};
use crate::text::catalog::{Language, number_text, sentence, words};
use crate::text::{Diagnostic, Grade, escape};

/// An input of the report.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Id of its field.
    pub id: &'static str,
    /// Catalog id of its group.
    pub group: &'static str,
    /// Catalog id of its label.
    pub label: &'static str,
    /// Symbol or variable, or empty.
    pub symbol: &'static str,
    /// Value as it is shown.
    pub value: String,
    /// Unit, or empty.
    pub unit: &'static str,
    /// Catalog id of where a fact comes from; `None` for a choice.
    pub origin: Option<&'static str>,
}

/// A kind of facts about the control that no manual at hand confirms.
#[derive(Debug, Clone, PartialEq)]
pub struct Open {
    /// Catalog id of the kind.
    pub kind: &'static str,
    /// The facts, a few words each.
    pub facts: Vec<String>,
}

/// Everything that the report says.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// Machine, control, name of the project.
    pub title: String,
    /// Prefix of the control's variables, for instance `#`.
    pub variable: char,
    /// Inputs by group.
    pub inputs: Vec<Input>,
    /// Results with verdicts.
    pub readouts: Vec<Readout>,
    /// Findings about fields and program.
    pub diagnostics: Vec<Diagnostic>,
    /// Tables.
    pub sheets: Vec<Sheet>,
    /// What is open.
    pub open: Vec<Open>,
}

/// The report as Markdown, readable as plain text too.
pub fn markdown(report: &Report, language: Language) -> String {
    let mut out = format!("# {}\n", escape::markdown(&report.title));
    let say = |id| words(language, id);
    section(&mut out, say("form.report.findings"));
    findings(&mut out, report, language);
    section(&mut out, say("form.report.results"));
    results(&mut out, report, language);
    section(&mut out, say("form.report.inputs"));
    inputs(&mut out, report, language);
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
    for finding in &report.diagnostics {
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

fn verdict(verdict: Verdict, language: Language) -> &'static str {
    match verdict {
        Verdict::None => "",
        Verdict::Ok => words(language, "form.report.ok"),
        Verdict::Warn => words(language, "form.report.warn"),
        Verdict::Fail => words(language, "form.report.fail"),
    }
}

fn results(out: &mut String, report: &Report, language: Language) {
    let columns = [
        "form.report.result",
        "form.report.value",
        "form.report.limit",
        "form.report.verdict",
        "form.report.formula",
        "form.report.source",
    ];
    head(out, language, &columns);
    for readout in &report.readouts {
        let shown =
            |value: f64| format!("{} {}", number_text(value, readout.decimals), readout.unit).trim_end().to_owned();
        let cells = [
            words(language, readout.label).to_owned(),
            if readout.value.is_finite() { shown(readout.value) } else { "-".to_owned() },
            readout.limit.map_or(String::new(), |limit| sentence(language, &limit.message(shown(limit.value())))),
            verdict(readout.verdict, language).to_owned(),
            readout.formula.replace('#', report.variable.encode_utf8(&mut [0; 4])),
            readout.cite.source.to_owned(),
        ];
        line(out, &cells);
    }
}

fn inputs(out: &mut String, report: &Report, language: Language) {
    head(
        out,
        language,
        &["form.report.group", "form.report.input", "form.report.symbol", "form.report.value", "form.report.origin"],
    );
    for input in &report.inputs {
        let cells = [
            words(language, input.group).to_owned(),
            words(language, input.label).to_owned(),
            input.symbol.replace('#', report.variable.encode_utf8(&mut [0; 4])),
            format!("{} {}", input.value, input.unit).trim_end().to_owned(),
            input.origin.map_or(String::new(), |id| words(language, id).to_owned()),
        ];
        line(out, &cells);
    }
}

fn sheet(out: &mut String, sheet: &Sheet, language: Language) {
    let mut columns = sheet.columns.clone();
    columns.push("form.report.source");
    head(out, language, &columns);
    for row in &sheet.rows {
        let mut cells = row.cells.clone();
        let doubt = if row.grade == Grade::Open { words(language, "form.report.unconfirmed") } else { "" };
        cells.push(format!("{} {doubt}", row.source).trim_end().to_owned());
        line(out, &cells);
    }
}
