//! The value of a field in the project.

use leptos::prelude::*;

use crate::machines::form::{FieldInfo, Value};
use crate::ui::state::Page;

/// The field's value in the project.
pub(super) fn value_of(page: Page, info: &FieldInfo) -> Value {
    page.project.with(|project| project.values.get(info.id).cloned().unwrap_or_else(|| info.default()))
}
