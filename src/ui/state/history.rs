//! The steps of a project for undo and redo.

use crate::project::Project;

/// Steps that are kept.
const STEPS: usize = 100;

/// Milliseconds within which changes of one field are one step.
const ONE_STEP: f64 = 1000.0;

/// Projects before and after the present one.
#[derive(Default)]
pub(crate) struct History {
    past: Vec<Project>,
    future: Vec<Project>,
    key: String,
    at: f64,
}

impl History {
    /// Notes a change at `now` milliseconds. Changes with the same key, if they have one, that follow at once are one step.
    pub(crate) fn note(&mut self, before: &Project, key: &str, now: f64) {
        if key.is_empty() || self.key != key || now - self.at > ONE_STEP {
            self.past.push(before.clone());
            if self.past.len() > STEPS {
                self.past.remove(0);
            }
        }
        key.clone_into(&mut self.key);
        self.at = now;
        self.future.clear();
    }

    /// The project before this one.
    pub(crate) fn back(&mut self, present: Project) -> Option<Project> {
        self.key.clear();
        let back = self.past.pop()?;
        self.future.push(present);
        Some(back)
    }

    /// The project after this one, where a step was taken back.
    pub(crate) fn forth(&mut self, present: Project) -> Option<Project> {
        self.key.clear();
        let forth = self.future.pop()?;
        self.past.push(present);
        Some(forth)
    }

    /// Whether there is a step back and a step forth.
    pub(crate) fn can(&self) -> (bool, bool) {
        (!self.past.is_empty(), !self.future.is_empty())
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::project;

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
        (0..130).for_each(|at| history.note(&named(&at.to_string()), "", f64::from(at)));
        assert_eq!(history.back(project()).unwrap().name, "129");
        assert_eq!(steps_back(&mut history), 99);
    }

    #[wasm_bindgen_test]
    fn changes_of_a_field_within_a_second_are_one_step() {
        let mut history = History::default();
        [0.0, 900.0, 1800.0].into_iter().for_each(|now| history.note(&named(&now.to_string()), "pitch", now));
        assert_eq!(history.back(project()).unwrap().name, "0");
        assert_eq!(history.can(), (false, true));
    }

    #[wasm_bindgen_test]
    fn change_after_more_than_a_second_is_another_step() {
        let mut history = History::default();
        [0.0, 1001.0].into_iter().for_each(|now| history.note(&project(), "pitch", now));
        assert_eq!(steps_back(&mut history), 2);
    }

    #[wasm_bindgen_test]
    fn change_of_another_field_is_another_step() {
        let mut history = History::default();
        ["pitch", "heads", "pitch"].into_iter().for_each(|key| history.note(&project(), key, 0.0));
        assert_eq!(steps_back(&mut history), 3);
    }

    #[wasm_bindgen_test]
    fn change_after_undo_removes_the_steps_forth() {
        let mut history = History::default();
        history.note(&named("first"), "", 0.0);
        assert_eq!(history.back(named("second")).unwrap().name, "first");
        history.note(&named("first"), "", 1.0);
        assert_eq!(history.can(), (true, false));
        assert!(history.forth(project()).is_none());
    }
}
