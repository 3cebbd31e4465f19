//! The page inside another one (`docs/embedding.md`): drawing, transport, verdicts and the first fields of one machine. Nothing is stored.

use leptos::prelude::*;

use crate::machines;
use crate::project::Project;
use crate::project::saved::embedded;
use crate::ui::dom;
use crate::ui::dom::turns::{at_last, in_turn};
use crate::ui::form::FirstFields;
use crate::ui::machine::EmbeddedMachine;
use crate::ui::parts::scene::StillDrawing;
use crate::ui::state::notices::Notice;
use crate::ui::state::{Page, ProjectStart};
use crate::ui::words::{Tone, sentence_with_hints, t};

/// Fields that are shown.
const FIELDS: usize = 3;

/// State with which an embedded page is built: its project, and notices about the address of the frame.
pub struct Embedded {
    start: ProjectStart,
    found: Vec<Notice>,
}

impl Embedded {
    /// Whether the address asks for an embedded page.
    pub fn is_asked_for() -> bool {
        embedded(&dom::address().1).is_some()
    }

    /// Reads the address, writes the program and begins its run, each in a turn of its own, then calls `then`, which gets `None` only if no
    /// machine has a control. An address that names no project shows the first machine.
    pub fn in_turns(then: impl FnOnce(Option<Embedded>) + 'static) {
        let asked = embedded(&dom::address().1);
        let notice =
            |found: &crate::text::Diagnostic| Notice::new(Tone::from(found.severity), sentence_with_hints(found));
        let found = asked.iter().flat_map(|asked| &asked.diagnostics).map(notice).collect();
        let first = || machines::ALL.first().and_then(|machine| Project::of(machine.id(), None));
        let Some(project) = asked.and_then(|asked| asked.project).or_else(first) else { return then(None) };
        ProjectStart::in_turns(project, move |start| then(Some(Embedded { start, found })));
    }
}

/// The embedded page.
#[component]
pub fn EmbeddedApp(
    /// State with which the page is built.
    embedded: Embedded,
) -> impl IntoView {
    let page = Page::provide(embedded.start, embedded.found);
    StillDrawing::provide();
    let busy = RwSignal::new(true);
    reload_on_another_fragment(page);
    in_turn(move || page.player.begin());
    at_last(move || {
        let _ = busy.try_set(false);
    });
    view! {
        <main class="embed" aria-busy=move || busy.get().to_string()>
            <EmbeddedMachine />
            <FirstFields count=FIELDS />
            <footer><h1>{t(page.project.with_untracked(|project| project.machine.name()))}</h1><WholePageLink /></footer>
        </main>
        <div class="hidden" role="status">{page.notices.announcement}</div>
    }
}

/// Reloads the page when the page around it changes the fragment: a browser does not load a page again for another fragment.
fn reload_on_another_fragment(page: Page) {
    let shown = dom::address().1;
    dom::on_event("hashchange", move |_| {
        // The page may be gone.
        if !page.is_gone() && dom::address().1 != shown {
            dom::reload();
        }
    });
}

/// The link to the whole page with the present project.
#[component]
fn WholePageLink() -> impl IntoView {
    let page = Page::here();
    // A project opened from a link still fits into a link after a few changes. If it does not fit, the element has no
    // address.
    let link = move || page.project.with(|project| project.to_link().ok());
    let address = move || link().map(|fragment| format!("{}#{fragment}", dom::address().0));
    view! { <a href=address target="_blank" rel="noopener">{t("page.embed-open")}</a> }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;
    use std::rc::Rc;

    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::ui::dom::turns;
    use crate::ui::testing::{ViewBench, mount_project, project, settled, until};

    /// The page at an address, in a browser with empty storage.
    async fn embedded_by(fragment: &str) -> ViewBench {
        dom::storage().unwrap().clear().unwrap();
        // The test bench can wait only after a first mount, and this may be the first test.
        drop(mount_project(project(), || ()).await);
        window().location().set_hash(fragment).unwrap();
        assert!(Embedded::is_asked_for());
        let start = Rc::new(RefCell::new(None));
        let take = Rc::clone(&start);
        Embedded::in_turns(move |embedded| drop(take.replace(embedded)));
        until(turns::are_over).await;
        let embedded = start.take().unwrap();
        let bench = mount_project(project(), || view! { <EmbeddedApp embedded=embedded /> }).await;
        dom::forget_fragment();
        settled().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn embedded_page_has_machine_three_fields_and_verdicts() {
        let bench = embedded_by("embed").await;
        assert_eq!(bench.all(".embed .field").len(), FIELDS);
        for part in [".stage svg", "#play", ".scrub", ".verdicts li", "main[aria-busy=false]"] {
            assert!(bench.has(part), "{part}");
        }
        assert!(!bench.has("dialog") && !bench.has(".top"));
    }

    #[wasm_bindgen_test]
    async fn link_to_the_whole_page_has_the_changed_project() {
        let mut order = project();
        order.name = "Order 7".to_owned();
        let bench = embedded_by(&format!("embed&{}", order.to_link().unwrap())).await;
        bench.type_into("#spindle-speed", "900").await;
        let address = bench.attribute("footer a", "href");
        let opened = Project::from_link(address.split_once('#').unwrap().1).project.unwrap();
        assert_eq!(
            (opened.name.as_str(), opened.values.get("spindle-speed")),
            ("Order 7", Some(&Value::Number(900.0)))
        );
    }

    #[wasm_bindgen_test]
    async fn embedded_page_stores_nothing() {
        let bench = embedded_by("embed&machine=turning-spindle").await;
        bench.type_into(".embed .field:first-of-type input.number", "70").await;
        crate::ui::testing::pause(500).await;
        assert!(dom::stored_keys().is_empty());
    }

    #[wasm_bindgen_test]
    async fn unknown_machine_in_the_address_is_reported() {
        let bench = embedded_by("embed&machine=loom").await;
        assert_eq!(bench.text("h1"), t(machines::ALL[0].name()));
        assert!(bench.text(".notice").contains("ribbon-line"));
    }

    #[wasm_bindgen_test]
    async fn unknown_language_and_units_in_the_address_are_reported() {
        let bench = embedded_by("embed&machine=turning-spindle&lang=fr&lengths=feet").await;
        assert_eq!(bench.text("h1"), t(machines::ALL[1].name()));
        let notices: Vec<String> = bench.all(".notice").iter().filter_map(|notice| notice.text_content()).collect();
        assert!(
            notices.iter().any(|text| text.contains("lang=zh"))
                && notices.iter().any(|text| text.contains("lengths=inch")),
            "{notices:?}"
        );
    }
}
