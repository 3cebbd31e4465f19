//! Loops with a condition that no block in them changes: once inside, a run never leaves such a loop.

use std::collections::BTreeSet;

use super::super::ast::{Expr, ExprId, Stmt};
use super::context::Lint;
use super::flow::{Flow, JumpTo, Successors};
use super::roles::{CALL, END, RETURN, STOP, SUB};
use super::vars::visit;
use crate::controls::VarKind;
use crate::msg;
use crate::text::listed;

/// Maximum visits of blocks per block of the text; inner loops are visited again.
const BUDGET: usize = 4;

/// Reports the loops of a program with a condition that cannot change. Constant conditions are intentional.
pub(super) fn endless(lint: &mut Lint, flow: &Flow) {
    // A modal call runs after each motion, and may change any variable.
    let modal = |block| flow.roles.block(flow.deck.words_of(block)) & CALL != 0;
    if flow.blocks.iter().any(modal) {
        return;
    }
    let mut budget = BUDGET * flow.blocks.len();
    for at in 0..flow.blocks.len() as u32 {
        let Some(block) = flow.blocks.get(at as usize).filter(|block| block.skip == 0) else { continue };
        let JumpTo::Block(start) = flow.successors(at).jump else { continue };
        if start > at {
            continue;
        }
        let cond = match (block.stmt, flow.blocks.get(start as usize).map(|block| block.stmt)) {
            (Stmt::If { cond, .. }, _) => Some((at, cond)),
            (Stmt::End { .. }, Some(Stmt::While { cond: Some(cond), .. })) => Some((start, cond)),
            _ => None,
        };
        let blocks = (at - start) as usize;
        let Some((place, cond)) = cond.filter(|_| blocks <= budget) else { continue };
        budget -= blocks;
        let Some(names) = variables(flow, cond) else { continue };
        if stays(flow, (start, at), &names) {
            let names: Vec<String> = names.iter().map(|&number| flow.control.variable(number)).collect();
            let block = place + flow.base;
            let (place, condition) = lint.written(block, lint.part(block, cond));
            lint.warn(place, msg!("lint.endless-loop", condition, variables = listed(names)));
        }
    }
}

/// The variables of a condition; `None` unless all are known and changed only by the program.
fn variables(flow: &Flow, cond: ExprId) -> Option<BTreeSet<u32>> {
    let (mut numbers, mut known) = (BTreeSet::new(), true);
    visit(flow.deck, cond, &mut |_, expr| match expr {
        // The vacant variable.
        Expr::Var(0) if flow.control.syntax.names().is_none() => {}
        Expr::Var(number) => {
            let kind = flow.control.var(number).map(|row| row.kind);
            known &= matches!(kind, Some(VarKind::Local | VarKind::Common | VarKind::Retained));
            numbers.insert(number);
        }
        Expr::Indirect(_) | Expr::Label(_) => known = false,
        _ => {}
    });
    Some(numbers).filter(|numbers| known && !numbers.is_empty())
}

/// Whether no block of a loop changes these variables, leaves the loop or stops in it.
fn stays(flow: &Flow, (start, end): (u32, u32), numbers: &BTreeSet<u32>) -> bool {
    let (mut moves, mut kept) = (false, false);
    for at in start..=end {
        let Some(block) = flow.blocks.get(at as usize) else { return false };
        let words = flow.deck.words_of(block);
        let changes = |to: ExprId| match flow.deck.expr(to) {
            Expr::Var(number) => numbers.contains(&number),
            _ => true,
        };
        let ends = match block.stmt {
            Stmt::Bad(_) | Stmt::Call { .. } => true,
            Stmt::Assign { to, .. } | Stmt::IfThen { to, .. } => changes(to),
            Stmt::Assigns { first, count } => flow.deck.assignments_at(first, count).iter().any(|one| changes(one.to)),
            _ => flow.roles.block(words) & (CALL | SUB | RETURN | END | STOP) != 0,
        };
        let Successors { jump, falls } = flow.successors(at);
        let inside = match jump {
            JumpTo::Nowhere => falls || at == end,
            JumpTo::Block(to) => (start..=end).contains(&to),
            JumpTo::Anywhere => false,
        };
        // The loop's own condition is not a way out.
        let own = at == start && matches!(block.stmt, Stmt::While { .. }) && jump == JumpTo::Block(end + 1);
        if ends || !inside && !own {
            return false;
        }
        moves |= words.iter().any(|word| flow.control.is_axis(word.letter));
    }
    for &number in numbers {
        kept |= flow.control.var(number).is_some_and(|row| row.kind != VarKind::Local);
    }
    // A loop without motion may wait for variables set by operator or PLC.
    moves || !kept
}
