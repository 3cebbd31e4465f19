//! Changes of the form with which all verdicts hold: remedies of failing results, each tried with those before it.

use super::Project;
use crate::text::Severity;
use crate::view::{Advice, Readout, Repairs, Verdict};

/// Most changes that are looked for.
const MOST: usize = 8;

/// Changes with which no verdict fails, or with which the fewest do. Each is the remedy after which the fewest results fail, then the fewest
/// are near their limit; of equals the first in the order of the results. What the customer asked for, the essential entries that are no
/// facts of the machine, is changed only where no other remedy helps.
pub fn repairs(project: &Project) -> Repairs {
    let mut changes: Vec<Advice> = Vec::new();
    let mut best = Trial::of(project.clone());
    while best.faults.failing > 0 && changes.len() < MOST {
        let fields = best.project.machine.fields();
        let essential =
            |(id, _): &(&str, String)| fields.iter().any(|field| field.id == *id && field.essential && !field.fact);
        let (of_product, of_machine): (Vec<Advice>, Vec<Advice>) =
            best.offered().into_iter().partition(|advice| advice.sets.iter().any(essential));
        let Some((change, after)) = best.improved(of_machine).or_else(|| best.improved(of_product)) else { break };
        // A later entry of the same fields replaces the earlier one.
        changes.retain(|earlier| !earlier.sets.iter().all(|(id, _)| change.sets.iter().any(|(other, _)| other == id)));
        changes.push(change);
        best = after;
    }
    Repairs { changes, left: best.faults.failing }
}

/// A project with these results.
struct Trial {
    project: Project,
    readouts: Vec<Readout>,
    faults: Faults,
}

/// What is wrong with a design, the worst first.
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

    /// The remedy after which the fewest faults are left, and the project with it; `None` if none leaves fewer.
    fn improved(&self, offered: Vec<Advice>) -> Option<(Advice, Trial)> {
        let tried = offered.into_iter().filter_map(|advice| {
            let after = Trial::of(self.project.with_entries(&advice.sets)?);
            (after.faults < self.faults).then_some((advice, after))
        });
        tried.min_by_key(|(_, after)| after.faults)
    }

    /// The remedies of its failing results, each once.
    fn offered(&self) -> Vec<Advice> {
        let failing = self.readouts.iter().filter(|readout| readout.verdict == Verdict::Fail);
        let mut offered: Vec<Advice> = Vec::new();
        for advice in failing.flat_map(|readout| &readout.advice).filter(|advice| !advice.sets.is_empty()) {
            if offered.iter().all(|other| other.sets != advice.sets) {
                offered.push(advice.clone());
            }
        }
        offered
    }
}
