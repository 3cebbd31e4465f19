//! Search in help, and its pages one at a time with the way back. The worker makes results and pages.

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::Event;

use crate::msg;
use crate::ui::dom;
use crate::ui::help::keys;
use crate::ui::parts::input::CheckMark;
use crate::ui::parts::{ContrastButton, LanguageButtons, LengthsButton, ThemeButton};
use crate::ui::state::Page;
use crate::ui::state::stepping::SteppingCommand;
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{FoundHelp, HelpPageHtml, Hit, ReadHelp, SearchHelp};

/// Keys and their effects.
const KEYS: [(&str, &str); 14] = [
    ("Space", "page.key-play"),
    (", .", "page.key-step"),
    ("Home", "page.key-start"),
    ("← →", "page.key-arrows"),
    ("↑ ↓", "page.key-fields"),
    ("+ − 0", "page.key-zoom"),
    ("A", "operator.key-list"),
    ("← → Delete", "operator.key-mark"),
    ("Enter", "page.key-meaning"),
    ("G", "page.key-block"),
    ("Ctrl Z", "page.key-undo"),
    ("Ctrl Shift Z", "page.key-redo"),
    ("? F1", "page.key-help"),
    ("/", "page.key-find"),
];

/// Keys of the editor and their effects.
const EDITOR_KEYS: [(&str, &str); 10] = [
    ("Ctrl Space", "page.key-complete"),
    ("Ctrl I", "page.key-word"),
    ("F12", "page.key-define"),
    ("Shift F12", "page.key-uses"),
    ("Ctrl Shift O", "page.key-outline"),
    ("F8", "page.key-finding"),
    ("Ctrl .", "page.key-findings"),
    ("F9", "page.key-point"),
    ("Ctrl F", "page.key-search"),
    ("Esc Tab", "page.key-leave"),
];

/// Id of the page that has the keys.
const PROGRAMS: &str = "programs";

/// The help page on show, and the pages before it.
#[derive(Clone, Copy)]
struct ReaderState {
    page: Page,
    worker: Client,
    /// The page that is shown; `None` until the worker has answered.
    shown: RwSignal<Option<HelpPageHtml>>,
    /// Whether the worker gives no answer.
    silent: RwSignal<bool>,
    /// Ids of the places before, the last one at the end.
    before: RwSignal<Vec<String>>,
    /// Id of the present place.
    at: RwSignal<String>,
    query: RwSignal<String>,
    found: RwSignal<Option<FoundHelp>>,
}

impl ReaderState {
    /// Shows a place and keeps the present one for the way back.
    fn go(self, id: String) {
        let at = self.at.get_untracked();
        if at != id && self.shown.with_untracked(Option::is_some) {
            self.before.update(|before| before.push(at));
        }
        self.show(id);
    }

    fn back(self) {
        if let Some(id) = self.before.try_update(Vec::pop).flatten() {
            self.show(id);
        }
    }

    fn show(self, id: String) {
        self.at.set(id.clone());
        self.query.set(String::new());
        self.found.set(None);
        let request = ReadHelp { id: id.clone(), theme: dom::theme() };
        let then = move |page: Option<Option<HelpPageHtml>>| match page.flatten() {
            // Only the answer to the last request counts.
            Some(page) if self.at.try_get_untracked().as_ref() == Some(&id) => {
                let anchor = page.anchor.clone();
                self.silent.set(false);
                self.shown.set(Some(page));
                dom::soon(move || to_anchor(&anchor));
            }
            Some(_) => {}
            None => {
                let _ = self.silent.try_set(true);
            }
        };
        self.page.project.with_untracked(|project| self.worker.ask(project, request, then));
    }

    fn find(self, query: String) {
        self.query.set(query.clone());
        if query.trim().is_empty() {
            return self.found.set(None);
        }
        let request = SearchHelp(query.clone());
        let then = move |found: Option<Option<FoundHelp>>| match found.flatten() {
            Some(found) if self.query.try_get_untracked().as_ref() == Some(&query) => {
                self.page.notices.announce(title(&found));
                self.found.set(Some(found));
            }
            Some(_) => {}
            None => self.page.notices.notify(Tone::Warn, t("page.no-answer").to_owned()),
        };
        self.page.project.with_untracked(|project| self.worker.ask(project, request, then));
    }
}

/// How many places were found, and how well.
fn title(found: &FoundHelp) -> String {
    match (found.hits.len() as u32, found.has_all_words) {
        (0, _) => t("help.not-found").to_owned(),
        (_, false) => t("help.nearest").to_owned(),
        (count, true) => sentence(&msg!("help.hits", count)),
    }
}

/// Brings a place of the page into view, and the focus with it.
fn to_anchor(id: &str) {
    match dom::by_id(id) {
        Some(element) => {
            element.scroll_into_view();
            let _ = element.focus();
        }
        None => dom::by_id("help-page").iter().for_each(|page| page.set_scroll_top(0)),
    }
}

/// Search above, pages at the left, the page that is read.
#[component]
pub(super) fn Reader() -> impl IntoView {
    let page = Page::here();
    let reading = ReaderState {
        page,
        worker: Client::here(),
        shown: RwSignal::new(None),
        silent: RwSignal::new(false),
        before: RwSignal::new(Vec::new()),
        at: RwSignal::new(String::new()),
        query: RwSignal::new(String::new()),
        found: RwSignal::new(None),
    };
    let search: NodeRef<html::Input> = NodeRef::new();
    Effect::new(move |_| {
        if page.view.helping.get() {
            let id = page.view.help_at.get();
            let focus = id.is_empty();
            reading.go(if focus { PROGRAMS.to_owned() } else { id });
            if focus && let Some(search) = search.get_untracked() {
                let _ = search.focus();
            }
        }
    });
    let follow = move |event: Event| {
        let link = dom::closest(&event, "[data-help]");
        if let Some(id) = link.and_then(|link| link.get_attribute("data-help")) {
            reading.go(id);
        }
    };
    let first = move |event: web_sys::SubmitEvent| {
        event.prevent_default();
        if let Some(id) = reading.found.with_untracked(|found| Some(found.as_ref()?.hits.first()?.id.clone())) {
            reading.go(id);
        }
    };
    view! {
        <form class="find" role="search" on:submit=first>
            <button
                type="button" class="back" disabled=move || reading.before.with(Vec::is_empty)
                on:click=move |_| reading.back()
            >
                "← " {t("help.back")}
            </button>
            <input
                type="search" id="help-search" autocomplete="off" spellcheck="false" autofocus node_ref=search
                aria-label=t("help.search") placeholder=t("help.search-example")
                prop:value=reading.query on:input=move |event| reading.find(event_target_value(&event))
            />
            <button type="button" class="print" title=t("help.print-about") on:click=|_| dom::print()>{t("help.print")}</button>
        </form>
        <div class="help-body" on:click=move |event| follow(event.unchecked_into())>
            <nav aria-label=t("help.pages")>
                {move || reading.shown.with(|shown| shown.as_ref().map(pages))}
            </nav>
            <div class="help-page" id="help-page" tabindex="0" role="region" aria-labelledby="help-page-title">
                {move || if reading.query.with(|query| query.trim().is_empty()) {
                    view! { <Content reading=reading /> }.into_any()
                } else {
                    view! { <Hits reading=reading /> }.into_any()
                }}
            </div>
        </div>
    }
}

/// The pages, the present one marked.
fn pages(shown: &HelpPageHtml) -> impl IntoView + use<> {
    let row = |(id, title): &(String, String)| {
        let current = (*id == shown.page).then_some("page");
        view! {
            <button type="button" class="quiet" data-help=id.clone() aria-current=current>{title.clone()}</button>
        }
    };
    shown.pages.iter().map(row).collect_view()
}

/// The page that is read.
#[component]
fn Content(
    /// State of the reader.
    reading: ReaderState,
) -> impl IntoView {
    move || match (reading.shown.get(), reading.silent.get()) {
        (Some(shown), _) => {
            let keys = (shown.page == PROGRAMS).then(|| view! { <Shortcuts /> });
            view! {
                <p class="on-paper source">"macroline · " {t("page.help")}</p>
                <h2 id="help-page-title">{shown.title}</h2>
                {keys}
                <div inner_html=shown.html></div>
            }
            .into_any()
        }
        (None, silent) => {
            let words = if silent { "page.no-answer" } else { "page.reading" };
            view! { <h2 id="help-page-title" class="lead">{t(words)}</h2> }.into_any()
        }
    }
}

/// List of search results.
#[component]
fn Hits(
    /// State of the reader.
    reading: ReaderState,
) -> impl IntoView {
    let row = |hit: Hit| {
        view! {
            <li>
                <button type="button" class="hit" data-help=hit.id>
                    <b>{hit.title}</b> " " <small>{hit.page}</small>
                    <span>{hit.text}</span>
                </button>
            </li>
        }
    };
    let hits = move || reading.found.get().map(|found| found.hits).unwrap_or_default();
    let rows = move || hits().into_iter().map(row).collect_view();
    let title = move || reading.found.with(|found| found.as_ref().map_or_else(|| t("page.reading").to_owned(), title));
    view! {
        <h2 id="help-page-title" class="lead">{title}</h2>
        <ol class="hits">{rows}</ol>
    }
}

/// Tour, language, appearance, and the keys of the page.
#[component]
fn Shortcuts() -> impl IntoView {
    let page = Page::here();
    let row = |(key, what): (&'static str, &'static str)| {
        view! { <tr><th scope="row"><kbd>{key}</kbd></th><td>{t(what)}</td></tr> }
    };
    let editor = EDITOR_KEYS.map(row).collect_view();
    let stepping = SteppingCommand::ALL.map(|command| {
        let (key, _, words) = command.shown();
        (key, words)
    });
    let rows = KEYS.into_iter().chain(stepping).map(row).collect_view();
    let keys_on = RwSignal::new(keys::on());
    let turn = move |on| {
        keys::turn(on);
        keys_on.set(on);
    };
    let tour = move |_| {
        page.view.helping.set(false);
        page.view.tour.set(Some(0));
    };
    view! {
        <p class="choices">
            <button type="button" class="tour-start" on:click=tour>{t("tour.start")}</button>
            <span class="pair">{t("page.language")} " " <LanguageButtons /></span>
            <span class="pair">{t("page.lengths")} " " <LengthsButton /></span>
            <ThemeButton /> <ContrastButton />
        </p>
        {dom::is_installable().then(|| view! {
            <p>{t("page.help-offline")} " " <a href="macroline.html" download="macroline.html">{t("page.help-one-file")}</a></p>
        })}
        <details>
            <summary>{t("page.keys")}</summary>
            <table class="shortcuts"><tbody>{rows}</tbody></table>
            <CheckMark label=t("page.keys-on") on=keys_on set=turn />
            <h3>{t("page.keys-editor")}</h3>
            <table class="shortcuts"><tbody>{editor}</tbody></table>
        </details>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;
    use web_sys::Element;

    use super::*;
    use crate::ui::help::HelpDialog;
    use crate::ui::testing::{ViewBench, mount, mount_project, project, settled, work_here};

    fn focused() -> Option<Element> {
        document().active_element()
    }

    async fn opened(id: &str) -> ViewBench {
        let bench = mount(|| view! { <HelpDialog /> }).await;
        work_here(bench.worker);
        bench.page.view.explain(id);
        settled().await;
        settled().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn help_opens_with_search_pages_and_every_key() {
        let bench = mount(|| view! { <HelpDialog /> }).await;
        work_here(bench.worker);
        assert!(!bench.has("dialog[open]") && !bench.has("#help-search"));
        bench.page.view.helping.set(true);
        settled().await;
        assert_eq!(focused().map(|element| element.id()).as_deref(), Some("help-search"));
        assert_eq!(bench.all(".shortcuts tr").len(), KEYS.len() + SteppingCommand::ALL.len() + EDITOR_KEYS.len());
        let first = bench.all(".help-body nav button").into_iter().next().and_then(|one| one.text_content());
        assert_eq!(first.as_deref(), Some(t("ribbon.name")));
        bench.press_button(t("page.close")).await;
        assert!(!bench.page.view.helping.get_untracked());
    }

    #[wasm_bindgen_test]
    async fn alarm_that_is_asked_for_has_the_focus() {
        let bench = opened("alarm.P62").await;
        assert_eq!(focused().map(|element| element.id()).as_deref(), Some("help-alarm.P62"));
        assert_eq!(bench.text("#help-page-title"), bench.page.project.with_untracked(|project| project.control.name));
    }

    #[wasm_bindgen_test]
    async fn link_leads_on_and_back_returns() {
        let bench = opened("field.pitch").await;
        bench.press("#help-field\\.pitch [data-help^='ribbon-line/result.']").await;
        settled().await;
        assert!(focused().is_some_and(|element| element.id().starts_with("help-result.")));
        bench.press(".back").await;
        settled().await;
        assert_eq!(focused().map(|element| element.id()).as_deref(), Some("help-field.pitch"));
        assert!(bench.has(".back:disabled"));
    }

    #[wasm_bindgen_test]
    async fn search_lists_hits_and_one_opens_its_place() {
        let bench = opened("").await;
        bench.type_into("#help-search", "P283").await;
        settled().await;
        assert!(bench.text(".hits li b").starts_with("P283"));
        bench.press(".hits button").await;
        settled().await;
        assert_eq!(focused().map(|element| element.id()).as_deref(), Some("help-alarm.P283"));
        assert!(!bench.has(".hits") && bench.value("#help-search").is_empty());
    }

    #[wasm_bindgen_test]
    async fn help_without_an_answer_has_a_note() {
        let bench = mount(|| view! { <HelpDialog /> }).await;
        bench.worker.answer_here(|_, _| None);
        bench.page.view.helping.set(true);
        settled().await;
        assert_eq!(bench.text("#help-page-title"), t("page.no-answer"));
    }

    #[wasm_bindgen_test]
    async fn single_keys_are_turned_off_and_that_is_remembered() {
        let bench = opened("").await;
        assert!(bench.checked(".check input") && keys::on());
        bench.press(".check input").await;
        assert!(!keys::on());
        drop(bench);
        let bench = mount_project(project(), || view! { <HelpDialog /> }).await;
        work_here(bench.worker);
        bench.page.view.helping.set(true);
        settled().await;
        assert!(!bench.checked(".check input"));
        bench.press(".check input").await;
        assert!(keys::on());
    }
}
