//! The list of projects in words, each with its picture, its versions and steps. States are hostile until checked.

use super::messages::{
    BEFORE_PROGRAM, BEFORE_VERSION, ListedProject, ListedStep, ListedVersion, OTHER_TAB, Shelf, ShelfPlace, ShelfState,
};
use super::pictures;
use crate::project::Project;
use crate::project::changes::changes_in_words;
use crate::project::saved::with_line;
use crate::text::clauses;
use crate::ui::words::{day, t};

/// Version of the states that this page reads.
const VERSION: f64 = 1.0;

/// Greatest number of pictures; the projects kept last have them.
const PICTURES: usize = 40;

/// Notes of versions that the page has kept by itself, with the catalog ids of their sentences.
const NOTES: [(&str, &str); 3] = [
    (BEFORE_PROGRAM, "projects.before-program"),
    (BEFORE_VERSION, "projects.before-version"),
    (OTHER_TAB, "page.aside-other-tab"),
];

/// The present project, the others from the last kept to the first, and the states that were set aside.
pub(in crate::ui) fn list(present: &Project, shelf: &Shelf) -> Vec<ListedProject> {
    let mut kept: Vec<&ShelfState> = shelf.states.iter().filter(|state| state.of.is_empty()).collect();
    kept.sort_by(|a, b| b.at.total_cmp(&a.at).then_with(|| a.id.cmp(&b.id)));
    let now =
        ShelfState { id: shelf.present.clone(), text: present.to_json(), version: VERSION, ..ShelfState::default() };
    let others = kept.into_iter().filter(|state| state.id != now.id).map(|state| (ShelfPlace::Shelf, state));
    let aside = shelf.aside.iter().map(|state| (ShelfPlace::Aside, state));
    let all = std::iter::once((ShelfPlace::Present, &now)).chain(others).chain(aside).enumerate();
    all.map(|(at, (place, state))| listed(present, shelf, (place, state), at < PICTURES)).collect()
}

/// One project.
fn listed(
    present: &Project,
    shelf: &Shelf,
    (place, state): (ShelfPlace, &ShelfState),
    pictured: bool,
) -> ListedProject {
    let when = if place == ShelfPlace::Present { t("projects.present").to_owned() } else { day(state.at) };
    let kept = clauses([when.as_str(), note(state)].into_iter().filter(|part| !part.is_empty()));
    let item = ListedProject { id: state.id.clone(), place, kept, ..ListedProject::default() };
    let project = match read(state) {
        Ok(project) => project,
        Err(reason) => return ListedProject { unread: Some(reason), ..item },
    };
    ListedProject {
        kind: clauses([t(project.machine.name()), project.control.name]),
        picture: if pictured { pictures::before_start(&project, shelf.theme) } else { String::new() },
        versions: if place == ShelfPlace::Aside { Vec::new() } else { versions(&project, shelf, &state.id) },
        steps: if place == ShelfPlace::Present { steps(present, &shelf.steps) } else { Vec::new() },
        name: project.name,
        ..item
    }
}

/// The project of a state, or the reason why it is unreadable.
fn read(state: &ShelfState) -> Result<Project, String> {
    if state.version > VERSION {
        return Err(t("projects.newer").to_owned());
    }
    let loaded = Project::from_json(&state.text);
    let reason = || loaded.diagnostics.first().map(|found| with_line(found, &state.text)).unwrap_or_default();
    loaded.project.clone().ok_or_else(reason)
}

/// The versions of a project, the last kept first, each with the changes since.
fn versions(project: &Project, shelf: &Shelf, id: &str) -> Vec<ListedVersion> {
    let mut kept: Vec<&ShelfState> = shelf.states.iter().filter(|state| state.of == id).collect();
    kept.sort_by(|a, b| b.at.total_cmp(&a.at));
    let version = |state: &ShelfState| {
        let (when, note) = (day(state.at), note(state).to_owned());
        let (name, kept) = if note.is_empty() { (when, note) } else { (note, when) };
        let (changes, unread) = match read(state) {
            Ok(version) => (changes_in_words(&version, project), None),
            Err(reason) => (String::new(), Some(reason)),
        };
        ListedVersion { id: state.id.clone(), name, kept, changes, unread }
    };
    kept.into_iter().map(version).collect()
}

/// The steps of undo and redo of the present project, the last one first.
fn steps(present: &Project, [past, future]: &[Vec<String>; 2]) -> Vec<ListedStep> {
    let project = |text: &String| Project::from_json(text).project;
    let (past, future): (Vec<_>, Vec<_>) =
        (past.iter().filter_map(project).collect(), future.iter().rev().filter_map(project).collect());
    if past.is_empty() && future.is_empty() {
        return Vec::new();
    }
    let states: Vec<&Project> = past.iter().chain([present]).chain(&future).collect();
    let step = |(at, state): (usize, &&Project)| {
        let before = at.checked_sub(1).and_then(|before| states.get(before));
        let changes = before.map_or_else(|| t("projects.began").to_owned(), |before| changes_in_words(before, state));
        ListedStep { steps: at as i32 - past.len() as i32, changes }
    };
    states.iter().enumerate().rev().map(step).collect()
}

/// The note of a state; the page's own are sentences of the catalog.
fn note(state: &ShelfState) -> &str {
    NOTES.iter().find(|(note, _)| *note == state.note).map_or(&state.note, |(_, words)| t(words))
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::project;
    use crate::view::Theme;

    fn state(id: &str, of: &str, at: f64, text: String) -> ShelfState {
        ShelfState { id: id.to_owned(), of: of.to_owned(), at, version: VERSION, note: String::new(), text }
    }

    fn named(name: &str) -> String {
        project().with_name(name).to_json()
    }

    fn list_of(states: Vec<ShelfState>) -> Vec<ListedProject> {
        let steps = [vec![named("Order 7")], vec![named("Order 9"), named("Order 8")]];
        list(&project(), &Shelf { present: "p1".to_owned(), states, aside: Vec::new(), steps, theme: Theme::Light })
    }

    #[wasm_bindgen_test]
    fn present_project_is_first_and_the_last_kept_follows() {
        let list = list_of(vec![
            state("p2", "", 1.0, named("Order 2")),
            state("p1", "", 9.0, named("Before")),
            state("p3", "", 2.0, named("Order 3")),
        ]);
        let names: Vec<_> = list.iter().map(|item| (item.id.as_str(), item.name.as_str())).collect();
        // The shelf's older state of the present project is not listed.
        assert_eq!(names, [("p1", ""), ("p3", "Order 3"), ("p2", "Order 2")]);
        assert!(list.iter().all(|item| item.picture.starts_with("data:image/svg+xml")));
    }

    #[wasm_bindgen_test]
    fn state_that_is_no_project_has_its_reason_and_no_picture() {
        let newer = ShelfState { version: 2.0, ..state("p2", "", 1.0, named("Order 2")) };
        for (broken, reason) in [(state("p2", "", 1.0, "{".to_owned()), "1"), (newer, t("projects.newer"))] {
            let list = list_of(vec![broken]);
            assert!(list[1].unread.as_ref().unwrap().contains(reason), "{:?}", list[1]);
            assert!(list[1].picture.is_empty() && list[1].versions.is_empty());
        }
    }

    #[wasm_bindgen_test]
    fn steps_are_listed_with_their_changes_the_last_first() {
        let list = list_of(Vec::new());
        let steps: Vec<_> = list[0].steps.iter().map(|step| (step.steps, step.changes.as_str())).collect();
        let expected = [(2, "Name Order 9"), (1, "Name Order 8"), (0, t("changes.no-name")), (-1, t("projects.began"))];
        assert_eq!(steps, expected);
    }

    #[wasm_bindgen_test]
    fn version_is_listed_with_the_changes_since() {
        let list = list_of(vec![state("v1", "p1", 1.0, named("Order 7"))]);
        assert_eq!(list[0].versions[0].changes, t("changes.no-name"));
    }
}
