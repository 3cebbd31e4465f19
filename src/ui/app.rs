//! The page: puts the features together.

use leptos::ev::KeyboardEvent;
use leptos::prelude::*;

use super::dom;
use super::files::{ExportDialog, Header, LargeFile, LargeFileDialog, open, store};
use super::form::Form;
use super::form::field_help::FieldHelp;
use super::help::{HelpDialog, keys};
use super::machine::Machine;
use super::machine::operator_panel::OperatorPanel;
use super::parts::divider::Divider;
use super::program::ProgramTab;
use super::results::{ExploreTab, ParametersTab, PlcTab, ResultsTab, VariablesTab};
use super::state::view::Tab;
use super::state::{Page, stepping};
use super::words::t;
use super::worker::client::Client;
use super::worker::diagnostics;

/// The page.
#[component]
pub fn App() -> impl IntoView {
    let (project, found) = store::load();
    // There is always a machine with a control: a test of the library holds it.
    let page = Page::provide(project?, found);
    let worker = Client::provide();
    let large = LargeFile::provide();
    stepping::restore(page);
    store::keep(page);
    diagnostics::follow(page, worker);
    keys::listen(page);
    open::listen(page, large);
    page.player.settle();
    // The machine moves at first sight, but not for those who asked for stillness.
    if !dom::prefers("(prefers-reduced-motion: reduce)") {
        page.player.repeat.set(true);
        dom::soon(move || page.player.toggle());
    }
    Some(view! {
        <a class="skip" href="#machine">{t("page.skip")}</a>
        <Header />
        <main class="page">
            <Form />
            <Divider property="--left" label="page.divide-form" grows=1.0 />
            <Machine />
            <Divider property="--right" label="page.divide-side" grows=-1.0 />
            <Side />
        </main>
        <FieldHelp />
        <ExportDialog />
        <HelpDialog />
        <LargeFileDialog />
        <div class="hidden" role="status">{page.notices.said}</div>
    })
}

/// The tabs with their ids and names.
const TABS: [(Tab, &str, &str); 6] = [
    (Tab::Program, "tab-program", "page.program"),
    (Tab::Results, "tab-results", "page.results"),
    (Tab::Explore, "tab-explore", "page.explore"),
    (Tab::Variables, "tab-variables", "page.variables"),
    (Tab::Parameters, "tab-parameters", "page.parameters"),
    (Tab::Plc, "tab-plc", "page.plc"),
];

/// Whether the machine has something for a tab.
fn is_there(page: Page, tab: Tab) -> bool {
    page.machine.track();
    tab != Tab::Explore || page.project.with_untracked(|project| project.machine.explores())
}

/// Program and everything that follows from the project, as tabs; below them the operator's panel.
#[component]
fn Side() -> impl IntoView {
    let page = Page::here();
    let tab = page.view.tab;
    Effect::new(move |_| {
        if !is_there(page, tab.get()) {
            tab.set(Tab::Program);
        }
    });
    let body = move || match tab.get() {
        Tab::Program => view! { <ProgramTab /> }.into_any(),
        Tab::Results => view! { <ResultsTab /> }.into_any(),
        Tab::Explore => view! { <ExploreTab /> }.into_any(),
        Tab::Variables => view! { <VariablesTab /> }.into_any(),
        Tab::Parameters => view! { <ParametersTab /> }.into_any(),
        Tab::Plc => view! { <PlcTab /> }.into_any(),
    };
    let label = move || TABS.iter().find(|(one, ..)| *one == tab.get()).map_or("", |(_, id, _)| *id);
    view! {
        <section class="pane side" id="side" aria-label=t("page.side")>
            <h2 class="hidden">{t("page.side")}</h2>
            <Tabs />
            <div class="body" id="side-body" role="tabpanel" aria-labelledby=label>{body}</div>
            <OperatorPanel />
        </section>
    }
}

/// The list of tabs; arrow keys move between them.
#[component]
fn Tabs() -> impl IntoView {
    let page = Page::here();
    let tab = page.view.tab;
    let keys = move |event: KeyboardEvent| {
        let there: Vec<_> = TABS.iter().filter(|(one, ..)| untrack(|| is_there(page, *one))).collect();
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
    let button = |(one, id, label): (Tab, &'static str, &'static str)| {
        let chosen = move || tab.get() == one;
        view! {
            <button
                type="button" role="tab" id=id aria-controls="side-body"
                aria-selected=move || chosen().to_string()
                tabindex=move || if chosen() { "0" } else { "-1" }
                class:gone=move || !is_there(page, one)
                on:click=move |_| tab.set(one)
            >
                {t(label)}
            </button>
        }
    };
    view! { <div class="tabs" role="tablist" on:keydown=keys>{TABS.map(button).into_iter().collect_view()}</div> }
}
