//! Value and origin of a field in the project.

use leptos::prelude::*;

use crate::machines::form::{FieldInfo, Provenance, Value};
use crate::ui::state::Page;

/// The field's value in the project, followed in effects and memos.
pub(super) fn value_of(page: Page, info: &FieldInfo) -> Value {
    page.field_changes.track(info.id);
    page.project.with_untracked(|project| project.values.get(info.id).cloned().unwrap_or_else(|| info.default()))
}

/// The origin of a field's value, followed in effects and memos.
pub(super) fn origin_of(page: Page, id: &'static str) -> Provenance {
    page.field_changes.track(id);
    page.project.with_untracked(|project| project.provenance.get(id).copied().unwrap_or_default())
}
