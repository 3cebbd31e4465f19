//! Assumed facts that are worth measuring first: a tenth more or less of them flips a verdict.

use std::time::Duration;

use leptos::prelude::*;

use super::value::value_of;
use crate::machines::form::FieldInfo;
use crate::ui::dom::delayed::Delayed;
use crate::ui::dom::go_to_field;
use crate::ui::state::{Page, put};
use crate::ui::words::t;
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::FindFlips;

/// Greatest number of facts that are listed.
const MOST: usize = 5;

/// Delay after the start of the page, which has more urgent work, and after the last change of the project.
const REST: [Duration; 2] = [Duration::from_secs(2), Duration::from_millis(400)];

/// Ids of the facts of the present project, the most decisive first.
pub(super) fn decisive_facts() -> RwSignal<Vec<String>> {
    let (page, worker) = (Page::here(), Client::here());
    let found = RwSignal::new(Vec::new());
    let ask = move || {
        page.project.with_untracked(|project| {
            worker.ask(project, FindFlips, move |ids| {
                if let Some(mut ids) = ids
                    && !found.is_disposed()
                {
                    // Product fields are the customer's own and come first in the form.
                    let fields = page.project.with_untracked(|project| project.machine.fields());
                    ids.retain(|id| !fields.iter().any(|field| field.essential && field.id == *id));
                    put(found, ids);
                }
            });
        });
    };
    let delayed = Delayed::new();
    Effect::new(move |changed: Option<()>| {
        page.project.track();
        delayed.call(ask, REST[usize::from(changed.is_some())]);
    });
    found
}

/// The facts; each leads to its field.
#[component]
pub(super) fn MeasureFirst(
    /// Ids of the facts, see [`decisive_facts`].
    found: RwSignal<Vec<String>>,
) -> impl IntoView {
    let page = Page::here();
    let rows = move || {
        let fields = page.project.with_untracked(|project| project.machine.fields());
        let ids = found.get();
        let facts = ids.iter().take(MOST).filter_map(|id| fields.iter().find(|field| field.id == *id).cloned());
        facts.map(|info| view! { <Fact info=info /> }).collect_view()
    };
    view! {
        <Show when=move || !found.with(Vec::is_empty)>
            <div class="measure-first">
                <p>{t("page.measure-first")}</p>
                {rows}
            </div>
        </Show>
    }
}

/// A fact with its present value.
#[component]
fn Fact(
    /// The row of its field.
    info: FieldInfo,
) -> impl IntoView {
    let page = Page::here();
    let (id, label) = (info.id, t(info.label));
    let value = move || info.text_with_unit(&value_of(page, &info));
    view! {
        <button type="button" on:click=move |_| go_to_field(id)>
            <span>{label}</span>
            <code>{value}</code>
        </button>
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::rc::Rc;

    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, field, mount, pause, settled, until};
    use crate::ui::worker::messages::Ask;

    async fn listed(ids: &[&str]) -> ViewBench {
        let found: Vec<String> = ids.iter().map(|id| (*id).to_owned()).collect();
        mount(move || view! { <MeasureFirst found=RwSignal::new(found) /> <input id="heads" /> }).await
    }

    #[wasm_bindgen_test]
    async fn fact_that_flips_a_verdict_leads_to_its_field() {
        let bench = listed(&["heads"]).await;
        assert_eq!(
            (bench.text("button span"), bench.text("button code")),
            (t(field("heads").label).to_owned(), "6".to_owned())
        );
        bench.press("button").await;
        assert_eq!(document().active_element().unwrap().id(), "heads");
    }

    #[wasm_bindgen_test]
    async fn at_most_five_facts_are_listed() {
        let fields = crate::ui::testing::project().machine.fields();
        let facts: Vec<&str> = fields.iter().filter(|field| field.role.is_fact()).map(|field| field.id).collect();
        assert_eq!(listed(&facts).await.all("button").len(), MOST);
    }

    #[wasm_bindgen_test]
    async fn nothing_is_listed_where_no_fact_flips_a_verdict() {
        assert!(!listed(&[]).await.has(".measure-first"));
    }

    #[wasm_bindgen_test]
    async fn nothing_is_found_without_a_worker() {
        let found = Rc::new(Cell::new(None));
        let facts = Rc::clone(&found);
        let bench = mount(move || facts.set(Some(decisive_facts()))).await;
        bench.page.edit(|project| project.name = "Changed".to_owned());
        pause(600).await;
        assert!(found.get().unwrap().get_untracked().is_empty());
    }

    #[wasm_bindgen_test]
    async fn product_fields_are_not_listed() {
        let fields = crate::ui::testing::project().machine.fields();
        let ids = || fields.iter().filter(|field| field.role.is_fact());
        let machine: Vec<String> = ids().filter(|field| !field.essential).map(|field| field.id.to_owned()).collect();
        assert!(machine.len() < ids().count());
        let found = Rc::new(Cell::new(None));
        let facts = Rc::clone(&found);
        let _bench = mount(move || {
            Client::here().answer_here(|project, _| {
                let fields = project.machine.fields().into_iter().filter(|field| field.role.is_fact());
                FindFlips.answer(&fields.map(|field| field.id.to_owned()).collect())
            });
            facts.set(Some(decisive_facts()));
        })
        .await;
        let found = found.get().unwrap();
        until(move || !found.with_untracked(Vec::is_empty)).await;
        assert_eq!(found.get_untracked(), machine);
    }

    #[wasm_bindgen_test]
    async fn facts_are_those_of_the_project_after_its_last_change() {
        let found = Rc::new(Cell::new(None));
        let facts = Rc::clone(&found);
        let bench = mount(move || {
            Client::here().answer_here(|project, _| FindFlips.answer(&vec![project.name.clone()]));
            facts.set(Some(decisive_facts()));
        })
        .await;
        let found = found.get().unwrap();
        for name in ["First", "Last"] {
            bench.page.edit(|project| project.name = name.to_owned());
            settled().await;
        }
        assert!(found.get_untracked().is_empty(), "a change asks for nothing at once");
        until(move || found.get_untracked() == ["Last"]).await;
    }
}
