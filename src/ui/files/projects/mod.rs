//! The dialog of the projects in this browser: list, search, versions, and the actions on each of them.

mod actions;
mod item;

use leptos::html;
use leptos::prelude::*;

use self::actions::ProjectActions;
use self::item::ProjectItem;
use crate::ui::parts::{Dialog, DialogButton};
use crate::ui::state::Page;
use crate::ui::words::t;

/// The button of the dialog.
#[component]
pub(super) fn ProjectsButton() -> impl IntoView {
    view! { <DialogButton id="projects" label="projects.title" about="projects.about" open=Page::here().view.projects /> }
}

/// The dialog.
#[component]
pub(crate) fn ProjectsDialog() -> impl IntoView {
    let open = Page::here().view.projects;
    let actions = ProjectActions::new();
    let search = RwSignal::new(String::new());
    let field = NodeRef::<html::Input>::new();
    Effect::new(move |_| {
        if open.get() {
            search.set(String::new());
            actions.show();
        }
    });
    let restore = move |_| {
        actions.restore();
        // The pressed button disappears, and with it the focus.
        if let Some(field) = field.get_untracked() {
            let _ = field.focus();
        }
    };
    view! {
        <Dialog id="projects-title" title=t("projects.title") open=open close=move || open.set(false) class="wide shelf">
            <div class="tools">
                <input
                    node_ref=field type="text" autocomplete="off" aria-label=t("projects.search") placeholder=t("projects.search")
                    prop:value=search on:input=move |event| search.set(event_target_value(&event))
                />
                <button type="button" id="pack" title=t("projects.pack-about") on:click=move |_| actions.pack()>{t("page.save-all")}</button>
                <FileButton id="unpack" kind=".zip" label="projects.unpack" about="projects.unpack-about" take=move |file| actions.unpack(file) />
                <FileButton id="compare-file" kind=".json" label="compare.file" about="compare.file-about" take=move |file| actions.compare_file(file) />
            </div>
            <p class="said" role="status">
                {actions.announcement} " "
                <button
                    node_ref=actions.restore_button type="button" class="link"
                    class:gone=move || !actions.can_restore() on:click=restore
                >{t("page.undo")}</button>
            </p>
            <ul class="projects">
                <For each=move || actions.found(&search.read()) key=String::clone let:id>
                    <ProjectItem actions=actions id=id />
                </For>
            </ul>
        </Dialog>
    }
}

/// A button that asks for a file.
#[component]
fn FileButton(
    /// Id of its input.
    id: &'static str,
    /// End of the names of files.
    kind: &'static str,
    /// Catalog id of its words.
    label: &'static str,
    /// Catalog id of its tooltip.
    about: &'static str,
    /// Called with the chosen file.
    take: impl Fn(web_sys::File) + 'static,
) -> impl IntoView {
    let input = NodeRef::<html::Input>::new();
    let chosen = move |_| {
        let Some(input) = input.get() else { return };
        if let Some(file) = input.files().and_then(|files| files.get(0)) {
            take(file);
        }
        // An emptied input reports the same file again when it is chosen twice in a row.
        input.set_value("");
    };
    view! {
        <input node_ref=input id=id class="hidden" type="file" accept=kind tabindex="-1" aria-label=t(label) on:change=chosen />
        <button type="button" title=t(about) on:click=move |_| input.get_untracked().iter().for_each(|input| input.click())>{t(label)}</button>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use leptos::wasm_bindgen::JsCast;
    use web_sys::{Element, HtmlInputElement};

    use super::super::set_aside::{self, SetAsideReason};
    use super::super::{shelf, store};
    use super::*;
    use crate::machines::form::Value;
    use crate::msg;
    use crate::ui::testing::{ViewBench, mount, project, until, work_here};
    use crate::ui::words::{day, sentence};
    use crate::ui::worker::client::Client;
    use crate::ui::worker::messages::{BEFORE_VERSION, ShelfState};

    /// Fields with the names of the projects.
    const NAMES: &str = ".projects > li > .what input";

    fn state(id: &str, of: &str, name: &str) -> ShelfState {
        let text = project().with_name(name).to_json();
        ShelfState { id: id.to_owned(), of: of.to_owned(), at: 1.0, text, ..ShelfState::default() }
    }

    /// The open dialog, with two projects besides the present one, and a version of the first.
    async fn dialog() -> ViewBench {
        shelf::test_shelf::empty();
        for state in [state("p2", "", "Order 2"), state("p3", "", "Order 3"), state("v2", "p2", "Order 2 before")] {
            shelf::test_shelf::put(state).await;
        }
        opened().await
    }

    async fn opened() -> ViewBench {
        let bench = mount(|| {
            work_here(Client::here());
            view! { <ProjectsButton /> <ProjectsDialog /> }
        })
        .await;
        bench.press("#projects").await;
        listed(&bench).await;
        bench
    }

    async fn listed(bench: &ViewBench) {
        let list = bench.find(".projects");
        until(move || list.children().length() > 0).await;
    }

    /// Presses a button of the project or version of a name.
    async fn press(bench: &ViewBench, label: &'static str, name: &str) {
        bench.press(&format!("[aria-label='{} {name}']", t(label))).await;
    }

    /// Names of the listed projects, the present one first.
    fn names(bench: &ViewBench) -> Vec<String> {
        let name = |field: Element| field.unchecked_into::<HtmlInputElement>().value();
        bench.all(NAMES).into_iter().map(name).collect()
    }

    fn name(bench: &ViewBench) -> String {
        bench.page.project.with_untracked(|project| project.name.clone())
    }

    async fn until_names(bench: &ViewBench, expected: &[&str]) {
        for _ in 0..100 {
            if names(bench) == expected {
                return;
            }
            crate::ui::testing::pause(10).await;
        }
        assert_eq!(names(bench), expected);
    }

    #[wasm_bindgen_test]
    async fn project_before_the_opened_one_is_kept() {
        let bench = dialog().await;
        store::keep(bench.page, store::Stored::default());
        bench.page.set("pitch", Value::Number(9.0));
        crate::ui::testing::settled().await;
        press(&bench, "page.open", "Order 2").await;
        assert_eq!((name(&bench).as_str(), bench.has("dialog[open]")), ("Order 2", false));
        assert_eq!(bench.page.project.with_untracked(|project| project.id.clone()).as_deref(), Some("p2"));
        until(|| set_aside::list().is_empty()).await;
        let kept = shelf::states().await.unwrap();
        assert!(kept.iter().any(|state| state.text.contains("\"pitch\": 9")), "the one before is not on the shelf");
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(Value::Number(9.0)));
        // The store follows the project until the page is gone.
        crate::ui::testing::settled().await;
    }

    #[wasm_bindgen_test]
    async fn opened_version_leaves_the_last_state_as_a_version() {
        let bench = dialog().await;
        press(&bench, "page.open", &day(1.0)).await;
        assert_eq!(name(&bench), "Order 2 before");
        assert_eq!(bench.page.project.with_untracked(|project| project.id.clone()).as_deref(), Some("p2"));
        crate::ui::testing::pause(50).await;
        let kept = shelf::states().await.unwrap();
        let before = kept.iter().find(|state| state.of == "p2" && state.note == BEFORE_VERSION).unwrap();
        assert!(before.text.contains("Order 2\""));
    }

    #[wasm_bindgen_test]
    async fn search_leaves_the_projects_that_have_all_words() {
        let bench = dialog().await;
        bench.type_into(".shelf .tools input", "order 3").await;
        assert_eq!(names(&bench), ["Order 3"]);
        bench.type_into(".shelf .tools input", "").await;
        assert_eq!(names(&bench), ["", "Order 2", "Order 3"]);
    }

    #[wasm_bindgen_test]
    async fn duplicate_renames_and_deletes_are_listed() {
        let bench = dialog().await;
        press(&bench, "projects.duplicate", "Order 2").await;
        let copy = sentence(&msg!("projects.copy-of", name = "Order 2"));
        until_names(&bench, &["", &copy, "Order 2", "Order 3"]).await;
        bench.choose(".projects > li:nth-child(4) > .what input", "Order 33").await;
        until_names(&bench, &["", &copy, "Order 2", "Order 33"]).await;
        press(&bench, "page.delete", "Order 2").await;
        until_names(&bench, &["", &copy, "Order 33"]).await;
        assert!(shelf::states().await.unwrap().iter().all(|state| state.of != "p2"), "its version is left");
        bench.press(".said button").await;
        until_names(&bench, &["", &copy, "Order 2", "Order 33"]).await;
        assert!(shelf::states().await.unwrap().iter().any(|state| state.of == "p2"));
    }

    #[wasm_bindgen_test]
    async fn present_project_is_renamed_in_the_form_and_by_undo() {
        let bench = dialog().await;
        bench.choose(".present > .what input", "Order 1").await;
        assert_eq!(name(&bench), "Order 1");
        bench.page.undo();
        assert_eq!(name(&bench), "");
    }

    #[wasm_bindgen_test]
    async fn version_of_the_present_project_is_kept_with_its_note() {
        let bench = dialog().await;
        bench.press(".present .versions summary").await;
        bench.type_into(".keep input", "as offered").await;
        press_keep(&bench).await;
        assert!(bench.has(".present .versions[open]"), "the list of versions is folded");
        assert_eq!(bench.value(".keep input"), "");
        assert!(bench.text(".present .versions").contains("as offered"));
        assert_eq!(bench.text(".said"), t("projects.kept").to_owned() + " " + t("page.undo"));
    }

    async fn press_keep(bench: &ViewBench) {
        bench.press(".keep button").await;
        let list = bench.find(".projects");
        until(move || list.query_selector(".present .versions li").unwrap().is_some()).await;
    }

    #[wasm_bindgen_test]
    async fn pressed_step_is_gone_to_and_listed_as_undone() {
        shelf::test_shelf::empty();
        let bench = opened().await;
        bench.page.set("pitch", Value::Number(9.0));
        bench.page.set("heads", Value::Number(7.0));
        // The steps are listed from the last to the first: two to be undone, then one of both undone.
        for (row, pitch) in [(3, 8.0), (2, 9.0)] {
            bench.page.view.projects.set(false);
            crate::ui::testing::settled().await;
            bench.press("#projects").await;
            let list = bench.find(".projects");
            until(move || list.query_selector_all(".steps li").unwrap().length() == 3).await;
            bench.press(&format!(".steps li:nth-child({row}) button")).await;
            assert_eq!(bench.setting("pitch"), Some(Value::Number(pitch)));
            assert!(!bench.has("dialog[open]"));
        }
    }

    #[wasm_bindgen_test]
    async fn refused_list_gives_a_notice_and_shows_projects_set_aside() {
        shelf::test_shelf::empty();
        shelf::test_shelf::refuse("SecurityError");
        drop(mount(|| ()).await);
        let bench = opened().await;
        set_aside::keep_project(&project().with_name("Order 7"), SetAsideReason::Replaced);
        set_aside::keep("{ not a project", SetAsideReason::Unread, None);
        bench.page.view.projects.set(false);
        crate::ui::testing::settled().await;
        bench.press("#projects").await;
        let list = bench.find(".projects");
        until(move || list.children().length() == 3).await;
        assert!(bench.notices().contains(&sentence(&msg!("projects.refused", reason = t("projects.denied")))));
        let text = bench.text(".projects");
        assert!(
            text.contains("Order 7") && text.contains(t("page.aside-opened")) && text.contains(t("page.aside-unread"))
        );
        press(&bench, "page.delete", t("page.aside-unread")).await;
        until(|| set_aside::list().len() == 1).await;
        until(|| {
            document().active_element().is_some_and(|focus| focus.text_content().as_deref() == Some(t("page.undo")))
        })
        .await;
        bench.press(".said button").await;
        until(|| set_aside::list().len() == 2).await;
    }

    #[wasm_bindgen_test]
    async fn row_of_a_newer_page_is_listed_and_left_alone() {
        shelf::test_shelf::empty();
        shelf::test_shelf::put(state("p9", "", "Order 9")).await;
        let rows = shelf::states().await.unwrap();
        let newer = ShelfState { version: 2.0, ..rows[0].clone() };
        shelf::ask("restore", &[&js_sys::Array::of1(&shelf::row(&newer))]).await.unwrap();
        let bench = opened().await;
        assert!(bench.text(".projects > li:nth-child(2)").contains(t("projects.newer")));
        assert!(bench.has(".projects > li:nth-child(2) button"));
        assert!(
            bench
                .all(".projects > li:nth-child(2) button")
                .iter()
                .all(|button| button.text_content().as_deref() != Some(t("page.open")))
        );
    }
}
