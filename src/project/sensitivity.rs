//! Assumed facts of a machine whose error by a tenth changes a verdict: the ones to measure first.

use super::Project;
use crate::machines::form::{FieldInfo, FieldKindInfo, FieldRole, Provenance, Value};
use crate::math;
use crate::text::catalog::number_text;
use crate::view::{Readout, Verdict};

/// Changes of a fact that are tried.
const FACTORS: [f64; 2] = [0.9, 1.1];

/// An assumed fact whose change by a tenth changes the verdict of a result.
#[derive(Debug, Clone, PartialEq)]
pub struct Flip {
    /// Id of the fact's field.
    pub field: &'static str,
    /// Id of the result whose verdict changes most for the worse.
    pub readout: &'static str,
    /// Verdict with the value of the form.
    pub from: Verdict,
    /// Verdict with the changed value.
    pub to: Verdict,
    /// The change: 0.9 or 1.1.
    pub factor: f64,
}

/// The results of a machine, and the results after each assumed fact is changed by a tenth.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    /// The results with the entries of the form.
    pub before: Vec<Readout>,
    /// The facts that could be changed, in the order of the form.
    pub facts: Vec<TriedFact>,
}

/// An assumed fact with the results that its changes lead to.
#[derive(Debug, Clone, PartialEq)]
pub struct TriedFact {
    /// Id of the fact's field.
    pub field: &'static str,
    /// Catalog id of its label.
    pub label: &'static str,
    /// For each change, 0.9 or 1.1, the results.
    pub after: Vec<(f64, Vec<Readout>)>,
}

impl Sensitivity {
    /// Prepares the machine with 0.9 and 1.1 of each number that is shown on the control, is an uncertain fact and has no known origin: within the range
    /// of the field, rounded to its decimals, a whole number above 1 at least one off.
    pub fn new(project: &Project) -> Sensitivity {
        let tried = |field: FieldInfo| {
            let after = FACTORS.into_iter().filter_map(|factor| {
                let mut values = project.values.clone();
                values.insert(field.id.to_owned(), Value::Number(changed(project, &field, factor)?));
                Some((factor, project.machine.prepare(&values, project.control_context()).results().readouts))
            });
            TriedFact { field: field.id, label: field.label, after: after.collect() }
        };
        Sensitivity {
            before: project.prepared().results().readouts,
            facts: assumed_numbers(project).into_iter().map(tried).collect(),
        }
    }

    /// Facts that flip a verdict: first those that make one fail, then in the order of the form.
    pub fn flips(&self) -> Vec<Flip> {
        let mut found: Vec<Flip> = self.facts.iter().filter_map(|fact| fact.flip(&self.before)).collect();
        found.sort_by_key(|flip| core::cmp::Reverse(flip.to));
        found
    }
}

/// Fields of the numbers that are uncertain facts, have a meaning on the control and no known origin, in the order of the form.
pub(super) fn assumed_numbers(project: &Project) -> Vec<FieldInfo> {
    let prepared = project.prepared();
    let assumed = |id: &str| project.provenance.get(id).is_none_or(|origin| *origin == Provenance::Assumed);
    let counts = |field: &FieldInfo| {
        matches!(field.kind, FieldKindInfo::Number { .. })
            && field.role == FieldRole::Fact
            && assumed(field.id)
            && !prepared.hidden().contains(&field.id)
    };
    project.machine.fields().into_iter().filter(counts).collect()
}

impl TriedFact {
    /// The worst change of a verdict.
    fn flip(&self, before: &[Readout]) -> Option<Flip> {
        let mut worst: Option<Flip> = None;
        for (factor, after) in &self.after {
            let found = before.iter().filter_map(|old| {
                let to = after.iter().find(|new| new.id == old.id)?.verdict;
                // Some rules judge a result only if it does not hold, so a result without verdict counts as ok.
                let flips = to.max(Verdict::Ok) != old.verdict.max(Verdict::Ok);
                let flip = Flip { field: self.field, readout: old.id, from: old.verdict, to, factor: *factor };
                flips.then_some(flip)
            });
            for flip in found {
                if worst.as_ref().is_none_or(|worst| flip.to > worst.to) {
                    worst = Some(flip);
                }
            }
        }
        worst
    }
}

/// The value of a number by a factor, as the field takes it; `None` where the field is no number, or its range or decimals leave no other value.
pub(super) fn changed(project: &Project, field: &FieldInfo, factor: f64) -> Option<f64> {
    let FieldKindInfo::Number { min, max, default, decimals, .. } = field.kind else { return None };
    let value = match project.values.get(field.id) {
        Some(value @ Value::Number(number)) if field.check(value).is_ok() => *number,
        _ => default,
    };
    let rounded = |number: f64| number_text(math::clamp(number, min, max), decimals).parse::<f64>().ok();
    let mut changed = rounded(value * factor)?;
    // A whole number above one changes by at least one. A count of one is not changed: it cannot be miscounted by one.
    if decimals == 0 && changed == value && value.abs() > 1.0 {
        changed = rounded(value + (factor - 1.0).signum())?;
    }
    (changed != value).then_some(changed)
}
