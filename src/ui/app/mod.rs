//! The page: puts the features together.

pub(super) mod embed;
mod parts_bar;

use leptos::ev::KeyboardEvent;
use leptos::prelude::*;

use super::dom;
use super::dom::turns::{at_last, in_turn};
use super::files::{
    ExportDialog, GalleryDialog, Header, LargeFile, LargeFileDialog, ProjectsDialog, ShareDialog, offline, open, share,
    store,
};
use super::form::Form;
use super::form::field_help::FieldHelp;
use super::help::tour::Tour;
use super::help::{HelpDialog, keys};
use super::machine::{CompareDialog, Machine};
use super::parts::Later;
use super::parts::divider::Divider;
use super::parts::meaning::MeaningPopover;
use super::parts::reload;
use super::parts::scene::StillDrawing;
use super::program::ProgramTab;
use super::results::{ExploreTab, ParametersTab, PlcTab, ResultsTab, SizingTab, VariablesTab};
use super::state::notices::Notice;
use super::state::view::Tab;
use super::state::{Page, ProjectStart, stepping};
use super::words::{sentence, t};
use super::worker::client::Client;
use super::worker::diagnostics;
use crate::msg;
use crate::ui::machine::operator::panel::OperatorPanel;
use parts_bar::PartsBar;

/// State with which the page is built: the project of the last visit, or a fresh one, with its program, its run and notices.
pub struct PageStart {
    start: ProjectStart,
    found: Vec<Notice>,
    /// State of the browser's store.
    stored: store::Stored,
}

impl PageStart {
    /// Reads the browser's store, writes the program and begins its run, each in a turn of its own, then calls `then`. `then` gets `None`
    /// only if no machine has a control, which a test of the library excludes.
    pub fn in_turns(then: impl FnOnce(Option<PageStart>) + 'static) {
        let visit = store::load();
        let Some(project) = visit.project else { return then(None) };
        let (found, stored) = (visit.notices, visit.stored);
        ProjectStart::in_turns(project, move |start| then(Some(PageStart { start, found, stored })));
    }
}

/// The page. The first screen is built at once, everything else in turns.
#[component]
pub fn App(
    /// State with which the page is built.
    start: PageStart,
) -> impl IntoView {
    let PageStart { start, found, stored } = start;
    let page = Page::provide(start, found);
    let worker = Client::provide();
    let large = LargeFile::provide();
    stepping::restore(page);
    store::keep(page, stored);
    diagnostics::follow(page, worker);
    keys::listen(page);
    open::listen(page, large, worker);
    share::listen(page);
    name_browser_tab(page);
    view! { <Later><Screen /></Later> }
}

/// Gives the browser's tab the name of the project, or that of its machine while it has none.
fn name_browser_tab(page: Page) {
    let name = Memo::new(move |_| {
        page.project.with(|project| {
            let machine = t(project.machine.name());
            if project.name.is_empty() { machine.to_owned() } else { project.name.clone() }
        })
    });
    Effect::new(move |_| document().set_title(&sentence(&msg!("page.browser-title", name = name.get()))));
}

/// Everything on the page, in place of the first drawing in its HTML.
#[component]
fn Screen() -> impl IntoView {
    let page = Page::here();
    StillDrawing::provide();
    let busy = RwSignal::new(true);
    let view = view! {
        <a class="skip" href="#machine">{t("page.skip")}</a>
        <Header />
        <main class="page" aria-busy=move || busy.get().to_string()>
            <Form />
            <Divider property="--left" label="page.divide-form" grows=1.0 />
            <Machine />
            <Divider property="--right" label="page.divide-side" grows=-1.0 />
            <Side />
            <Later>
                <PartsBar />
                <MeaningPopover />
                <FieldHelp />
            </Later>
        </main>
        <Later>
            <ShareDialog />
            <ExportDialog />
            <GalleryDialog />
            <HelpDialog />
            <ProjectsDialog />
            <CompareDialog />
            <Tour />
            <LargeFileDialog />
        </Later>
        <div class="hidden" role="status">{page.notices.announcement}</div>
    };
    in_turn(move || reload::begin_run(page));
    // The page may be gone.
    at_last(move || {
        if busy.try_set(false).is_none() {
            offline::keep(page);
        }
    });
    view
}

/// The tabs with their ids and names.
const TABS: [(Tab, &str, &str); 7] = [
    (Tab::Program, "tab-program", "page.program"),
    (Tab::Results, "tab-results", "page.results"),
    (Tab::Sizing, "tab-sizing", "page.sizing"),
    (Tab::Explore, "tab-explore", "page.explore"),
    (Tab::Variables, "tab-variables", "page.variables"),
    (Tab::Parameters, "tab-parameters", "page.parameters"),
    (Tab::Plc, "tab-plc", "page.plc"),
];

/// Whether the machine has contents for a tab.
fn is_there(page: Page, tab: Tab) -> bool {
    page.machine.track();
    tab != Tab::Explore || page.project.with_untracked(|project| project.machine.info().explores)
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
        Tab::Sizing => view! { <SizingTab /> }.into_any(),
        Tab::Explore => view! { <ExploreTab /> }.into_any(),
        Tab::Variables => view! { <VariablesTab /> }.into_any(),
        Tab::Parameters => view! { <ParametersTab /> }.into_any(),
        Tab::Plc => view! { <PlcTab /> }.into_any(),
    };
    let label = move || TABS.iter().find(|(one, ..)| *one == tab.get()).map_or("", |(_, id, _)| *id);
    view! {
        <section class="pane side" id="side" aria-label=t("page.side")>
            <h2 class="hidden">{t("page.side")}</h2>
            <Later>
                <Tabs />
                <div class="body" id="side-body" role="tabpanel" aria-labelledby=label>{body}</div>
            </Later>
            <Later><OperatorPanel /></Later>
        </section>
    }
}

/// Count of the results that fail, at the corner of their tab.
#[component]
fn Failures() -> impl IntoView {
    let results = Page::here().results;
    let count = Memo::new(move |_| results.failing());
    view! {
        <Show when=move || count.get() != 0>
            <b class="failures" aria-hidden="true">{move || count.get()}</b>
            <span class="hidden">{move || sentence(&msg!("page.results-fail", count = count.get()))}</span>
        </Show>
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
                {(one == Tab::Results).then(|| view! { <Failures /> })}
            </button>
        }
    };
    view! { <div class="tabs" role="tablist" on:keydown=keys>{TABS.map(button).into_iter().collect_view()}</div> }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;
    use std::rc::Rc;

    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::dom::turns;
    use crate::ui::testing::{ViewBench, mount_project, project, settled, until};

    async fn app() -> ViewBench {
        dom::storage().unwrap().clear().unwrap();
        app_of_the_last_visit().await
    }

    async fn app_of_the_last_visit() -> ViewBench {
        // The test bench can wait only after a first mount, and this may be the first test.
        drop(mount_project(project(), || ()).await);
        let start = Rc::new(RefCell::new(None));
        let take = Rc::clone(&start);
        PageStart::in_turns(move |start| drop(take.replace(start)));
        until(turns::are_over).await;
        let start = start.take().unwrap();
        let bench = mount_project(project(), || view! { <App start=start /> }).await;
        settled().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn page_has_form_machine_and_side() {
        let bench = app().await;
        assert_eq!(bench.text("h1"), "macroline");
        for part in ["#form", ".centre", "#side", ".panel", "main[aria-busy=false]"] {
            assert!(bench.has(part), "{part}");
        }
    }

    #[wasm_bindgen_test]
    async fn browser_tab_has_the_name_of_the_project_or_its_machine() {
        let bench = app().await;
        let titled = |name: &str| sentence(&msg!("page.browser-title", name));
        assert_eq!(document().title(), titled(t(crate::machines::ALL[0].name())));
        bench.type_into("input.name", "Order 7").await;
        assert_eq!(document().title(), titled("Order 7"));
        bench.press_button(t("page.undo")).await;
        assert_eq!(document().title(), titled(t(crate::machines::ALL[0].name())));
    }

    #[wasm_bindgen_test]
    async fn tab_of_the_results_counts_those_that_fail() {
        let bench = app().await;
        assert!(!bench.has(".failures"), "the first example fails in nothing");
        bench.type_into("#pitch", "20").await;
        bench.press("#tab-results").await;
        let count = bench.all(".result.fail").len();
        assert_eq!((bench.text("#tab-results .failures"), count > 0), (count.to_string(), true));
        bench.press_button(t("page.undo")).await;
        assert!(!bench.has(".failures"));
    }

    #[wasm_bindgen_test]
    async fn undo_restores_the_shown_field() {
        let bench = app().await;
        bench.type_into("#pitch", "9.5").await;
        bench.press_button(t("page.undo")).await;
        assert_eq!(bench.value("#pitch"), "10");
    }

    #[wasm_bindgen_test]
    async fn field_change_reaches_the_program() {
        let bench = app().await;
        bench.type_into("#pitch", "7,25").await;
        let mut found = false;
        for at in 1..=bench.all("#side-body .chip").len() {
            bench.press(&format!("#side-body .chip:nth-of-type({at})")).await;
            found |= bench.text(".listing").contains("#107=7.25");
        }
        assert!(found, "no file sets #107 to 7.25");
    }

    #[wasm_bindgen_test]
    async fn change_of_control_rewrites_program_and_form() {
        let bench = app().await;
        let control = crate::controls::find(crate::machines::ALL[0].controls()[2]).unwrap();
        let before = bench.text(".listing");
        bench.choose("select.control", control.id).await;
        assert_ne!(bench.text(".listing"), before);
        assert!(bench.text("#form").contains(&control.variable(107)));
    }

    #[wasm_bindgen_test]
    async fn broken_stored_state_is_set_aside() {
        dom::storage().unwrap().clear().unwrap();
        dom::store("macroline.project", "{ not a project");
        let bench = app_of_the_last_visit().await;
        assert!(bench.text(".notice").contains(t("page.set-aside")));
    }

    #[wasm_bindgen_test]
    async fn arrow_keys_go_round_the_tabs() {
        let bench = app().await;
        let chosen = || bench.attribute("[role=tab][aria-selected=true]", "id");
        let mut seen = vec![chosen()];
        for _ in 0..6 {
            bench.key("[role=tablist]", "ArrowRight", false).await;
            seen.push(chosen());
        }
        let ids = ["program", "results", "sizing", "variables", "parameters", "plc", "program"];
        assert_eq!(seen, ids.map(|id| format!("tab-{id}")));
        assert_eq!(document().active_element().unwrap().id(), "tab-program");
        assert_eq!(bench.attribute("#side-body", "aria-labelledby"), "tab-program");
        assert_eq!(bench.all("[role=tab][tabindex='0']").len(), 1);
    }

    #[wasm_bindgen_test]
    async fn machine_without_an_explorer_leaves_its_tab() {
        let bench = app().await;
        assert!(bench.has("#tab-explore.gone"));
        let at = crate::machines::ALL.iter().position(|machine| machine.info().explores).unwrap() + 1;
        bench.press(&format!(".segments button:nth-child({at})")).await;
        bench.press("#tab-explore").await;
        assert_eq!(bench.attribute("#tab-explore", "aria-selected"), "true");
        bench.press(".segments button:nth-child(1)").await;
        assert_eq!(bench.attribute("#tab-program", "aria-selected"), "true");
    }

    #[wasm_bindgen_test]
    async fn verdict_leads_to_its_result() {
        let bench = app().await;
        bench.press(".cards .to-result").await;
        settled().await;
        assert_eq!(bench.attribute("#tab-results", "aria-selected"), "true");
        assert!(document().active_element().unwrap().id().starts_with("result-"));
    }
}
