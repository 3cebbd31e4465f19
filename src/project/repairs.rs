//! Changes of the form with which all results hold: remedies of failing results, each tried with those before it.

use std::collections::BTreeSet;

use super::Project;
use super::remedy::set_field;
use crate::text::number::figure;
use crate::view::{FieldEntry, Readout, Repair, Repairs, Verdict};

/// Maximum number of changes.
const MOST: usize = 8;

/// Maximum number of ways.
const WAYS: usize = 3;

/// A way to a design whose results hold: its changes, and what they do to the results that come first.
#[derive(Debug, Clone, PartialEq)]
pub struct RepairWay {
    /// The changes.
    pub repairs: Repairs,
    /// Headline results that differ: before and after.
    pub consequences: Vec<(Readout, Readout)>,
}

/// The ways that change different fields: those after which the fewest faults are left, then those with the fewest changes. The first
/// is that of [`repairs`].
pub fn ways(project: &Project) -> Vec<RepairWay> {
    let before = Trial::of(project.clone());
    let first = found_after(before.clone(), Vec::new());
    let others = before.offered().into_iter().filter_map(|remedy| {
        let after = Trial::of(project.with_entries(&remedy.entries)?);
        let is_sound = after.faults.failing < before.faults.failing && after.faults.errors <= before.faults.errors;
        is_sound.then(|| found_after(after, vec![remedy]))
    });
    let mut others: Vec<(Vec<Repair>, Trial)> = others.collect();
    others.sort_by_key(|(changes, after)| (after.faults, changes.len()));
    let mut ways: Vec<(Vec<Repair>, Trial)> = vec![first];
    for (changes, after) in others {
        let is_new = ways.iter().all(|(known, _)| fields(known) != fields(&changes));
        let is_as_good = ways.first().is_some_and(|(_, first)| {
            (after.faults.errors, after.faults.failing) <= (first.faults.errors, first.faults.failing)
        });
        if is_new && is_as_good && ways.len() < WAYS {
            ways.push((changes, after));
        }
    }
    let way = |(changes, after): (Vec<Repair>, Trial)| RepairWay {
        consequences: before.differing(&after),
        repairs: before.repairs(&after, changes),
    };
    ways.into_iter().map(way).collect()
}

/// The fields that changes enter.
fn fields(changes: &[Repair]) -> BTreeSet<&'static str> {
    changes.iter().flat_map(|change| &change.entries).map(|entry| entry.field).collect()
}

/// Greedy search: takes the remedy after which the fewest results fail, then the fewest warn; of equals the first in the order of the results.
/// Entries that the customer orders (essential, not facts of the machine) are changed only if no other remedy lowers the number of failing
/// results. Where no remedy alone lowers it, two together may.
pub fn repairs(project: &Project) -> Repairs {
    let before = Trial::of(project.clone());
    let (changes, after) = found_after(before.clone(), Vec::new());
    before.repairs(&after, changes)
}

/// The search after some changes, with the project to which it leads.
fn found_after(mut best: Trial, mut changes: Vec<Repair>) -> (Vec<Repair>, Trial) {
    while best.faults.failing > 0 && changes.len() < MOST {
        let fields = best.project.machine.fields();
        let essential = |entry: &FieldEntry| {
            fields.iter().any(|field| field.id == entry.field && field.essential && !field.role.is_fact())
        };
        let (of_product, of_machine): (Vec<Repair>, Vec<Repair>) =
            best.offered().into_iter().partition(|repair| repair.entries.iter().any(essential));
        let one = best.improved(of_machine).or_else(|| best.improved(of_product));
        let found = one.map(|(change, after)| (vec![change], after)).or_else(|| best.improved_by_two());
        let Some((found, after)) = found else { break };
        found.into_iter().for_each(|change| add(&mut changes, change));
        best = after;
    }
    (changes, best)
}

/// Adds a change; a later entry of the same fields replaces the earlier one.
fn add(changes: &mut Vec<Repair>, change: Repair) {
    changes.retain(|earlier| {
        !earlier.entries.iter().all(|entry| change.entries.iter().any(|other| other.field == entry.field))
    });
    changes.push(change);
}

/// A project with these results.
#[derive(Clone)]
struct Trial {
    project: Project,
    readouts: Vec<Readout>,
    faults: Faults,
}

/// Counts of faults, compared in this order.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Faults {
    errors: usize,
    failing: usize,
    warned: usize,
}

impl Trial {
    fn of(project: Project) -> Trial {
        let design = project.design();
        let count = |verdict| design.readouts.iter().filter(|readout| readout.verdict == verdict).count();
        let faults = Faults {
            errors: design.diagnostics.iter().filter(|found| found.is_error()).count(),
            failing: count(Verdict::Fail),
            warned: count(Verdict::Warn),
        };
        Trial { project, faults, readouts: design.readouts }
    }

    /// The changes that lead from this project to another one.
    fn repairs(&self, after: &Trial, changes: Vec<Repair>) -> Repairs {
        let is_warned = |readout: &&Readout| readout.verdict == Verdict::Warn;
        let was_warned: Vec<&str> = self.readouts.iter().filter(is_warned).map(|readout| readout.id).collect();
        let new = after.readouts.iter().filter(|readout| is_warned(readout) && !was_warned.contains(&readout.id));
        Repairs {
            changes,
            still_failing: after.faults.failing,
            errors: after.faults.errors,
            new_warnings: new.map(|readout| (readout.id, readout.label)).collect(),
        }
    }

    /// Headline results whose shown figures change, each before and after.
    fn differing(&self, after: &Trial) -> Vec<(Readout, Readout)> {
        let pairs = self.readouts.iter().filter(|readout| readout.headline).filter_map(|before| {
            let after = after.readouts.iter().find(|readout| readout.id == before.id)?;
            let shown = |readout: &Readout| figure(readout.value, readout.decimals);
            (shown(before) != shown(after)).then(|| (before.clone(), after.clone()))
        });
        pairs.collect()
    }

    /// The remedy after which the fewest faults are left, and the project with it; `None` if no remedy makes fewer results fail.
    fn improved(&self, offered: Vec<Repair>) -> Option<(Repair, Trial)> {
        let tried = offered.into_iter().filter_map(|repair| {
            let after = Trial::of(self.project.with_entries(&repair.entries)?);
            let is_better = after.faults.failing < self.faults.failing && after.faults.errors <= self.faults.errors;
            is_better.then_some((repair, after))
        });
        tried.min_by_key(|(_, after)| after.faults)
    }

    /// Two remedies, the second one offered after the first, after which fewer results fail: those with the fewest faults left.
    fn improved_by_two(&self) -> Option<(Vec<Repair>, Trial)> {
        let tried = self.offered().into_iter().filter_map(|first| {
            let between = Trial::of(self.project.with_entries(&first.entries)?);
            let (second, after) = Trial { faults: self.faults, ..between.clone() }.improved(between.offered())?;
            Some((vec![first, second], after))
        });
        tried.min_by_key(|(_, after)| after.faults)
    }

    /// The remedies of its failing results, each once. Beside its result a button need not name the field of its number; here it does.
    fn offered(&self) -> Vec<Repair> {
        let fields = self.project.machine.fields();
        let number = |entries: &[FieldEntry]| match entries {
            [entry] => set_field(&fields, entry.field, entry.text.parse().ok()?),
            _ => None,
        };
        let failing = self.readouts.iter().filter(|readout| readout.verdict == Verdict::Fail);
        let mut offered: Vec<Repair> = Vec::new();
        for advice in failing.flat_map(|readout| &readout.advice) {
            let Some(text) = advice.button.clone() else { continue };
            if offered.iter().all(|other| other.entries != advice.entries) {
                let text = number(&advice.entries).unwrap_or(text);
                offered.push(Repair { text, entries: advice.entries.clone() });
            }
        }
        offered
    }
}
