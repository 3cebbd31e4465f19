//! A tour of three steps: machine and transport, fields and verdicts, program and export. It blocks nothing.

use leptos::html;
use leptos::prelude::*;

use crate::ui::dom;
use crate::ui::parts::{Glyph, IconButton};
use crate::ui::state::Page;
use crate::ui::words::t;

/// Key in the browser's store, set when help was opened once: the tour is no longer offered then.
const SEEN: &str = "macroline.tour";

/// Attribute of the page for a user who has not opened help yet.
const NEW: &str = "data-new";

/// The part of the page that each step is about, its title and its text.
const STEPS: [(&str, &str, &str); 3] = [
    (".centre", "tour.machine", "tour.machine.about"),
    (".form", "tour.fields", "tour.fields.about"),
    (".side", "tour.program", "tour.program.about"),
];

/// Marks the part of the page that a step is about, and no other.
fn mark(step: Option<usize>) {
    let Ok(marked) = document().query_selector_all("[data-tour]") else { return };
    (0..marked.length()).filter_map(|at| marked.get(at)).for_each(|node| {
        let _ = leptos::wasm_bindgen::JsCast::unchecked_into::<web_sys::Element>(node).remove_attribute("data-tour");
    });
    let part = step.and_then(|step| STEPS.get(step)).map(|(part, ..)| *part);
    if let Some(part) = part.and_then(|part| document().query_selector(part).ok().flatten()) {
        dom::set(&part, "data-tour", "");
        part.scroll_into_view();
    }
}

/// A sign at the button of help until help is first opened, and the steps of the tour, which begins there.
#[component]
pub(crate) fn Tour() -> impl IntoView {
    let page = Page::here();
    let step = page.view.tour;
    let root = document().document_element();
    let is_new = dom::storage().is_some() && dom::stored(SEEN).is_none();
    if let Some(root) = root.clone().filter(|_| is_new) {
        dom::set(&root, NEW, "");
    }
    Effect::new(move |_| {
        if page.view.helping.get() || step.get().is_some() {
            dom::store(SEEN, "1");
            root.iter().for_each(|root| {
                let _ = root.remove_attribute(NEW);
            });
        }
    });
    Effect::new(move |before: Option<Option<usize>>| {
        let at = step.get();
        if at.is_some() || before.flatten().is_some() {
            mark(at);
        }
        at
    });
    let end = move || step.set(None);
    let next_button: NodeRef<html::Button> = NodeRef::new();
    // The focus follows the tour, so that Enter leads through it.
    Effect::new(move |_| {
        if let (Some(_), Some(button)) = (step.get(), next_button.get()) {
            let _ = button.focus();
        }
    });
    let shown = move || {
        let at = step.get()?;
        let (_, title, about) = STEPS.get(at)?;
        let last = at + 1 == STEPS.len();
        let next = move |_| step.set((!last).then_some(at + 1));
        Some(view! {
            <section
                class=format!("tour at-{at}") aria-label=t("tour.name") aria-live="polite"
                on:keydown=move |event| if event.key() == "Escape" { end() }
            >
                <h2>{t(title)} " " <small>{format!("{} / {}", at + 1, STEPS.len())}</small></h2>
                <p>{t(about)}</p>
                <footer>
                    <button type="button" disabled=at == 0 on:click=move |_| step.set(at.checked_sub(1))>
                        {t("tour.before")}
                    </button>
                    <button type="button" class="primary" node_ref=next_button on:click=next>
                        {t(if last { "tour.end" } else { "tour.next" })}
                    </button>
                </footer>
                <IconButton glyph=Glyph::Close label=t("tour.close") press=end />
            </section>
        })
    };
    view! { {shown} }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, mount_project, project, settled};

    async fn page() -> ViewBench {
        mount(|| view! { <div class="form"></div><div class="centre"></div><div class="side"></div><Tour /> }).await
    }

    fn is_new() -> bool {
        document().document_element().unwrap().has_attribute(NEW)
    }

    #[wasm_bindgen_test]
    async fn sign_of_the_first_visit_goes_when_help_is_opened() {
        let bench = page().await;
        assert!(is_new() && !bench.has(".tour"));
        bench.page.view.helping.set(true);
        settled().await;
        assert!(!is_new());
        drop(bench);
        let bench = mount_project(project(), || view! { <Tour /> }).await;
        assert!(!is_new() && !bench.has(".tour"));
    }

    #[wasm_bindgen_test]
    async fn each_step_marks_its_part_alone_and_the_end_marks_none() {
        let bench = page().await;
        bench.page.view.tour.set(Some(0));
        settled().await;
        for (part, title, _) in STEPS {
            assert!(bench.text(".tour h2").starts_with(t(title)));
            assert!(bench.has(&format!("{part}[data-tour]")) && bench.all("[data-tour]").len() == 1);
            bench.press(".tour footer .primary").await;
        }
        assert!(!bench.has(".tour") && !bench.has("[data-tour]"));
    }

    #[wasm_bindgen_test]
    async fn escape_ends_the_tour() {
        let bench = page().await;
        bench.page.view.tour.set(Some(1));
        settled().await;
        bench.key(".tour footer button.primary", "Escape", false).await;
        assert!(!bench.has(".tour"));
    }
}
