//! The control's variables at the play head, to be set as on its screen.

use leptos::prelude::*;

use super::hand::act;
use super::model::Model;
use super::words::{figure, t};
use crate::motion::Action;

/// The variables tab.
pub(super) fn variables(model: Model) -> AnyView {
    let machine = Memo::new(move |_| model.project.with(|project| (project.machine.id(), project.control.id)));
    let rows = move || {
        machine.track();
        let rows = model.project.with_untracked(|project| project.machine.variables(project.control));
        rows.into_iter().map(|(number, meaning, unit)| row(model, number, meaning, unit)).collect_view()
    };
    view! {
        <p class="lead">{t("page.variables-lead")}</p>
        <table class="variables">
            <thead><tr><th scope="col">{t("page.variable")}</th><th scope="col">{t("page.value")}</th><th scope="col">{t("page.unit")}</th><th scope="col">{t("page.meaning")}</th></tr></thead>
            <tbody>{rows}</tbody>
        </table>
    }
    .into_any()
}

fn row(model: Model, number: u32, meaning: &'static str, unit: &'static str) -> AnyView {
    let player = model.player;
    let value = Memo::new(move |_| {
        player.plans.track();
        let t = player.now.with(|now| now.t);
        player.ask_planner(|planner| planner.variable_at(number, t)).flatten()
    });
    // Another animation by turns makes the row flash at each change.
    let flash = Memo::new(move |count: Option<&u32>| {
        value.track();
        count.map_or(0, |count| count + 1)
    });
    let class = move || match flash.get() {
        0 => "",
        count if count.is_multiple_of(2) => "flash-a",
        _ => "flash-b",
    };
    let text = move || {
        value.get().map_or_else(
            || t("page.vacant").to_owned(),
            |value| figure(value, 6).trim_end_matches('0').trim_end_matches('.').to_owned(),
        )
    };
    let set = move |event: web_sys::Event| {
        let typed =
            event_target_value(&event).replace(',', ".").replace('\u{2212}', "-").replace(['\u{202f}', ' '], "");
        let parsed =
            if typed.is_empty() { Some(None) } else { typed.parse::<f64>().ok().filter(|v| v.is_finite()).map(Some) };
        match parsed {
            Some(value) => act(model, Action::Variable(number, value)),
            None => model.notify("warn", t("page.not-a-value").to_owned()),
        }
    };
    view! {
        <tr class=class>
            <th scope="row">"#" {number}</th>
            <td><input type="text" inputmode="decimal" autocomplete="off" aria-label=format!("#{number}") prop:value=text on:change=set /></td>
            <td>{unit}</td>
            <td>{t(meaning)}</td>
        </tr>
    }
    .into_any()
}
