//! Parameter sheet, interface and ladder, as tables with sources and grades.

use super::el::{El, el};
use super::model::Model;
use super::words::t;
use crate::text::Grade;
use crate::view::{Sheet, ladder};

/// The sheet of the control's parameters.
pub(super) fn parameters(model: Model) -> Vec<El> {
    sheets(model, |id| id == "parameters")
}

/// Interface and ladder.
pub(super) fn plc(model: Model) -> Vec<El> {
    sheets(model, |id| id != "parameters")
}

fn sheets(model: Model, which: fn(&str) -> bool) -> Vec<El> {
    let all = move || {
        model.project.with(|project| {
            let sheets = project.machine.sheets(&project.values, project.control, &project.switches);
            sheets.iter().filter(|sheet| which(sheet.id)).flat_map(table).collect()
        })
    };
    vec![el("div.sheets").swap(all)]
}

fn grade(grade: Grade) -> &'static str {
    match grade {
        Grade::Manual => t("page.grade-manual"),
        Grade::Sister => t("page.grade-sister"),
        Grade::Measured => t("page.grade-measured"),
        Grade::Inferred => t("page.grade-inferred"),
        Grade::Open => t("page.grade-open"),
    }
}

fn table(sheet: &Sheet) -> Vec<El> {
    let mut parts = vec![el("h3").text(t(sheet.title))];
    if !sheet.ladder.is_empty() {
        let drawing = el("div.scroll").at("tabindex", "0").at("role", "group").label(t(sheet.title));
        drawing.dom().set_inner_html(&ladder::svg(&sheet.ladder));
        parts.push(drawing);
    }
    let head = |id: &&'static str| el("th").at("scope", "col").text(t(id));
    let heads: Vec<El> = sheet.columns.iter().chain(&["page.grade"]).map(head).collect();
    let rows: Vec<El> = sheet
        .rows
        .iter()
        .map(|row| {
            let cells: Vec<El> = row.cells.iter().map(|cell| el("td").text(cell)).collect();
            let class = if row.grade == Grade::Open { "td.grade.open" } else { "td.grade" };
            el("tr").add(&cells).add(&[el(class).at("title", row.source).text(grade(row.grade))])
        })
        .collect();
    let table = el("table.sheet").add(&[el("thead").add(&[el("tr").add(&heads)]), el("tbody").add(&rows)]);
    parts.push(el("div.scroll").at("tabindex", "0").at("role", "group").label(t(sheet.title)).add(&[table]));
    parts
}
