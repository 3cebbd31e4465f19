//! Fields of the form that each result depends on, found by changing one field at a time.

use std::collections::BTreeMap;

use super::Project;
use super::sensitivity::changed;
use crate::machines::form::{FieldInfo, FieldKindInfo, Value};
use crate::view::Readout;

/// Ids of the fields by the id of each result that they change, in the order of the form.
///
/// Each field that is shown on the control takes another value: a number 1.1 times its value (0.9 at its limit, one step from 0), a flag
/// the other state, a choice each other option. A field counts if value, limit or verdict of the result differ afterwards.
pub fn fields_by_result(project: &Project) -> BTreeMap<&'static str, Vec<&'static str>> {
    let prepared = project.prepared();
    let before = prepared.results().readouts;
    let mut found: BTreeMap<&'static str, Vec<&'static str>> = BTreeMap::new();
    for field in project.machine.fields().iter().filter(|field| !prepared.hidden().contains(&field.id)) {
        for value in others(project, field) {
            let mut values = project.values.clone();
            values.insert(field.id.to_owned(), value);
            let after = project.machine.prepare(&values, project.control_context()).results().readouts;
            for old in &before {
                let differs = after.iter().find(|new| new.id == old.id).is_some_and(|new| differ(old, new));
                let fields = found.entry(old.id).or_default();
                if differs && fields.last() != Some(&field.id) {
                    fields.push(field.id);
                }
            }
        }
    }
    found
}

/// Other values of a field; none of a text.
fn others(project: &Project, field: &FieldInfo) -> Vec<Value> {
    let present = project.values.get(field.id).cloned().unwrap_or_else(|| field.default());
    match &field.kind {
        FieldKindInfo::Number { min, max, step, .. } => {
            let number = if let Value::Number(number) = present { number } else { return Vec::new() };
            let part = [1.1, 0.9].into_iter().find_map(|factor| changed(project, field, factor));
            // A tenth of 0 is none.
            let near = [number + step, number - step].into_iter().find(|other| (*min..=*max).contains(other));
            part.or(near).map(Value::Number).into_iter().collect()
        }
        FieldKindInfo::Flag(_) => vec![Value::Flag(present != Value::Flag(true))],
        FieldKindInfo::Choice(options) => {
            options.iter().map(|(id, _)| Value::Text((*id).to_owned())).filter(|value| *value != present).collect()
        }
        FieldKindInfo::Text(_) => Vec::new(),
    }
}

/// Whether two results differ by more than the last digits of a calculation.
fn differ(old: &Readout, new: &Readout) -> bool {
    let off = |a: f64, b: f64| (a - b).abs() > 1e-9 * a.abs().max(b.abs());
    let limits = match (old.limit, new.limit) {
        (Some(old), Some(new)) => off(old.value(), new.value()),
        (old, new) => old.is_some() != new.is_some(),
    };
    off(old.value, new.value) || limits || old.verdict != new.verdict
}
