//! Other states of a [`Page`]: those before and after it in the history, and other projects in its place.

use leptos::prelude::*;

use super::super::history::History;
use super::Page;
use crate::project::Project;
use crate::ui::dom;

impl Page {
    /// Changes the machine: to its last project on this page, or a fresh one. Undo brings the present one back.
    pub(crate) fn change_machine(self, id: &'static str) {
        let present = self.project.get_untracked();
        let left = self.left.try_update_value(|left| {
            left.retain(|project| project.machine.id() != present.machine.id());
            left.push(present);
            left.iter().find(|project| project.machine.id() == id).cloned()
        });
        if let Some(project) = left.flatten().or_else(|| Project::of(id, None)) {
            self.replace(project);
        }
    }

    /// Takes another project in place of this one, and shows it from its start; undo brings this one back. A project without an id is a new
    /// one.
    pub(crate) fn replace(self, mut project: Project) {
        project.id.get_or_insert_with(dom::fresh_id);
        self.entries.invalid.set(Vec::new());
        self.player.zoom.set(None);
        self.player.seek(0.0);
        self.edit(|present| *present = project);
        self.entries.show_again();
    }

    /// Shows the project of another tab; this tab has no steps of its own then.
    pub(crate) fn watch(self, project: Project) {
        let before = self.project.get_untracked();
        self.entries.invalid.set(Vec::new());
        self.history.set_value(History::default());
        self.follow(&before, project);
        self.entries.show_again();
    }

    /// The steps of undo and redo as a text for the browser's store.
    pub(crate) fn steps(self) -> String {
        self.history.with_value(History::to_json)
    }

    /// Takes the steps of the last visit.
    pub(crate) fn take_steps(self, history: History) {
        self.undoable.set(history.undoable());
        self.history.set_value(history);
    }

    /// All steps as project files: before the present project, the oldest first, and after it, the next one last.
    pub(crate) fn step_texts(self) -> [Vec<String>; 2] {
        self.history.with_value(History::texts)
    }

    /// Goes back one step.
    pub(crate) fn undo(self) {
        self.travel(-1);
    }

    /// Goes forth one step again.
    pub(crate) fn redo(self) {
        self.travel(1);
    }

    /// Goes `steps` steps forth in the history, or back if negative, as far as there are any.
    pub(crate) fn travel(self, steps: i32) {
        let step = if steps < 0 { History::back } else { History::forth };
        let before = self.project.get_untracked();
        let mut after = None;
        self.history.update_value(|history| {
            for _ in 0..steps.unsigned_abs() {
                let present = after.clone().unwrap_or_else(|| before.clone());
                let Some(next) = step(history, present) else { break };
                after = Some(next);
            }
        });
        if let Some(after) = after {
            self.entries.invalid.set(Vec::new());
            self.follow(&before, after);
            self.mark_changes(&before, None);
            self.entries.show_again();
        }
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::super::super::history::Undoable;
    use super::*;
    use crate::machines::form::Value;
    use crate::ui::testing::mount;

    fn number(page: Page, id: &str) -> Value {
        page.project.with_untracked(|project| project.values[id].clone())
    }

    #[wasm_bindgen_test]
    async fn undo_and_redo_travel_between_values() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        page.set("pitch", Value::Number(9.0));
        assert_eq!(page.undoable.get_untracked(), Undoable { undo: true, redo: false });
        page.undo();
        assert_eq!(
            (number(page, "pitch"), page.undoable.get_untracked()),
            (Value::Number(8.0), Undoable { undo: false, redo: true })
        );
        page.redo();
        assert_eq!(number(page, "pitch"), Value::Number(9.0));
    }

    #[wasm_bindgen_test]
    async fn several_steps_are_taken_at_once() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        [("pitch", 9.0), ("heads", 7.0), ("pitch", 10.0)]
            .into_iter()
            .for_each(|(id, value)| page.set(id, Value::Number(value)));
        page.travel(-2);
        assert_eq!(
            (number(page, "pitch"), page.undoable.get_untracked()),
            (Value::Number(9.0), Undoable { undo: true, redo: true })
        );
        assert_eq!(page.step_texts().map(|steps| steps.len()), [1, 2]);
        page.travel(9);
        assert_eq!(
            (number(page, "pitch"), page.undoable.get_untracked()),
            (Value::Number(10.0), Undoable { undo: true, redo: false })
        );
    }

    #[wasm_bindgen_test]
    async fn machine_comes_back_as_it_was_left() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        let (first, second) = (crate::machines::ALL[0].id(), crate::machines::ALL[1].id());
        page.set("pitch", Value::Number(9.0));
        page.change_machine(second);
        assert_eq!(page.machine.get_untracked(), second);
        page.change_machine(first);
        assert_eq!(number(page, "pitch"), Value::Number(9.0));
    }
}
