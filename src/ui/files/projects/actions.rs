//! Actions on the projects in this browser, and the list of projects after them.

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};

use super::super::open::show;
use super::super::{set_aside, shelf};
use crate::msg;
use crate::project::Project;
use crate::project::name::clean_name;
use crate::ui::dom;
use crate::ui::state::view::Compared;
use crate::ui::state::{EditKey, Page};
use crate::ui::words::{Tone, has_all_words, sentence, shown_name, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{BEFORE_VERSION, ListProjects, ListedProject, Shelf, ShelfState};

/// Name of the archive of all projects.
const ARCHIVE: &str = "macroline-projects.zip";

/// The last deletion, which the undo button brings back.
#[derive(Clone)]
enum Deleted {
    /// Rows of the database.
    Rows(JsValue),
    /// Key and text of a state that was set aside.
    Aside(String, String),
}

/// The list of projects and the actions on it. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(super) struct ProjectActions {
    page: Page,
    worker: Client,
    /// The list, the present project first.
    listed: RwSignal<Vec<ListedProject>>,
    /// The states that the list shows: everything on the shelf, and the states that were set aside.
    states: StoredValue<Vec<ShelfState>>,
    /// Sentence about the last action.
    pub announcement: RwSignal<String>,
    deleted: RwSignal<Option<Deleted>, LocalStorage>,
    /// The button that undoes the last deletion.
    pub restore_button: NodeRef<html::Button>,
}

impl ProjectActions {
    /// The list of the page around, empty until it is [shown](ProjectActions::show).
    pub(super) fn new() -> ProjectActions {
        ProjectActions {
            page: Page::here(),
            worker: Client::here(),
            listed: RwSignal::new(Vec::new()),
            states: StoredValue::new(Vec::new()),
            announcement: RwSignal::new(String::new()),
            deleted: RwSignal::new_local(None),
            restore_button: NodeRef::new(),
        }
    }

    /// Ids of the listed projects whose name, machine and control have all words of a search.
    pub(super) fn found(self, search: &str) -> Vec<String> {
        let has_all = |item: &&ListedProject| has_all_words(&[item.name.as_str(), &item.kind].join(" "), search);
        self.listed.with(|listed| listed.iter().filter(has_all).map(|item| item.id.clone()).collect())
    }

    /// The listed project of an id; an empty one once it is gone.
    pub(super) fn item(self, id: &str) -> ListedProject {
        self.listed.with(|listed| listed.iter().find(|item| item.id == id).cloned().unwrap_or_default())
    }

    /// Whether the last deletion can be undone.
    pub(super) fn can_restore(self) -> bool {
        self.deleted.with(Option::is_some)
    }

    fn announce(self, text: impl Into<String>) {
        let _ = self.announcement.try_set(text.into());
        let _ = self.deleted.try_set(None);
    }

    /// Runs work on the database, then lists the projects again.
    fn then(self, work: impl Future<Output = Result<String, String>> + 'static) {
        spawn_local(async move {
            match work.await {
                Ok(notice) if !notice.is_empty() => self.announce(notice),
                Ok(_) => {}
                Err(reason) => self.refused(&reason),
            }
            self.load().await;
        });
    }

    /// Reports that the browser refuses work on the list, also in the dialog, because the dialog covers the notice.
    fn refused(self, reason: &str) {
        self.announce(sentence(&msg!("projects.refused", reason)));
        shelf::warn_refused(self.page, reason);
    }

    /// Shows the list, with the present project as it is now and the states that were set aside.
    pub(super) fn show(self) {
        self.announce("");
        self.then(async move {
            shelf::keep_present(self.page).await?;
            shelf::take_in(self.page).await?;
            Ok(String::new())
        });
    }

    /// Loads the list; states that were set aside are listed without the database too.
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
            theme: dom::theme(),
        };
        let show = move |listed| match listed {
            Some(listed) => drop(self.listed.try_set(listed)),
            None => self.page.notices.notify(Tone::Fail, t("page.no-answer").to_owned()),
        };
        self.page.project.with_untracked(|project| self.worker.ask(project, ListProjects(shelf), show));
    }

    /// The state of an id; of the present project as it is now.
    fn state(self, id: &str) -> Option<ShelfState> {
        let present = shelf::present(self.page);
        if present.id == id {
            return Some(present);
        }
        self.states.with_value(|states| states.iter().find(|state| state.id == id).cloned())
    }

    /// A callback that calls `act` with the state of an id.
    pub(super) fn with_state(self, id: StoredValue<String>, act: fn(ProjectActions, ShelfState)) -> Callback<()> {
        Callback::new(move |()| {
            if let Some(state) = id.with_value(|id| self.state(id)) {
                act(self, state);
            }
        })
    }

    /// Keeps a version of the present project; `kept` acts once it is.
    pub(super) fn keep(self, note: &str, kept: impl FnOnce() + 'static) {
        let present = shelf::present(self.page);
        let note = note.trim().to_owned();
        self.then(async move {
            // A version without its project would not be listed.
            shelf::ask("put", &[&shelf::row(&present)]).await?;
            shelf::keep_version(&present.id, &note, present.text).await?;
            kept();
            Ok(t("projects.kept").to_owned())
        });
    }

    /// Undoes steps (`steps` below 0), or does them again.
    pub(super) fn travel(self, steps: i32) {
        self.page.view.projects.set(false);
        self.page.travel(steps);
    }

    /// Opens a project, or a version in place of the last state of its project, which is kept as a version itself.
    pub(super) fn open(self, state: ShelfState) {
        let Some(project) = Project::from_json(&state.text).project else { return };
        let page = self.page;
        let id = match state.of.is_empty() {
            true if set_aside::is_key(&state.id) => None,
            true => Some(state.id),
            false => Some(state.of),
        };
        let last = id.as_deref().and_then(|id| self.state(id)).filter(|last| last.text != state.text);
        if let Some(last) = last {
            spawn_local(async move {
                if let Err(reason) = shelf::keep_version(&last.id, BEFORE_VERSION, last.text).await {
                    shelf::warn_refused(page, &reason);
                }
            });
        }
        page.view.projects.set(false);
        show(page, project.with_id(id));
        page.notices.announce(t("page.opened"));
    }

    /// Shows a project or a version beside the present one.
    pub(super) fn compare(self, state: ShelfState) {
        let name = Project::from_json(&state.text).project.map(|project| project.name).unwrap_or_default();
        let called = if state.of.is_empty() { name } else { [name, crate::ui::words::day(state.at)].join(" ") };
        self.page.view.projects.set(false);
        let name = shown_name(&called).to_owned();
        self.page.view.compared.set(Some(Compared::Project(name, state.text)));
    }

    /// Shows a file that a person chose beside the present project.
    pub(super) fn compare_file(self, file: web_sys::File) {
        spawn_local(async move {
            let name = file.name();
            let text = JsFuture::from(file.text()).await.ok().and_then(|text| text.as_string()).unwrap_or_default();
            match Project::from_json(&text).project {
                Some(_) if !self.page.is_gone() => {
                    self.page.view.projects.set(false);
                    self.page.view.compared.set(Some(Compared::Project(name, text)));
                }
                _ => self.announce(sentence(&msg!("compare.no-project", file = name))),
            }
        });
    }

    /// Puts a copy of a project on the shelf.
    pub(super) fn duplicate(self, state: ShelfState) {
        let Some(project) = Project::from_json(&state.text).project else { return };
        let name = shown_name(&project.name);
        let copy = sentence(&msg!("projects.copy-of", name));
        let state = ShelfState {
            id: dom::fresh_id(),
            at: js_sys::Date::now(),
            text: project.with_name(copy.as_str()).to_json(),
            ..ShelfState::default()
        };
        self.then(async move {
            shelf::ask("put", &[&shelf::row(&state)]).await?;
            Ok(sentence(&msg!("projects.copied", name = copy)))
        });
    }

    /// Gives a project another name.
    pub(super) fn rename(self, id: &str, typed: &str) {
        let Some(state) = self.state(id) else { return };
        let name = clean_name(typed);
        if self.page.project.with_untracked(|present| present.id.as_ref() == Some(&state.id)) {
            self.page.edit_merged(EditKey::Name, |project| project.name = name);
            return self.show();
        }
        let Some(project) = Project::from_json(&state.text).project else { return };
        let state = ShelfState { text: project.with_name(name).to_json(), ..state };
        self.then(async move { shelf::ask("put", &[&shelf::row(&state)]).await.map(|_| String::new()) });
    }

    /// Deletes a project with its versions, or a version; can be undone until the next deletion or the end of the page.
    pub(super) fn delete(self, state: ShelfState) {
        let name = Project::from_json(&state.text).project.map(|project| project.name).unwrap_or_default();
        let name = shown_name(&name).to_owned();
        let message =
            if state.of.is_empty() { msg!("projects.deleted", name) } else { msg!("projects.version-deleted") };
        spawn_local(async move {
            let gone = if set_aside::is_key(&state.id) {
                dom::forget(&state.id);
                Ok(Deleted::Aside(state.id, state.text))
            } else {
                shelf::ask("remove", &[&state.id.into()]).await.map(Deleted::Rows)
            };
            match gone {
                Ok(gone) => {
                    self.announce(sentence(&message));
                    let _ = self.deleted.try_set(Some(gone));
                    // The pressed button disappears with its project.
                    dom::soon(move || self.focus_restore());
                }
                Err(reason) => self.refused(&reason),
            }
            self.load().await;
        });
    }

    /// Undoes the last deletion.
    pub(super) fn restore(self) {
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
    pub(super) fn pack(self) {
        self.then(async move {
            shelf::keep_present(self.page).await?;
            let bytes = shelf::ask("pack", &[]).await?.unchecked_into::<js_sys::Uint8Array>();
            dom::download(ARCHIVE, "application/zip", &bytes.to_vec());
            Ok(String::new())
        });
    }

    /// Adds the projects of such an archive, all of them or none.
    pub(super) fn unpack(self, file: web_sys::File) {
        let name = file.name();
        self.then(async move {
            let added = async {
                let buffer = JsFuture::from(file.array_buffer()).await.map_err(|error| dom::error_text(&error))?;
                shelf::ask("unpack", &[&js_sys::Uint8Array::new(&buffer)]).await
            };
            match added.await {
                Ok(count) => Ok(sentence(&msg!("projects.unpacked", count = count.as_f64().unwrap_or_default()))),
                Err(reason) => {
                    // The list itself is unchanged, and stays.
                    if !self.page.is_gone() {
                        let text = sentence(&msg!("projects.not-unpacked", file = name, reason));
                        self.page.notices.notify(Tone::Fail, text);
                    }
                    Ok(String::new())
                }
            }
        });
    }

    /// Saves a state as a file; an unreadable one byte for byte.
    pub(super) fn save(self, state: ShelfState) {
        let name = Project::from_json(&state.text).project.map(|project| project.file_name("json"));
        dom::download(name.as_deref().unwrap_or(set_aside::FILE), "text/plain", state.text.as_bytes());
    }

    fn focus_restore(self) {
        if let Some(button) = self.restore_button.try_get_untracked().flatten() {
            let _ = button.focus();
        }
    }
}
