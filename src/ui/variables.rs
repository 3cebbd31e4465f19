//! The control's variables at the play head, to be set as on its screen.

use std::cell::Cell;

use web_sys::Event;

use super::dom;
use super::el::{El, el, number, value};
use super::model::Model;
use super::operator_panel::act;
use super::words::{t, value_of};
use crate::motion::Action;

/// The variables tab.
pub(super) fn variables(model: Model) -> Vec<El> {
    let rows = move || {
        model.variables.get().into_iter().map(|(variable, meaning, unit)| row(model, variable, meaning, unit)).collect()
    };
    let heads =
        ["page.variable", "page.value", "page.unit", "page.meaning"].map(|id| el("th").at("scope", "col").text(t(id)));
    let head = el("thead").add(&[el("tr").add(&heads)]);
    vec![el("p.lead").text(t("page.variables-lead")), el("table.variables").add(&[head, el("tbody").swap(rows)])]
}

fn row(model: Model, variable: u32, meaning: &'static str, unit: &str) -> El {
    let player = model.player;
    let control = model.project.with_untracked(|project| project.control);
    let name = control.variable(variable);
    let input = el("input").at("type", "text").at("inputmode", "decimal").at("autocomplete", "off").label(&name);
    let row = el("tr");
    let (field, line) = (input.input().clone(), row.dom().clone());
    let (last, flashes) = (Cell::new(None), Cell::new(0_u32));
    let follow = move || {
        let (value, changed) = player.variable(control, variable);
        let _ = line.toggle_attribute_with_force("data-changed", changed);
        if last.replace(Some(value)) == Some(value) {
            return;
        }
        field.set_value(&value_of(control, value, 6));
        // Another animation by turns makes the row flash at each change but the first.
        let class = match flashes.replace(flashes.get() + 1) {
            0 => "",
            count if count.is_multiple_of(2) => "flash-a",
            _ => "flash-b",
        };
        dom::set(&line, "class", class);
    };
    let set = move |event: Event| {
        let typed = value(&event);
        match number(&event) {
            None if !typed.trim().is_empty() => model.notify("warn", t("page.not-a-value").to_owned()),
            None if !control.has_vacant() => act(model, Action::Variable(variable, Some(0.0))),
            set => act(model, Action::Variable(variable, set)),
        }
    };
    row.run(follow).add(&[
        el("th").at("scope", "row").text(&name),
        el("td").add(&[input.on("change", set)]),
        el("td").text(unit),
        el("td").text(t(meaning)),
    ])
}
