//! The steps of a project for undo and redo.

use std::cell::OnceCell;
use std::mem::Discriminant;

use crate::motion::Action;
use crate::project::Project;
use crate::project::saved::{StepTexts, steps_from_json, steps_to_json};

/// Steps that are kept.
const STEPS: usize = 100;

/// Greatest size (bytes) of the steps in the browser's store, each way: the newest ones.
const STORED: usize = 200_000;

/// A project before or after the present one, and its text once it was needed.
struct Step {
    project: Project,
    text: OnceCell<String>,
}

impl From<Project> for Step {
    fn from(project: Project) -> Step {
        Step { project, text: OnceCell::new() }
    }
}

impl Step {
    fn texts(&self) -> StepTexts<'_> {
        let text = self.text.get_or_init(|| self.project.to_json());
        (self.project.id.as_deref().unwrap_or_default(), text)
    }
}

/// Milliseconds within which changes of one field are one step.
const ONE_STEP: f64 = 1000.0;

/// Changes of one kind; those of the same key that follow at once are one step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EditKey {
    /// Value of this field.
    Field(&'static str),
    /// Origin of this field's value.
    Origin(&'static str),
    /// Setting of this switch of the control.
    Switch(&'static str),
    /// Name of the project.
    Name,
    /// Text of the program.
    Text,
    /// Time of an action of the operator, moved by keys; without the place of the action in the list, which follows from the time.
    ActionTime,
    /// This knob of the operator's panel.
    Knob(Discriminant<Action>),
}

/// Whether undo and redo have something to do.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Undoable {
    pub undo: bool,
    pub redo: bool,
}

/// Projects before and after the present one.
#[derive(Default)]
pub(crate) struct History {
    past: Vec<Step>,
    future: Vec<Step>,
    /// Key of the last change; `None` if the next one is another step in any case.
    key: Option<EditKey>,
    at: f64,
    held: bool,
}

impl History {
    /// Notes a change at `now` milliseconds. Changes with the same key, if they have one, that follow at once are one step.
    pub(crate) fn note(&mut self, before: &Project, key: Option<EditKey>, now: f64) {
        if key.is_none() || self.key != key || !self.held && now - self.at > ONE_STEP {
            self.past.push(before.clone().into());
            if self.past.len() > STEPS {
                self.past.remove(0);
            }
        }
        self.key = key;
        self.at = now;
        self.future.clear();
    }

    /// Keeps the step open while a value is dragged; the end of the drag begins another step.
    pub(crate) fn hold(&mut self, held: bool) {
        self.key = None;
        self.held = held;
    }

    /// The project before this one.
    pub(crate) fn back(&mut self, present: Project) -> Option<Project> {
        self.key = None;
        let back = self.past.pop()?;
        self.future.push(present.into());
        Some(back.project)
    }

    /// The project after this one, if a step was taken back.
    pub(crate) fn forth(&mut self, present: Project) -> Option<Project> {
        self.key = None;
        let forth = self.future.pop()?;
        self.past.push(present.into());
        Some(forth.project)
    }

    /// Whether there is a step back and a step forth.
    pub(crate) fn undoable(&self) -> Undoable {
        Undoable { undo: !self.past.is_empty(), redo: !self.future.is_empty() }
    }

    /// The newest steps as a text for the browser's store.
    pub(crate) fn to_json(&self) -> String {
        steps_to_json(newest(&self.past), newest(&self.future))
    }

    /// All steps as project files: before the present project, the oldest first, and after it, the next one last.
    pub(crate) fn texts(&self) -> [Vec<String>; 2] {
        [&self.past, &self.future].map(|steps| steps.iter().map(|step| step.texts().1.to_owned()).collect())
    }

    /// The steps of a text that [`to_json`](History::to_json) wrote; no steps for any other text.
    pub(crate) fn from_json(text: &str) -> History {
        let (past, future) = steps_from_json(text);
        let steps = |projects: Vec<Project>| projects.into_iter().map(Step::from).collect();
        History { past: steps(past), future: steps(future), ..History::default() }
    }
}

/// The texts of the newest steps that fit the store, the oldest first.
fn newest(steps: &[Step]) -> Vec<StepTexts<'_>> {
    let mut room = STORED;
    let texts = steps.iter().rev().map(Step::texts);
    let mut newest: Vec<StepTexts> = texts
        .map_while(|(id, text)| {
            room = room.checked_sub(text.len())?;
            Some((id, text))
        })
        .collect();
    newest.reverse();
    newest
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::project;

    const PITCH: Option<EditKey> = Some(EditKey::Field("pitch"));

    fn named(name: &str) -> Project {
        let mut project = project();
        project.name = name.to_owned();
        project
    }

    fn steps_back(history: &mut History) -> usize {
        (0..1000).take_while(|_| history.back(project()).is_some()).count()
    }

    #[wasm_bindgen_test]
    fn history_keeps_a_hundred_steps() {
        let mut history = History::default();
        (0..130).for_each(|at| history.note(&named(&at.to_string()), None, f64::from(at)));
        assert_eq!(history.back(project()).unwrap().name, "129");
        assert_eq!(steps_back(&mut history), 99);
    }

    #[wasm_bindgen_test]
    fn changes_of_a_field_within_a_second_are_one_step() {
        let mut history = History::default();
        [0.0, 900.0, 1800.0].into_iter().for_each(|now| history.note(&named(&now.to_string()), PITCH, now));
        assert_eq!(history.back(project()).unwrap().name, "0");
        assert_eq!(history.undoable(), Undoable { undo: false, redo: true });
    }

    #[wasm_bindgen_test]
    fn change_after_more_than_a_second_is_another_step() {
        let mut history = History::default();
        [0.0, 1001.0].into_iter().for_each(|now| history.note(&project(), PITCH, now));
        assert_eq!(steps_back(&mut history), 2);
    }

    #[wasm_bindgen_test]
    fn held_step_takes_changes_of_any_time() {
        let mut history = History::default();
        history.note(&project(), PITCH, 0.0);
        history.hold(true);
        [1.0, 5000.0, 90000.0].into_iter().for_each(|now| history.note(&project(), PITCH, now));
        history.hold(false);
        history.note(&project(), PITCH, 90001.0);
        assert_eq!(steps_back(&mut history), 3);
    }

    #[wasm_bindgen_test]
    fn change_of_another_field_is_another_step() {
        let mut history = History::default();
        [PITCH, Some(EditKey::Field("heads")), PITCH].into_iter().for_each(|key| history.note(&project(), key, 0.0));
        assert_eq!(steps_back(&mut history), 3);
    }

    #[wasm_bindgen_test]
    fn value_and_origin_of_a_field_are_two_steps() {
        let mut history = History::default();
        [PITCH, Some(EditKey::Origin("pitch"))].into_iter().for_each(|key| history.note(&project(), key, 0.0));
        assert_eq!(steps_back(&mut history), 2);
    }

    #[wasm_bindgen_test]
    fn change_after_undo_removes_the_steps_forth() {
        let mut history = History::default();
        history.note(&named("first"), None, 0.0);
        assert_eq!(history.back(named("second")).unwrap().name, "first");
        history.note(&named("first"), None, 1.0);
        assert_eq!(history.undoable(), Undoable { undo: true, redo: false });
        assert!(history.forth(project()).is_none());
    }

    #[wasm_bindgen_test]
    fn steps_are_the_same_after_a_way_through_the_store() {
        let mut history = History::default();
        ["a", "b", "c"].into_iter().for_each(|name| history.note(&named(name), None, 0.0));
        assert_eq!(history.back(named("d")).unwrap().name, "c");
        let mut read = History::from_json(&history.to_json());
        assert_eq!(read.forth(named("c")).unwrap().name, "d");
        let back = |history: &mut History| history.back(project()).unwrap().name;
        assert_eq!([back(&mut read), back(&mut read), back(&mut read)], ["c", "b", "a"]);
    }

    #[wasm_bindgen_test]
    fn stored_steps_keep_the_ids_of_their_projects() {
        let mut history = History::default();
        history.note(&project().with_id(Some("p1".to_owned())), None, 0.0);
        history.note(&named("b"), None, 1.0);
        let mut read = History::from_json(&history.to_json());
        let mut back = || read.back(project()).unwrap().id;
        assert_eq!([back(), back()], [None, Some("p1".to_owned())]);
    }

    #[wasm_bindgen_test]
    fn stored_steps_are_the_newest_that_have_room() {
        let mut history = History::default();
        let mut large = named("large");
        large.edited = Some(crate::nc::Files::one("O1.nc", "X1.\n".repeat(STORED / 8)));
        [&named("old"), &large, &large, &named("new")].into_iter().for_each(|step| history.note(step, None, 0.0));
        let mut read = History::from_json(&history.to_json());
        assert_eq!(steps_back(&mut read), 2);
    }

    #[wasm_bindgen_test]
    fn any_text_is_read_as_steps_or_none() {
        let good = steps_to_json([("a", project().to_json().as_str())], []);
        assert_eq!(History::from_json(&good).undoable(), Undoable { undo: true, redo: false });
        let broken = steps_to_json([("a", project().to_json().as_str()), ("b", "{")], []);
        for text in ["", "[]", "{}", "\u{0}", &good.replace("\"version\":1", "\"version\":9"), &broken] {
            assert_eq!(History::from_json(text).undoable(), Undoable { undo: false, redo: false }, "{text:.60}");
        }
    }
}
