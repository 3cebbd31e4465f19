//! Sheets as HTML for the page, and the documents of an export.

use super::messages::{ExportDocuments, FoundRepairs, Range, ReadParts, Remark, Sheets};
use crate::controls::options::CommentCharacters;
use crate::project::chance;
use crate::project::export::ExportOptions;
use crate::project::meaning::{self, Subject, Table};
use crate::project::parts;
use crate::project::repairs;
use crate::project::saved::with_line;
use crate::project::size::{size, size_telling};
use crate::project::variants::compare;
use crate::project::{Project, encode};
use crate::text::{Diagnostic, DiagnosticKind, Grade, Message, Severity, columns};
use crate::ui::words::{Tone, sentence, sentence_with_hints, t, verdict_words};
use crate::view::svg::escape;
use crate::view::{Column, Comparison, Row, Sheet, SheetKind, VariantCell, Verdict};

/// The sheets of a project, by the tab that shows them.
pub(super) fn sheets(project: &Project) -> Sheets {
    let mut out = Sheets::default();
    for sheet in &project.prepared().sheets() {
        let takes = sheet.rows.iter().any(|row| !row.sets.is_empty());
        let tab = match sheet.kind {
            _ if takes => &mut out.ways,
            SheetKind::Parameters => &mut out.parameters,
            _ => &mut out.plc,
        };
        html(tab, sheet, project);
    }
    out
}

/// Changes with which the failing results of a project hold.
pub(in crate::ui) fn repairs(project: &Project) -> FoundRepairs {
    let found = repairs::repairs(project);
    let entry = |(id, text): &(&'static str, String)| ((*id).to_owned(), text.clone());
    FoundRepairs {
        changes: found.texts(),
        entries: found.changes.iter().flat_map(|change| &change.sets).map(entry).collect(),
        still_failing: found.still_failing as u32,
        errors: found.errors as u32,
    }
}

/// A project with the sound parts of a table.
pub(in crate::ui) fn parts(mut project: Project, name: &str, text: &str) -> ReadParts {
    let (read, found) = parts::read(text, name);
    let added = read.len() as u32;
    project.add_parts(read);
    let remark = |told: &Diagnostic| (told.severity == Severity::Error, with_line(told, text));
    ReadParts { project: project.to_json(), added, remarks: found.iter().map(remark).collect() }
}

/// The sheets of a sizing of the project; reports the share done.
pub(super) fn sizing(project: &Project, tell: &mut dyn FnMut(f64)) -> Sheets {
    let mut sizing = String::new();
    let sized = size_telling(project, &project.written(), tell);
    sized.sheets().iter().for_each(|sheet| html(&mut sizing, sheet, project));
    Sheets { sizing, ..Sheets::default() }
}

/// The chance that every verdict holds, as a sheet; reports the share done.
pub(super) fn chance(project: &Project, tell: &mut dyn FnMut(f64)) -> Sheets {
    let mut sizing = String::new();
    html(&mut sizing, &chance::chance_telling(project, chance::DRAWS, chance::SEED, tell).sheet(), project);
    Sheets { sizing, ..Sheets::default() }
}

/// The rows in which the present settings and the variants of a project differ, under titles; cells that differ from the present ones are
/// marked.
pub(in crate::ui) fn variants(project: &Project) -> String {
    project.compared_variants(t("variants.now")).map(|comparison| differences(&comparison)).unwrap_or_default()
}

/// Table of the differences between a project and another one, under these names, with the table's head.
pub(in crate::ui) fn compared_with(project: &Project, names: [String; 2], text: &str) -> String {
    let Some(other) = Project::from_json(text).project else { return String::new() };
    let [name, other_name] = names;
    let comparison = compare(&[(name, project.clone()), (other_name, other)]);
    let mut out = "<thead><tr>".to_owned();
    for head in std::iter::once(t("variants.row")).chain(comparison.names.iter().map(String::as_str)) {
        out.push_str("<th scope=\"col\">");
        tagged(&mut out, "span", head);
        out.push_str("</th>");
    }
    out.push_str("</tr></thead><tbody>");
    out + &differences(&comparison) + "</tbody>"
}

/// The rows of a comparison that differ, under the titles of their groups.
fn differences(comparison: &Comparison) -> String {
    let mut out = String::new();
    let columns = comparison.names.len() + 1;
    let titled = |out: &mut String, title: &str| {
        out.push_str(&format!("<tr class=\"title\"><th colspan=\"{columns}\" scope=\"colgroup\">"));
        tagged(out, "span", title);
        out.push_str("</th></tr>");
    };
    let groups = comparison.differences();
    if groups.is_empty() {
        titled(&mut out, t("variants.same"));
    }
    for (title, rows) in groups {
        titled(&mut out, t(title));
        for row in rows {
            out.push_str("<tr><th scope=\"row\">");
            escape(&mut out, &row.label);
            out.push(' ');
            tagged(&mut out, "small", row.unit);
            out.push_str("</th>");
            for (at, cell) in row.cells.iter().enumerate() {
                compared(&mut out, cell.as_ref(), row.differs_at(at));
            }
            out.push_str("</tr>");
        }
    }
    out
}

/// A cell of a comparison: the sign of a failed verdict, with its words for screen readers, then the value.
fn compared(out: &mut String, cell: Option<&VariantCell>, differs: bool) {
    out.push_str(if differs { "<td class=\"differs\">" } else { "<td>" });
    match cell {
        None => out.push('–'),
        Some((text, verdict)) => {
            if *verdict >= Verdict::Warn {
                let tone = Tone::from(*verdict);
                out.push_str(&format!("<i class=\"{tone}\" aria-hidden=\"true\">{}</i> ", tone.sign()));
            }
            escape(out, text);
            if *verdict >= Verdict::Warn {
                out.push_str("<span class=\"hidden\">, ");
                escape(out, verdict_words(*verdict));
                out.push_str("</span>");
            }
        }
    }
    out.push_str("</td>");
}

/// Rows of a list that repeats a drawing above which it is folded.
const FOLDED: usize = 12;

fn html(out: &mut String, sheet: &Sheet, project: &Project) {
    let titled = |out: &mut String, tag: &str| {
        out.push_str(tag);
        out.push_str(" aria-label=\"");
        escape(out, t(sheet.title));
        out.push_str("\">");
    };
    tagged(out, "h3", t(sheet.title));
    if !sheet.drawing.is_empty() {
        titled(out, "<div role=\"img\"");
        out.push_str(&sheet.drawing);
        out.push_str("</div>");
    }
    let folded = !sheet.drawing.is_empty() && sheet.rows.len() > FOLDED;
    if folded {
        out.push_str("<details>");
        tagged(out, "summary", t("page.as-table"));
    }
    titled(out, "<div class=\"scroll\" tabindex=\"0\" role=\"group\"");
    // Columns without a value are left out.
    let some = |at: &usize| sheet.rows.iter().any(|row| row.cells.get(*at).is_some_and(|cell| !cell.is_empty()));
    let shown: Vec<usize> = (0..sheet.columns.len()).filter(some).collect();
    // In a narrow layout, prose after many columns goes below them: see `.stacked`.
    let prose = matches!(sheet.columns.last(), Some(Column::Prose(_))) && shown.len() > 3;
    // In a narrow layout, sentences in several columns go below one another, each with its head: see `.told`.
    let is_bill = sheet.kind == SheetKind::Bill;
    let has_sentences = is_bill || shown.iter().filter(|at| longest(sheet, **at) > SENTENCE).count() > 2;
    // A source that all rows share is shown once.
    let common = sheet.common_source().filter(|_| is_bill || !has_sentences && !prose);
    out.push_str("<table class=\"sheet");
    if has_sentences {
        out.push_str(" told");
    } else if prose {
        out.push_str(&format!(" stacked n{}", shown.len() - 1));
    }
    out.push_str("\"><thead><tr>");
    let heads = shown.iter().filter_map(|at| sheet.columns.get(*at)).map(|column| column.head());
    for head in heads.chain(common.is_none().then_some("page.grade")) {
        out.push_str("<th scope=\"col\">");
        escape(out, t(head));
        out.push_str("</th>");
    }
    out.push_str("</tr></thead><tbody>");
    for row in &sheet.rows {
        let cells: Vec<(Option<&Column>, &String)> =
            shown.iter().filter_map(|at| Some((sheet.columns.get(*at), row.cells.get(*at)?))).collect();
        match cells.as_slice() {
            [(_, first), rest @ ..] if !row.sets.is_empty() => {
                offer(out, row, first);
                rest.iter().for_each(|(_, cell)| tagged(out, "td", cell));
            }
            cells => {
                out.push_str("<tr>");
                for (column, cell) in cells {
                    table_cell(out, *column, cell, has_sentences, project);
                }
            }
        }
        if common.is_none() {
            graded(out, "td", row);
        }
        out.push_str("</tr>");
    }
    out.push_str("</tbody></table></div>");
    if let Some(row) = common {
        graded(out, "p", row);
    }
    if folded {
        out.push_str("</details>");
    }
}

/// Opens a row whose entries the form can take, with its first cell as a button.
fn offer(out: &mut String, row: &Row, first: &str) {
    let sets: Vec<String> = row.sets.iter().map(|(id, text)| format!("{id}={text}")).collect();
    out.push_str("<tr data-sets=\"");
    escape(out, &sets.join("\n"));
    out.push_str("\"><td><button type=\"button\" class=\"chip\" aria-label=\"");
    escape(out, &format!("{} {first}", t("page.take")));
    out.push_str("\">");
    escape(out, first);
    out.push_str("</button></td>");
}

/// A cell of a column, with the head of the column where the table has sentences.
fn table_cell(out: &mut String, column: Option<&Column>, cell: &str, has_sentences: bool, project: &Project) {
    match column {
        Some(Column::Parameter(_)) if meaning::of(project, cell, Table::Parameters).is_some() => {
            out.push_str("<td data-means=\"parameters\">");
            escape(out, cell);
            out.push_str("</td>");
        }
        Some(Column::Prose(_) | Column::Product(_)) => tagged(out, "td", cell),
        // No head over nothing.
        _ if has_sentences && cell.is_empty() => out.push_str("<td></td>"),
        Some(column) if has_sentences => {
            out.push_str("<td>");
            tagged(out, "small", t(column.head()));
            escape(out, cell);
            out.push_str("</td>");
        }
        _ => devices(out, cell, project),
    }
}

/// The grade of a row, with its source; as a paragraph with the source beside it.
fn graded(out: &mut String, tag: &str, row: &Row) {
    let open = if row.grade == Grade::Open { " open" } else { "" };
    out.push_str(&format!("<{tag} class=\"grade{open}\" title=\""));
    escape(out, row.source.words());
    out.push_str("\">");
    if tag == "p" {
        escape(out, row.source.words());
        out.push_str(": ");
    }
    escape(out, row.grade.words());
    out.push_str(&format!("</{tag}>"));
}

/// Characters from which on a cell is a sentence.
const SENTENCE: usize = 24;

/// Characters of the longest cell of a column.
fn longest(sheet: &Sheet, at: usize) -> usize {
    sheet.rows.iter().filter_map(|row| Some(columns(row.cells.get(at)?))).max().unwrap_or(0)
}

/// A cell whose registers and variables have their meaning: `MOV R148 R74`.
fn devices(out: &mut String, cell: &str, project: &Project) {
    out.push_str("<td>");
    for (at, word) in cell.split(' ').enumerate() {
        if at > 0 {
            out.push(' ');
        }
        let means = meaning::of(project, word, Table::Interface).map(|found| found.subject);
        if matches!(means, Some(Subject::Signal(_) | Subject::Variable(_) | Subject::Code(_))) {
            out.push_str("<span data-means=\"interface\">");
            escape(out, word);
            out.push_str("</span>");
        } else {
            escape(out, word);
        }
    }
    out.push_str("</td>");
}

pub(super) fn tagged(out: &mut String, tag: &str, text: &str) {
    out.push_str(&format!("<{tag}>"));
    escape(out, text);
    out.push_str(&format!("</{tag}>"));
}

/// The day by the computer's clock, `2026-11-22`.
fn today() -> String {
    let now = js_sys::Date::new_0();
    format!("{:04}-{:02}-{:02}", now.get_full_year(), now.get_month() + 1, now.get_date())
}

/// A finding as a sentence; assumed facts are counted, because the results list them by name.
fn finding_text(found: &Diagnostic) -> String {
    match found.kind {
        DiagnosticKind::AssumedFacts => sentence(&Message { id: "page.assumed-facts", ..found.message.clone() }),
        _ => sentence_with_hints(found),
    }
}

/// The documents of a project's export, with the findings that refuse it or accompany it.
pub(super) fn documents(project: &Project) -> ExportDocuments {
    let written = project.written();
    let (advice, date, sizing) = (project.advice(&written), today(), size(project, &written));
    let options = ExportOptions { advice: &advice, date: &date, sizing: Some(&sizing) };
    let export = project.export_with(&written, &options);
    let remark = |found: &Diagnostic| Remark {
        refuses: found.severity == Severity::Error,
        tone: found.severity.into(),
        alarm: found.alarm.as_deref().unwrap_or_default().to_owned(),
        text: finding_text(found),
        field: found.field.unwrap_or_default().to_owned(),
        place: found.place.map(Range::from),
    };
    let programs = match project.characters() {
        CommentCharacters::Gbk => {
            written.files.0.iter().map(|file| encode::bytes(&file.text, CommentCharacters::Gbk)).collect()
        }
        CommentCharacters::Ascii | CommentCharacters::Utf8 => Vec::new(),
    };
    ExportDocuments {
        programs,
        files: export.documents().iter().map(|file| (file.name.clone(), file.text.clone())).collect(),
        remarks: export.diagnostics.iter().map(remark).collect(),
        draft: export.draft,
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::project;

    #[wasm_bindgen_test]
    fn remark_about_assumed_facts_has_no_ids_of_fields() {
        let project = project();
        let remarks = documents(&project).remarks;
        assert!(remarks.iter().any(|remark| remark.text.contains("only assumed")));
        for field in project.machine.fields().iter().filter(|field| field.id.contains('-')) {
            assert!(remarks.iter().all(|remark| !remark.text.contains(field.id)), "{}", field.id);
        }
    }
}
