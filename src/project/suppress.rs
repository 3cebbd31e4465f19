//! Warnings that the user does not want to see: left out by the id of their sentence.

use crate::text::{Diagnostic, Severity};

/// Leaves out what is silenced, in place; how many it were. Errors are never silenced.
pub fn silence(found: &mut Vec<Diagnostic>, silenced: &[String]) -> usize {
    let before = found.len();
    if !silenced.is_empty() {
        found.retain(|d| d.severity == Severity::Error || !silenced.iter().any(|id| id == d.message.id));
    }
    before - found.len()
}
