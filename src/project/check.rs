//! Everything that is said of a program before it runs: what its reader finds, alarms that are certain, and warnings.

use std::rc::Rc;

use super::program::Written;
use super::{Project, run};
use crate::interp;
use crate::nc::{self, Parsed};
use crate::text::{Diagnostic, Severity};

/// All of it, in the order of the text. `start` is the number of the program that is started, where somebody has said; `set` are variables
/// that the operator sets.
pub fn review(parsed: &Rc<Parsed>, start: Option<u32>, set: &[u32]) -> Vec<Diagnostic> {
    let mut found = parsed.diagnostics().to_vec();
    found.extend(beyond(parsed, start, set));
    Diagnostic::in_order(&mut found);
    found
}

/// What the reader does not say.
fn beyond(parsed: &Rc<Parsed>, start: Option<u32>, set: &[u32]) -> Vec<Diagnostic> {
    let mut found = interp::precheck(parsed);
    let mut warnings = nc::warnings(parsed, start, set);
    // One mistake is said once.
    let said = |warning: &Diagnostic| {
        found.iter().any(|alarm| warning.place.zip(alarm.place).is_some_and(|(a, b)| a.meets(b)))
    };
    warnings.retain(|warning| warning.severity == Severity::Info || !said(warning));
    found.append(&mut warnings);
    found
}

impl Project {
    /// What is said of the program beyond what its reader finds: alarms that are certain, and what a senior programmer would say. What is
    /// silenced too.
    pub fn advice(&self, written: &Written) -> Vec<Diagnostic> {
        beyond(&written.parsed, Some(written.main), &run::set_by_operator(&[], &self.panel, self.control))
    }
}
