//! Where a part of a formula stands: found by reading its block once more, as trees have no places.

use super::super::ast::{Block, Deck, ExprId, Stmt, WordValue};
use super::super::parsed::Parsed;
use super::{Reader, Tables};
use crate::text::{FileId, Span};

/// The place of a part of a formula that stands in a block of a file; `None` where it is no part of the block.
pub fn part_span(parsed: &Parsed, file: FileId, block: &Block, part: ExprId) -> Option<Span> {
    let source = parsed.files().get(file)?.text.as_str();
    let tables = Tables::new(parsed.control(), parsed.calls());
    let mut reader = Reader::new(parsed.control(), &tables, file, source, Deck::default());
    reader.places = Some(Vec::new());
    reader.take_line(block.span.of(source).as_bytes(), block.span.start as usize);
    let stmt = reader.statement().ok()?;
    // The parts of a block are read in one order.
    let moved = first_formula(parsed.deck(), block.stmt)?.checked_sub(first_formula(&reader.deck, stmt)?)?;
    let span = *reader.places?.get(part.0.checked_sub(moved)? as usize)?;
    Some(Span::new(block.span.start + span.start, block.span.start + span.end))
}

/// Index of the first formula of a statement.
fn first_formula(deck: &Deck, stmt: Stmt) -> Option<u32> {
    let ExprId(index) = match stmt {
        Stmt::Assign { to, .. } => to,
        Stmt::If { cond, .. } | Stmt::IfThen { cond, .. } => cond,
        Stmt::Goto(target) => target,
        Stmt::While { cond, .. } => cond?,
        Stmt::Words { first, count } => {
            let words = deck.words.get(first as usize..first as usize + count as usize)?;
            words.iter().find_map(|word| match word.value {
                WordValue::Expr(value) => Some(value),
                WordValue::Number(_) => None,
            })?
        }
        Stmt::Empty | Stmt::End { .. } | Stmt::Bad(_) => return None,
    };
    Some(index)
}
