//! Entries of number fields: the nearest one to a value, on either side of it, and the ends of the range.

use super::{Field, FieldKind};
use crate::nc::dec::POW10;
use crate::text::catalog::number_text;
use crate::view::FieldEntry;

/// An entry of a number field, rounded to the field's decimals.
#[derive(Debug, Clone, PartialEq)]
pub struct NumberEntry {
    /// Id of the field.
    pub field: &'static str,
    /// Value in the unit of the field.
    pub value: f64,
    /// The entry as text for the field.
    pub text: String,
}

impl From<NumberEntry> for FieldEntry {
    fn from(entry: NumberEntry) -> FieldEntry {
        FieldEntry { field: entry.field, text: entry.text }
    }
}

/// The greatest entry of a number field that is not above `value`.
pub fn at_most<P>(fields: &[Field<P>], id: &'static str, value: f64) -> NumberEntry {
    entry(fields, id, value, f64::floor)
}

/// The least entry of a number field that is not below `value`.
pub fn at_least<P>(fields: &[Field<P>], id: &'static str, value: f64) -> NumberEntry {
    entry(fields, id, value, f64::ceil)
}

/// The entry of a number field that is nearest to `value`.
pub fn nearest<P>(fields: &[Field<P>], id: &'static str, value: f64) -> NumberEntry {
    entry(fields, id, value, f64::round)
}

/// The greatest entry of a number field; infinite for other fields.
pub fn field_max<P>(fields: &[Field<P>], id: &str) -> f64 {
    let kind = fields.iter().find(|field| field.id == id).map(|field| &field.kind);
    match kind {
        Some(FieldKind::Number { max, .. }) => *max,
        _ => f64::INFINITY,
    }
}

/// The least entry of a number field; minus infinity for other fields.
pub fn field_min<P>(fields: &[Field<P>], id: &str) -> f64 {
    let kind = fields.iter().find(|field| field.id == id).map(|field| &field.kind);
    match kind {
        Some(FieldKind::Number { min, .. }) => *min,
        _ => f64::NEG_INFINITY,
    }
}

fn entry<P>(fields: &[Field<P>], id: &'static str, value: f64, round: fn(f64) -> f64) -> NumberEntry {
    let decimals = fields.iter().find(|field| field.id == id).map_or(0, |field| match field.kind {
        FieldKind::Number { decimals, .. } => decimals,
        _ => 0,
    });
    let unit = POW10[usize::from(decimals.min(12))] as f64;
    let value = round(value * unit) / unit;
    NumberEntry { field: id, value, text: number_text(value, decimals) }
}
