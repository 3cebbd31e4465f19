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
