//! Changes of a project field by field: an edit reruns only effects and memos that follow the changed fields.

use std::collections::BTreeMap;

use leptos::prelude::*;

use crate::project::Project;

/// A trigger for each field of the form that an effect or memo follows. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct FieldChanges(StoredValue<BTreeMap<&'static str, ArcTrigger>>);

impl FieldChanges {
    pub(super) fn new() -> FieldChanges {
        FieldChanges(StoredValue::new(BTreeMap::new()))
    }

    /// Reruns the present effect or memo when value or origin of this field changes.
    pub(crate) fn track(self, id: &'static str) {
        let trigger = self.0.try_update_value(|all| all.entry(id).or_default().clone());
        if let Some(trigger) = trigger {
            trigger.track();
        }
    }

    /// Reruns effects and memos that follow a field that differs between two projects; for different machines, every field.
    pub(super) fn notify(self, before: &Project, after: &Project) {
        let differs = |id: &str| {
            before.machine.id() != after.machine.id()
                || before.values.get(id) != after.values.get(id)
                || before.provenance.get(id) != after.provenance.get(id)
        };
        let changed: Vec<ArcTrigger> = self.0.with_value(|all| {
            let changed = all.iter().filter(|(id, _)| differs(id));
            changed.map(|(_, trigger)| trigger.clone()).collect()
        });
        changed.iter().for_each(Notify::notify);
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::rc::Rc;

    use wasm_bindgen_test::wasm_bindgen_test;

    use crate::machines::form::{Provenance, Value};
    use crate::ui::testing::{mount, settled};

    use super::*;

    #[wasm_bindgen_test]
    async fn only_the_changed_field_is_shown_anew() {
        let runs: [Rc<Cell<u32>>; 2] = core::array::from_fn(|_| Rc::default());
        let counted = runs.clone();
        let bench = mount(move || {
            let page = crate::ui::state::Page::here();
            for (id, count) in ["pitch", "heads"].into_iter().zip(counted) {
                Effect::new(move |_| {
                    page.field_changes.track(id);
                    count.set(count.get() + 1);
                });
            }
        })
        .await;
        let counts = || runs.each_ref().map(|count| count.get());
        assert_eq!(counts(), [1, 1]);
        bench.page.set("pitch", Value::Number(9.0));
        settled().await;
        assert_eq!(counts(), [2, 1]);
        bench.page.set_provenance("heads", Provenance::Measured);
        settled().await;
        assert_eq!(counts(), [2, 2]);
        bench.page.undo();
        bench.page.undo();
        settled().await;
        assert_eq!(counts(), [3, 3]);
        bench.page.change_machine(crate::machines::ALL[1].id());
        settled().await;
        assert_eq!(counts(), [4, 4]);
    }
}
