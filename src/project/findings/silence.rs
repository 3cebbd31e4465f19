//! Warnings that the user silences by their stable ids.

use std::collections::BTreeSet;

use crate::text::Diagnostic;

/// Removes silenced warnings, in place, and returns their number. Errors are never silenced.
pub fn silence(found: &mut Vec<Diagnostic>, silenced: &[String]) -> usize {
    let before = found.len();
    if !silenced.is_empty() {
        let silenced: BTreeSet<&str> = silenced.iter().map(String::as_str).collect();
        found.retain(|d| d.is_error() || !silenced.contains(d.message_id()));
    }
    before - found.len()
}
