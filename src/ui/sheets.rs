//! Parameter sheet, interface and ladder, as tables with sources and grades.

use super::el::{El, el, value};
use super::model::Model;
use super::words::{grade, t};
use super::worker::messages::{Request, Response, Sheets};
use crate::controls::Switch;
use crate::controls::options::SwitchOption;
use crate::text::Grade;
use crate::text::catalog::Language;

/// The sheet of the control's parameters.
pub(super) fn parameters(model: Model) -> Vec<El> {
    vec![sheets(model, |sheets| &sheets.parameters), switches(model)]
}

/// Interface and ladder.
pub(super) fn plc(model: Model) -> Vec<El> {
    vec![sheets(model, |sheets| &sheets.plc)]
}

/// Sheets from the worker, made anew with every change of the project; `which` picks those to show.
pub(super) fn sheets(model: Model, which: fn(&Sheets) -> &String) -> El {
    let host = el("div.sheets").add(&[el("p.lead").text(t("page.reading"))]);
    let element = host.dom().clone();
    host.run(move || {
        let element = element.clone();
        let show = move |response: Option<Response>| {
            let Some(Response::Sheets(sheets)) = response else {
                return element.set_text_content(Some(t("page.no-answer")));
            };
            let html = which(&sheets);
            element.set_inner_html(html);
            if html.is_empty() {
                let _ = element.append_child(el("p.lead").text(t("page.no-sheet")).dom());
            }
        };
        model.project.with(|project| model.worker.ask(project, Request::Sheets, show));
    })
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
    let set = move || model.project.with(|p| p.switches.setting(switch).to_owned());
    let text = switch.text(Language::English);
    let input = if switch.is_text() {
        el("input").at("type", "text").at("spellcheck", "false").at("autocomplete", "off")
    } else {
        let option = |one: &SwitchOption| el("option").at("value", one.id).text(t(one.label));
        let options: Vec<El> = switch.options().iter().map(option).collect();
        el("select").add(&options)
    };
    let input = input.label(&text).valued(set).on("change", move |event| {
        let chosen = value(&event).trim().to_owned();
        if !switch.takes(&chosen) {
            model.notify("warn", t("page.not-a-setting").to_owned());
            return;
        }
        model.edit(switch.id(), |project| project.switches.set(switch, &chosen));
    });
    let class = if switch.cite.grade == Grade::Open { "td.grade.open" } else { "td.grade" };
    el("tr").add(&[
        el("td").text(&text),
        el("td").add(&[input]),
        el(class).at("title", switch.cite.source).text(grade(switch.cite.grade)),
    ])
}
