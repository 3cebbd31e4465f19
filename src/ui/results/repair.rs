//! How many results fail, with a button that finds changes of the form with which they hold.

use leptos::prelude::*;

use crate::text::clauses;
use crate::ui::state::Page;
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{FindRepairs, FoundRepairs};
use crate::view::FieldEntry;

/// The number of failing results, the button, and the ways that were found; empty while every result holds.
#[component]
pub(super) fn RepairAll() -> impl IntoView {
    let (page, worker) = (Page::here(), Client::here());
    let searching = RwSignal::new(false);
    let ways = RwSignal::new(Vec::<FoundRepairs>::new());
    let failing = Memo::new(move |_| page.results.failing());
    // Ways of an older project are no longer offered.
    Effect::new(move |_| {
        page.project.track();
        ways.set(Vec::new());
    });
    let repair = move |_| {
        searching.set(true);
        let asked = page.project.get_untracked();
        worker.ask(&asked.clone(), FindRepairs, move |found| {
            searching.set(false);
            match found {
                Some(_) if page.project.with_untracked(|project| *project != asked) => {}
                Some(found) => match found.as_slice() {
                    [] => take(page, &FoundRepairs::default()),
                    [only] => take(page, only),
                    _ => ways.set(found),
                },
                None => page.notices.notify(Tone::Fail, t("page.no-answer").to_owned()),
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
                <Show when=move || ways.with(|ways| !ways.is_empty())>
                    <Ways ways=ways />
                </Show>
            </div>
        </Show>
    }
}

/// The ways, each with its changes, its consequences, and a button that takes it.
#[component]
fn Ways(
    /// The ways.
    ways: RwSignal<Vec<FoundRepairs>>,
) -> impl IntoView {
    let page = Page::here();
    let lead = move || {
        if ways.with(|ways| ways.iter().all(|way| way.still_failing == 0)) {
            t("page.repair-ways")
        } else {
            t("page.repair-ways-but")
        }
    };
    let row = move |way: FoundRepairs| {
        let (changes, name) =
            (clauses(&way.changes), sentence(&crate::msg!("page.repair-way", changes = clauses(&way.changes))));
        let consequences = if way.consequences.is_empty() {
            t("page.repair-nothing-else").to_owned()
        } else {
            clauses(&way.consequences)
        };
        view! {
            <li>
                <p>{changes}</p>
                <p class="dim">{consequences}</p>
                {(!way.warning.is_empty()).then(|| view! {
                    <p class="warn"><i aria-hidden="true">{Tone::Warn.sign()}</i> " " {way.warning.clone()}</p>
                })}
                <button type="button" aria-label=name on:click=move |_| take(page, &way)>{t("page.repair-take")}</button>
            </li>
        }
    };
    view! {
        <p class="lead" role="status">{lead}</p>
        <ul class="ways-out">{move || ways.get().into_iter().map(row).collect_view()}</ul>
    }
}

/// Takes the changes in one step, and says which they are.
fn take(page: Page, found: &FoundRepairs) {
    let fields = page.project.with_untracked(|project| project.machine.fields());
    let known = |(id, text): &(String, String)| {
        fields.iter().find(|field| field.id == id).map(|field| FieldEntry::new(field.id, text.as_str()))
    };
    let entries: Vec<FieldEntry> = found.entries.iter().filter_map(known).collect();
    if entries.is_empty() {
        return page.notices.notify(Tone::Warn, t("page.no-repair").to_owned());
    }
    page.take_entries(&entries);
    let (changes, left, errors) = (clauses(&found.changes), found.still_failing, found.errors);
    let (tone, message) = match (left, errors) {
        (0, 0) if !found.warning.is_empty() => {
            (Tone::Warn, crate::msg!("page.repaired-warned", changes, warning = found.warning.as_str()))
        }
        (0, 0) => (Tone::Info, crate::msg!("page.repaired", changes)),
        (0, _) => (Tone::Warn, crate::msg!("page.repaired-errors", changes, errors)),
        _ => (Tone::Warn, crate::msg!("page.repaired-but", changes, left)),
    };
    page.notices.confirm_as(tone, sentence(&message));
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::project::Project;
    use crate::ui::testing::{ViewBench, mount_project, settled, work_here};
    use crate::ui::worker::messages::Ask;

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
        assert!(bench.text(".repairs p").contains(&sentence(&crate::msg!("page.results-fail", count = 9_u32))));
        bench.page.notices.confirm_as(Tone::Warn, "9 results fail".to_owned());
        work_here(bench.worker);
        bench.press(".repairs button").await;
        settled().await;
        assert!(bench.all(".ways-out li").len() > 1);
        assert!(bench.text(".ways-out li .dim").contains(t("ribbon.readout.surface-ratio")));
        bench.press(".ways-out button").await;
        settled().await;
        assert!(!bench.has(".repairs") && !bench.notices().contains(&"9 results fail".to_owned()));
        assert!(bench.notices().iter().any(|notice| notice.contains("47")), "{:?}", bench.notices());
        bench.page.undo();
        settled().await;
        assert!(bench.has(".repairs"));
    }

    #[wasm_bindgen_test]
    async fn repair_without_a_remedy_only_gives_a_notice() {
        let bench = failing().await;
        let before = bench.page.project.get_untracked();
        bench.worker.answer_here(|_, _| FindRepairs.answer(&vec![FoundRepairs::default()]));
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
