//! Timeline, log and diagnostics of a run, and their lengths at a checkpoint.

use std::collections::VecDeque;

use super::timeline::{Timeline, TimelineLengths};
use crate::interp::Canon;
use crate::text::{Diagnostic, Place, Severity};

/// Warnings of a run are kept up to so many findings.
pub(super) const REMARKS: usize = 1000;

/// Records of a run; cut to [`RecordLengths`] when the past changes.
#[derive(Debug, Clone)]
pub(super) struct Records {
    pub(super) timeline: Timeline,
    pub(super) log: VecDeque<(f64, Canon, Place)>,
    /// Log entries that were handed out.
    pub(super) taken: usize,
    pub(super) diagnostics: Vec<Diagnostic>,
    /// Number of the first log entry that the debugger shows.
    pub(super) anew: usize,
}

/// Lengths of the records at a checkpoint.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct RecordLengths {
    pub(super) timeline: TimelineLengths,
    log: usize,
    diagnostics: usize,
}

impl RecordLengths {
    /// Number of changes of variables.
    pub(super) fn changes(&self) -> usize {
        self.timeline.changes
    }
}

impl Records {
    /// Adds a finding of the run, once: a program that is started again meets the same alarms. Warnings beyond [`REMARKS`] are left out.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        let has_room = diagnostic.severity == Severity::Error || self.diagnostics.len() < REMARKS;
        if has_room && !self.diagnostics.contains(&diagnostic) {
            self.diagnostics.push(diagnostic);
        }
    }

    pub(super) fn logged(&self) -> usize {
        self.taken + self.log.len()
    }

    /// Forgets the log but for its newest entries.
    pub(super) fn forget_log(&mut self, keep: usize) {
        while self.log.len() > keep {
            self.log.pop_front();
            self.taken += 1;
        }
    }

    pub(super) fn marks(&self) -> RecordLengths {
        RecordLengths { timeline: self.timeline.lengths(), log: self.logged(), diagnostics: self.diagnostics.len() }
    }

    pub(super) fn truncate(&mut self, marks: &RecordLengths) {
        self.timeline.truncate(&marks.timeline);
        self.log.truncate(marks.log.saturating_sub(self.taken));
        self.diagnostics.truncate(marks.diagnostics);
    }
}
