//! How many results fail, with a button that changes the form so that they hold.

use leptos::prelude::*;

use crate::text::clauses;
use crate::ui::state::Page;
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{FoundRepairs, Request, Response};

/// The number of failing results and the button; empty while every result holds.
#[component]
pub(super) fn RepairAll() -> impl IntoView {
    let (page, worker) = (Page::here(), Client::here());
    let searching = RwSignal::new(false);
    let failing = Memo::new(move |_| page.results.failing());
    let repair = move |_| {
        searching.set(true);
        let asked = page.project.get_untracked();
        worker.ask(&asked.clone(), Request::Repairs, move |response| {
            searching.set(false);
            match response {
                // Changes of an older project are not taken: the button finds new ones.
                Some(Response::Repairs(_)) if page.project.with_untracked(|project| *project != asked) => {}
                Some(Response::Repairs(found)) => take(page, &found),
                _ => page.notices.notify(Tone::Fail, t("page.no-answer").to_owned()),
            }
        });
    };
    let words = move || sentence(&crate::msg!("page.results-fail", count = failing.get()));
    view! {
        <Show when=move || { failing.get() > 0 }>
            <div class="repairs">
                <p><i aria-hidden="true">{Tone::Fail.sign()}</i> " " {words}</p>
                <button type="button" title=t("page.repair-about") prop:disabled=move || searching.get() || page.is_stale() on:click=repair>
                    {t("page.repair")}
                </button>
            </div>
        </Show>
    }
}

/// Takes the changes in one step, and says which they are.
fn take(page: Page, found: &FoundRepairs) {
    let fields = page.project.with_untracked(|project| project.machine.fields());
    let known = |(id, text): &(String, String)| {
        fields.iter().find(|field| field.id == id).map(|field| (field.id, text.clone()))
    };
    let entries: Vec<(&'static str, String)> = found.entries.iter().filter_map(known).collect();
    if entries.is_empty() {
        return page.notices.notify(Tone::Warn, t("page.no-repair").to_owned());
    }
    page.take_entries(&entries);
    let (changes, left, errors) = (clauses(&found.changes), found.still_failing, found.errors);
    if left == 0 {
        // The notice that results of this project fail is no longer true.
        page.notices.leave_project();
    }
    let (tone, message) = match (left, errors) {
        (0, 0) => (Tone::Info, crate::msg!("page.repaired", changes)),
        (0, _) => (Tone::Warn, crate::msg!("page.repaired-errors", changes, errors)),
        _ => (Tone::Warn, crate::msg!("page.repaired-but", changes, left)),
    };
    page.notices.notify(tone, sentence(&message));
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::project::Project;
    use crate::ui::testing::{ViewBench, mount_project, settled};
    use crate::ui::worker::documents::repairs;

    fn answer(project: &Project, _: Request) -> Option<Response> {
        Some(Response::Repairs(repairs(project)))
    }

    async fn failing() -> ViewBench {
        mount_project(Project::named("ribbon-line", None, Some("paper")).unwrap(), || view! { <RepairAll /> }).await
    }

    #[wasm_bindgen_test]
    async fn sound_design_offers_no_repair() {
        let sound = Project::of("ribbon-line", None).unwrap();
        assert!(!mount_project(sound, || view! { <RepairAll /> }).await.has(".repairs"));
    }

    #[wasm_bindgen_test]
    async fn repair_makes_every_result_hold_in_one_step() {
        let bench = failing().await;
        assert!(bench.text(".repairs p").contains(&sentence(&crate::msg!("page.results-fail", count = 7_u32))));
        bench.page.notices.notify_of_project(Tone::Warn, "7 results fail".to_owned());
        bench.worker.answer_here(answer);
        bench.press(".repairs button").await;
        settled().await;
        assert!(!bench.has(".repairs") && !bench.notices().contains(&"7 results fail".to_owned()));
        assert!(bench.notices().iter().any(|notice| notice.contains("15.28")), "{:?}", bench.notices());
        bench.page.undo();
        settled().await;
        assert!(bench.has(".repairs"));
    }

    #[wasm_bindgen_test]
    async fn repair_without_a_remedy_changes_nothing_and_says_so() {
        let bench = failing().await;
        let before = bench.page.project.get_untracked();
        bench.worker.answer_here(|_, _| Some(Response::Repairs(FoundRepairs::default())));
        bench.press(".repairs button").await;
        assert!(bench.page.project.with_untracked(|project| *project == before));
        assert!(bench.notices().contains(&t("page.no-repair").to_owned()), "{:?}", bench.notices());
    }

    #[wasm_bindgen_test]
    async fn repair_without_a_worker_is_a_notice() {
        let bench = failing().await;
        bench.press(".repairs button").await;
        assert!(bench.notices().contains(&t("page.no-answer").to_owned()), "{:?}", bench.notices());
        assert!(bench.has(".repairs button:enabled"));
    }
}
