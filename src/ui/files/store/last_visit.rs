//! The state that the page begins with: that of the last visit, or the project of a link.

use super::super::set_aside::{self, SetAsideReason};
use super::super::share;
use super::write::{ID, STEPS};
use crate::machines;
use crate::project::Project;
use crate::project::saved::{Loaded, with_line};
use crate::ui::dom;
use crate::ui::dom::tab_entry::carried;
use crate::ui::state::notices::Notice;
use crate::ui::state::view::PROJECT;
use crate::ui::words::{Tone, t};

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
pub(super) fn no_room(state: Option<String>) -> Notice {
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

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{first_project, mount};

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
}
