//! What is done with the form of a [`Page`]: entries, their origins, and the results that depend on them.

use leptos::prelude::*;

use super::super::entries::of_field;
use super::super::history::EditKey;
use super::super::put::put;
use super::super::view::Tab;
use super::Page;
use crate::machines::form::{Provenance, Value};
use crate::project::Project;
use crate::project::dependence::fields_by_result;
use crate::text::Diagnostic;
use crate::ui::dom;
use crate::view::FieldEntry;

impl Page {
    /// Sets a field of the form by its own entry.
    pub(crate) fn set(self, id: &'static str, value: Value) {
        self.entries.accept(id);
        self.set_below_text(id, value);
    }

    /// Sets a field whose typed text is no value back to the value before the entry; the text stays as typed.
    pub(crate) fn set_below_text(self, id: &'static str, value: Value) {
        self.edit_in(Some(id), Some(EditKey::Field(id)), |project| {
            project.values.insert(id.to_owned(), value);
        });
    }

    /// Sets a field of the form by another control.
    pub(crate) fn take_value(self, id: &'static str, value: Value) {
        self.entries.accept(id);
        self.edit_merged(EditKey::Field(id), |project| {
            project.values.insert(id.to_owned(), value);
        });
    }

    /// Takes entries of the form in one step, and names them where there are several: the words of a button have room for one.
    pub(crate) fn take_entries(self, entries: &[FieldEntry]) {
        self.edit(|project| {
            if let Some(after) = project.with_entries(entries) {
                *project = after;
            }
        });
        entries.iter().for_each(|entry| self.entries.accept(entry.field));
        self.entries.show_again();
        if entries.len() > 1 {
            let mut fields = self.project.with_untracked(|project| project.machine.fields());
            fields.retain(|field| entries.iter().any(|entry| entry.field == field.id));
            self.notices.confirm(self.in_words(&fields));
        }
    }

    /// Notes where the value of a field comes from.
    pub(crate) fn set_provenance(self, id: &'static str, from: Provenance) {
        self.edit_merged(EditKey::Origin(id), |project| {
            if from == Provenance::default() {
                project.provenance.remove(id);
            } else {
                project.provenance.insert(id.to_owned(), from);
            }
        });
    }

    /// Invalid fields: entries that are not values, and values that the machine or its control cannot have.
    pub(crate) fn wrong_fields(self) -> Vec<Diagnostic> {
        let mut found = self.entries.invalid.get();
        self.results.errors.with(|errors| {
            for error in errors {
                if error.field.is_none_or(|field| of_field(&found, field).is_none()) {
                    found.push(error.clone());
                }
            }
        });
        found
    }

    /// Whether an invalid entry makes the results outdated. A value that the machine cannot have still has results of its own.
    pub(crate) fn is_stale(self) -> bool {
        self.entries.invalid.with(|invalid| !invalid.is_empty())
    }

    /// Focuses the next wrong field after the focused one, else the first.
    pub(crate) fn show_wrong_field(self) {
        let fields: Vec<_> = untrack(|| self.wrong_fields()).iter().filter_map(|found| found.field).collect();
        let here = document().active_element().map(|element| element.id()).unwrap_or_default();
        let next = fields.iter().position(|field| *field == here).map_or(0, |at| at + 1);
        if let Some(field) = fields.get(next).or(fields.first()) {
            dom::go_to_field(field);
        }
    }

    /// Shows the fields and parts that a result depends on; of no result, shows none.
    pub(crate) fn show_causes(self, result: Option<&'static str>) {
        let causes = result.and_then(|id| {
            let present = self.project.get_untracked();
            self.dependence.try_update_value(|known| {
                let same = |of: &Project| {
                    of.values == present.values
                        && of.control.id == present.control.id
                        && of.switches == present.switches
                };
                if !known.as_ref().is_some_and(|(of, _)| of.machine.id() == present.machine.id() && same(of)) {
                    let found = fields_by_result(&present);
                    *known = Some((present, found));
                }
                known.as_ref()?.1.get(id).cloned()
            })?
        });
        put(self.view.causes, causes.unwrap_or_default());
    }

    /// Shows a result among all results.
    pub(crate) fn show_result(self, id: &'static str) {
        self.view.tab.set(Tab::Results);
        dom::soon(move || {
            if let Some(row) = dom::by_id(&format!("result-{id}")) {
                row.scroll_into_view();
                let _ = row.focus();
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::super::super::history::Undoable;
    use super::*;
    use crate::ui::testing::mount;

    fn number(page: Page, id: &str) -> Value {
        page.project.with_untracked(|project| project.values[id].clone())
    }

    #[wasm_bindgen_test]
    async fn setting_the_same_value_is_no_step() {
        let bench = mount(|| ()).await;
        bench.page.set("pitch", Value::Number(8.0));
        assert_eq!(bench.page.undoable.get_untracked(), Undoable { undo: false, redo: false });
    }

    #[wasm_bindgen_test]
    async fn causes_of_a_result_follow_the_project() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        page.show_causes(Some("dots-per-second"));
        assert!(
            page.view.causes.with_untracked(|causes| causes.contains(&"pitch") && !causes.contains(&"loop-capacity"))
        );
        page.show_causes(None);
        assert!(page.view.causes.with_untracked(Vec::is_empty));
        page.change_machine(crate::machines::ALL[1].id());
        page.show_causes(Some("dots-per-second"));
        assert!(page.view.causes.with_untracked(Vec::is_empty));
    }

    #[wasm_bindgen_test]
    async fn advised_entries_are_one_step() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        page.take_entries(&[FieldEntry::new("pitch", "9"), FieldEntry::new("heads", "7")]);
        assert_eq!((number(page, "pitch"), number(page, "heads")), (Value::Number(9.0), Value::Number(7.0)));
        let told = page.notices.list.with_untracked(|list| list.last().map(|notice| notice.text.clone()));
        assert_eq!(told.as_deref(), Some("Changed: Pitch 9 mm; Print heads 7."));
        page.undo();
        assert_eq!((number(page, "pitch"), number(page, "heads")), (Value::Number(8.0), Value::Number(6.0)));
    }

    #[wasm_bindgen_test]
    async fn assumed_origin_is_not_kept() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        page.set_provenance("heads", Provenance::Measured);
        assert_eq!(page.project.with_untracked(|project| project.provenance.len()), 1);
        page.set_provenance("heads", Provenance::Assumed);
        assert!(page.project.with_untracked(|project| project.provenance.is_empty()));
    }
}
