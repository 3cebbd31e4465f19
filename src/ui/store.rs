//! The project in this browser's store: kept while one works, set aside when it cannot be read.

use std::time::Duration;

use leptos::prelude::*;

use super::debug;
use super::dom;
use super::editor;
use super::local::Local;
use super::model::Model;
use super::state::{Kept, Notice};
use super::words::t;
use crate::machines;
use crate::project::Project;
use crate::project::saved::with_line;

/// Where the project is kept.
const KEY: &str = "macroline.project";

/// Where a state goes that could not be read.
const ASIDE: &str = "macroline.set-aside";

/// Name of the file in which a state that was set aside is handed out.
pub(super) const ASIDE_FILE: &str = "macroline-set-aside.txt";

/// The project of the last visit, or a fresh one, with notices about it. None only where no machine has a control.
pub(super) fn load() -> (Option<Project>, Vec<Notice>) {
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
    dom::store(ASIDE, &text);
    dom::forget(KEY);
    let reason = loaded.diagnostics.first().map(|d| with_line(d, &text)).unwrap_or_default();
    let said = format!("{} {reason}", t("page.set-aside"));
    notices.push(Notice { tone: "warn", text: said, file: Some((ASIDE_FILE, text)) });
    (fresh(), notices)
}

/// Keeps the project from now on, shortly after each change.
pub(super) fn keep(model: Model) {
    let timer = Local::new(None::<TimeoutHandle>);
    let save = move || {
        let text = model.project.with_untracked(Project::to_json);
        model.kept.set(if dom::store(KEY, &text) { Kept::Yes } else { Kept::No });
        timer.quietly(|timer| *timer = None);
    };
    Effect::new(move |first: Option<()>| {
        model.project.track();
        if first.is_none() {
            return;
        }
        model.kept.set(Kept::Soon);
        if let Some(timer) = timer.get_untracked() {
            timer.clear();
        }
        let next = set_timeout_with_handle(save, Duration::from_millis(300)).ok();
        timer.quietly(|timer| *timer = next);
    });
    // Whoever closes the page in that moment loses nothing either.
    let hide = move || {
        debug::keep(model);
        let typed = model.typed.with_untracked(Option::is_some);
        editor::take(model);
        let waiting = timer.get_untracked();
        if typed || waiting.is_some() {
            waiting.iter().for_each(TimeoutHandle::clear);
            save();
        }
    };
    dom::hear("pagehide", move |_| hide());
    dom::hear("visibilitychange", move |_| hide());
}
