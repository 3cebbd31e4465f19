//! The statements of macro programs: assignments, jumps, loops, calls by name, messages.

use super::canon::Canon;
use super::context::BlockContext;
use super::error::{BlockResult, Trap};
use super::state::RunState;
use crate::controls::{Address, Alarm};
use crate::msg;
use crate::nc::{BadBlock, Block, Stmt};
use crate::text::{Diagnostic, DiagnosticKind, Place, Severity};

impl RunState {
    /// Executes a block.
    pub(super) fn execute_block(&mut self, cx: &mut BlockContext, at: u32, block: &Block) -> BlockResult<()> {
        if block.skip > 0 && cx.world.block_skip(block.skip) {
            self.counts.macros += 1;
            self.counts.empty += 1;
            return Ok(());
        }
        if cx.shared.refuses {
            self.refused(cx, block)?;
        }
        if let Some(number) = block.number {
            self.modal.set_shown(Address::N, f64::from(number));
        }
        match block.stmt {
            Stmt::Words { .. } => return self.execute_words(cx, at, block, cx.deck.words_of(block)),
            Stmt::Empty => self.counts.empty += 1,
            Stmt::Assign { to, value } => self.assign(cx, block, to, value)?,
            Stmt::If { cond, target, .. } => {
                if self.number(cx, cond)? != 0.0 {
                    self.go_to(cx, at, target)?;
                }
            }
            Stmt::Assigns { first, count } => {
                for assignment in cx.deck.assignments_at(first, count) {
                    self.assign(cx, block, assignment.to, assignment.value)?;
                }
            }
            Stmt::Ifs { first, count } => {
                for jump in cx.deck.jumps_at(first, count) {
                    let jumps = match jump.cond {
                        Some(cond) => self.number(cx, cond)? != 0.0,
                        None => true,
                    };
                    if jumps {
                        self.go_to(cx, at, jump.target)?;
                        break;
                    }
                }
            }
            Stmt::Call { name, repeats } => self.call_named(cx, name, repeats)?,
            Stmt::Message(text) => self.queue.push(Canon::Show { text: cx.deck.text(text).to_owned() }),
            Stmt::IfThen { cond, to, value } => {
                if self.number(cx, cond)? != 0.0 {
                    self.assign(cx, block, to, value)?;
                }
            }
            Stmt::Goto { target, .. } => self.go_to(cx, at, target)?,
            Stmt::While { cond, .. } => {
                let end = self.partner(cx, at, block)?;
                let goes_on = match cond {
                    Some(cond) => self.number(cx, cond)? != 0.0,
                    None => true,
                };
                if !goes_on {
                    self.at = end.saturating_add(1);
                }
            }
            Stmt::End { .. } => self.at = self.partner(cx, at, block)?,
            Stmt::Bad(bad) => return Err(self.bad_block(cx, bad)),
        }
        self.counts.macros += 1;
        Ok(())
    }

    /// The alarm of a block that the control refuses, as reported by the reader.
    #[cold]
    fn refused(&self, cx: &BlockContext, block: &Block) -> BlockResult<()> {
        let here = Place { file: self.file, span: block.span };
        let is_it = |finding: &&Diagnostic| {
            finding.kind == DiagnosticKind::RefusedBlock && finding.place.is_some_and(|at| here.covers(at))
        };
        match cx.shared.parsed.diagnostics().iter().find(is_it) {
            Some(finding) => Err(Trap::alarm(Alarm::Format, msg!("interp.bad-block")).reported_as(Some(finding))),
            None => Ok(()),
        }
    }

    /// The alarm of a block that does not parse, as reported by the reader.
    #[cold]
    fn bad_block(&self, cx: &BlockContext, bad: BadBlock) -> Trap {
        let place = Place { file: self.file, span: bad.finding };
        let mut here = cx.shared.parsed.diagnostics().iter().filter(|finding| finding.place == Some(place));
        // Where only the simulation stops, the reader's finding is a warning.
        if matches!(bad.alarm, Alarm::NotSimulated)
            && let Some(finding) = here.clone().find(|finding| finding.severity == Severity::Warning)
        {
            return Trap::alarm(bad.alarm, finding.message.clone()).within(bad.finding);
        }
        let reported = here.find(|finding| finding.is_error());
        Trap::alarm(bad.alarm, msg!("interp.bad-block")).reported_as(reported)
    }
}
