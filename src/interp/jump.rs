//! Jumps to labels and sequence numbers, and from DO to END and back.

use super::context::BlockContext;
use super::error::{Run, Trap};
use super::index::Partner;
use super::operators::WHOLE;
use super::state::RunState;
use crate::controls::Address;
use crate::controls::Alarm;
use crate::msg;
use crate::nc::ExprId;
use crate::text::DiagnosticKind;

impl RunState {
    /// The END of the DO in a block, or the DO of its END.
    pub(super) fn partner(&self, cx: &BlockContext, at: u32) -> Run<u32> {
        match cx.shared.index.partner(self.program, at) {
            Partner::Block(partner) => Ok(partner),
            Partner::Fault(Alarm::DoNesting) => {
                let depth = u32::from(cx.control.syntax.do_depth);
                Err(Trap::alarm(Alarm::DoNesting, msg!("interp.do-nesting", depth)))
            }
            Partner::Fault(alarm) => {
                Err(Trap::alarm(alarm, msg!("interp.do-pair")).of_kind(DiagnosticKind::UnpairedLoop))
            }
        }
    }

    pub(super) fn go_to(&mut self, cx: &mut BlockContext, from: u32, target: ExprId) -> Run<()> {
        if cx.control.syntax.names().is_some() {
            self.at = cx
                .shared
                .index
                .target(target)
                .ok_or_else(|| Trap::alarm(Alarm::NoSequence, msg!("interp.no-label")).part(target))?;
            return Ok(());
        }
        let number = self.number(cx, target)?;
        self.go_to_number(cx, from, number, Alarm::GotoTarget).map_err(|trap| trap.part(target))
    }

    /// Goes on at a sequence number of the running program; `from` is the block that jumps, `missing` the alarm where no block has the
    /// number.
    pub(super) fn go_to_number(&mut self, cx: &BlockContext, from: u32, number: f64, missing: Alarm) -> Run<()> {
        // A calculated number may miss the whole one by a last digit; no block has a number with decimals.
        let whole = (number - number.round()).abs() < WHOLE;
        let number = if whole { number.round() } else { number };
        if !cx.control.syntax.sequence_numbers().contains(&number) {
            return Err(Trap::alarm(Alarm::JumpNumber, msg!("interp.no-sequence", (number, 9))).behind(&[Address::P]));
        }
        let found = || cx.shared.index.sequence(self.program, number as u32, from.saturating_add(1));
        let Some(to) = whole.then(found).flatten() else {
            return Err(Trap::alarm(missing, msg!("interp.no-sequence", (number, 9))).behind(&[Address::P]));
        };
        if cx.shared.index.enters_loop(self.program, from, to) {
            return Err(Trap::alarm(Alarm::IntoLoop, msg!("interp.into-loop", (number, 0))));
        }
        self.at = to;
        Ok(())
    }
}
