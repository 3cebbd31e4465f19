//! Simulation of one event: state, plant, panel and records.

use super::checked_plant::CheckedPlant;
use super::once::Once;
use super::panel::Panel;
use super::records::Records;
use super::state::SimState;
use crate::text::{Diagnostic, DiagnosticKind, Message};

/// The state, and everything that its events read and write.
pub(super) struct Sim<'a, P> {
    pub(super) state: &'a mut SimState<P>,
    pub(super) plant: &'a CheckedPlant,
    pub(super) out: &'a mut Records,
    pub(super) panel: &'a Panel,
}

impl<P> Sim<'_, P> {
    /// Adds a warning, once per run.
    pub(super) fn warn(&mut self, once: Once, message: impl FnOnce() -> Message) {
        self.warn_kind(once, DiagnosticKind::Plain, message);
    }

    /// Adds a warning with a kind that code tests for, once per run.
    pub(super) fn warn_kind(&mut self, once: Once, kind: DiagnosticKind, message: impl FnOnce() -> Message) {
        self.once(once, || Diagnostic::warning(message()).kind(kind));
    }

    /// Adds a remark, once per run.
    pub(super) fn note(&mut self, once: Once, message: impl FnOnce() -> Message) {
        self.once(once, || Diagnostic::info(message()));
    }

    fn once(&mut self, once: Once, finding: impl FnOnce() -> Diagnostic) {
        if !self.state.reported.contains(&once) {
            self.state.reported.push(once);
            self.out.diagnostics.push(Diagnostic { place: self.state.place, ..finding() });
        }
    }

    /// Adds a finding about the executing block.
    pub(super) fn report_in_block(&mut self, finding: Diagnostic) {
        self.out.report_in_block(Diagnostic { place: self.state.place, ..finding });
    }
}
