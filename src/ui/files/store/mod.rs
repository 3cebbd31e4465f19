//! The project in this browser's store, with its steps of undo: kept during work, set aside if unreadable, held by one tab.

mod last_visit;
mod tabs;
mod write;

use std::time::Duration;

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Event, PageTransitionEvent, StorageEvent};

use super::latest;
use super::set_aside::{self, SetAsideReason};
use super::shelf;
use crate::project::Project;
use crate::ui::dom;
use crate::ui::dom::delayed::Delayed;
use crate::ui::dom::tab_entry::{carried, remembered};
use crate::ui::state::history::History;
use crate::ui::state::view::{Kept, PROJECT};
use crate::ui::state::{Page, stepping};
pub(crate) use last_visit::{Stored, load};
use tabs::ThisTab;
pub(crate) use tabs::take_over;
use write::{STEPS, has_latest, refused, store_now};

/// Time from a change until it is stored.
const REST: Duration = Duration::from_millis(300);

/// Time that another tab has to answer.
const ANSWER: Duration = Duration::from_secs(2);

/// Stores the project with the entry being typed, or, in a tab that watches, a copy of it set aside, so that a reload loses nothing.
/// Returns false if the browser has no room for it.
pub(super) fn store_before_reload(page: Page) -> bool {
    page.take_typed();
    if page.view.kept.get_untracked() == Kept::Elsewhere {
        let own = page.project.with_untracked(Project::to_json);
        return dom::stored(PROJECT).is_some_and(|stored| stored == own)
            || set_aside::keep(&own, SetAsideReason::OtherTab, None);
    }
    store_now(page);
    page.view.kept.get_untracked() == Kept::Yes || carried(PROJECT).is_some()
}

/// Whether this tab stores the project: no other tab holds it, and the page is still there.
fn is_stored_here(page: Page) -> bool {
    page.view.kept.try_get_untracked().is_some_and(|kept| kept != Kept::Elsewhere)
}

/// Stores the project shortly after each change: the call that waits, and the function that stores at once.
fn save_after_changes(page: Page, by_link: bool) -> (Delayed, impl Fn() + Copy + 'static) {
    let waiting = Delayed::new();
    let save = move || {
        if is_stored_here(page) {
            store_now(page);
        }
    };
    Effect::new(move |first: Option<()>| {
        page.project.track();
        if first.is_none() && !by_link || !is_stored_here(page) {
            return;
        }
        page.view.kept.set(Kept::Soon);
        // The project of a link waits for the answer of a tab that holds another one, which a busy machine delays.
        let rest = if first.is_none() { ANSWER } else { REST };
        waiting.call(save, rest);
    });
    (waiting, save)
}

/// Keeps the project from now on, shortly after each change, as long as no other tab holds it. A project that a link replaced is one step
/// back.
pub(crate) fn keep(page: Page, Stored { occupied, replaced }: Stored) {
    let by_link = replaced.is_some();
    let mut steps = remembered(STEPS).filter(|_| !occupied).map(|steps| History::from_json(&steps)).unwrap_or_default();
    if let Some(before) = replaced {
        steps.note(&before, None, dom::now());
    }
    page.take_steps(steps);
    let is_carried = carried(PROJECT).is_some();
    if is_carried {
        page.view.kept.set(refused());
    }
    if occupied {
        page.view.kept.set(Kept::Elsewhere);
    }
    shelf::ensure_project_id(page);
    shelf::take_in_soon(page);
    if !by_link && !is_carried && !has_latest() {
        latest::offer(page);
    }
    let tab = ThisTab::new(page, by_link);
    let (waiting, save) = save_after_changes(page, by_link);
    dom::on_event("storage", move |event| {
        let event: &StorageEvent = event.unchecked_ref();
        // The page may be gone.
        if let (Some(key), Some(value), false) = (event.key(), event.new_value(), page.is_gone()) {
            tab.receive(&key, &value);
        }
    });
    tab.ask();
    // A page that is closed during the delay loses nothing either.
    let hide = move || {
        stepping::keep(page);
        let typed = page.program.typed.with_value(Option::is_some);
        page.take_typed();
        if waiting.cancel() || typed {
            save();
        }
    };
    dom::on_event("pagehide", move |_| {
        hide();
        tab.close();
    });
    // The history takes no text any more when the page is gone.
    dom::on_event("beforeunload", move |event| {
        hide();
        warn_of_loss(page, &event);
    });
    // A page restored from the browser's history asks like a new one.
    dom::on_event("pageshow", move |event| {
        if event.unchecked_ref::<PageTransitionEvent>().persisted() {
            tab.ask();
        }
    });
    dom::on_event("visibilitychange", move |_| hide());
}

/// Asks before a project is lost that the browser does not store. A reload by the page itself loses nothing.
fn warn_of_loss(page: Page, event: &Event) {
    let refused = page.view.kept.try_get_untracked().is_some_and(Kept::is_refused);
    if refused && !dom::reloads() && !page.project.with_untracked(set_aside::is_untouched) {
        event.prevent_default();
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::write::PLACE;
    use super::*;
    use crate::machines;
    use crate::machines::form::Value;
    use crate::ui::state::EditKey;
    use crate::ui::state::history::Undoable;
    use crate::ui::testing::{ViewBench, mount, mount_project, new_tab, project, settled, until};
    use crate::ui::words::t;

    async fn stored_soon(page: Page) {
        settled().await;
        until(move || page.view.kept.get_untracked() == Kept::Yes).await;
    }

    /// A page that keeps its project.
    pub(super) async fn kept() -> ViewBench {
        let bench = mount(|| ()).await;
        keep(bench.page, Stored::default());
        settled().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn project_is_stored_shortly_after_a_change() {
        let bench = kept().await;
        assert!(dom::stored(PROJECT).is_none());
        bench.page.set("pitch", Value::Number(9.0));
        settled().await;
        assert_eq!(bench.page.view.kept.get_untracked(), Kept::Soon);
        stored_soon(bench.page).await;
        let visit = load();
        assert!(visit.project == Some(bench.page.project.get_untracked()) && visit.notices.is_empty());
    }

    #[wasm_bindgen_test]
    async fn replaced_project_is_kept_at_every_replacement() {
        let ways: [fn(Page); 4] = [
            |page| page.change_machine(machines::ALL[1].id()),
            |page| page.replace(project().with_name("Order 7")),
            |page| page.undo(),
            |page| page.watch(project().with_id(Some("p9".to_owned()))),
        ];
        for way in ways {
            shelf::test_shelf::empty();
            let bench = kept().await;
            bench.page.replace(project().with_name("Before"));
            settled().await;
            way(bench.page);
            settled().await;
            until(|| set_aside::list().is_empty()).await;
            let names = shelf::states()
                .await
                .unwrap()
                .into_iter()
                .filter_map(|state| Some(Project::from_json(&state.text).project?.name));
            assert!(names.into_iter().any(|name| name == "Before"));
        }
    }

    #[wasm_bindgen_test]
    async fn project_has_its_id_again_after_a_reload() {
        let bench = kept().await;
        bench.page.set("pitch", Value::Number(9.0));
        stored_soon(bench.page).await;
        let id = bench.page.project.with_untracked(|project| project.id.clone());
        assert!(id.is_some() && load().project.unwrap().id == id);
    }

    /// Fills the store up to its last byte.
    fn fill() {
        let mut part = 1 << 22;
        while part > 0 {
            let filled = dom::stored("filler").unwrap_or_default();
            if !dom::store("filler", &(filled + &"x".repeat(part))) {
                part /= 2;
            }
        }
    }

    #[wasm_bindgen_test]
    async fn project_that_only_the_shelf_has_is_offered_at_the_start() {
        // With a project of an earlier visit in the store, and without one.
        for earlier in [true, false] {
            shelf::test_shelf::empty();
            let bench = kept().await;
            if earlier {
                bench.page.set("pitch", Value::Number(9.0));
                stored_soon(bench.page).await;
            } else {
                dom::forget(PLACE);
            }
            // With steps in the store the project would be stored in their space.
            dom::forget(STEPS);
            fill();
            bench.page.edit_merged(EditKey::Name, |project| project.name = "Order 7 ".repeat(12));
            until(move || bench.page.view.kept.get_untracked() == Kept::No).await;
            shelf::keep_present(bench.page).await.unwrap();
            let latest = bench.page.project.get_untracked();
            drop(bench);
            new_tab();
            let visit = load();
            assert!(visit.project.as_ref().is_some_and(|project| project.name.is_empty()));
            let bench = mount_project(visit.project.unwrap(), || ()).await;
            keep(bench.page, visit.stored);
            until(|| !bench.notices().is_empty()).await;
            let offer = bench.page.notices.list.with_untracked(|list| list[0].offer);
            offer.unwrap().1.run(());
            assert!(bench.page.project.get_untracked() == latest);
            dom::forget("filler");
        }
    }

    #[wasm_bindgen_test]
    async fn project_without_room_returns_after_a_reload() {
        let bench = kept().await;
        bench.page.set("pitch", Value::Number(9.0));
        stored_soon(bench.page).await;
        dom::forget(STEPS);
        fill();
        bench.page.edit_merged(EditKey::Name, |project| project.name = "Order 7 ".repeat(12));
        until(move || bench.page.view.kept.get_untracked() == Kept::No).await;
        let latest = bench.page.project.get_untracked();
        drop(bench);
        let visit = load();
        assert!(visit.project.as_ref() == Some(&latest) && latest.id.is_some());
        let bench = mount_project(visit.project.unwrap(), || ()).await;
        keep(bench.page, visit.stored);
        settled().await;
        bench.page.undo();
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(Value::Number(8.0)));
        dom::forget("filler");
        stored_soon(bench.page).await;
        assert_eq!(carried(PROJECT), None);
    }

    #[wasm_bindgen_test]
    async fn undo_goes_on_after_a_reload() {
        let bench = kept().await;
        bench.page.set("pitch", Value::Number(9.0));
        stored_soon(bench.page).await;
        drop(bench);
        let visit = load();
        let bench = mount_project(visit.project.unwrap(), || ()).await;
        keep(bench.page, visit.stored);
        assert_eq!(bench.page.undoable.get_untracked(), Undoable { undo: true, redo: false });
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(Value::Number(8.0)));
    }

    #[wasm_bindgen_test]
    async fn state_without_room_for_a_copy_stays_until_the_user_decides() {
        let bench = mount(|| ()).await;
        // Two of them have no room.
        let text = "{".repeat(3_000_000);
        assert!(dom::store(PROJECT, &text));
        let visit = load();
        assert!(visit.stored.occupied && visit.notices[0].text.contains(t("page.set-aside-full")));
        keep(bench.page, visit.stored);
        bench.page.set("pitch", Value::Number(9.0));
        settled().await;
        assert_eq!(bench.page.view.kept.get_untracked(), Kept::Elsewhere);
        assert!(dom::stored(PROJECT).is_some_and(|stored| stored == text));
        take_over(bench.page);
        assert!(dom::stored(PROJECT).is_some_and(|stored| stored != text));
        assert!(bench.notices().contains(&t("page.aside-full").to_owned()));
    }
}
