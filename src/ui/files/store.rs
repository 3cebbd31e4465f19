//! The project in this browser's store, with its steps of undo: kept during work, set aside if unreadable, held by one tab.

use std::cell::Cell;
use std::time::Duration;

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Event, PageTransitionEvent, StorageEvent};

use super::latest;
use super::set_aside::{self, SetAsideReason};
use super::share;
use super::shelf;
use crate::machines;
use crate::project::Project;
use crate::project::saved::{Loaded, with_line};
use crate::ui::dom;
use crate::ui::dom::tab_entry::{carried, carry, drop_carried, remembered};
use crate::ui::state::history::History;
use crate::ui::state::notices::Notice;
use crate::ui::state::view::{Kept, PROJECT};
use crate::ui::state::{Page, put, stepping};
use crate::ui::words::{Tone, t};
use crate::ui::worker::messages::ShelfState;

/// Key of the project's id.
const ID: &str = "macroline.id";

/// Key of the project's steps of undo and redo.
const STEPS: &str = "macroline.steps";

/// Keys of the texts that this tab's history entry carries over a reload where the store refuses the project.
const CARRIED: [&str; 3] = [PROJECT, ID, STEPS];

/// Key of the place that has the latest state of the project: [`IN_STORE`] or [`ON_SHELF`]. Both words have the same length, so that a full
/// store can replace one by the other.
const PLACE: &str = "macroline.place";

/// This store has the latest state.
const IN_STORE: &str = "store";

/// The store had no room for the latest state: at most the shelf has it.
const ON_SHELF: &str = "shelf";

/// Key of the messages between tabs of this browser: a word, and a number that makes each message a change of the store.
const TABS: &str = "macroline.tab";

/// Question of a newly opened tab: which tab holds the project?
const ASKS: &str = "asks";

/// Answer of a tab that held the project before the asking tab.
const HOLDS: &str = "holds";

/// A tab takes the project over.
const TAKES: &str = "takes";

/// Message that the tab with the project closes or reloads.
const LEAVES: &str = "leaves";

/// Time from a change until it is stored.
const REST: Duration = Duration::from_millis(300);

/// Time that another tab has to answer.
const ANSWER: Duration = Duration::from_secs(2);

/// Least time (ms) from the message [`LEAVES`] until a watching tab takes over, and greatest random time added so that one of them is first. A
/// reloaded page has asked by then.
const PATIENCE: (f64, f64) = (4000.0, 1000.0);

/// The state of the last visit.
pub(crate) struct LastVisit {
    /// The stored project, or a fresh one. `None` only if no machine has a control.
    pub project: Option<Project>,
    /// Notices about it.
    pub notices: Vec<Notice>,
    /// State of the browser's store.
    pub stored: Stored,
}

/// State of the browser's store when the page is built.
#[derive(Default)]
pub(crate) struct Stored {
    /// The store still has a state that could not be set aside for lack of room.
    pub occupied: bool,
    /// The project of the last visit, if the project of a link replaced it.
    pub replaced: Option<Project>,
}

/// The project of the link that the page was opened with, or the state of the last visit.
pub(crate) fn load() -> LastVisit {
    match share::linked() {
        Some(linked) => by_link(last_visit(), linked),
        None => last_visit(),
    }
}

/// Puts the project of a link in the place of the last visit's, which is set aside. An unreadable link changes nothing.
fn by_link(last: LastVisit, linked: Loaded) -> LastVisit {
    let mut notices = share::notices(&linked);
    notices.extend(last.notices);
    let Some(project) = linked.project else { return LastVisit { notices, ..last } };
    let aside = last.project.as_ref().is_none_or(|before| set_aside::keep_project(before, SetAsideReason::Replaced));
    if !aside {
        notices.push(no_room(last.project.as_ref().map(Project::to_json)));
    }
    let stored = Stored { occupied: last.stored.occupied || !aside, replaced: last.project };
    LastVisit { project: Some(project), notices, stored }
}

/// Notice that the store has no room to set a state aside, with the state as a file.
fn no_room(state: Option<String>) -> Notice {
    let notice = Notice::new(Tone::Warn, t("page.aside-full").to_owned());
    state.into_iter().fold(notice, |notice, state| notice.with_file(set_aside::FILE, state))
}

/// The state of the last visit. An unreadable text is set aside; without room for that, it stays.
fn last_visit() -> LastVisit {
    if let Some(project) = carried(PROJECT).and_then(|text| Project::from_json(&text).project) {
        let project = Some(project.with_id(carried(ID)));
        return LastVisit { project, notices: Vec::new(), stored: Stored::default() };
    }
    let fresh = || machines::ALL.first().and_then(|machine| Project::of(machine.id(), None));
    let Some(text) = dom::stored(PROJECT) else {
        return LastVisit { project: fresh(), notices: Vec::new(), stored: Stored::default() };
    };
    let loaded = Project::from_json(&text);
    if let Some(mut project) = loaded.project {
        project.id = dom::stored(ID);
        let notice = |found| Notice::new(Tone::Warn, with_line(found, &text));
        let notices = loaded.diagnostics.iter().map(notice).collect();
        return LastVisit { project: Some(project), notices, stored: Stored::default() };
    }
    let aside = set_aside::keep(&text, SetAsideReason::Unread, None);
    if aside {
        dom::forget(PROJECT);
        dom::forget(STEPS);
    }
    let reason = loaded.diagnostics.first().map(|found| with_line(found, &text)).unwrap_or_default();
    let message = format!("{} {reason}", t(if aside { "page.set-aside" } else { "page.set-aside-full" }));
    let notice = Notice::new(Tone::Warn, message).with_file(set_aside::FILE, text);
    LastVisit { project: fresh(), notices: vec![notice], stored: Stored { occupied: !aside, replaced: None } }
}

/// Stores the project now, then its steps, and notes whether the store had room.
fn store_now(page: Page) {
    let ShelfState { id, text, .. } = shelf::present(page);
    // The id before the text: a tab that is notified of the text reads its id. An id without its project would belong to another one.
    let id_before = dom::stored(ID);
    if !dom::store(ID, &id) {
        dom::forget(ID);
    }
    // Without room for both, the steps are dropped for the project.
    let kept = dom::store(PROJECT, &text) || make_room(&text);
    if kept {
        dom::store(STEPS, &page.steps());
        drop_carried(&CARRIED);
    } else {
        dom::forget(ID);
        if let Some(id) = id_before {
            dom::store(ID, &id);
        }
        // A stale state would come back.
        if !carry(&[(PROJECT, &text), (ID, &id), (STEPS, &page.steps())]) {
            drop_carried(&CARRIED);
        }
    }
    if kept || carried(PROJECT).is_some() {
        share::forget_link();
    }
    dom::store(PLACE, if kept { IN_STORE } else { ON_SHELF });
    // A state that has no room in this store may have room in the database.
    shelf::soon(page);
    page.view.kept.set(if kept { Kept::Yes } else { refused() });
    // Once: a small screen shows no state of the store.
    if !kept && !REFUSED.replace(true) {
        page.notices.notify(Tone::Warn, t(refused().words()).to_owned());
    }
}

/// The state of a store that refuses the project.
fn refused() -> Kept {
    if dom::storage().is_some() { Kept::No } else { Kept::Denied }
}

thread_local! {
    /// Whether the refusal of the store has been reported to the user.
    static REFUSED: Cell<bool> = const { Cell::new(false) };
}

/// Stores the project in the space of its stored steps; if even that does not suffice, the steps stay stored.
fn make_room(text: &str) -> bool {
    let Some(steps) = dom::stored(STEPS) else { return false };
    dom::forget(STEPS);
    let kept = dom::store(PROJECT, text);
    if !kept {
        dom::store(STEPS, &steps);
    }
    kept
}

/// Sends a word to the other tabs.
fn notify_tabs(word: &str) {
    // Only a changed value notifies other tabs.
    dom::store(TABS, &format!("{word} {}", js_sys::Math::random()));
}

/// Stores the project of this tab, and sets the other tab's stored project aside.
pub(crate) fn take_over(page: Page) {
    let own = page.project.with_untracked(Project::to_json);
    if let Some(text) = dom::stored(PROJECT).filter(|text| *text != own)
        && !set_aside::keep(&text, SetAsideReason::OtherTab, None)
    {
        page.notices.show(no_room(Some(text)));
    }
    notify_tabs(TAKES);
    store_now(page);
    shelf::take_in_soon(page);
    ["page.other-tab", "page.other-tab-open", "page.link-other-tab"]
        .into_iter()
        .for_each(|words| page.notices.dismiss(t(words)));
}

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

/// Makes this tab watch: nothing is stored from it.
fn watch(page: Page, words: &'static str) {
    put(page.view.kept, Kept::Elsewhere);
    drop_carried(&CARRIED);
    page.notices.notify(Tone::Warn, t(words).to_owned());
}

/// Takes over from a closed tab, unless another tab has sent a message since.
fn follow(page: Page) {
    let wait = PATIENCE.0 + PATIENCE.1 * js_sys::Math::random();
    let take = move || {
        let watches = !page.is_gone() && page.view.kept.get_untracked() == Kept::Elsewhere;
        if watches && dom::stored(TABS).is_some_and(|last| last.starts_with(LEAVES)) {
            take_over(page);
        }
    };
    set_timeout(take, Duration::from_millis(wait as u64));
}

/// Handles messages and stored states of other tabs. A watching tab follows the other tab's project until it is edited here; a tab opened by
/// a link never follows.
fn receive(page: Page, by_link: bool, (key, value): (&str, &str), shown: StoredValue<Option<Project>, LocalStorage>) {
    let watches = page.view.kept.get_untracked() == Kept::Elsewhere;
    match (key, value.split(' ').next().unwrap_or_default()) {
        (TABS, ASKS) if !watches => notify_tabs(HOLDS),
        (TABS, HOLDS) if !watches => {
            shown.set_value((!by_link).then(|| page.project.get_untracked()));
            watch(page, if by_link { "page.link-other-tab" } else { "page.other-tab-open" });
        }
        (TABS, TAKES) => {
            shown.set_value(Some(page.project.get_untracked()));
            watch(page, "page.other-tab");
        }
        (TABS, LEAVES) if watches => follow(page),
        (PROJECT, _) if watches => {
            let own = page.project.get_untracked();
            if shown.with_value(|shown| shown.as_ref() == Some(&own))
                && let Some(mut project) = Project::from_json(value).project
            {
                project.id = dom::stored(ID);
                shown.set_value(Some(project.clone()));
                page.watch(project);
            }
        }
        (PROJECT, _) => watch(page, "page.other-tab"),
        _ => {}
    }
}

/// Whether this store has the latest state of the project. Without a word from the last visit the store is new, full or denied; it is new
/// if it accepts a word.
fn has_latest() -> bool {
    match dom::stored(PLACE) {
        Some(place) => place == IN_STORE,
        None => dom::store(PLACE, IN_STORE),
    }
}

/// Notes the project with which this tab began to watch, and puts a project that another one replaces on the shelf.
fn note_projects(page: Page, [shown, watched]: [StoredValue<Option<Project>, LocalStorage>; 2]) {
    Effect::new(move |before: Option<bool>| {
        let watches = page.view.kept.try_get() == Some(Kept::Elsewhere);
        if watches && before != Some(true) {
            watched.set_value(page.project.try_get_untracked());
        }
        watches
    });
    Effect::new(move |last: Option<Option<Project>>| {
        // The page may be gone.
        let present = page.project.try_get()?;
        // The projects of another tab that this tab follows are kept by that tab.
        let follows = shown.with_value(|shown| shown.as_ref() == Some(&present));
        let gone = last.flatten().filter(|last| last.id.is_some() && last.id != present.id && !follows);
        gone.iter().for_each(|last| shelf::leave(page, last));
        Some(present)
    });
}

/// Whether this tab stores the project: no other tab holds it, and the page is still there.
fn is_stored_here(page: Page) -> bool {
    page.view.kept.try_get_untracked().is_some_and(|kept| kept != Kept::Elsewhere)
}

/// Stores the project shortly after each change: the timer that waits, and the function that stores at once.
fn save_after_changes(page: Page, by_link: bool) -> (StoredValue<Option<TimeoutHandle>>, impl Fn() + Copy + 'static) {
    let timer = StoredValue::new(None::<TimeoutHandle>);
    let save = move || {
        if is_stored_here(page) {
            store_now(page);
            timer.set_value(None);
        }
    };
    Effect::new(move |first: Option<()>| {
        page.project.track();
        if first.is_none() && !by_link || !is_stored_here(page) {
            return;
        }
        page.view.kept.set(Kept::Soon);
        if let Some(timer) = timer.get_value() {
            timer.clear();
        }
        // The project of a link waits for the answer of a tab that holds another one, which a busy machine delays.
        let rest = if first.is_none() { ANSWER } else { REST };
        let next = set_timeout_with_handle(save, rest).ok();
        timer.set_value(next);
    });
    (timer, save)
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
    // The project of the other tab that is shown here, and that of this tab when it began to watch.
    let shown = StoredValue::new_local(None::<Project>);
    let watched = StoredValue::new_local(None::<Project>);
    note_projects(page, [shown, watched]);
    let (timer, save) = save_after_changes(page, by_link);
    dom::on_event("storage", move |event| {
        let event: &StorageEvent = event.unchecked_ref();
        // The page may be gone.
        if let (Some(key), Some(value), false) = (event.key(), event.new_value(), page.is_gone()) {
            receive(page, by_link, (&key, &value), shown);
        }
    });
    notify_tabs(ASKS);
    // A page that is closed during the delay loses nothing either.
    let hide = move || {
        stepping::keep(page);
        let typed = page.program.typed.with_value(Option::is_some);
        page.take_typed();
        let waiting = timer.get_value();
        if typed || waiting.is_some() {
            waiting.iter().for_each(TimeoutHandle::clear);
            save();
        }
    };
    dom::on_event("pagehide", move |_| {
        hide();
        close(page, [shown, watched]);
    });
    // The history takes no text any more when the page is gone.
    dom::on_event("beforeunload", move |event| {
        hide();
        warn_of_loss(page, &event);
    });
    // A page restored from the browser's history asks like a new one.
    dom::on_event("pageshow", move |event| {
        if event.unchecked_ref::<PageTransitionEvent>().persisted() {
            notify_tabs(ASKS);
        }
    });
    dom::on_event("visibilitychange", move |_| hide());
}

/// The page closes: the next tab may take over. Changes in a tab that only watches are set aside, because they are stored nowhere else.
fn close(page: Page, known: [StoredValue<Option<Project>, LocalStorage>; 2]) {
    match page.view.kept.try_get_untracked() {
        Some(Kept::Elsewhere) => {
            let own = page.project.get_untracked();
            if known.iter().all(|known| known.with_value(|known| known.as_ref() != Some(&own))) {
                set_aside::keep(&own.to_json(), SetAsideReason::OtherTab, None);
            }
        }
        Some(_) => notify_tabs(LEAVES),
        None => {}
    }
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

    use super::*;
    use crate::machines::form::Value;
    use crate::ui::state::EditKey;
    use crate::ui::state::history::Undoable;
    use crate::ui::testing::{
        ViewBench, event, first_project, mount, mount_project, new_tab, pause, project, settled, until,
    };

    async fn stored_soon(page: Page) {
        settled().await;
        until(move || page.view.kept.get_untracked() == Kept::Yes).await;
    }

    /// Simulates another tab that stores a value or sends a message.
    async fn other_tab(key: &str, value: &str) {
        let members = [("key", key.into()), ("newValue", value.into())];
        window().dispatch_event(&event("StorageEvent", "storage", &members)).unwrap();
        settled().await;
    }

    async fn kept() -> ViewBench {
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
    async fn state_that_does_not_read_is_set_aside() {
        let _bench = mount(|| ()).await;
        dom::store(PROJECT, "{ not a project");
        let visit = load();
        assert!(visit.project == Some(first_project()) && !visit.stored.occupied);
        assert!(visit.notices[0].text.contains(t("page.set-aside")));
        assert_eq!(visit.notices[0].file, Some((set_aside::FILE, "{ not a project".to_owned())));
        assert_eq!((dom::stored(PROJECT), set_aside::list().len()), (None, 1));
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

    #[wasm_bindgen_test]
    async fn tab_that_opens_second_watches_until_it_takes_over() {
        let bench = kept().await;
        other_tab(TABS, "holds 0.5").await;
        assert_eq!(bench.page.view.kept.get_untracked(), Kept::Elsewhere);
        assert_eq!(bench.notices(), [t("page.other-tab-open")]);
        let mut theirs = project();
        theirs.name = "Order 7".to_owned();
        dom::store(PROJECT, &theirs.to_json());
        other_tab(PROJECT, &theirs.to_json()).await;
        assert!(bench.page.project.get_untracked() == theirs);
        bench.page.set("pitch", Value::Number(9.0));
        settled().await;
        take_over(bench.page);
        assert_eq!(bench.page.view.kept.get_untracked(), Kept::Yes);
        assert!(dom::stored(TABS).unwrap().starts_with(TAKES) && bench.notices().is_empty());
        assert_eq!(set_aside::list().len(), 1);
    }

    #[wasm_bindgen_test]
    async fn watching_tab_takes_over_when_the_other_closes() {
        for (last, kept_then) in [("leaves 0.5", Kept::Yes), ("asks 0.5", Kept::Elsewhere)] {
            let bench = kept().await;
            other_tab(TABS, "holds 0.5").await;
            other_tab(TABS, "leaves 0.5").await;
            // Last message in the store: a page that was loaded again has already asked.
            dom::store(TABS, last);
            pause((PATIENCE.0 + PATIENCE.1) as i32 + 200).await;
            assert_eq!(
                (bench.page.view.kept.get_untracked(), bench.notices().is_empty()),
                (kept_then, kept_then == Kept::Yes)
            );
        }
    }

    #[wasm_bindgen_test]
    async fn tab_that_holds_the_project_answers_and_gives_way() {
        let bench = kept().await;
        other_tab(TABS, "asks 0.5").await;
        assert!(dom::stored(TABS).unwrap().starts_with(HOLDS));
        assert_eq!(bench.page.view.kept.get_untracked(), Kept::Yes);
        other_tab(TABS, "takes 0.5").await;
        assert_eq!(bench.notices(), [t("page.other-tab")]);
    }

    #[wasm_bindgen_test]
    async fn watching_tab_that_is_edited_keeps_its_own_values() {
        let bench = kept().await;
        other_tab(TABS, "holds 0.5").await;
        bench.page.set("pitch", Value::Number(9.0));
        other_tab(PROJECT, &project().to_json()).await;
        assert_eq!(bench.setting("pitch"), Some(Value::Number(9.0)));
    }
}
