//! This tab beside the other tabs of the browser: one of them holds the project and stores it, the others watch.

use std::time::Duration;

use leptos::prelude::*;

use super::super::set_aside::{self, SetAsideReason};
use super::super::shelf;
use super::last_visit::no_room;
use super::write::{CARRIED, ID, store_now};
use crate::project::Project;
use crate::ui::dom;
use crate::ui::dom::tab_entry::drop_carried;
use crate::ui::state::view::{Kept, PROJECT};
use crate::ui::state::{Page, put};
use crate::ui::words::{Tone, t};

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

/// Least time (ms) from the message [`LEAVES`] until a watching tab takes over, and greatest random time added so that one of them is first. A
/// reloaded page has asked by then.
const PATIENCE: (f64, f64) = (4000.0, 1000.0);

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

/// This tab. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(super) struct ThisTab {
    page: Page,
    /// Whether it was opened by a link: then it never follows another tab.
    by_link: bool,
    /// The project of the other tab that is shown here.
    shown: StoredValue<Option<Project>, LocalStorage>,
    /// The project with which this tab began to watch.
    watched: StoredValue<Option<Project>, LocalStorage>,
}

impl ThisTab {
    /// Notes which projects are shown in this tab, and puts a project that another one replaces on the shelf.
    pub(super) fn new(page: Page, by_link: bool) -> ThisTab {
        let tab = ThisTab { page, by_link, shown: StoredValue::new_local(None), watched: StoredValue::new_local(None) };
        Effect::new(move |before: Option<bool>| {
            let watches = page.view.kept.try_get() == Some(Kept::Elsewhere);
            if watches && before != Some(true) {
                tab.watched.set_value(page.project.try_get_untracked());
            }
            watches
        });
        Effect::new(move |last: Option<Option<Project>>| {
            // The page may be gone.
            let present = page.project.try_get()?;
            // The projects of another tab that this tab follows are kept by that tab.
            let follows = tab.shown.with_value(|shown| shown.as_ref() == Some(&present));
            let gone = last.flatten().filter(|last| last.id.is_some() && last.id != present.id && !follows);
            gone.iter().for_each(|last| shelf::leave(page, last));
            Some(present)
        });
        tab
    }

    /// Asks whether another tab holds the project.
    pub(super) fn ask(self) {
        notify_tabs(ASKS);
    }

    /// Handles messages and stored states of other tabs. A watching tab follows the other tab's project until it is edited here.
    pub(super) fn receive(self, key: &str, value: &str) {
        let ThisTab { page, by_link, shown, .. } = self;
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

    /// The page closes: the next tab may take over. Changes in a tab that only watches are set aside, because they are stored nowhere else.
    pub(super) fn close(self) {
        match self.page.view.kept.try_get_untracked() {
            Some(Kept::Elsewhere) => {
                let own = self.page.project.get_untracked();
                let differs = |known: StoredValue<Option<Project>, LocalStorage>| {
                    known.with_value(|known| known.as_ref() != Some(&own))
                };
                if differs(self.shown) && differs(self.watched) {
                    set_aside::keep(&own.to_json(), SetAsideReason::OtherTab, None);
                }
            }
            Some(_) => notify_tabs(LEAVES),
            None => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::super::tests::kept;
    use super::*;
    use crate::machines::form::Value;
    use crate::ui::testing::{event, pause, project, settled};

    /// Simulates another tab that stores a value or sends a message.
    async fn other_tab(key: &str, value: &str) {
        let members = [("key", key.into()), ("newValue", value.into())];
        window().dispatch_event(&event("StorageEvent", "storage", &members)).unwrap();
        settled().await;
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
