//! The shelf: projects and their versions in a database of this browser (IndexedDB), with the present one, kept during work.

use std::time::Duration;

use leptos::prelude::*;
use leptos::wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};

use super::set_aside::{self, SetAsideReason};
use crate::msg;
use crate::project::Project;
use crate::ui::dom;
use crate::ui::dom::script::call;
use crate::ui::state::Page;
use crate::ui::state::view::Kept;
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::messages::{OTHER_TAB, ShelfState};

/// Delay after the last change before the project is put on the shelf; until then the browser's other store has it.
const REST: Duration = Duration::from_secs(2);

/// A state as a row of the database.
pub(super) fn row(state: &ShelfState) -> JsValue {
    serde_wasm_bindgen::to_value(state).unwrap_or_default()
}

/// Calls a method of the database; the error is a reason in words.
pub(super) async fn ask(method: &'static str, values: &[&JsValue]) -> Result<JsValue, String> {
    let asked = async {
        let promise = call(&module().await?, method, values)?;
        JsFuture::from(promise.dyn_into::<js_sys::Promise>()?).await
    };
    asked.await.map_err(|error| reason(&error))
}

/// Reason of an error by its name, one of the browser's or of `shelf.js`.
fn reason(error: &JsValue) -> String {
    match dom::error_name(error).as_str() {
        "QuotaExceededError" => t("projects.no-room").to_owned(),
        "VersionError" => t("projects.newer").to_owned(),
        "SecurityError" | "NotAllowedError" => t("projects.denied").to_owned(),
        "NoArchive" => t("projects.no-archive").to_owned(),
        "Incomplete" => t("projects.incomplete").to_owned(),
        _ => dom::error_text(error),
    }
}

/// Gives the present project an id if it has none.
pub(super) fn ensure_project_id(page: Page) {
    if page.project.with_untracked(|project| project.id.is_none()) {
        page.project.update_untracked(|project| project.id = Some(dom::fresh_id()));
    }
}

/// The present project as a state of the shelf.
pub(super) fn present(page: Page) -> ShelfState {
    ensure_project_id(page);
    page.project.with_untracked(|project| ShelfState {
        id: project.id.clone().unwrap_or_default(),
        at: js_sys::Date::now(),
        text: project.to_json(),
        ..ShelfState::default()
    })
}

/// Puts the present project on the shelf; an untouched example only if its id is there already. A tab that watches another one puts nothing
/// on the shelf.
pub(super) async fn keep_present(page: Page) -> Result<(), String> {
    if page.view.kept.try_get_untracked().is_none_or(|kept| kept == Kept::Elsewhere) {
        return Ok(());
    }
    let untouched = page.project.with_untracked(set_aside::is_untouched);
    ask("put", &[&row(&present(page)), &untouched.into()]).await.map(drop)
}

/// Keeps a version of a project; an automatic one (note `auto:…`) only if it differs from the last version.
pub(super) async fn keep_version(of: &str, note: &str, text: String) -> Result<(), String> {
    let versions = states().await?;
    let last = versions.iter().filter(|state| state.of == of).max_by(|a, b| a.at.total_cmp(&b.at));
    if note.starts_with("auto:") && last.is_some_and(|last| last.text == text) {
        return Ok(());
    }
    let state = ShelfState {
        id: dom::fresh_id(),
        of: of.to_owned(),
        at: js_sys::Date::now(),
        note: note.to_owned(),
        text,
        ..ShelfState::default()
    };
    ask("put", &[&row(&state)]).await.map(drop)
}

/// Everything on the shelf.
pub(super) async fn states() -> Result<Vec<ShelfState>, String> {
    serde_wasm_bindgen::from_value(ask("all", &[]).await?).map_err(|error| error.to_string())
}

/// Reports that the shelf refuses a project. It is in the browser's other store, so it is not lost.
pub(super) fn warn_refused(page: Page, reason: &str) {
    if !page.is_gone() {
        page.notices.notify(Tone::Warn, sentence(&msg!("projects.refused", reason)));
    }
}

/// Keeps a version of the present project before another project or program replaces it.
pub(super) fn version_before(page: Page, note: &'static str) {
    let before = present(page);
    spawn_local(async move {
        if let Err(reason) = keep_version(&before.id, note, before.text).await {
            warn_refused(page, &reason);
        }
    });
}

/// Moves the states that were set aside to the shelf, which has more room. Each stays in the store until the shelf has it; unreadable ones
/// stay there.
pub(super) async fn take_in(page: Page) -> Result<(), String> {
    for state in set_aside::list() {
        if state.reason == SetAsideReason::Unread || page.is_gone() {
            continue;
        }
        let now = present(page);
        // A state that undo has made the present project again needs no entry of its own.
        if state.text != now.text {
            let own = state.id.as_deref().filter(|id| *id != now.id);
            let kept = ShelfState {
                // Two tabs give the same state the same id.
                id: own.map_or_else(|| format!("a{:x}", state.at as u64), str::to_owned),
                at: state.at,
                note: if state.reason == SetAsideReason::OtherTab { OTHER_TAB.to_owned() } else { String::new() },
                text: state.text.clone(),
                ..ShelfState::default()
            };
            ask("put", &[&row(&kept)]).await?;
        }
        dom::forget(&state.key);
    }
    Ok(())
}

/// Sets a replaced project aside, unless it is an untouched example, until the shelf has it; reports a lack of room.
pub(super) fn leave(page: Page, before: &Project) {
    if !set_aside::keep_project(before, SetAsideReason::Replaced) {
        page.notices.notify(Tone::Warn, t("page.aside-full").to_owned());
    }
    take_in_soon(page);
}

/// Moves the states in the background: after one was set aside, and at the start for states left from the last visit.
pub(super) fn take_in_soon(page: Page) {
    if set_aside::list().iter().all(|state| state.reason == SetAsideReason::Unread) {
        return;
    }
    spawn_local(async move {
        if let Err(reason) = take_in(page).await {
            warn_refused(page, &reason);
        }
    });
}

thread_local! {
    static WAITS: std::cell::Cell<Option<TimeoutHandle>> = const { std::cell::Cell::new(None) };
}

/// Puts the project on the shelf after a pause in the changes.
pub(super) fn soon(page: Page) {
    let put = move || {
        spawn_local(async move {
            if let Err(reason) = keep_present(page).await {
                warn_refused(page, &reason);
            }
        });
    };
    let next = set_timeout_with_handle(put, REST).ok();
    if let Some(before) = WAITS.replace(next) {
        before.clear();
    }
}

#[cfg(not(test))]
async fn module() -> Result<JsValue, JsValue> {
    dom::script::load("shelf.js").await
}

#[cfg(test)]
async fn module() -> Result<JsValue, JsValue> {
    Ok(test_shelf::module())
}

/// A shelf for tests, in place of the database.
#[cfg(test)]
pub(super) mod test_shelf {
    use std::cell::RefCell;

    use super::*;

    thread_local! {
        static MODULE: RefCell<Option<JsValue>> = const { RefCell::new(None) };
    }

    /// A database in memory: `fault` is the name of the error with which it refuses everything.
    const SHELF: &str = "(() => { const rows = new Map(); const it = { fault: '', rows };
        const act = (does) => async (...values) => { if (it.fault) throw new DOMException('refused', it.fault); return does(...values); };
        it.all = act(() => [...rows.values()]);
        it.put = act((row, known) => { if (!known || rows.has(row.id)) rows.set(row.id, { ...row, version: 1 }); });
        it.remove = act((id) => { const gone = [...rows.values()].filter((row) => row.id === id || row.of === id);
          gone.forEach((row) => rows.delete(row.id)); return gone; });
        it.restore = act((gone) => gone.forEach((row) => rows.set(row.id, row)));
        return it; })()";

    fn made() -> JsValue {
        js_sys::eval(SHELF).unwrap()
    }

    pub(super) fn module() -> JsValue {
        MODULE.with_borrow_mut(|module| module.get_or_insert_with(made).clone())
    }

    /// Begins with an empty shelf.
    pub(in crate::ui::files) fn empty() {
        MODULE.set(Some(made()));
    }

    /// Makes the shelf refuse everything, by the name of the browser's error.
    pub(in crate::ui::files) fn refuse(fault: &str) {
        crate::ui::dom::script::set(&module(), "fault", &fault.into());
    }

    /// Puts a state on the shelf.
    pub(in crate::ui::files) async fn put(state: ShelfState) {
        ask("put", &[&row(&state)]).await.unwrap();
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::text::catalog::{self, Language};
    use crate::ui::testing::{ViewBench, first_project, mount, mount_project, project};
    use crate::ui::worker::messages::{BEFORE_PROGRAM, BEFORE_VERSION};

    async fn bench() -> ViewBench {
        test_shelf::empty();
        mount(|| ()).await
    }

    fn named(name: &str) -> Project {
        project().with_name(name)
    }

    async fn names() -> Vec<String> {
        let name = |state: &ShelfState| Some(Project::from_json(&state.text).project?.name);
        states().await.unwrap().iter().filter_map(name).collect()
    }

    #[wasm_bindgen_test]
    async fn present_project_is_kept_under_one_id() {
        let bench = bench().await;
        for pitch in [9.0, 7.0] {
            bench.page.set("pitch", Value::Number(pitch));
            keep_present(bench.page).await.unwrap();
        }
        let kept = states().await.unwrap();
        assert_eq!(kept.len(), 1);
        assert_eq!(Project::from_json(&kept[0].text).project.unwrap().values["pitch"], Value::Number(7.0));
    }

    #[wasm_bindgen_test]
    async fn untouched_example_is_not_kept() {
        drop(bench().await);
        let bench = mount_project(first_project(), || ()).await;
        keep_present(bench.page).await.unwrap();
        assert!(states().await.unwrap().is_empty());
    }

    #[wasm_bindgen_test]
    async fn undone_project_is_kept_under_its_own_id_again() {
        let bench = bench().await;
        bench.page.set("pitch", Value::Number(9.0));
        keep_present(bench.page).await.unwrap();
        bench.page.replace(named("Order 7"));
        keep_present(bench.page).await.unwrap();
        bench.page.undo();
        keep_present(bench.page).await.unwrap();
        assert_eq!(names().await, ["", "Order 7"]);
    }

    #[wasm_bindgen_test]
    async fn states_that_were_set_aside_go_to_the_shelf() {
        let bench = bench().await;
        set_aside::keep_project(&named("Order 7").with_id(Some("p1".to_owned())), SetAsideReason::Replaced);
        set_aside::keep("{ not a project", SetAsideReason::Unread, None);
        take_in(bench.page).await.unwrap();
        let kept = states().await.unwrap();
        assert_eq!((kept.len(), kept[0].id.as_str()), (1, "p1"));
        assert_eq!(set_aside::list().iter().map(|state| state.reason).collect::<Vec<_>>(), [SetAsideReason::Unread]);
    }

    #[wasm_bindgen_test]
    async fn state_of_another_tab_never_takes_the_place_of_a_project() {
        let bench = bench().await;
        keep_present(bench.page).await.unwrap();
        set_aside::keep(&named("Of the other").to_json(), SetAsideReason::OtherTab, None);
        take_in(bench.page).await.unwrap();
        assert_eq!(names().await, ["", "Of the other"]);
    }

    #[wasm_bindgen_test]
    async fn refused_state_stays_where_it_was_set_aside() {
        let bench = bench().await;
        set_aside::keep_project(&named("Order 7"), SetAsideReason::Replaced);
        for (fault, reason) in [
            ("QuotaExceededError", "projects.no-room"),
            ("SecurityError", "projects.denied"),
            ("VersionError", "projects.newer"),
        ] {
            let reason = t(reason);
            test_shelf::refuse(fault);
            let refused = take_in(bench.page).await.unwrap_err();
            warn_refused(bench.page, &refused);
            assert!(bench.notices().contains(&sentence(&msg!("projects.refused", reason))), "{refused}");
            assert_eq!(set_aside::list().len(), 1);
        }
    }

    #[wasm_bindgen_test]
    async fn unknown_error_is_named_in_chinese() {
        let bench = bench().await;
        test_shelf::refuse("UnknownError");
        assert_eq!(keep_present(bench.page).await.unwrap_err(), "refused");
        catalog::speak(Language::Chinese.sentences());
        let told = keep_present(bench.page).await.unwrap_err();
        catalog::speak(Language::English.sentences());
        assert!(told.contains("UnknownError") && !told.contains("refused"), "{told}");
    }

    #[wasm_bindgen_test]
    async fn watching_tab_keeps_nothing() {
        let bench = bench().await;
        bench.page.view.kept.set(Kept::Elsewhere);
        keep_present(bench.page).await.unwrap();
        assert!(states().await.unwrap().is_empty());
    }

    #[wasm_bindgen_test]
    async fn same_version_is_kept_by_itself_only_once() {
        drop(bench().await);
        for note in [BEFORE_PROGRAM, BEFORE_VERSION, "mine"] {
            keep_version("p1", note, "{}".to_owned()).await.unwrap();
        }
        assert_eq!(states().await.unwrap().len(), 2);
    }
}
