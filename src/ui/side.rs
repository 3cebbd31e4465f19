//! The tabs at the side: program, results, variables, sheets.

use leptos::prelude::*;
use web_sys::KeyboardEvent;

use super::dom;
use super::model::Model;
use super::program::program;
use super::results::results;
use super::sheets::{parameters, plc};
use super::variables::variables;
use super::words::t;

/// A tab.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Tab {
    /// The program files.
    Program,
    /// Every result.
    Results,
    /// The control's variables.
    Variables,
    /// Parameters of the control.
    Parameters,
    /// Interface and ladder.
    Plc,
}

const TABS: [(Tab, &str, &str); 5] = [
    (Tab::Program, "tab-program", "page.program"),
    (Tab::Results, "tab-results", "page.results"),
    (Tab::Variables, "tab-variables", "page.variables"),
    (Tab::Parameters, "tab-parameters", "page.parameters"),
    (Tab::Plc, "tab-plc", "page.plc"),
];

/// Shows a result among all results.
pub(super) fn open_result(model: Model, id: &'static str) {
    model.tab.set(Tab::Results);
    leptos::task::spawn_local(async move {
        leptos::task::tick().await;
        if let Some(row) = dom::by_id(&format!("result-{id}")) {
            row.scroll_into_view();
            let _ = row.focus();
        }
    });
}

/// The tabs.
pub(super) fn side(model: Model) -> AnyView {
    let tab = model.tab;
    // Arrow keys move between tabs, as in any list of tabs.
    let keys = move |event: KeyboardEvent| {
        let at = TABS.iter().position(|(one, ..)| *one == tab.get_untracked()).unwrap_or(0);
        let to = match event.key().as_str() {
            "ArrowRight" => (at + 1) % TABS.len(),
            "ArrowLeft" => (at + TABS.len() - 1) % TABS.len(),
            _ => return,
        };
        tab.set(TABS[to].0);
        if let Some(button) = dom::by_id(TABS[to].1) {
            let _ = button.focus();
        }
    };
    let tabs = TABS.map(|(one, id, label)| {
        let chosen = move || tab.get() == one;
        view! {
            <button type="button" role="tab" id=id aria-controls="side-body" aria-selected=move || chosen().to_string()
                tabindex=move || if chosen() { "0" } else { "-1" } on:click=move |_| tab.set(one)>{t(label)}</button>
        }
    });
    let body = move || match tab.get() {
        Tab::Program => program(model),
        Tab::Results => results(model),
        Tab::Variables => variables(model),
        Tab::Parameters => parameters(model),
        Tab::Plc => plc(model),
    };
    let label = move || TABS.iter().find(|(one, ..)| *one == tab.get()).map_or("", |(_, id, _)| *id);
    view! {
        <section class="pane side" id="side" aria-label=t("page.side")>
            <div class="tabs" role="tablist" on:keydown=keys>{tabs.into_iter().collect_view()}</div>
            <div class="body" id="side-body" role="tabpanel" aria-labelledby=label>{body}</div>
        </section>
    }
    .into_any()
}
