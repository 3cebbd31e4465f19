//! Timeline, log and diagnostics of a run, and their lengths at a checkpoint.

use std::collections::VecDeque;

use super::timeline::{Timeline, TimelineLengths};
use crate::interp::Canon;
use crate::text::{Diagnostic, Place};

/// Maximum findings of a run; beyond it only errors are added.
const REMARKS: usize = 1000;

/// Records of a run; cut to [`RecordLengths`] when planning returns to a checkpoint.
#[derive(Debug, Clone)]
pub(super) struct Records {
    pub(super) timeline: Timeline,
    pub(super) log: VecDeque<(f64, Canon, Place)>,
    /// Number of log entries taken.
    pub(super) taken: usize,
    pub(super) diagnostics: Vec<Diagnostic>,
    /// Log index of the first command since [`Gate::OpenAsFirst`](super::Gate::OpenAsFirst).
    pub(super) first_kept: usize,
}

/// Lengths of the records at a checkpoint.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct RecordLengths {
    pub(super) timeline: TimelineLengths,
    log: usize,
    diagnostics: usize,
}

impl RecordLengths {
    /// Number of variable changes.
    pub(super) fn changes(&self) -> usize {
        self.timeline.changes
    }
}

impl Records {
    /// Adds a finding, once: a restarted program raises the same alarms again. Warnings beyond [`REMARKS`] are dropped.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        let has_room = diagnostic.is_error() || self.diagnostics.len() < REMARKS;
        if has_room && !self.diagnostics.contains(&diagnostic) {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Adds a finding, once per block, also in a loop with changing values; none beyond [`REMARKS`].
    pub(super) fn report_in_block(&mut self, finding: Diagnostic) {
        let is_same =
            |other: &Diagnostic| other.place == finding.place && other.message.is_same_sentence(&finding.message);
        if self.diagnostics.len() < REMARKS && !self.diagnostics.iter().any(is_same) {
            self.diagnostics.push(finding);
        }
    }

    pub(super) fn logged(&self) -> usize {
        self.taken + self.log.len()
    }

    /// Drops all but the newest log entries.
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
