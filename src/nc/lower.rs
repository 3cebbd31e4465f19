//! Rewrites of what a control lacks, each by name; applying them twice changes nothing more.
//!
//! | rewrite | where the control lacks | becomes |
//! |---|---|---|
//! | `plain_texts` | small letters, brackets, `%`, `;` and foreign characters in comments | capitals, `[ ]`, spaces, `?` |
//! | `whole_signs` | nothing; one spelling for one thing | the sign of a constant is part of it |
//! | `no_modulo` | `MOD` | `a-FIX[a/b]*b` |
//! | `short_texts` | long blocks and messages | comments clipped |

use super::ast::{Block, Deck, Expr, ExprId, Op, Stmt, WordValue};
use super::dec::Dec;
use super::emit::text_length;
use crate::controls::syntax::Function;
use crate::controls::{Control, VarKind};

/// The deck as the control can take it. Blocks stay one to one.
pub fn lower(deck: &Deck, control: &Control) -> Deck {
    let mut low = deck.clone();
    plain_texts(&mut low);
    whole_signs(&mut low);
    if !control.syntax.modulo {
        no_modulo(&mut low);
    }
    short_texts(&mut low, control);
    low
}

fn plain_texts(deck: &mut Deck) {
    for comment in &mut deck.comments {
        let plain = |c: char| match c {
            '(' => '[',
            ')' => ']',
            '%' | ';' => ' ',
            c if c.is_ascii_graphic() => c.to_ascii_uppercase(),
            c if c.is_whitespace() || c.is_control() => ' ',
            _ => '?',
        };
        *comment = comment.chars().map(plain).collect();
    }
    for program in deck.programs.iter_mut().filter(|program| program.number == 0) {
        program.title = None;
    }
}

fn whole_signs(deck: &mut Deck) {
    let whole = |dec: Dec| Dec { point: dec.point || dec.scale > 0, ..dec };
    for at in 0..deck.exprs.len() {
        let rewritten = match deck.exprs[at] {
            Expr::Number(number) => Expr::Number(whole(number)),
            // Children stand before their parents: the inner sign is settled.
            Expr::Negate(inner) => match deck.expr(inner) {
                Expr::Number(number) => Expr::Number(Dec { mantissa: number.mantissa.saturating_neg(), ..number }),
                _ => continue,
            },
            _ => continue,
        };
        deck.exprs[at] = rewritten;
    }
    for word in &mut deck.words {
        if let WordValue::Number(number) = &mut word.value {
            *number = whole(*number);
        }
    }
}

/// `a MOD b` is `a-FIX[a/b]*b`.
fn no_modulo(deck: &mut Deck) {
    if !deck.exprs.iter().any(|expr| matches!(expr, Expr::Binary(Op::Modulo, ..))) {
        return;
    }
    // The parts go in front of their parent, so every index moves.
    let mut exprs: Vec<Expr> = Vec::with_capacity(deck.exprs.len() + 3);
    let mut moved: Vec<ExprId> = Vec::with_capacity(deck.exprs.len());
    let push = |expr: Expr, exprs: &mut Vec<Expr>| {
        exprs.push(expr);
        ExprId(exprs.len() as u32 - 1)
    };
    for expr in &deck.exprs {
        let at = |id: ExprId| moved.get(id.0 as usize).copied().unwrap_or(id);
        let id = match *expr {
            Expr::Number(_) | Expr::Var(_) => push(*expr, &mut exprs),
            Expr::Indirect(inner) => push(Expr::Indirect(at(inner)), &mut exprs),
            Expr::Negate(inner) => push(Expr::Negate(at(inner)), &mut exprs),
            Expr::Call(function, inner) => push(Expr::Call(function, at(inner)), &mut exprs),
            Expr::Binary(Op::Modulo, left, right) => {
                let (left, right) = (at(left), at(right));
                let ratio = push(Expr::Binary(Op::Divide, left, right), &mut exprs);
                let whole = push(Expr::Call(Function::Fix, ratio), &mut exprs);
                let multiple = push(Expr::Binary(Op::Multiply, whole, right), &mut exprs);
                push(Expr::Binary(Op::Subtract, left, multiple), &mut exprs)
            }
            Expr::Binary(op, left, right) => push(Expr::Binary(op, at(left), at(right)), &mut exprs),
        };
        moved.push(id);
    }
    let at = |id: &mut ExprId| *id = moved.get(id.0 as usize).copied().unwrap_or(*id);
    for block in &mut deck.blocks {
        match &mut block.stmt {
            Stmt::Assign { to, value } => {
                at(to);
                at(value);
            }
            Stmt::IfThen { cond, to, value } => {
                at(cond);
                at(to);
                at(value);
            }
            Stmt::If { cond, target } => {
                at(cond);
                at(target);
            }
            Stmt::Goto(target) => at(target),
            Stmt::While { cond: Some(cond), .. } => at(cond),
            _ => {}
        }
    }
    for word in &mut deck.words {
        if let WordValue::Expr(value) = &mut word.value {
            at(value);
        }
    }
    deck.exprs = exprs;
}

/// Blocks stay below the control's length, messages within what its screen shows.
fn short_texts(deck: &mut Deck, control: &Control) {
    let room = control.syntax.block_chars.saturating_sub(1);
    for at in 0..deck.programs.len() {
        let Some((title, number)) = deck.programs.get(at).and_then(|p| Some((p.title?, p.number))) else { continue };
        clip(deck, title, room.saturating_sub(number.to_string().len() + 3));
    }
    for at in 0..deck.blocks.len() {
        let Some(block) = deck.blocks.get(at).copied() else { continue };
        let Some(comment) = block.comment else { continue };
        let message = is_message(deck, control, &block);
        if deck.comment(Some(comment)).len() <= (if message { control.syntax.message_chars } else { 0 }) {
            continue;
        }
        let before = text_length(deck, control, &block);
        let gap = usize::from(before > 0 && !message);
        let room = room.saturating_sub(before + gap + 2);
        let room = if message { room.min(control.syntax.message_chars) } else { room };
        clip(deck, comment, room);
    }
}

/// Shortens a text, which is ASCII by now.
fn clip(deck: &mut Deck, comment: u32, room: usize) {
    if let Some(text) = deck.comments.get_mut(comment as usize).filter(|text| text.len() > room) {
        *text = text.chars().take(room).collect::<String>().trim_end().into();
    }
}

/// Whether the comment of a block is what the operator reads: `#3000=1(…)`.
pub(super) fn is_message(deck: &Deck, control: &Control, block: &Block) -> bool {
    let Stmt::Assign { to, .. } = block.stmt else { return false };
    let Expr::Var(number) = deck.expr(to) else { return false };
    control.var(number).is_some_and(|row| matches!(row.kind, VarKind::AlarmMessage | VarKind::StopMessage))
}
