//! Cells of the tables of a report, independent of the output format.

use super::document::{Figure, Input, ListedPart, OpenSetting, Report};
use crate::text::Grade;
use crate::text::catalog::{number_text, sentence, words};
use crate::view::{Column, Limit, Readout, Row, Sheet, Verdict};

/// Short word for a verdict.
pub(super) fn verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::None => "",
        Verdict::Ok => words("form.report.ok"),
        Verdict::Warn => words("form.report.warn"),
        Verdict::Fail => words("form.report.fail"),
    }
}

/// Heads of the table of results.
pub(super) const RESULT_COLUMNS: [&str; 6] = [
    "form.report.result",
    "form.report.value",
    "form.report.limit",
    "form.report.verdict",
    "form.report.formula",
    "form.report.source",
];

/// Heads of the table of inputs.
pub(super) const INPUT_COLUMNS: [&str; 5] =
    ["form.report.group", "form.report.input", "form.report.symbol", "form.report.value", "form.report.origin"];

/// Heads of the parts list.
pub(super) const PART_COLUMNS: [&str; 5] =
    ["form.report.item", "form.report.quantity", "form.report.part", "form.report.data", "form.report.origin"];

/// Heads of the settings of the control, before that of their sources.
pub(super) const SETTING_COLUMNS: [&str; 4] =
    ["form.open.setting", "form.open.chosen", "form.open.others", "form.report.source"];

/// A setting of the control, without its source.
pub(super) fn cells_of_setting(setting: &OpenSetting) -> [String; 3] {
    [setting.label.clone(), setting.chosen.clone(), setting.others.clone()]
}

/// A row of the parts list.
pub(super) fn cells_of_part(item: u32, part: &ListedPart) -> [String; 5] {
    let origin = part.origin.map_or("", |id| words(id));
    let name = words(part.name);
    [item.to_string(), part.quantity.to_string(), name.to_owned(), part.data.clone(), origin.to_owned()]
}

/// Replaces `#` by the control's sign for variables.
fn with_variable(report: &Report, text: &str) -> String {
    text.replace('#', report.variable.encode_utf8(&mut [0; 4]))
}

fn shown(value: f64, decimals: u8, unit: &str) -> String {
    if value.is_finite() {
        format!("{} {unit}", number_text(value, decimals)).trim_end().to_owned()
    } else {
        "-".to_owned()
    }
}

impl Figure {
    /// Value and unit.
    pub(super) fn shown(&self) -> String {
        shown(self.value, self.decimals, self.unit)
    }
}

/// A limit as a phrase with its unit.
fn limit_words(readout: &Readout, limit: Limit) -> String {
    sentence(&limit.message(shown(limit.value(), readout.decimals, readout.unit)))
}

/// The cells of a result.
pub(super) fn cells_of_result(report: &Report, readout: &Readout) -> [String; 6] {
    [
        words(readout.label).to_owned(),
        shown(readout.value, readout.decimals_apart(), readout.unit),
        readout.limit.map_or(String::new(), |limit| limit_words(readout, limit)),
        verdict(readout.verdict).to_owned(),
        with_variable(report, readout.formula.words()),
        readout.cite.source.to_string(),
    ]
}

/// The cells of an input.
pub(super) fn cells_of_input(report: &Report, input: &Input) -> [String; 5] {
    [
        words(input.group).to_owned(),
        words(input.label).to_owned(),
        with_variable(report, input.symbol),
        format!("{} {}", input.value, input.unit).trim_end().to_owned(),
        input.origin.map_or(String::new(), |origin| origin.words().to_owned()),
    ]
}

/// Whether the sheet already has a column of sources.
pub(super) fn has_sources(sheet: &Sheet) -> bool {
    sheet.columns.iter().any(|column| matches!(column, Column::Source(_)))
}

/// Source of a row of a sheet, with a remark if it is not confirmed.
pub(super) fn source_of_row(row: &Row) -> String {
    let doubt = if row.grade == Grade::Open { words("form.report.unconfirmed") } else { "" };
    format!("{} {doubt}", row.source).trim_end().to_owned()
}

/// The cells of a row of a sheet, followed by its source.
pub(super) fn cells_of_row(row: &Row) -> Vec<String> {
    row.cells.iter().cloned().chain([source_of_row(row)]).collect()
}
