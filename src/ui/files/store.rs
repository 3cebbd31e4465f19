//! The project in this browser's store: kept while one works, set aside when it cannot be read.

use std::time::Duration;

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::StorageEvent;

use crate::machines;
use crate::project::Project;
use crate::project::saved::with_line;
use crate::ui::dom;
use crate::ui::state::notices::Notice;
use crate::ui::state::view::Kept;
use crate::ui::state::{Page, stepping};
use crate::ui::words::t;

/// Where the project is kept.
const KEY: &str = "macroline.project";

/// Where a state goes that could not be read.
const ASIDE: &str = "macroline.set-aside";

/// Name of the file in which a state that was set aside is handed out.
pub(crate) const ASIDE_FILE: &str = "macroline-set-aside.txt";

/// The project of the last visit, or a fresh one, with notices about it. None only where no machine has a control.
pub(crate) fn load() -> (Option<Project>, Vec<Notice>) {
    let fresh = || machines::ALL.first().and_then(|machine| Project::of(machine.id(), None));
    let mut notices = Vec::new();
    let Some(text) = dom::stored(KEY) else { return (fresh(), notices) };
    let loaded = Project::from_json(&text);
    if let Some(project) = loaded.project {
        notices.extend(loaded.diagnostics.iter().map(|d| Notice {
            tone: "warn",
            text: with_line(d, &text),
            file: None,
        }));
        return (Some(project), notices);
    }
    // The text is kept under another name before anything new is written over it.
    if dom::store(ASIDE, &text) {
        dom::forget(KEY);
    }
    let reason = loaded.diagnostics.first().map(|d| with_line(d, &text)).unwrap_or_default();
    let said = format!("{} {reason}", t("page.set-aside"));
    notices.push(Notice { tone: "warn", text: said, file: Some((ASIDE_FILE, text)) });
    (fresh(), notices)
}

/// Stores the project now, and notes whether the browser has taken it.
fn store_now(page: Page) {
    let text = page.project.with_untracked(Project::to_json);
    page.view.kept.set(if dom::store(KEY, &text) { Kept::Yes } else { Kept::No });
}

/// Stores the project of this tab, whatever another tab has stored.
pub(crate) fn take_over(page: Page) {
    store_now(page);
    page.notices.dismiss(t("page.other-tab"));
}

/// Keeps the project from now on, shortly after each change.
pub(crate) fn keep(page: Page) {
    let timer = StoredValue::new(None::<TimeoutHandle>);
    let save = move || {
        // The page may be gone.
        if page.view.kept.is_disposed() || page.view.kept.get_untracked() == Kept::Elsewhere {
            return;
        }
        store_now(page);
        timer.set_value(None);
    };
    Effect::new(move |first: Option<()>| {
        page.project.track();
        if first.is_none() {
            return;
        }
        if page.view.kept.get_untracked() == Kept::Elsewhere {
            return;
        }
        page.view.kept.set(Kept::Soon);
        if let Some(timer) = timer.get_value() {
            timer.clear();
        }
        let next = set_timeout_with_handle(save, Duration::from_millis(300)).ok();
        timer.set_value(next);
    });
    dom::hear("storage", move |event| {
        let event: &StorageEvent = event.unchecked_ref();
        if event.key().as_deref() == Some(KEY) && event.new_value().is_some() {
            page.view.kept.set(Kept::Elsewhere);
            page.notices.notify("warn", t("page.other-tab").to_owned());
        }
    });
    // Whoever closes the page in that moment loses nothing either.
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
    dom::hear("pagehide", move |_| hide());
    dom::hear("visibilitychange", move |_| hide());
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, project, until};

    #[wasm_bindgen_test]
    async fn project_is_stored_shortly_after_a_change() {
        let bench = mount(|| ()).await;
        keep(bench.page);
        crate::ui::testing::settled().await;
        assert!(dom::stored(KEY).is_none());
        bench.page.set("pitch", crate::machines::form::Value::Number(9.0));
        crate::ui::testing::settled().await;
        assert_eq!(bench.page.view.kept.get_untracked(), Kept::Soon);
        let page = bench.page;
        until(move || page.view.kept.get_untracked() == Kept::Yes).await;
        let (loaded, notices) = load();
        assert!(loaded == Some(page.project.get_untracked()) && notices.is_empty());
    }

    #[wasm_bindgen_test]
    async fn state_that_does_not_read_is_set_aside() {
        let _bench = mount(|| ()).await;
        dom::store(KEY, "{ not a project");
        let (loaded, notices) = load();
        assert!(loaded == Some(project()));
        assert!(notices[0].text.contains(t("page.set-aside")));
        assert_eq!(notices[0].file, Some((ASIDE_FILE, "{ not a project".to_owned())));
        assert_eq!((dom::stored(KEY), dom::stored(ASIDE).as_deref()), (None, Some("{ not a project")));
    }
}
