//! Warnings that the user does not want to see: left out by their stable id.

use std::collections::BTreeSet;

use crate::text::{Diagnostic, Severity};

/// Leaves out what is silenced, in place; how many it were. Errors are never silenced.
pub fn silence(found: &mut Vec<Diagnostic>, silenced: &[String]) -> usize {
    let before = found.len();
    if !silenced.is_empty() {
        let silenced: BTreeSet<&str> = silenced.iter().map(String::as_str).collect();
        found.retain(|d| d.severity == Severity::Error || !silenced.contains(d.id()));
    }
    before - found.len()
}
