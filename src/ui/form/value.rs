//! The value of a field in the project, and its text.

use leptos::prelude::*;

use crate::machines::form::{FieldInfo, KindInfo, Value};
use crate::text::catalog::number_text;
use crate::ui::state::Page;

/// A value as its field shows it.
pub(super) fn shown(info: &FieldInfo, value: &Value) -> String {
    match (value, &info.kind) {
        (Value::Number(number), KindInfo::Number { decimals, .. }) => number_text(*number, (*decimals).max(6)),
        (Value::Number(number), _) => number_text(*number, 6),
        (Value::Flag(flag), _) => flag.to_string(),
        (Value::Text(text), _) => text.clone(),
    }
}

/// The field's value in the project.
pub(super) fn value_of(page: Page, info: &FieldInfo) -> Value {
    page.project.with(|project| project.values.get(info.id).cloned().unwrap_or_else(|| info.default()))
}
