//! Operator messages longer than the control's display.

use super::super::ast::{Block, Expr, Stmt};
use super::context::Lint;
use crate::controls::VarKind;
use crate::msg;
use crate::text::Span;

/// Reports a message that is too long, at the part beyond the display.
pub(super) fn length(lint: &mut Lint, at: u32, block: &Block) {
    let text = match block.stmt {
        Stmt::Assign { to, .. } | Stmt::IfThen { to, .. } => {
            let Expr::Var(number) = lint.deck.expr(to) else { return };
            let kind = lint.control.var(number).map(|row| row.kind);
            block.comment.filter(|_| matches!(kind, Some(VarKind::AlarmMessage | VarKind::StopMessage)))
        }
        Stmt::Message(text) => text,
        _ => return,
    };
    let Some(id) = text else { return };
    let text = lint.deck.text(text);
    let most = lint.control.syntax.message_chars;
    let Some((cut, _)) = text.char_indices().nth(most) else { return };
    let Span { start, end } = lint.parsed.text_span(id);
    let place = lint.place(at, Span::new((start + cut as u32).min(end), end));
    lint.warn(place, msg!("lint.long-message", count = text.chars().count() as u32, most = most as u32));
}
