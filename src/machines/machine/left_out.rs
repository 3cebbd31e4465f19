//! Blocks that a published listing leaves out: it prints the sequence number alone, and the text has the formula in words.

use crate::msg;
use crate::nc::{Block, Expr, Parsed, Stmt};
use crate::text::{Diagnostic, Message, Place, Span};

/// A block that a published listing leaves out.
#[derive(Debug, Clone, Copy)]
pub struct LeftOut {
    /// Sequence number of the empty block.
    pub number: u32,
    /// The variable that it would set, and that no other block sets.
    pub variable: u32,
    /// Text of the block after its number, as the fix inserts it.
    pub text: &'static str,
    /// The finding.
    pub finding: fn() -> Message,
}

impl LeftOut {
    /// The finding about a program that lacks the block, with the block as its fix.
    pub fn find(&self, parsed: &Parsed) -> Option<Diagnostic> {
        let deck = parsed.deck();
        let is_it = |to| matches!(deck.expr(to), Expr::Var(number) if number == self.variable);
        if deck.blocks.iter().any(|block| deck.assignments_of(block.stmt).any(|one| is_it(one.to))) {
            return None;
        }
        let (program, block) = deck.programs.iter().find_map(|program| {
            let alone = |block: &&Block| block.number == Some(self.number) && block.stmt == Stmt::Empty;
            Some((program, deck.blocks_of(program).iter().find(alone)?))
        })?;
        let behind = Place { file: program.file, span: Span::at(block.span.end) };
        let fix = (behind, format!(" {}", self.text));
        let finding = Diagnostic::warning((self.finding)()).at(Place { file: program.file, span: block.span });
        Some(finding.fix(msg!("nc.fix.left-out", block = self.text), vec![fix]))
    }
}
