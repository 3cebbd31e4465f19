//! Typed text to a checked value, with a diagnostic for every invalid one.

use super::{FieldInfo, FieldKindInfo, Value, Values};
use crate::msg;
use crate::text::escape::shortened;
use crate::text::listed;
use crate::text::quantity::{self, Typed};
use crate::text::{Diagnostic, catalog::number_text, number, units};
use crate::view::FieldEntry;

impl FieldInfo {
    /// Reads text; a number without a unit is in the field's own unit. Spaces around it, a decimal comma, a minus sign
    /// (U+2212) and another unit of the same quantity behind the number (`4.5 in`) are accepted where they are clear.
    /// An invalid text is an error diagnostic about this field that names the allowed range.
    pub fn read_metric(&self, typed: &str) -> Result<Value, Box<Diagnostic>> {
        read(self, typed, |number, _, _| number)
    }

    /// Reads text typed by the user; a number without a unit is in the displayed unit.
    pub fn read_displayed(&self, typed: &str) -> Result<Value, Box<Diagnostic>> {
        read(self, typed, units::entered)
    }

    /// Checks a value that came from a file or a link.
    pub fn check(&self, value: &Value) -> Result<(), Box<Diagnostic>> {
        check(self, value)
    }
}

/// The values with other entries. `None` where a field does not take its entry.
pub fn with_entries(values: &Values, fields: &[FieldInfo], entries: &[FieldEntry]) -> Option<Values> {
    let mut values = values.clone();
    for entry in entries {
        let field = fields.iter().find(|field| field.id == entry.field)?;
        values.insert(entry.field.to_owned(), field.read_metric(&entry.text).ok()?);
    }
    Some(values)
}

/// Reads typed text. `in_unit(number, decimals, unit)` converts a number typed without a unit to the field's `unit`.
fn read(field: &FieldInfo, typed: &str, in_unit: fn(f64, u8, &str) -> f64) -> Result<Value, Box<Diagnostic>> {
    let text = typed.trim();
    match &field.kind {
        FieldKindInfo::Number { unit, decimals, .. } => {
            let typed = quantity::read(text, unit).ok_or_else(|| {
                let wrong = if text.is_empty() {
                    msg!("form.empty")
                } else {
                    msg!("form.not-a-number", text = shortened(text))
                };
                Box::new(with_range(field, Diagnostic::error(wrong).about(field.id)))
            })?;
            let value = Value::Number(match typed {
                Typed::Shown(number) => in_unit(number, *decimals, unit),
                Typed::Converted(number) => number::rounded(number, *decimals),
            });
            check(field, &value).map(|()| value)
        }
        FieldKindInfo::Flag(_) => match text {
            "true" => Ok(Value::Flag(true)),
            "false" => Ok(Value::Flag(false)),
            _ => Err(Box::new(Diagnostic::error(msg!("form.not-a-flag", text = shortened(text))).about(field.id))),
        },
        FieldKindInfo::Choice(_) | FieldKindInfo::Text(_) => {
            let value = Value::Text(text.to_owned());
            check(field, &value).map(|()| value)
        }
    }
}

fn check(field: &FieldInfo, value: &Value) -> Result<(), Box<Diagnostic>> {
    let wrong = match (&field.kind, value) {
        (FieldKindInfo::Number { unit, min, max, decimals, .. }, Value::Number(number)) => {
            if !number.is_finite() {
                msg!("form.not-finite")
            } else if number < min {
                msg!("form.too-small", value = (*number, 6), unit = *unit)
            } else if number > max {
                msg!("form.too-large", value = (*number, 6), unit = *unit)
            } else if too_fine(*number, *decimals) {
                if *decimals == 0 {
                    msg!("form.whole-number")
                } else {
                    msg!("form.too-many-decimals", most = u32::from(*decimals))
                }
            } else {
                return Ok(());
            }
        }
        (FieldKindInfo::Flag(_), Value::Flag(_)) => return Ok(()),
        (FieldKindInfo::Choice(options), Value::Text(id)) => {
            if options.iter().any(|(option, _)| option == id) {
                return Ok(());
            }
            msg!("form.no-such-choice", text = shortened(id), choices = listed(options.iter().map(|(id, _)| *id)))
        }
        (FieldKindInfo::Text(max), Value::Text(text)) => {
            if text.chars().count() <= *max {
                return Ok(());
            }
            msg!("form.text-too-long", most = *max as u32)
        }
        _ => msg!("form.wrong-kind"),
    };
    Err(Box::new(with_range(field, Diagnostic::error(wrong).about(field.id))))
}

/// Whether a number has more decimals than allowed. Floats carry about 1e-9 of slack here, far below any allowed decimal.
fn too_fine(number: f64, decimals: u8) -> bool {
    let scaled = number * crate::nc::dec::POW10[decimals.min(12) as usize] as f64;
    (scaled - scaled.round()).abs() > 1e-9 * scaled.abs().max(1.0)
}

fn with_range(field: &FieldInfo, diagnostic: Diagnostic) -> Diagnostic {
    match &field.kind {
        FieldKindInfo::Number { unit, min, max, decimals, .. } => diagnostic.hint(msg!(
            "form.allowed",
            least = number_text(*min, (*decimals).max(6)),
            most = number_text(*max, (*decimals).max(6)),
            unit = *unit
        )),
        _ => diagnostic,
    }
}
