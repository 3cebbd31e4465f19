//! What leaves the page on paper, as the worker makes it: sheets as HTML, and the files of the export.

use leptos::wasm_bindgen::JsValue;

use super::script::{object, table};
use super::words::{grade, t, tell, tone};
use crate::machines;
use crate::project::Project;
use crate::text::{Diagnostic, Grade};
use crate::view::svg::escape;
use crate::view::{Sheet, ladder};

/// The sheets for the tab of the parameters, for the tab of the PLC, and those whose rows are ways that can be taken.
pub(super) fn sheets(project: &Project) -> JsValue {
    let sheets = machines::sheets(project.machine, &project.values, project.on());
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

fn html(out: &mut String, sheet: &Sheet) {
    let scroll = |out: &mut String| {
        out.push_str("<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"");
        escape(out, t(sheet.title));
        out.push_str("\">");
    };
    tagged(out, "h3", t(sheet.title));
    if !sheet.ladder.is_empty() {
        scroll(out);
        out.push_str(&ladder::svg(&sheet.ladder));
        out.push_str("</div>");
    }
    scroll(out);
    out.push_str("<table class=\"sheet\"><thead><tr>");
    for head in sheet.columns.iter().chain(&["page.grade"]) {
        out.push_str("<th scope=\"col\">");
        escape(out, t(head));
        out.push_str("</th>");
    }
    out.push_str("</tr></thead><tbody>");
    for row in &sheet.rows {
        if let [first, rest @ ..] = row.cells.as_slice()
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
            row.cells.iter().for_each(|cell| tagged(out, "td", cell));
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
