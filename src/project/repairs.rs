//! Changes of the form with which all results hold: remedies of failing results, each tried with those before it.

use super::Project;
use crate::text::Severity;
use crate::view::{Readout, Repair, Repairs, Verdict};

/// Maximum number of changes.
const MOST: usize = 8;

/// Greedy search: takes the remedy after which the fewest results fail, then the fewest warn; of equals the first in the order of the results.
/// Entries that the customer orders (essential, not facts of the machine) are changed only if no other remedy lowers the number of failing
/// results.
pub fn repairs(project: &Project) -> Repairs {
    let mut changes: Vec<Repair> = Vec::new();
    let mut best = Trial::of(project.clone());
    while best.faults.failing > 0 && changes.len() < MOST {
        let fields = best.project.machine.fields();
        let essential = |(id, _): &(&str, String)| {
            fields.iter().any(|field| field.id == *id && field.essential && !field.role.is_fact())
        };
        let (of_product, of_machine): (Vec<Repair>, Vec<Repair>) =
            best.offered().into_iter().partition(|repair| repair.sets.iter().any(essential));
        let Some((change, after)) = best.improved(of_machine).or_else(|| best.improved(of_product)) else { break };
        // A later entry of the same fields replaces the earlier one.
        changes.retain(|earlier| !earlier.sets.iter().all(|(id, _)| change.sets.iter().any(|(other, _)| other == id)));
        changes.push(change);
        best = after;
    }
    Repairs { changes, still_failing: best.faults.failing, errors: best.faults.errors }
}

/// A project with these results.
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
            errors: design.diagnostics.iter().filter(|found| found.severity == Severity::Error).count(),
            failing: count(Verdict::Fail),
            warned: count(Verdict::Warn),
        };
        Trial { project, faults, readouts: design.readouts }
    }

    /// The remedy after which the fewest faults are left, and the project with it; `None` if no remedy makes fewer results fail.
    fn improved(&self, offered: Vec<Repair>) -> Option<(Repair, Trial)> {
        let tried = offered.into_iter().filter_map(|repair| {
            let after = Trial::of(self.project.with_entries(&repair.sets)?);
            let is_better = after.faults.failing < self.faults.failing && after.faults.errors <= self.faults.errors;
            is_better.then_some((repair, after))
        });
        tried.min_by_key(|(_, after)| after.faults)
    }

    /// The remedies of its failing results, each once.
    fn offered(&self) -> Vec<Repair> {
        let failing = self.readouts.iter().filter(|readout| readout.verdict == Verdict::Fail);
        let mut offered: Vec<Repair> = Vec::new();
        for advice in failing.flat_map(|readout| &readout.advice) {
            let Some(text) = advice.button.clone() else { continue };
            if offered.iter().all(|other| other.sets != advice.sets) {
                offered.push(Repair { text, sets: advice.sets.clone() });
            }
        }
        offered
    }
}
