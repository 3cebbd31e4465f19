//! Formulas behind an address without brackets, on a control that may refuse them.

use super::super::ast::{Expr, Op, Program, Stmt, WordValue};
use super::context::Lint;
use crate::controls::options::SwitchKind;
use crate::msg;
use crate::nc::lex::spelling::needs_brackets;
use crate::text::{Fix, Place, Span};

/// Maximum words in one fix.
const PLACES: usize = 1000;

/// Reports the first formula of each program without brackets, where a switch of the control decides about them and lets them pass.
pub(super) fn without_brackets(lint: &mut Lint) {
    let open = lint.control.switches.iter().any(|row| matches!(row.kind, SwitchKind::WordFormula(_)));
    if !open || lint.parsed.dialect().reading.enclosed || lint.deck.exprs.is_empty() {
        return;
    }
    for program in &lint.deck.programs {
        let words = bare_formulas(lint, program);
        let Some(&(at, word, _)) = words.first() else { continue };
        let edits = words.iter().take(PLACES).flat_map(|&(at, _, formula)| {
            let place = |byte: u32| lint.place(at, Span::at(byte));
            [(place(formula.start), "[".to_owned()), (place(formula.end), "]".to_owned())]
        });
        let edits: Vec<(Place, String)> = edits.collect();
        let (place, word) = lint.written(at, word);
        if let Some(finding) = lint.warn(place, msg!("lint.word-formula", word, count = words.len() as u32)) {
            finding.fixes.push(Fix { title: msg!("nc.fix.square"), edits });
        }
    }
}

/// The words of a program with such a formula: index of the block, the word, and its formula.
fn bare_formulas(lint: &Lint, program: &Program) -> Vec<(u32, Span, Span)> {
    let mut found = Vec::new();
    for (at, block) in (program.first..).zip(lint.deck.blocks_of(program)) {
        if !matches!(block.stmt, Stmt::Words { .. }) {
            continue;
        }
        for word in lint.deck.words_of(block) {
            let WordValue::Expr(id) = word.value else { continue };
            if !matches!(lint.deck.expr(id), Expr::Binary(op, ..) if !matches!(op, Op::Atan | Op::Power)) {
                continue;
            }
            let span = word.span(block);
            // A longer word, or one with a comment in its formula, has no place for the brackets.
            let (place, _) = lint.written(at, span);
            let text = lint.parsed.text(place);
            let formula = text.get(1..).unwrap_or_default().trim_ascii_start();
            let commented = lint.parsed.text(lint.place(at, span)).matches('(').count() > 1;
            if word.len < u8::MAX && !commented && needs_brackets(formula.as_bytes()) {
                found.push((at, span, Span::new(place.span.end - formula.len() as u32, place.span.end)));
            }
        }
    }
    found
}
