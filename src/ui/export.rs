//! What leaves the page on paper, as the worker makes it: sheets as HTML, and the files of the export.

use leptos::wasm_bindgen::JsValue;

use super::script::{object, table};
use super::words::{grade, t, tell, tone};
use crate::project::Project;
use crate::text::{Diagnostic, Grade};
use crate::view::Sheet;
use crate::view::svg::escape;

/// The sheets for the tab of the parameters, for the tab of the PLC, and those whose rows are ways that can be taken.
pub(super) fn sheets(project: &Project) -> JsValue {
    let sheets = project.prepared().sheets();
    let (mut parameters, mut plc, mut ways) = (String::new(), String::new(), String::new());
    for sheet in &sheets {
        let takes = sheet.rows.iter().any(|row| !row.sets.is_empty());
        let out = match sheet.id {
            _ if takes => &mut ways,
            "parameters" => &mut parameters,
            _ => &mut plc,
        };
        html(out, sheet);
    }
    object([("parameters", parameters.into()), ("plc", plc.into()), ("ways", ways.into())])
}

/// Rows of a list that repeats a drawing above which it is folded.
const FOLDED: usize = 12;

fn html(out: &mut String, sheet: &Sheet) {
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
    // What no row has is no column.
    let some = |at: &usize| sheet.rows.iter().any(|row| row.cells.get(*at).is_some_and(|cell| !cell.is_empty()));
    let shown: Vec<usize> = (0..sheet.columns.len()).filter(some).collect();
    // Where there is little room, prose behind many columns goes below them: see `.stacked`.
    let prose = matches!(sheet.columns.last(), Some(&("sheet.meaning" | "sheet.use"))) && shown.len() > 3;
    out.push_str("<table class=\"sheet");
    if prose {
        out.push_str(&format!(" stacked n{}", shown.len() - 1));
    }
    out.push_str("\"><thead><tr>");
    for head in shown.iter().filter_map(|at| sheet.columns.get(*at)).chain(&["page.grade"]) {
        out.push_str("<th scope=\"col\">");
        escape(out, t(head));
        out.push_str("</th>");
    }
    out.push_str("</tr></thead><tbody>");
    for row in &sheet.rows {
        let cells: Vec<&String> = shown.iter().filter_map(|at| row.cells.get(*at)).collect();
        if let [first, rest @ ..] = cells.as_slice()
            && !row.sets.is_empty()
        {
            let sets: Vec<String> = row.sets.iter().map(|(id, text)| format!("{id}={text}")).collect();
            out.push_str("<tr data-sets=\"");
            escape(out, &sets.join(";"));
            out.push_str("\"><td><button type=\"button\" class=\"chip\" aria-label=\"");
            escape(out, &format!("{} {first}", t("page.take")));
            out.push_str("\">");
            escape(out, first);
            out.push_str("</button></td>");
            rest.iter().for_each(|cell| tagged(out, "td", cell));
        } else {
            out.push_str("<tr>");
            cells.iter().for_each(|cell| tagged(out, "td", cell));
        }
        out.push_str(if row.grade == Grade::Open {
            "<td class=\"grade open\" title=\""
        } else {
            "<td class=\"grade\" title=\""
        });
        escape(out, row.source);
        out.push_str("\">");
        escape(out, grade(row.grade));
        out.push_str("</td></tr>");
    }
    out.push_str("</tbody></table></div>");
    if folded {
        out.push_str("</details>");
    }
}

fn tagged(out: &mut String, tag: &str, text: &str) {
    out.push_str(&format!("<{tag}>"));
    escape(out, text);
    out.push_str(&format!("</{tag}>"));
}

/// The files of the export with name and text, and what is said of them: class, alarm, sentence, field.
pub(super) fn export(project: &Project) -> JsValue {
    let export = project.export_with(&project.advice(&project.written()));
    let files = export.files.iter().map(|file| vec![file.name.as_str().into(), file.text.as_str().into()]);
    let told = |found: &Diagnostic| {
        let alarm = found.alarm.as_deref().unwrap_or_default();
        vec![tone(found.severity).into(), alarm.into(), tell(found).into(), found.field.unwrap_or_default().into()]
    };
    object([("files", table(files)), ("told", table(export.diagnostics.iter().map(told)))])
}
