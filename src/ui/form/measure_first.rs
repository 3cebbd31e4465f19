//! Assumed facts that are worth measuring first: a tenth more or less of them flips a verdict.

use leptos::prelude::*;

use super::value::value_of;
use crate::machines::form::FieldInfo;
use crate::ui::dom::go_to_field;
use crate::ui::state::{Page, put};
use crate::ui::words::t;
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{Request, Response};

/// Greatest number of facts that are listed.
const MOST: usize = 5;

/// The facts; each leads to its field.
#[component]
pub(super) fn MeasureFirst() -> impl IntoView {
    let (page, worker) = (Page::here(), Client::here());
    let found = RwSignal::new(Vec::<String>::new());
    // Of one project at a time, and of the last one at the end.
    let asked = StoredValue::new(false);
    Effect::new(move |_| {
        page.project.track();
        if !asked.get_value() {
            asked.set_value(true);
            ask(page, worker, found, asked);
        }
    });
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

fn ask(page: Page, worker: Client, found: RwSignal<Vec<String>>, asked: StoredValue<bool>) {
    let sent = page.project.get_untracked();
    let about = sent.clone();
    worker.ask(&sent, Request::Flips, move |response| {
        if let Some(Response::Flips(ids)) = response
            && !found.is_disposed()
        {
            put(found, ids);
            let present = page.project.get_untracked();
            let same = present.values == about.values && present.provenance == about.provenance;
            if same && present.control.id == about.control.id {
                asked.set_value(false);
            } else {
                ask(page, worker, found, asked);
            }
        }
    });
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
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, field, mount};

    async fn mounted(answer: fn(&crate::project::Project, Request) -> Option<Response>) -> ViewBench {
        mount(move || {
            Client::here().answer_here(answer);
            view! { <MeasureFirst /> <input id="heads" /> }
        })
        .await
    }

    #[wasm_bindgen_test]
    async fn fact_that_flips_a_verdict_leads_to_its_field() {
        let bench = mounted(|_, _| Some(Response::Flips(vec!["heads".to_owned()]))).await;
        assert_eq!(
            (bench.text("button span"), bench.text("button code")),
            (t(field("heads").label).to_owned(), "6".to_owned())
        );
        bench.press("button").await;
        assert_eq!(document().active_element().unwrap().id(), "heads");
    }

    #[wasm_bindgen_test]
    async fn at_most_five_facts_are_listed() {
        let many = |_: &crate::project::Project, _| {
            let facts = crate::ui::testing::project().machine.fields().into_iter().filter(|field| field.fact);
            Some(Response::Flips(facts.map(|field| field.id.to_owned()).collect()))
        };
        assert_eq!(mounted(many).await.all("button").len(), MOST);
    }

    #[wasm_bindgen_test]
    async fn nothing_is_listed_where_no_fact_flips_a_verdict() {
        assert!(!mounted(|_, _| Some(Response::Flips(Vec::new()))).await.has(".measure-first"));
        assert!(!mounted(|_, _| None).await.has(".measure-first"));
    }
}
