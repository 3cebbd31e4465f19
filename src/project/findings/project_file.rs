//! Findings about a project file, each at its place, up to a number that a person can read.

use std::collections::BTreeSet;

use crate::msg;
use crate::project::files::json::{self, JsonMembers};
use crate::text::escape::clip;
use crate::text::{Diagnostic, Message, Severity};

/// Findings that are listed at most; the others are counted.
const LISTED: usize = 100;

/// Findings about a project file.
pub(in crate::project) struct Findings<'t> {
    text: &'t str,
    list: Vec<Diagnostic>,
    /// Findings beyond [`LISTED`].
    more: u32,
}

impl<'t> Findings<'t> {
    pub(in crate::project) fn new(text: &'t str) -> Findings<'t> {
        Findings { text, list: Vec::new(), more: 0 }
    }

    /// The text that the findings are about.
    pub(in crate::project) fn text(&self) -> &'t str {
        self.text
    }

    /// Adds a finding at a part of the text; an empty part is no place.
    pub(in crate::project) fn add(&mut self, mut finding: Diagnostic, part: &str) {
        if self.list.len() >= LISTED {
            self.more += 1;
            return;
        }
        finding.place = if part.is_empty() { finding.place } else { json::place(self.text, part) };
        self.list.push(finding);
    }

    /// Adds an error at a part of the text.
    pub(in crate::project) fn error(&mut self, message: Message, part: &str) {
        self.add(Diagnostic::error(message), part);
    }

    /// Adds an error for each key of an object that an earlier member has.
    pub(in crate::project) fn repeated(&mut self, members: &JsonMembers<'t>) {
        let mut known = BTreeSet::new();
        for member in &members.0 {
            if !known.insert(member.key.as_str()) {
                self.error(msg!("project.twice", name = clip(&member.key)), member.source);
            }
        }
    }

    /// All findings in the order of the text, and how many were left out.
    pub(in crate::project) fn into_diagnostics(mut self) -> Vec<Diagnostic> {
        Diagnostic::in_order(&mut self.list);
        if self.more > 0 {
            let severity = self.list.iter().map(|finding| finding.severity).min().unwrap_or(Severity::Error);
            let more = Diagnostic::error(msg!("project.more", count = self.more));
            self.list.push(Diagnostic { severity, ..more });
        }
        self.list
    }
}
