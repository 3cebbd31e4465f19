//! Marks of fields changed by something other than their own input: a button, another control, undo.

use std::time::Duration;

use leptos::prelude::*;

use super::put::put;
use crate::machines::form::{FieldInfo, Value};
use crate::project::Project;
use crate::ui::dom::delayed::Delayed;

/// Time for which a field stays marked.
const MARKED: Duration = Duration::from_secs(6);

/// The marked fields. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct ChangeMarks {
    fields: RwSignal<Vec<&'static str>>,
    end: Delayed,
}

/// Fields with different values in two states of a project; none for two projects or machines.
pub(super) fn changed_fields(before: &Project, after: &Project) -> Vec<FieldInfo> {
    if before.id != after.id || before.machine.id() != after.machine.id() || before.values == after.values {
        return Vec::new();
    }
    let value = |project: &Project, field: &FieldInfo| -> Value {
        project.values.get(field.id).cloned().unwrap_or_else(|| field.default())
    };
    let differs = |field: &FieldInfo| value(before, field) != value(after, field);
    after.machine.fields().into_iter().filter(differs).collect()
}

impl ChangeMarks {
    /// Nothing is marked.
    pub(super) fn new() -> ChangeMarks {
        ChangeMarks { fields: RwSignal::new(Vec::new()), end: Delayed::new() }
    }

    /// Whether a field is marked, followed in effects and memos.
    pub(crate) fn has(self, field: &str) -> bool {
        self.fields.with(|fields| fields.contains(&field))
    }

    /// Marks these fields together with those that still are.
    pub(super) fn mark(self, changed: &[FieldInfo]) {
        self.fields.update(|fields| fields.extend(changed.iter().map(|field| field.id)));
        self.end.call(move || put(self.fields, Vec::new()), MARKED);
    }

    /// Takes the mark of a field away, whose own entry has changed it now.
    pub(super) fn unmark(self, field: &str) {
        if self.fields.with_untracked(|fields| fields.contains(&field)) {
            self.fields.update(|fields| fields.retain(|marked| *marked != field));
        }
    }
}
