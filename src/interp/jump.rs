//! Jumps to labels and sequence numbers, and from DO to END and back.

use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::index::Partner;
use super::operators::WHOLE;
use super::state::RunState;
use crate::controls::{Address, Alarm};
use crate::msg;
use crate::nc::{Block, Expr, ExprId};
use crate::text::{Diagnostic, DiagnosticKind, Place, Span};

impl RunState {
    /// Block of the END for a DO, or of the DO for an END.
    pub(super) fn partner(&self, cx: &BlockContext, at: u32, block: &Block) -> BlockResult<u32> {
        match cx.shared.index.partner(self.program, at) {
            Partner::Block(partner) => Ok(partner),
            Partner::Fault(alarm) => Err(self.faulty_loop(cx, block, alarm)),
        }
    }

    /// The alarm of a DO or END without a partner, as reported by the reader: about this block, else about a crossing loop, else about a
    /// block that does not parse and hides the partner.
    #[cold]
    fn faulty_loop(&self, cx: &BlockContext, block: &Block, alarm: Alarm) -> Trap {
        let message = match alarm {
            Alarm::DoNesting => msg!("interp.do-nesting", most = u32::from(cx.control.syntax.do_depth)),
            _ => msg!("interp.do-pair"),
        };
        let place = |span: Span| Place { file: self.file, span };
        let blocks = cx.deck.blocks.get(self.first as usize..self.end as usize).unwrap_or_default();
        let program = blocks.first().zip(blocks.last()).map(|(first, last)| place(first.span.to(last.span)));
        let errors = cx.shared.parsed.diagnostics().iter().filter(|finding| finding.is_error());
        let within = |outer: Option<Place>| {
            errors.clone().filter(move |error| outer.zip(error.place).is_some_and(|(outer, at)| outer.covers(at)))
        };
        let is_loop = |finding: &&Diagnostic| finding.kind == DiagnosticKind::UnpairedLoop;
        let reported = within(Some(place(block.span))).chain(within(program)).find(is_loop);
        Trap::alarm(alarm, message).reported_as(reported.or_else(|| within(program).next()))
    }

    pub(super) fn go_to(&mut self, cx: &mut BlockContext, from: u32, target: ExprId) -> BlockResult<()> {
        if cx.control.syntax.names().is_some() {
            self.at = cx.shared.index.target(target).ok_or_else(|| self.no_target(cx, from, target))?;
            return Ok(());
        }
        let number = self.number(cx, target)?;
        self.go_to_number(cx, from, number, Alarm::GotoTarget).map_err(|trap| trap.part(target))
    }

    /// The alarm of a jump whose label or block number is not in its direction, or not in the program.
    #[cold]
    fn no_target(&self, cx: &BlockContext, from: u32, target: ExprId) -> Trap {
        let blocks = cx.deck.blocks.get(self.first as usize..self.end as usize).unwrap_or_default();
        let message = match cx.deck.expr(target) {
            Expr::Label(label) => {
                let label = cx.deck.text(Some(label));
                let jump = cx.deck.blocks.get(from as usize).map(|block| cx.deck.jumps_of(block.stmt));
                let jump = jump.into_iter().flatten().find(|jump| jump.target == target);
                let exists = blocks.iter().any(|block| block.label.is_some() && cx.deck.text(block.label) == label);
                match jump.filter(|_| exists) {
                    Some(jump) => {
                        let (keyword, other) = jump.way.keywords();
                        msg!("nc.label-other-way", label, keyword, other)
                    }
                    None => msg!("nc.no-such-label", label),
                }
            }
            Expr::Number(number) => msg!("nc.no-such-sequence", block = format!("N{number}")),
            _ => msg!("interp.bad-block"),
        };
        Trap::alarm(Alarm::NoSequence, message).part(target)
    }

    /// Jumps to a sequence number of the running program. `from` is the jumping block, `missing` the alarm if no block has the number.
    pub(super) fn go_to_number(
        &mut self,
        cx: &BlockContext,
        from: u32,
        number: f64,
        missing: Alarm,
    ) -> BlockResult<()> {
        // A calculated number may differ from a whole one by rounding; sequence numbers have no decimals.
        let whole = (number - number.round()).abs() < WHOLE;
        let number = if whole { number.round() } else { number };
        let numbers = cx.control.syntax.sequence_numbers();
        if !numbers.contains(&number) {
            let (least, most) = (numbers.start, numbers.end - 1.0);
            let message = msg!("nc.jump-range", number = (number, 9), least, most);
            return Err(Trap::alarm(Alarm::JumpNumber, message).at_word(&[Address::P]));
        }
        let found = || cx.shared.index.sequence(self.program, number as u32, from.saturating_add(1));
        let Some(to) = whole.then(found).flatten() else {
            return Err(Trap::alarm(missing, msg!("interp.no-sequence", number = (number, 9))).at_word(&[Address::P]));
        };
        if cx.shared.index.enters_loop(self.program, from, to) {
            return Err(Trap::alarm(Alarm::IntoLoop, msg!("interp.into-loop", number = (number, 0))));
        }
        self.at = to;
        Ok(())
    }
}
