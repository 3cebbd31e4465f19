//! [`Check`]: one program under check, and the errors so far.

use std::collections::BTreeMap;

use super::jump_targets::JumpTargets;
use crate::controls::{Alarm, Control};
use crate::nc::ast::{Block, Deck, ExprId, Program};
use crate::nc::codes::Codes;
use crate::nc::parsed::{FINDINGS, PartPlaces};
use crate::nc::program_names::ProgramNames;
use crate::text::{Diagnostic, Message, Place, Span};

/// Checks of one program.
pub(super) struct Check<'a> {
    pub(super) deck: &'a Deck,
    pub(super) places: &'a PartPlaces,
    pub(super) known: &'a ProgramNames<'a>,
    pub(super) control: &'a Control,
    pub(super) codes: &'a Codes,
    pub(super) program: &'a Program,
    pub(super) blocks: &'a [Block],
    /// The program's file.
    pub(super) text: &'a str,
    pub(super) targets: JumpTargets<'a>,
    /// Findings of WHILE without DO, by their places.
    pub(super) without_do: &'a BTreeMap<Place, usize>,
    pub(super) found: &'a mut Vec<Diagnostic>,
}

impl Check<'_> {
    /// Span of an expression of the block; the block's span if unknown.
    pub(super) fn expr_span(&self, block: &Block, expr: ExprId) -> Span {
        let span = self.places.exprs.get(expr.0 as usize).and_then(|span| span.trimmed(self.text));
        span.unwrap_or(block.span)
    }

    /// Whether so many findings are known that no more are looked for.
    pub(super) fn is_full(&self) -> bool {
        self.found.len() > 2 * FINDINGS
    }

    /// Reports an alarm of the control.
    pub(super) fn report(&mut self, alarm: Alarm, span: Span, message: Message) {
        let place = Place { file: self.program.file, span };
        let finding = Diagnostic::error(message).at(place).alarm(self.control.alarm_shown(alarm));
        self.found.push(finding);
    }
}
