//! Parameter sheet, interface and ladder, as tables with sources and grades.

use super::el::{El, el, value};
use super::model::Model;
use super::words::t;
use crate::controls::Switch;
use crate::text::Grade;
use crate::view::{Sheet, ladder};

/// The sheet of the control's parameters.
pub(super) fn parameters(model: Model) -> Vec<El> {
    let mut parts = sheets(model, |id| id == "parameters");
    parts.push(switches(model));
    parts
}

/// Interface and ladder.
pub(super) fn plc(model: Model) -> Vec<El> {
    sheets(model, |id| id != "parameters")
}

fn sheets(model: Model, which: fn(&str) -> bool) -> Vec<El> {
    let all = move || {
        model.project.with(|project| {
            let sheets = project.machine.sheets(&project.values, project.on());
            sheets.iter().filter(|sheet| which(sheet.id)).flat_map(table).collect()
        })
    };
    vec![el("div.sheets").swap(all)]
}

/// The points of the control that no manual at hand settles, each with its settings, source and grade.
fn switches(model: Model) -> El {
    let rows = move || {
        model.control.track();
        model.project.with_untracked(|project| project.control.switches).iter().map(|row| switch(model, row)).collect()
    };
    el("div.sheets").add(&[
        el("h3").text(t("page.switches")),
        el("p.lead").text(t("page.switches-lead")),
        el("table.switches").add(&[el("tbody").swap(rows)]),
    ])
}

fn switch(model: Model, switch: &'static Switch) -> El {
    let set =
        move || model.project.with(|p| p.switches.get(p.control.switches, switch.id).unwrap_or_default().to_owned());
    let input = if switch.is_text() {
        el("input").at("type", "text").at("spellcheck", "false").at("autocomplete", "off")
    } else {
        let options: Vec<El> = switch.options.iter().map(|one| el("option").at("value", one).text(one)).collect();
        el("select").add(&options)
    };
    let input = input.label(switch.text).valued(set).on("change", move |event| {
        let chosen = value(&event).trim().to_owned();
        if !switch.takes(&chosen) {
            model.notify("warn", t("page.not-a-setting").to_owned());
            return;
        }
        model.edit(switch.id, |project| {
            project.switches.0.retain(|(id, _)| id != switch.id);
            if switch.options.first() != Some(&chosen.as_str()) {
                project.switches.0.push((switch.id.to_owned(), chosen));
            }
        });
    });
    let class = if switch.cite.grade == Grade::Open { "td.grade.open" } else { "td.grade" };
    el("tr").add(&[
        el("td").text(switch.text),
        el("td").add(&[input]),
        el(class).at("title", switch.cite.source).text(grade(switch.cite.grade)),
    ])
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
