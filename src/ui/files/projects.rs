//! The dialog of the projects in this browser: list, search, versions, and what can be done with each of them.

use leptos::ev::Event;
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Element, HtmlElement, HtmlInputElement};

use super::open::show;
use super::set_aside;
use super::shelf;
use crate::msg;
use crate::project::Project;
use crate::ui::dom;
use crate::ui::parts::{Dialog, DialogButton};
use crate::ui::state::Page;
use crate::ui::state::view::Compared;
use crate::ui::words::{say, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{BEFORE_VERSION, Request, Response, Shelf, ShelfState};

/// Name of the archive of all projects.
const ARCHIVE: &str = "macroline-projects.zip";

/// Id of the field with the note of the next version.
pub(crate) const NOTE: &str = "version-note";

/// The last deletion, which the undo button brings back.
#[derive(Clone)]
enum Deleted {
    /// Rows of the database.
    Rows(JsValue),
    /// Key and text of a state that was set aside.
    Aside(String, String),
}

/// The button of the dialog.
#[component]
pub(super) fn ProjectsButton() -> impl IntoView {
    view! { <DialogButton id="projects" label="projects.title" about="projects.about" open=Page::here().view.projects /> }
}

/// The dialog as handles: copies mean the same.
#[derive(Clone, Copy)]
struct List {
    page: Page,
    worker: Client,
    /// The items of the list.
    html: RwSignal<String>,
    /// Everything on the shelf and what was set aside, as it is listed.
    states: StoredValue<Vec<ShelfState>>,
    /// The last message of the dialog.
    said: RwSignal<String>,
    /// The last deletion, which the undo button brings back.
    deleted: RwSignal<Option<Deleted>, LocalStorage>,
    /// Text of the search field.
    search: RwSignal<String>,
    host: NodeRef<html::Ul>,
}

/// The dialog.
#[component]
pub(crate) fn ProjectsDialog() -> impl IntoView {
    let page = Page::here();
    let open = page.view.projects;
    let list = List {
        page,
        worker: Client::here(),
        html: RwSignal::new(String::new()),
        states: StoredValue::new(Vec::new()),
        said: RwSignal::new(String::new()),
        deleted: RwSignal::new_local(None),
        search: RwSignal::new(String::new()),
        host: NodeRef::new(),
    };
    Effect::new(move |_| {
        if open.get() {
            list.say("");
            list.show();
        }
    });
    Effect::new(move |_| {
        list.search.track();
        list.find();
    });
    view! {
        <Dialog id="projects-title" title=t("projects.title") open=open close=move || open.set(false) class="wide shelf">
            <div class="tools">
                <input
                    type="text" autocomplete="off" aria-label=t("projects.search") placeholder=t("projects.search")
                    prop:value=list.search on:input=move |event| list.search.set(event_target_value(&event))
                />
                <button type="button" id="pack" title=t("projects.pack-about") on:click=move |_| list.pack()>{t("page.save-all")}</button>
                <FileButton id="unpack" kind=".zip" label="projects.unpack" about="projects.unpack-about" take=move |file| list.unpack(file) />
                <FileButton id="compare-file" kind=".json" label="compare.file" about="compare.file-about" take=move |file| list.compare_file(file) />
            </div>
            <p class="said" role="status">
                {list.said} " "
                <button type="button" class="link" class:gone=move || list.deleted.with(Option::is_none) on:click=move |_| list.restore()>
                    {t("page.undo")}
                </button>
            </p>
            <ul class="projects" node_ref=list.host inner_html=list.html on:click=move |event| list.act(&event) on:change=move |event| list.act(&event)></ul>
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
    /// Catalog id of what is said about it.
    about: &'static str,
    /// Takes the file.
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

/// Action (`data-act`) of the element of an event, and the id of its project or version.
fn asked(event: &Event) -> Option<(String, String)> {
    let element: Element = event.target()?.dyn_into().ok()?;
    let act = element.get_attribute("data-act")?;
    // A field acts when it is left with another text, a button when it is pressed.
    if (event.type_() == "change") != (act == "rename") {
        return None;
    }
    let id = element.closest("[data-id]").ok()??.get_attribute("data-id")?;
    Some((act, id))
}

impl List {
    /// Says what was done.
    fn say(self, text: impl Into<String>) {
        let _ = self.said.try_set(text.into());
        let _ = self.deleted.try_set(None);
    }

    /// Does something with the database and shows what became of the list.
    fn then(self, work: impl Future<Output = Result<String, String>> + 'static) {
        spawn_local(async move {
            match work.await {
                Ok(said) if !said.is_empty() => self.say(said),
                Ok(_) => {}
                Err(reason) => shelf::tell(self.page, &reason),
            }
            self.load().await;
        });
    }

    /// Shows the list, with the present project as it is now and what was set aside.
    fn show(self) {
        self.then(async move {
            shelf::keep_present(self.page).await?;
            shelf::take_in(self.page).await?;
            Ok(String::new())
        });
    }

    /// Loads the list; what was set aside is there without the database too.
    async fn load(self) {
        let states = shelf::states().await.unwrap_or_default();
        if self.page.view.projects.try_get_untracked() != Some(true) {
            return;
        }
        let aside: Vec<ShelfState> = set_aside::list()
            .into_iter()
            .map(|state| ShelfState {
                id: state.key,
                at: state.at,
                note: t(state.reason.words().1).to_owned(),
                text: state.text,
                ..ShelfState::default()
            })
            .collect();
        self.states.set_value(states.iter().chain(&aside).cloned().collect());
        let shelf = Shelf {
            present: shelf::present(self.page).id,
            states,
            aside,
            steps: self.page.step_texts(),
            dark: dom::is_dark(),
        };
        let show = move |response: Option<Response>| match response {
            Some(Response::Html(html)) => {
                // The list is made anew, with the button that was pressed.
                let (held, unfolded) = (self.held(), self.unfolded());
                let _ = self.html.try_set(html);
                dom::soon(move || {
                    self.find();
                    self.unfold(&unfolded);
                    self.hold(held);
                });
            }
            _ => self.page.notices.notify("fail", t("page.no-answer").to_owned()),
        };
        self.page.project.with_untracked(|project| self.worker.ask(project, Request::Shelf(shelf), show));
    }

    /// The groups of the list, each with a name that it has again when the list is made anew.
    fn groups(self) -> Vec<(String, Element)> {
        let Some(host) = self.host.try_get_untracked().flatten() else { return Vec::new() };
        let named = |group: Element| {
            let id = group.closest("[data-id]").ok()??.get_attribute("data-id")?;
            Some((id + &group.class_name(), group))
        };
        dom::all(&host, "details").into_iter().filter_map(named).collect()
    }

    /// Names of the groups that are open.
    fn unfolded(self) -> Vec<String> {
        let open = self.groups().into_iter().filter(|(_, group)| group.has_attribute("open"));
        open.map(|(name, _)| name).collect()
    }

    fn unfold(self, names: &[String]) {
        for (name, group) in self.groups() {
            if names.contains(&name) {
                dom::set(&group, "open", "");
            }
        }
    }

    /// State and act of the element of the list that has the focus.
    fn held(self) -> Option<(String, String)> {
        let focus = document().active_element()?;
        let id = focus.closest("[data-id]").ok()??.get_attribute("data-id")?;
        Some((id, focus.get_attribute("data-act").unwrap_or_default()))
    }

    /// Gives the focus back to the element of the list that had it, or to the first of the list where it is gone.
    fn hold(self, held: Option<(String, String)>) {
        let (Some((id, act)), Some(host)) = (held, self.host.try_get_untracked().flatten()) else { return };
        let all = dom::all(&host, "[data-act]");
        let is_held = |element: &&Element| {
            let item = element.closest("[data-id]").ok().flatten().and_then(|item| item.get_attribute("data-id"));
            item.as_ref() == Some(&id) && element.get_attribute("data-act").as_ref() == Some(&act)
        };
        if let Some(element) = all.iter().find(is_held).or(all.first()) {
            let _ = element.unchecked_ref::<HtmlElement>().focus();
        }
    }

    /// Leaves the projects in the list whose words have what is searched.
    fn find(self) {
        let search = self.search.try_get_untracked().unwrap_or_default().to_lowercase();
        let Some(host) = self.host.try_get_untracked().flatten() else { return };
        for item in dom::all(&host, "[data-words]") {
            let words = item.get_attribute("data-words").unwrap_or_default();
            let found = search.split_whitespace().all(|word| words.contains(word));
            let _ = item.class_list().toggle_with_force("gone", !found);
        }
    }

    /// Does what the element of the list is for.
    fn act(self, event: &Event) {
        let Some((act, id)) = asked(event) else { return };
        let present = shelf::present(self.page);
        if act == "rename" {
            return self.rename(&id, &present.id, &event_target_value(event));
        }
        if act == "keep" {
            let field = dom::by_id(NOTE).map(|field| field.unchecked_into::<HtmlInputElement>().value());
            let note = field.unwrap_or_default();
            let kept = t("projects.kept").to_owned();
            return self.then(async move {
                // A version without its project would not be listed.
                shelf::ask("put", &[&shelf::row(&present)]).await?;
                shelf::keep_version(&present.id, note.trim(), present.text).await?;
                Ok(kept)
            });
        }
        if let Some(steps) = act.strip_prefix("go:").and_then(|steps| steps.parse().ok()) {
            self.page.view.projects.set(false);
            return self.page.travel(steps);
        }
        let all = self.states.get_value();
        let state = std::iter::once(&present).chain(&all).find(|state| state.id == id).cloned();
        let Some(state) = state else { return };
        match act.as_str() {
            "open" => self.open(state, &all, present),
            "duplicate" => self.duplicate(&state),
            "compare" => self.compare(state),
            "save" => save(&state),
            "delete" => self.delete(state),
            _ => {}
        }
    }

    /// Opens a project, or a version in place of the last state of its project, which is kept as a version itself.
    fn open(self, state: ShelfState, all: &[ShelfState], present: ShelfState) {
        let Some(project) = Project::from_json(&state.text).project else { return };
        let page = self.page;
        let id = match state.of.is_empty() {
            true if set_aside::is_key(&state.id) => None,
            true => Some(state.id),
            false => Some(state.of),
        };
        let last =
            std::iter::once(&present).chain(all).find(|last| Some(&last.id) == id.as_ref() && last.text != state.text);
        if let Some(last) = last.cloned() {
            spawn_local(async move {
                if let Err(reason) = shelf::keep_version(&last.id, BEFORE_VERSION, last.text).await {
                    shelf::tell(page, &reason);
                }
            });
        }
        page.view.projects.set(false);
        show(page, project.with_id(id));
        page.notices.say(t("page.opened"));
    }

    /// Shows a project or a version beside the present one.
    fn compare(self, state: ShelfState) {
        let name = Project::from_json(&state.text).project.map(|project| project.name).unwrap_or_default();
        let called = if state.of.is_empty() { name } else { [name, crate::ui::words::day(state.at)].join(" ") };
        self.page.view.projects.set(false);
        let name = if called.trim().is_empty() { t("page.untitled").to_owned() } else { called };
        self.page.view.compared.set(Some(Compared::Project(name, state.text)));
    }

    /// Shows a file that a person chose beside the present project.
    fn compare_file(self, file: web_sys::File) {
        spawn_local(async move {
            let name = file.name();
            let text = JsFuture::from(file.text()).await.ok().and_then(|text| text.as_string()).unwrap_or_default();
            match Project::from_json(&text).project {
                Some(_) if !self.page.view.kept.is_disposed() => {
                    self.page.view.projects.set(false);
                    self.page.view.compared.set(Some(Compared::Project(name, text)));
                }
                _ => self.say(say(&msg!("compare.no-project", file = name))),
            }
        });
    }

    /// Puts a copy of a project on the shelf.
    fn duplicate(self, state: &ShelfState) {
        let Some(project) = Project::from_json(&state.text).project else { return };
        let name = if project.name.is_empty() { t("page.untitled") } else { project.name.as_str() };
        let copy = say(&msg!("projects.copy-of", name));
        let state = ShelfState {
            id: dom::fresh_id(),
            at: js_sys::Date::now(),
            text: project.with_name(copy.as_str()).to_json(),
            ..ShelfState::default()
        };
        self.then(async move {
            shelf::ask("put", &[&shelf::row(&state)]).await?;
            Ok(say(&msg!("projects.copied", name = copy)))
        });
    }

    fn rename(self, id: &str, present: &str, typed: &str) {
        let name: String = typed.chars().filter(|c| !c.is_control()).take(120).collect();
        if id == present {
            self.page.edit("name", |project| project.name = name);
            return self.show();
        }
        let Some(state) = self.states.with_value(|all| all.iter().find(|state| state.id == id).cloned()) else {
            return;
        };
        let Some(project) = Project::from_json(&state.text).project else { return };
        let state = ShelfState { text: project.with_name(name).to_json(), ..state };
        self.then(async move { shelf::ask("put", &[&shelf::row(&state)]).await.map(|_| String::new()) });
    }

    /// Deletes a project with its versions, or a version, until the next deletion or the end of the page to be undone.
    fn delete(self, state: ShelfState) {
        let name = Project::from_json(&state.text).project.map(|project| project.name).filter(|name| !name.is_empty());
        let name = name.unwrap_or_else(|| t("page.untitled").to_owned());
        let said = if state.of.is_empty() { msg!("projects.deleted", name) } else { msg!("projects.version-deleted") };
        spawn_local(async move {
            let gone = if set_aside::is_key(&state.id) {
                dom::forget(&state.id);
                Ok(Deleted::Aside(state.id, state.text))
            } else {
                shelf::ask("remove", &[&state.id.into()]).await.map(Deleted::Rows)
            };
            match gone {
                Ok(gone) => {
                    self.say(say(&said));
                    let _ = self.deleted.try_set(Some(gone));
                }
                Err(reason) => shelf::tell(self.page, &reason),
            }
            self.load().await;
        });
    }

    /// Brings back what was deleted last.
    fn restore(self) {
        let Some(gone) = self.deleted.get_untracked() else { return };
        self.then(async move {
            match gone {
                Deleted::Rows(rows) => drop(shelf::ask("restore", &[&rows]).await?),
                Deleted::Aside(key, text) => drop(dom::store(&key, &text)),
            }
            Ok(t("projects.restored").to_owned())
        });
    }

    /// Saves all projects with their versions as one archive.
    fn pack(self) {
        self.then(async move {
            shelf::keep_present(self.page).await?;
            let bytes = shelf::ask("pack", &[]).await?.unchecked_into::<js_sys::Uint8Array>();
            dom::download(ARCHIVE, "application/zip", &bytes.to_vec());
            Ok(String::new())
        });
    }

    /// Adds the projects of such an archive, all of them or none.
    fn unpack(self, file: web_sys::File) {
        let name = file.name();
        self.then(async move {
            let added = async {
                let buffer = JsFuture::from(file.array_buffer()).await.map_err(|error| dom::told(&error))?;
                shelf::ask("unpack", &[&js_sys::Uint8Array::new(&buffer)]).await
            };
            match added.await {
                Ok(count) => Ok(say(&msg!("projects.unpacked", count = count.as_f64().unwrap_or_default()))),
                Err(reason) => {
                    // The list itself is as it was, and is kept.
                    if !self.page.view.kept.is_disposed() {
                        let told = say(&msg!("projects.not-unpacked", file = name, reason));
                        self.page.notices.notify("fail", told);
                    }
                    Ok(String::new())
                }
            }
        });
    }
}

/// Saves a state as a file; one that does not read as it is.
fn save(state: &ShelfState) {
    let name = Project::from_json(&state.text).project.map(|project| project.file_name("json"));
    dom::download(name.as_deref().unwrap_or(set_aside::FILE), "text/plain", state.text.as_bytes());
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::super::set_aside::Reason;
    use super::super::store;
    use super::*;
    use crate::machines::form::Value;
    use crate::ui::testing::{Bench, mount, project, until};
    use crate::ui::worker::shelf as worker;

    fn state(id: &str, of: &str, name: &str) -> ShelfState {
        let text = project().with_name(name).to_json();
        ShelfState { id: id.to_owned(), of: of.to_owned(), at: 1.0, text, ..ShelfState::default() }
    }

    /// The open dialog, with two projects besides the present one, and a version of the first.
    async fn dialog() -> Bench {
        shelf::pretend::empty();
        for state in [state("p2", "", "Order 2"), state("p3", "", "Order 3"), state("v2", "p2", "Order 2 before")] {
            shelf::pretend::put(state).await;
        }
        opened().await
    }

    async fn opened() -> Bench {
        let bench = mount(|| {
            Client::here().answer_here(|project, request| match request {
                Request::Shelf(shelf) => Some(Response::Html(worker::list(project, &shelf))),
                _ => None,
            });
            view! { <ProjectsButton /> <ProjectsDialog /> }
        })
        .await;
        bench.press("#projects").await;
        listed(&bench).await;
        bench
    }

    async fn listed(bench: &Bench) {
        let list = bench.find(".projects");
        until(move || list.children().length() > 0).await;
    }

    /// Presses a button of a state.
    async fn press(bench: &Bench, id: &str, act: &str) {
        bench.press(&format!("[data-id={id}] [data-act={act}]")).await;
    }

    /// Names of the listed projects, the present one first.
    fn names(bench: &Bench) -> Vec<String> {
        let name = |field: Element| field.unchecked_into::<HtmlInputElement>().value();
        bench.all("[data-act=rename]").into_iter().map(name).collect()
    }

    fn name(bench: &Bench) -> String {
        bench.page.project.with_untracked(|project| project.name.clone())
    }

    async fn until_names(bench: &Bench, expected: &[&str]) {
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
        press(&bench, "p2", "open").await;
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
        press(&bench, "v2", "open").await;
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
        assert_eq!(bench.all(".projects > li:not(.gone)").len(), 1);
        assert!(bench.has("[data-id=p3]:not(.gone)"));
        bench.type_into(".shelf .tools input", "").await;
        assert_eq!(bench.all(".projects > li:not(.gone)").len(), 3);
    }

    #[wasm_bindgen_test]
    async fn duplicate_renames_and_deletes_are_listed() {
        let bench = dialog().await;
        press(&bench, "p2", "duplicate").await;
        let copy = say(&msg!("projects.copy-of", name = "Order 2"));
        until_names(&bench, &["", &copy, "Order 2", "Order 3"]).await;
        bench.choose("[data-id=p3] [data-act=rename]", "Order 33").await;
        until_names(&bench, &["", &copy, "Order 2", "Order 33"]).await;
        press(&bench, "p2", "delete").await;
        until_names(&bench, &["", &copy, "Order 33"]).await;
        assert!(shelf::states().await.unwrap().iter().all(|state| state.of != "p2"), "its version is left");
        bench.press(".said button").await;
        until_names(&bench, &["", &copy, "Order 2", "Order 33"]).await;
        assert!(shelf::states().await.unwrap().iter().any(|state| state.of == "p2"));
    }

    #[wasm_bindgen_test]
    async fn present_project_is_renamed_in_the_form_and_by_undo() {
        let bench = dialog().await;
        bench.choose(".present [data-act=rename]", "Order 1").await;
        assert_eq!(name(&bench), "Order 1");
        bench.page.undo();
        assert_eq!(name(&bench), "");
    }

    #[wasm_bindgen_test]
    async fn version_of_the_present_project_is_kept_with_its_note() {
        let bench = dialog().await;
        bench.type_into("#version-note", "as offered").await;
        press_keep(&bench).await;
        assert!(bench.text(".present .versions").contains("as offered"));
        assert_eq!(bench.text(".said"), t("projects.kept").to_owned() + " " + t("page.undo"));
    }

    async fn press_keep(bench: &Bench) {
        bench.press("[data-act=keep]").await;
        let list = bench.find(".projects");
        until(move || list.query_selector(".present .versions li").unwrap().is_some()).await;
    }

    #[wasm_bindgen_test]
    async fn pressed_step_is_gone_to_and_listed_as_undone() {
        shelf::pretend::empty();
        let bench = opened().await;
        bench.page.set("pitch", Value::Number(9.0));
        bench.page.set("heads", Value::Number(7.0));
        for (act, pitch) in [("go:-2", 8.0), ("go:1", 9.0)] {
            bench.page.view.projects.set(false);
            crate::ui::testing::settled().await;
            bench.press("#projects").await;
            let list = bench.find(".projects");
            let there = format!("[data-act='{act}']");
            until(move || list.query_selector(&there).unwrap().is_some()).await;
            bench.press(&format!("[data-act='{act}']")).await;
            assert_eq!(bench.setting("pitch"), Some(Value::Number(pitch)));
            assert!(!bench.has("dialog[open]"));
        }
    }

    #[wasm_bindgen_test]
    async fn refused_list_says_so_and_shows_what_was_set_aside() {
        shelf::pretend::empty();
        shelf::pretend::refuse("SecurityError");
        drop(mount(|| ()).await);
        let bench = opened().await;
        set_aside::keep_project(&project().with_name("Order 7"), Reason::Replaced);
        set_aside::keep("{ not a project", Reason::Unread, None);
        bench.page.view.projects.set(false);
        crate::ui::testing::settled().await;
        bench.press("#projects").await;
        let list = bench.find(".projects");
        until(move || list.children().length() == 3).await;
        assert!(bench.notices().contains(&say(&msg!("projects.refused", reason = t("projects.denied")))));
        let text = bench.text(".projects");
        assert!(
            text.contains("Order 7") && text.contains(t("page.aside-opened")) && text.contains(t("page.aside-unread"))
        );
        bench.press("li:nth-child(3) [data-act=delete]").await;
        until(|| set_aside::list().len() == 1).await;
        bench.press(".said button").await;
        until(|| set_aside::list().len() == 2).await;
    }

    #[wasm_bindgen_test]
    async fn row_of_a_newer_page_is_listed_and_left_alone() {
        shelf::pretend::empty();
        shelf::pretend::put(state("p9", "", "Order 9")).await;
        let rows = shelf::states().await.unwrap();
        let newer = ShelfState { version: 2.0, ..rows[0].clone() };
        shelf::ask("restore", &[&js_sys::Array::of1(&shelf::row(&newer))]).await.unwrap();
        let bench = opened().await;
        assert!(bench.text("[data-id=p9]").contains(t("projects.newer")));
        assert!(!bench.has("[data-id=p9] [data-act=open]"));
    }
}
