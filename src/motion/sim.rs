//! Simulation of one event: state, plant, panel and records.

use super::checked_plant::CheckedPlant;
use super::panel::Panel;
use super::records::Records;
use super::state::SimState;
use crate::interp::canon::AXES;
use crate::text::{Diagnostic, DiagnosticKind, Message};

/// Diagnostics reported once per run; those of an axis once for each, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Once {
    Starved,
    SpindleClamp,
    SpindleAtRest,
    OffCentre,
    NoStage,
    NoEncoder,
    NotLocked,
    NoDrivenTool,
    FeedWithoutRotation,
    Notice,
    SmallOffset,
    Clamp(usize),
    Missing(usize),
}

impl Once {
    /// Its bit in [`SimState::reported`]; those of the axes follow the others.
    fn bit(self) -> u32 {
        const CLAMP: usize = 11;
        const MISSING: usize = CLAMP + AXES;
        let number = match self {
            Once::Starved => 0,
            Once::SpindleClamp => 1,
            Once::SpindleAtRest => 2,
            Once::OffCentre => 3,
            Once::NoStage => 4,
            Once::NoEncoder => 5,
            Once::NotLocked => 6,
            Once::NoDrivenTool => 7,
            Once::FeedWithoutRotation => 8,
            Once::Notice => 9,
            Once::SmallOffset => 10,
            Once::Clamp(axis) => CLAMP + axis,
            Once::Missing(axis) => MISSING + axis,
        };
        1 << number
    }
}

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
        if self.state.reported & once.bit() == 0 {
            self.state.reported |= once.bit();
            self.out.diagnostics.push(Diagnostic { place: self.state.place, ..finding() });
        }
    }

    /// Adds a finding about the executing block.
    pub(super) fn report_in_block(&mut self, finding: Diagnostic) {
        self.out.report_in_block(Diagnostic { place: self.state.place, ..finding });
    }
}
