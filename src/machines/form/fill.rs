//! Fills parameters: first with the defaults of the form, then with every valid value.

use super::{Field, FieldKind, Origins, Provenance, Value, Values};
use crate::text::Diagnostic;

/// Sets every parameter to the default of its field.
pub fn defaults<P>(fields: &[Field<P>], params: &mut P) {
    for field in fields {
        match &field.kind {
            FieldKind::Number { default, set, .. } => set(params, *default),
            FieldKind::Flag { default, set, .. } => set(params, *default),
            FieldKind::Choice { set, .. } => set(params, 0),
            FieldKind::Text { set, .. } => set(params, String::new()),
        }
    }
}

/// The facts (field ids) that are only assumed: their origin is [`Provenance::Assumed`] or missing.
pub fn assumed(facts: &[&'static str], origins: &Origins) -> Vec<&'static str> {
    let known = |id: &str| origins.get(id).is_some_and(|origin| *origin != Provenance::Assumed);
    facts.iter().copied().filter(|id| !known(id)).collect()
}

/// Fills parameters from values: valid ones are set, invalid ones are reported and leave the parameter unchanged.
pub fn fill<P>(fields: &[Field<P>], values: &Values, params: &mut P) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for field in fields {
        let Some(value) = values.get(field.id) else { continue };
        if let Err(problem) = field.info().check(value) {
            debug_assert!(problem.is_error());
            found.push(*problem);
            continue;
        }
        match (&field.kind, value) {
            (FieldKind::Number { set, .. }, Value::Number(number)) => set(params, *number),
            (FieldKind::Flag { set, .. }, Value::Flag(flag)) => set(params, *flag),
            (FieldKind::Choice { options, set, .. }, Value::Text(id)) => {
                if let Some(at) = options.iter().position(|(option, _)| option == id) {
                    set(params, at);
                }
            }
            (FieldKind::Text { set, .. }, Value::Text(text)) => set(params, text.clone()),
            _ => {}
        }
    }
    found
}
