//! Where a part of a formula stands: found by reading its block once more, as trees have no places.

use super::super::ast::{Deck, ExprId, Stmt, WordValue};
use super::super::parsed::Parsed;
use super::{Reader, Tables};
use crate::text::{Place, Span};

/// The bytes of a part of a formula that stands in the block at a place; `None` where it is no part of it.
pub fn part_span(parsed: &Parsed, place: Place, part: ExprId) -> Option<Span> {
    let deck = parsed.deck();
    let source = parsed.files().get(place.file)?.text.as_str();
    let block = deck.programs.iter().filter(|program| program.file == place.file).find_map(|program| {
        let blocks = deck.blocks_of(program);
        blocks.get(blocks.partition_point(|block| block.span.start < place.span.start)).filter(|b| b.span == place.span)
    })?;
    let tables = Tables::new(parsed.control(), parsed.dialect(), parsed.codes());
    let mut reader = Reader::new(parsed.control(), &tables, place.file, source, Deck::default());
    reader.places = Some(Vec::new());
    let stmt = reader.again(block.span).ok()?;
    // The parts of a block are read in one order.
    let moved = first_formula(deck, block.stmt)?.checked_sub(first_formula(&reader.deck, stmt)?)?;
    let span = *reader.places?.get(part.0.checked_sub(moved)? as usize)?;
    Some(Span::new(block.span.start + span.start, block.span.start + span.end))
}

/// Index of the first formula of a statement.
fn first_formula(deck: &Deck, stmt: Stmt) -> Option<u32> {
    let ExprId(index) = match stmt {
        Stmt::Assign { to, .. } => to,
        Stmt::Assigns { first, .. } | Stmt::Ifs { first, .. } => deck.pairs.get(first as usize)?.left,
        Stmt::If { cond, .. } | Stmt::IfThen { cond, .. } => cond,
        Stmt::Goto { target, .. } => target,
        Stmt::Call { repeats, .. } => repeats?,
        Stmt::While { cond, .. } => cond?,
        Stmt::Words { first, count } => {
            let words = deck.words.get(first as usize..first as usize + count as usize)?;
            words.iter().find_map(|word| match word.value {
                WordValue::Expr(value) => Some(value),
                WordValue::Number(_) => None,
            })?
        }
        Stmt::Empty | Stmt::End { .. } | Stmt::Message(_) | Stmt::Bad(_) => return None,
    };
    Some(index)
}
