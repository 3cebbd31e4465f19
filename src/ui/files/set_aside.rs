//! States of the project that gave way to another one: kept in the browser's store, several of them, and offered again.

use leptos::prelude::*;

use crate::project::Project;
use crate::project::saved::with_line;
use crate::ui::dom;
use crate::ui::parts::{Dialog, DialogButton};
use crate::ui::state::Page;
use crate::ui::words::t;

/// Begin of the keys; behind it the time in ms and the reason.
const KEYS: &str = "macroline.aside.";

/// Where earlier versions kept one state that did not read.
const OLD: &str = "macroline.set-aside";

/// States that are kept.
const MOST: usize = 8;

/// Name of the file in which a state is handed out that does not read.
pub(super) const FILE: &str = "macroline-set-aside.txt";

/// Why a state was set aside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reason {
    /// It did not read.
    Unread,
    /// A new project took its place.
    New,
    /// An opened file took its place.
    Opened,
    /// The project of a link took its place.
    Link,
    /// This tab took the place of another one.
    OtherTab,
}

impl Reason {
    const ALL: [Reason; 5] = [Reason::Unread, Reason::New, Reason::Opened, Reason::Link, Reason::OtherTab];

    /// The word in the key of the store, and the catalog id of the sentence.
    fn words(self) -> (&'static str, &'static str) {
        match self {
            Reason::Unread => ("unread", "page.aside-unread"),
            Reason::New => ("new", "page.aside-new"),
            Reason::Opened => ("opened", "page.aside-opened"),
            Reason::Link => ("link", "page.aside-link"),
            Reason::OtherTab => ("other-tab", "page.aside-other-tab"),
        }
    }
}

/// A state that was set aside.
#[derive(Clone, PartialEq)]
pub(super) struct State {
    key: String,
    /// Milliseconds since 1970; 0 where it is not known.
    at: f64,
    reason: Reason,
    text: String,
}

/// The states, the newest first.
pub(super) fn list() -> Vec<State> {
    let state = |key: String| {
        let (at, reason) = match key.strip_prefix(KEYS) {
            Some(rest) => rest.split_once('.')?,
            None => ("0", "unread"),
        };
        let reason = Reason::ALL.into_iter().find(|one| one.words().0 == reason)?;
        Some(State { at: at.parse().ok()?, reason, text: dom::stored(&key)?, key })
    };
    let keys = dom::stored_keys().into_iter().filter(|key| key.starts_with(KEYS) || key == OLD);
    let mut states: Vec<State> = keys.filter_map(state).collect();
    states.sort_by(|a, b| b.at.total_cmp(&a.at));
    states
}

/// Sets a state aside; false where the store has no room for it. The oldest one is removed only after the copy is stored.
pub(super) fn keep(text: &str, reason: Reason) -> bool {
    let before = list();
    if before.iter().any(|state| state.text == text) {
        return true;
    }
    // Two states of one millisecond have two keys.
    let at = before.first().map_or(0.0, |state| state.at + 1.0).max(js_sys::Date::now());
    let kept = dom::store(&format!("{KEYS}{at}.{}", reason.words().0), text);
    if kept {
        before.iter().skip(MOST - 1).for_each(|state| dom::forget(&state.key));
    }
    kept
}

/// Sets a project aside, unless it is an untouched example; false where the store has no room for it.
pub(super) fn keep_project(project: &Project, reason: Reason) -> bool {
    let example = project.present_example();
    let made = example.map(|example| Project::example(project.machine, project.control, example));
    made.as_ref() == Some(project) || keep(&project.to_json(), reason)
}

/// Sets the present project aside, unless it is an untouched example; tells where there is no room for it.
pub(super) fn keep_present(page: Page, reason: Reason) {
    if !page.project.with_untracked(|project| keep_project(project, reason)) {
        page.notices.notify("warn", t("page.aside-full").to_owned());
    }
}

/// The dialog that offers the states again.
#[component]
pub(crate) fn EarlierDialog() -> impl IntoView {
    let page = Page::here();
    let open = page.view.earlier;
    let states = RwSignal::new(Vec::new());
    Effect::new(move |_| {
        if open.get() {
            states.set(list());
        }
    });
    let row = move |state: State| view! { <EarlierState state=state states=states /> };
    view! {
        <Dialog id="earlier-title" title=t("page.earlier") open=open close=move || open.set(false) class="wide">
            <p>{t("page.earlier-about")}</p>
            <p class:gone=move || !states.with(Vec::is_empty)>{t("page.earlier-none")}</p>
            <table class="earlier"><tbody>
                <For each=move || states.get() key=|state| state.key.clone() children=row />
            </tbody></table>
        </Dialog>
    }
}

/// One state: its project, when and why it was set aside, and what can be done with it.
#[component]
fn EarlierState(
    /// The state.
    state: State,
    /// All states that are shown.
    states: RwSignal<Vec<State>>,
) -> impl IntoView {
    let page = Page::here();
    let loaded = Project::from_json(&state.text);
    let name = match &loaded.project {
        Some(project) if project.name.is_empty() => t("page.untitled").to_owned(),
        Some(project) => project.name.clone(),
        None => loaded.diagnostics.first().map(|found| with_line(found, &state.text)).unwrap_or_default(),
    };
    let about =
        loaded.project.as_ref().map(|project| format!("{}, {}", t(project.machine.name()), project.control.name));
    let when = if state.at > 0.0 {
        String::from(js_sys::Date::new(&state.at.into()).to_locale_string("en-GB", &js_sys::Object::new().into()))
    } else {
        String::new()
    };
    let reads = loaded.project.is_some();
    let take = move |_| {
        if let Some(project) = loaded.project.clone() {
            keep_present(page, Reason::Opened);
            page.replace(project);
            page.view.earlier.set(false);
        }
    };
    let file = if reads { "macroline.json" } else { FILE };
    let text = state.text.clone();
    let save = move |_| dom::download(file, "text/plain", text.as_bytes());
    let forget = move |_| {
        dom::forget(&state.key);
        states.set(list());
    };
    view! {
        <tr>
            <th scope="row">{name}<small>{about}</small></th>
            <td>{t(state.reason.words().1)}<small>{when}</small></td>
            <td>
                <button type="button" class:gone=!reads on:click=take>{t("page.open")}</button>
                <button type="button" on:click=save>{t("page.save-file")}</button>
                <button type="button" on:click=forget>{t("page.delete")}</button>
            </td>
        </tr>
    }
}

/// The button of the dialog.
#[component]
pub(super) fn EarlierButton() -> impl IntoView {
    view! { <DialogButton id="earlier" label="page.earlier" about="page.earlier-about" open=Page::here().view.earlier /> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{Bench, first_project, mount, mount_project, project, settled};

    fn named(name: &str) -> String {
        let mut project = project();
        project.name = name.to_owned();
        project.to_json()
    }

    async fn dialog() -> Bench {
        let bench = mount(|| view! { <EarlierButton /> <EarlierDialog /> }).await;
        keep(&named("Order 7"), Reason::New);
        keep("{ not a project", Reason::Unread);
        bench.press("#earlier").await;
        bench
    }

    #[wasm_bindgen_test]
    async fn several_states_are_kept_and_the_oldest_goes_last() {
        let _bench = mount(|| ()).await;
        for at in 0..MOST + 2 {
            assert!(keep(&named(&at.to_string()), Reason::New));
        }
        let names: Vec<_> =
            list().iter().filter_map(|state| Some(Project::from_json(&state.text).project?.name)).collect();
        assert_eq!(names, ["9", "8", "7", "6", "5", "4", "3", "2"]);
        assert!(keep(&named("5"), Reason::New));
        assert_eq!(list().len(), MOST);
    }

    #[wasm_bindgen_test]
    async fn nothing_is_removed_where_there_is_no_room() {
        let _bench = mount(|| ()).await;
        (0..MOST).for_each(|at| assert!(keep(&named(&at.to_string()), Reason::New)));
        let before = list();
        assert!(!keep(&"x".repeat(12_000_000), Reason::Unread));
        assert!(list() == before);
    }

    #[wasm_bindgen_test]
    async fn state_is_opened_again_and_the_present_one_set_aside() {
        let bench = dialog().await;
        assert_eq!(bench.all("tbody tr").len(), 2);
        bench.page.set("pitch", crate::machines::form::Value::Number(9.0));
        bench.press("tr:nth-child(2) button:first-child").await;
        assert_eq!(bench.page.project.with_untracked(|project| project.name.clone()), "Order 7");
        assert!(!bench.has("dialog[open]"));
        assert_eq!(list().first().map(|state| state.reason), Some(Reason::Opened));
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(crate::machines::form::Value::Number(9.0)));
    }

    #[wasm_bindgen_test]
    async fn state_that_does_not_read_can_be_saved_and_deleted_only() {
        let bench = dialog().await;
        assert!(bench.has("tr:first-child button.gone"));
        assert!(bench.text("tr:first-child td").contains(t("page.aside-unread")));
        bench.press("tr:first-child button:last-child").await;
        settled().await;
        assert_eq!((bench.all("tbody tr").len(), list().len()), (1, 1));
    }

    #[wasm_bindgen_test]
    async fn untouched_project_is_not_set_aside() {
        // What another test has set aside is none of this one's.
        dom::storage().unwrap().clear().unwrap();
        let bench = mount_project(first_project(), || ()).await;
        keep_present(bench.page, Reason::New);
        assert!(list().is_empty());
    }
}
