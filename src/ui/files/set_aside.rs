//! States of the project that another one replaced: kept in the browser's store until the shelf has them.

use crate::project::Project;
use crate::ui::dom;

/// Prefix of the keys, followed by the time in ms, the reason, and the id of the project if it has one.
const KEYS: &str = "macroline.aside.";

/// Key in the browser's store under which earlier versions kept one unreadable state.
const OLD: &str = "macroline.set-aside";

/// States that are kept.
const MOST: usize = 8;

/// Name of the file in which an unreadable state is offered to the user.
pub(super) const FILE: &str = "macroline-set-aside.txt";

/// Why a state was set aside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SetAsideReason {
    /// The state is unreadable.
    Unread,
    /// Another project replaced it.
    Replaced,
    /// A project of another tab that this tab replaced.
    OtherTab,
}

impl SetAsideReason {
    /// The reason by its word in a key.
    fn of(word: &str) -> Option<SetAsideReason> {
        match word {
            "unread" => Some(SetAsideReason::Unread),
            // Includes the words that the page used until November 2026.
            "opened" | "new" | "link" => Some(SetAsideReason::Replaced),
            "other-tab" => Some(SetAsideReason::OtherTab),
            _ => None,
        }
    }

    /// The word in the key of the store, and the catalog id of the sentence.
    pub(super) fn words(self) -> (&'static str, &'static str) {
        match self {
            SetAsideReason::Unread => ("unread", "page.aside-unread"),
            SetAsideReason::Replaced => ("opened", "page.aside-opened"),
            SetAsideReason::OtherTab => ("other-tab", "page.aside-other-tab"),
        }
    }
}

/// A state that was set aside.
#[derive(Clone, PartialEq)]
pub(super) struct SetAsideState {
    /// Key of the state in the store.
    pub key: String,
    /// Milliseconds since 1970; 0 where it is not known.
    pub at: f64,
    /// Why it was set aside.
    pub reason: SetAsideReason,
    /// Id of the project; none where it may be that of another state.
    pub id: Option<String>,
    /// The text.
    pub text: String,
}

/// Whether a key of the store is that of a state.
pub(super) fn is_key(key: &str) -> bool {
    key.starts_with(KEYS) || key == OLD
}

/// The states, the newest first.
pub(super) fn list() -> Vec<SetAsideState> {
    let state = |key: String| {
        let mut parts = key.strip_prefix(KEYS).unwrap_or("0.unread").splitn(3, '.');
        let (at, reason) = (parts.next()?.parse().ok()?, parts.next()?);
        let id = parts.next().map(str::to_owned);
        Some(SetAsideState { at, reason: SetAsideReason::of(reason)?, id, text: dom::stored(&key)?, key })
    };
    let keys = dom::stored_keys().into_iter().filter(|key| is_key(key));
    let mut states: Vec<SetAsideState> = keys.filter_map(state).collect();
    states.sort_by(|a, b| b.at.total_cmp(&a.at));
    states
}

/// Sets a state aside, with the id of its project; false where the store has no room for it. The oldest one is removed only after the copy is stored.
pub(super) fn keep(text: &str, reason: SetAsideReason, id: Option<&str>) -> bool {
    let before = list();
    if before.iter().any(|state| state.text == text) {
        return true;
    }
    // Two states of one millisecond have two keys.
    let at = before.first().map_or(0.0, |state| state.at + 1.0).max(js_sys::Date::now());
    let id = id.map(|id| format!(".{id}")).unwrap_or_default();
    let kept = dom::store(&format!("{KEYS}{at}.{}{id}", reason.words().0), text);
    if kept {
        before.iter().skip(MOST - 1).for_each(|state| dom::forget(&state.key));
    }
    kept
}

/// Whether a project equals an example of the gallery.
pub(super) fn is_untouched(project: &Project) -> bool {
    let example = project.present_example();
    example.map(|example| Project::example(project.machine, project.control, example)).as_ref() == Some(project)
}

/// Sets a project aside, unless it is an untouched example; false where the store has no room for it.
pub(super) fn keep_project(project: &Project, reason: SetAsideReason) -> bool {
    is_untouched(project) || keep(&project.to_json(), reason, project.id.as_deref())
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{first_project, mount, project};

    fn named(name: &str) -> String {
        project().with_name(name).to_json()
    }

    #[wasm_bindgen_test]
    async fn several_states_are_kept_and_the_oldest_goes_last() {
        let _bench = mount(|| ()).await;
        for at in 0..MOST + 2 {
            assert!(keep(&named(&at.to_string()), SetAsideReason::Replaced, None));
        }
        let names: Vec<_> =
            list().iter().filter_map(|state| Some(Project::from_json(&state.text).project?.name)).collect();
        assert_eq!(names, ["9", "8", "7", "6", "5", "4", "3", "2"]);
        assert!(keep(&named("5"), SetAsideReason::Replaced, None));
        assert_eq!(list().len(), MOST);
    }

    #[wasm_bindgen_test]
    async fn nothing_is_removed_where_there_is_no_room() {
        let _bench = mount(|| ()).await;
        (0..MOST).for_each(|at| assert!(keep(&named(&at.to_string()), SetAsideReason::Replaced, None)));
        let before = list();
        assert!(!keep(&"x".repeat(12_000_000), SetAsideReason::Unread, None));
        assert!(list() == before);
    }

    #[wasm_bindgen_test]
    async fn state_keeps_the_id_of_its_project() {
        let _bench = mount(|| ()).await;
        keep_project(&project().with_id(Some("p1.x".to_owned())), SetAsideReason::Replaced);
        keep("{ not a project", SetAsideReason::Unread, None);
        let ids: Vec<_> = list().into_iter().map(|state| (state.reason, state.id)).collect();
        assert_eq!(ids, [(SetAsideReason::Unread, None), (SetAsideReason::Replaced, Some("p1.x".to_owned()))]);
    }

    #[wasm_bindgen_test]
    async fn untouched_project_is_not_set_aside() {
        let _bench = mount(|| ()).await;
        assert!(keep_project(&first_project(), SetAsideReason::Replaced) && list().is_empty());
    }
}
