//! Simulation of one event: state, plant, panel and records.

use super::checked_plant::CheckedPlant;
use super::panel::Panel;
use super::records::{REMARKS, Records};
use super::state::SimState;
use crate::text::{Diagnostic, DiagnosticKind, Message};

/// Diagnostics reported once per run, as bit numbers; for axes, the bit number of the first axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Once {
    Starved,
    SpindleClamp,
    SpindleAtRest,
    OffCentre,
    NoStage,
    NoEncoder,
    NotLocked,
    NoDrivenTool,
    Clamp = 8,
    Missing = 16,
    FeedWithoutRotation = 24,
    Notice = 25,
    SmallOffset = 26,
}

/// The state, and everything that its events read and write.
pub(super) struct Sim<'a, P> {
    pub(super) s: &'a mut SimState<P>,
    pub(super) plant: &'a CheckedPlant,
    pub(super) out: &'a mut Records,
    pub(super) panel: &'a Panel,
}

impl<P> Sim<'_, P> {
    /// Adds a warning, once per run.
    pub(super) fn warn(&mut self, bit: u32, message: impl FnOnce() -> Message) {
        self.warn_kind(bit, DiagnosticKind::Plain, message);
    }

    /// Adds a warning with a kind that code tests for, once per run.
    pub(super) fn warn_kind(&mut self, bit: u32, kind: DiagnosticKind, message: impl FnOnce() -> Message) {
        self.once(bit, || Diagnostic::warning(message()).kind(kind));
    }

    /// Adds a remark, once per run.
    pub(super) fn note(&mut self, bit: u32, message: impl FnOnce() -> Message) {
        self.once(bit, || Diagnostic::info(message()));
    }

    fn once(&mut self, bit: u32, finding: impl FnOnce() -> Diagnostic) {
        if self.s.reported & (1 << bit) == 0 {
            self.s.reported |= 1 << bit;
            self.out.diagnostics.push(Diagnostic { place: self.s.place, ..finding() });
        }
    }

    /// Adds a finding, once per block of the program, up to [`REMARKS`] findings.
    pub(super) fn report_in_block(&mut self, finding: Diagnostic) {
        let finding = Diagnostic { place: self.s.place, ..finding };
        let told =
            |other: &Diagnostic| other.place == finding.place && other.message.is_same_sentence(&finding.message);
        let said = &mut self.out.diagnostics;
        if said.len() < REMARKS && !said.iter().any(told) {
            said.push(finding);
        }
    }
}
