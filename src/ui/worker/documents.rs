//! Documents of a project for the page: its sheets by tabs, its sizing, comparisons, and the documents of an export.

use super::messages::{
    CompareProjects, ComparedVariants, ExportDocuments, ExportedDocument, FoundRepairs, Range, ReadParts,
    ReadPartsTable, Remark, Sheets, ShownSection,
};
use super::sheet_html::{html, section_html, table, tagged};
use crate::controls::options::CommentCharacters;
use crate::nc::File;
use crate::project::Project;
use crate::project::chance;
use crate::project::export::{Export, ExportOptions, REPORT};
use crate::project::files::encode;
use crate::project::parts;
use crate::project::program::Written;
use crate::project::repairs::{self, RepairWay};
use crate::project::saved::with_line;
use crate::project::size::sections::SizingSection;
use crate::project::size::{size, size_with_progress};
use crate::project::variants::compare;
use crate::text::{Diagnostic, DiagnosticKind, Message};
use crate::ui::words::{Tone, sentence, sentence_with_hints, t, verdict_words};
use crate::view::svg::escape;
use crate::view::{Comparison, FieldEntry, Readout, SheetKind, VariantCell, Verdict};

/// The sheets of a project, by the tab that shows them.
pub(super) fn sheets(project: &Project) -> Sheets {
    let mut out = Sheets::default();
    for sheet in &project.prepared().sheets() {
        let takes = sheet.rows.iter().any(|row| !row.entries.is_empty());
        let tab = match sheet.kind {
            _ if takes => &mut out.ways,
            SheetKind::Parameters => &mut out.parameters,
            _ => &mut out.plc,
        };
        html(tab, sheet, project);
    }
    out
}

/// Ways to make the failing results of a project hold.
pub(super) fn repairs(project: &Project) -> Vec<FoundRepairs> {
    repairs::ways(project).iter().map(found_repairs).collect()
}

fn found_repairs(way: &RepairWay) -> FoundRepairs {
    let found = &way.repairs;
    let entry = |entry: &FieldEntry| (entry.field.to_owned(), entry.text.clone());
    let consequence = |(before, after): &(Readout, Readout)| {
        let [before, after] = [before, after].map(|readout| readout.clone().shown());
        let [from, to] = [&before, &after].map(|readout| readout.value_text());
        format!("{} {from} → {to} {}", t(after.label), after.unit).trim_end().to_owned()
    };
    FoundRepairs {
        changes: found.texts(),
        consequences: way.consequences.iter().map(consequence).collect(),
        entries: found.changes.iter().flat_map(|change| &change.entries).map(entry).collect(),
        still_failing: found.still_failing as u32,
        errors: found.errors as u32,
        warning: found.warning().as_ref().map(sentence).unwrap_or_default(),
    }
}

/// A project with the sound parts of a table.
pub(super) fn parts(project: &Project, ReadPartsTable { name, text }: &ReadPartsTable) -> ReadParts {
    let mut project = project.clone();
    let (read, found) = parts::read(text, name);
    let added = read.len() as u32;
    project.add_parts(read);
    let remark = |finding: &Diagnostic| (finding.is_error(), with_line(finding, text));
    ReadParts { project: project.to_json(), added, remarks: found.iter().map(remark).collect() }
}

/// The sections of a sizing of the project; reports the share done.
pub(super) fn sizing(project: &Project, tell: &mut dyn FnMut(f64)) -> Vec<ShownSection> {
    let shown = |section: SizingSection| ShownSection {
        id: section.id.to_owned(),
        title: t(section.title).to_owned(),
        tone: section.verdict.into(),
        html: section_html(&section, project),
        answer: section.answer,
    };
    size_with_progress(project, &project.written(), tell).sections().into_iter().map(shown).collect()
}

/// The chance that every verdict holds, as a section of the sizing; reports the share done.
pub(super) fn chance(project: &Project, tell: &mut dyn FnMut(f64)) -> ShownSection {
    let chance = chance::chance_with_progress(project, chance::DRAWS, chance::SEED, tell);
    let sheet = chance.sheet();
    let mut html = String::new();
    table(&mut html, &sheet, project);
    ShownSection {
        id: sheet.id.to_owned(),
        title: t(sheet.title).to_owned(),
        tone: chance.verdict().into(),
        answer: chance.answer(),
        html,
    }
}

/// The rows in which the present settings and the variants of a project differ, under titles; cells that differ from the present ones are
/// marked.
pub(super) fn variants(project: &Project) -> ComparedVariants {
    ComparedVariants {
        names: project.variants.iter().map(|variant| variant.name.clone()).collect(),
        rows: project
            .compared_variants(t("variants.now"))
            .map(|comparison| differences(&comparison))
            .unwrap_or_default(),
    }
}

/// Table of the differences between a project and another one, with the table's head.
pub(super) fn compared_with(project: &Project, CompareProjects { names, other }: &CompareProjects) -> String {
    let Some(other) = Project::from_json(other).project else { return String::new() };
    let [name, other_name] = names.clone();
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

fn exported(project: &Project, written: &Written) -> Export {
    let (advice, date, sizing) = (project.advice(written), today(), size(project, written));
    project.export_with(written, &ExportOptions { advice: &advice, date: &date, sizing: Some(&sizing) })
}

/// The report of a project as HTML; its draft where the export is refused.
pub(super) fn report(project: &Project) -> Option<String> {
    let export = exported(project, &project.written());
    let report = export.documents().find(|(file, _)| file.name == REPORT).map(|(file, _)| file.text.clone());
    report.or(export.draft)
}

/// The documents of a project's export, with the findings that refuse it or accompany it.
pub(super) fn export(project: &Project) -> ExportDocuments {
    let written = project.written();
    let export = exported(project, &written);
    let remark = |found: &Diagnostic| Remark {
        refuses: found.is_error(),
        tone: found.severity.into(),
        alarm: found.alarm.as_deref().unwrap_or_default().to_owned(),
        text: finding_text(found),
        field: found.field.unwrap_or_default().to_owned(),
        place: found.place.map(Range::from),
    };
    let document = |(file, meaning): (&File, &'static str)| ExportedDocument {
        name: file.name.clone(),
        meaning: t(meaning).to_owned(),
        text: file.text.clone(),
    };
    let programs = match project.characters() {
        CommentCharacters::Gbk => {
            written.files.0.iter().map(|file| encode::bytes(&file.text, CommentCharacters::Gbk)).collect()
        }
        CommentCharacters::Ascii | CommentCharacters::Utf8 => Vec::new(),
    };
    ExportDocuments {
        programs,
        files: export.documents().map(document).collect(),
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
        let remarks = export(&project).remarks;
        assert!(remarks.iter().any(|remark| remark.text.contains("only assumed")));
        for field in project.machine.fields().iter().filter(|field| field.id.contains('-')) {
            assert!(remarks.iter().all(|remark| !remark.text.contains(field.id)), "{}", field.id);
        }
    }
}
