//! Limits of the form that would hold at every event of the operating envelope.

use super::rows::{EnvelopeRow, Quantity};
use crate::math;
use crate::project::Project;
use crate::text::catalog::number_text;
use crate::view::{FieldEntry, Verdict};

/// A limit that would hold at every event.
#[derive(Debug, Clone, PartialEq)]
pub struct HoldingLimit {
    /// The quantity.
    pub quantity: Quantity,
    /// The limit, in `unit`.
    pub value: f64,
    /// Unit.
    pub unit: &'static str,
    /// Decimals shown.
    pub decimals: u8,
    /// Whether a run was cut: the true value is greater.
    pub is_truncated: bool,
    /// The entry of the form with this limit; none if the form does not accept it.
    pub entry: Option<FieldEntry>,
}

/// Limits of the form that would hold at every event and by every rule of the machine, for those that fail at an event.
pub(in crate::project::size) fn holding_limits(project: &Project, rows: &[EnvelopeRow]) -> Vec<HoldingLimit> {
    let beyond = rows.iter().filter(|row| row.verdict == Verdict::Fail);
    let mut holding_limits: Vec<HoldingLimit> = Vec::new();
    for of in beyond {
        let Some(field) = of.field.filter(|_| holding_limits.iter().all(|known| known.quantity != of.quantity)) else {
            continue;
        };
        let same = || rows.iter().filter(|row| row.quantity == of.quantity);
        let most = same().map(|row| row.value).fold(0.0, f64::max);
        let most = most.max(asked_by_rules(project, field));
        let scale = math::pow(10.0, f64::from(of.decimals));
        let value = (most * scale).ceil() / scale;
        let is_truncated = same().any(|row| row.is_truncated);
        let entry = FieldEntry::new(field, number_text(value, of.decimals));
        let fits = !is_truncated && project.with_entries(core::slice::from_ref(&entry)).is_some();
        let entry = fits.then_some(entry);
        holding_limits.push(HoldingLimit {
            quantity: of.quantity,
            value,
            unit: of.unit,
            decimals: of.decimals,
            is_truncated,
            entry,
        });
    }
    holding_limits
}

/// The greatest entry of a field in the advice on failing results; 0 if there is none.
fn asked_by_rules(project: &Project, field: &str) -> f64 {
    let results = project.prepared().results().readouts;
    let sets = results.iter().flat_map(|row| &row.advice).flat_map(|advice| &advice.entries);
    sets.filter(|set| set.field == field).filter_map(|set| set.text.parse::<f64>().ok()).fold(0.0, f64::max)
}
