//! Sheets that the worker writes, written again after every change of the project.

use std::time::Duration;

use leptos::prelude::*;

use crate::project::Project;
use crate::ui::dom::delayed::Delayed;
use crate::ui::state::{Page, put};
use crate::ui::words::t;
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{Request, Response, Sheets};

/// Sheets of one kind.
#[component]
pub(crate) fn SheetView(
    /// Selects the sheets to show.
    which: fn(Sheets) -> String,
    /// Request to the worker.
    #[prop(default = || Request::Sheets)]
    request: fn() -> Request,
    /// Delay after the last change of the project before a slow request is sent.
    #[prop(default = Duration::ZERO)]
    rest: Duration,
    /// Whether the answer is slow enough for a progress bar and a cancel button.
    #[prop(optional)]
    long: bool,
    /// Shown below the sheets once they are there.
    #[prop(optional)]
    children: Option<Children>,
) -> impl IntoView {
    let (page, worker) = (Page::here(), Client::here());
    let shown = RwSignal::new(format!("<p class=\"lead\">{}</p>", t("page.reading")));
    let answered = RwSignal::new(false);
    // The sheets are outdated: they show the project before its last change.
    let outdated = RwSignal::new(true);
    // Progress of the answer, and the number of its request; none without a request.
    let far = RwSignal::new(None::<f64>);
    let asked = StoredValue::new(0);
    let is_cancelled = RwSignal::new(false);
    let show = move |response: Option<Response>| {
        let html = match response {
            Some(Response::Sheets(sheets)) => which(sheets),
            _ => format!("<p class=\"lead\">{}</p>", t("page.no-answer")),
        };
        let html = if html.is_empty() { format!("<p class=\"lead\">{}</p>", t("page.no-sheet")) } else { html };
        // The tab may have been left.
        let _ = shown.try_set(html);
        let _ = outdated.try_set(false);
        let _ = far.try_set(None);
        if answered.try_get_untracked() == Some(false) {
            answered.set(true);
        }
    };
    let ask = move || {
        put(far, Some(0.0));
        put(is_cancelled, false);
        let progress = move |share| {
            let _ = far.try_set(Some(share));
        };
        let number = page.project.with_untracked(|project| worker.ask_long(project, request(), progress, show));
        asked.set_value(number);
    };
    let delayed = Delayed::new();
    let cancel = move |_| {
        // A request that waits for its delay would undo the cancelling.
        delayed.cancel();
        worker.cancel(asked.get_value());
        far.set(None);
        is_cancelled.set(true);
    };
    let before = StoredValue::new_local(None::<Project>);
    Effect::new(move |_| {
        let mut present = page.project.get();
        // Variants change no sheet.
        present.variants.clear();
        if before.with_value(|before| before.as_ref() == Some(&present)) {
            return;
        }
        before.set_value(Some(present));
        put(outdated, true);
        if rest.is_zero() {
            ask();
        } else {
            delayed.call(ask, rest);
        }
    });
    let mut children = children;
    let working = long.then(|| {
        view! {
            <div class="working" class:on=move || far.get().is_some() || is_cancelled.get()>
                <Show
                    when=move || !is_cancelled.get()
                    fallback=move || view! {
                        <span role="status">{t("page.cancelled")}</span>
                        <button type="button" class="chip" on:click=move |_| ask()>{t("page.again")}</button>
                    }
                >
                    <progress aria-label=t("page.progress") max="1" value=move || far.get().unwrap_or(1.0).to_string()></progress>
                    <button type="button" class="chip" on:click=cancel>{t("page.cancel")}</button>
                </Show>
            </div>
        }
    });
    view! {
        {working}
        <div class="sheets" aria-busy=move || outdated.get().to_string() inner_html=move || shown.get()></div>
        {move || answered.get().then(|| children.take().map(|children| children()))}
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, pause, settled};

    #[wasm_bindgen_test]
    async fn sheet_without_a_worker_says_so() {
        let bench = mount(|| view! { <SheetView which=|sheets| sheets.plc /> }).await;
        assert_eq!(bench.text(".sheets"), t("page.no-answer"));
    }

    #[wasm_bindgen_test]
    async fn sheet_follows_the_project() {
        let bench = mount(|| {
            Client::here().answer_here(|project, _| {
                Some(Response::Sheets(Sheets { plc: format!("<b>{}</b>", project.name), ..Sheets::default() }))
            });
            view! { <SheetView which=|sheets| sheets.plc /> <SheetView which=|sheets| sheets.ways /> }
        })
        .await;
        bench.page.edit("", |project| project.name = "Customer".to_owned());
        settled().await;
        assert_eq!(bench.text("b"), "Customer");
        assert_eq!(bench.text(".sheets + .sheets"), t("page.no-sheet"));
    }

    #[wasm_bindgen_test]
    async fn cancelled_before_it_is_sent_nothing_is_asked() {
        const REST: Duration = Duration::from_millis(60);
        let bench = mount(|| {
            Client::here().answer_here(|_, _| Some(Response::Sheets(Sheets::default())));
            view! { <SheetView which=|sheets| sheets.plc rest=REST long=true /> }
        })
        .await;
        bench.press(".working button").await;
        pause(120).await;
        assert_eq!(bench.text(".working span"), t("page.cancelled"));
        assert_eq!(bench.text(".sheets"), t("page.reading"));
        bench.press_button(t("page.again")).await;
        assert_eq!(bench.text(".sheets"), t("page.no-sheet"));
    }

    #[wasm_bindgen_test]
    async fn kept_variant_asks_for_no_other_sheet() {
        let bench = mount(|| {
            Client::here().answer_here(|project, _| {
                let plc = format!("<b>{}</b>", project.variants.len());
                Some(Response::Sheets(Sheets { plc, ..Sheets::default() }))
            });
            view! { <SheetView which=|sheets| sheets.plc /> }
        })
        .await;
        bench.page.edit("", |project| assert_eq!(project.keep_variant("A"), Some(0)));
        settled().await;
        assert_eq!((bench.text("b").as_str(), bench.attribute(".sheets", "aria-busy").as_str()), ("0", "false"));
    }
}
