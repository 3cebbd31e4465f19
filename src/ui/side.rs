//! The tabs at the side: program, results, variables, sheets.

use leptos::prelude::untrack;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Event, KeyboardEvent};

use super::dom;
use super::el::{El, button, el};
use super::explore::{explore, explores};
use super::model::Model;
use super::program::program;
use super::results::results;
use super::sheets::{parameters, plc};
use super::state::Tab;
use super::variables::variables;
use super::words::t;

const TABS: [(Tab, &str, &str); 6] = [
    (Tab::Program, "tab-program", "page.program"),
    (Tab::Results, "tab-results", "page.results"),
    (Tab::Explore, "tab-explore", "page.explore"),
    (Tab::Variables, "tab-variables", "page.variables"),
    (Tab::Parameters, "tab-parameters", "page.parameters"),
    (Tab::Plc, "tab-plc", "page.plc"),
];

/// Whether the machine has something for a tab.
fn is_there(model: Model, tab: Tab) -> bool {
    tab != Tab::Explore || explores(model)
}

/// The tabs.
pub(super) fn side(model: Model) -> El {
    let tab = model.tab;
    // Arrow keys move between tabs, as in any list of tabs.
    let keys = move |event: Event| {
        let event: &KeyboardEvent = event.unchecked_ref();
        let there: Vec<_> = TABS.iter().filter(|(one, ..)| untrack(|| is_there(model, *one))).collect();
        let at = there.iter().position(|(one, ..)| *one == tab.get_untracked()).unwrap_or(0);
        let to = match event.key().as_str() {
            "ArrowRight" => (at + 1) % there.len(),
            "ArrowLeft" => (at + there.len() - 1) % there.len(),
            _ => return,
        };
        let (one, id, _) = there[to];
        tab.set(*one);
        if let Some(button) = dom::by_id(id) {
            let _ = button.focus();
        }
    };
    let tabs = TABS.map(|(one, id, label)| {
        let chosen = move || tab.get() == one;
        let index = move || if chosen() { "0" } else { "-1" }.to_owned();
        button("button", t(label), move || tab.set(one))
            .at("role", "tab")
            .at("id", id)
            .at("aria-controls", "side-body")
            .state("aria-selected", chosen)
            .bind("tabindex", index)
            .mark("gone", move || !is_there(model, one))
    });
    let body = move || match tab.get() {
        Tab::Program => program(model),
        Tab::Results => results(model),
        Tab::Explore => explore(model),
        Tab::Variables => variables(model),
        Tab::Parameters => parameters(model),
        Tab::Plc => plc(model),
    };
    let leave = move || {
        if !is_there(model, tab.get()) {
            tab.set(Tab::Program);
        }
    };
    let label = move || TABS.iter().find(|(one, ..)| *one == tab.get()).map_or("", |(_, id, _)| *id).to_owned();
    let tabs = el("div.tabs").at("role", "tablist").add(&tabs).on("keydown", keys);
    let body = el("div.body#side-body").at("role", "tabpanel").bind("aria-labelledby", label).swap(body);
    el("section.pane.side#side").label(t("page.side")).add(&[tabs, body]).run(leave)
}
