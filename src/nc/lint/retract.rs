//! Retractions at cutting feed on a lathe: away from the cut, and past the end of the preceding rapid.

use super::super::ast::{Dimensioning, Stmt, Word};
use super::context::{Lint, measure};
use super::roles::{CALL, CURVED, INCH, INCREMENTAL, LINEAR, RAPID, RETURN, Roles, SPECIAL, SUB};
use crate::controls::Address;
use crate::msg;

/// Codes after which positions are unknown.
const UNKNOWN: u32 = CALL | CURVED | INCH | RETURN | SPECIAL | SUB;

/// A position across and along the spindle, in the unit of words. Unknown is NaN, for which no comparison is true.
type Place = [f64; 2];
const NOWHERE: Place = [f64::NAN; 2];

/// Reports the first retraction at cutting feed of every program.
pub(super) fn retracts(lint: &mut Lint, roles: &Roles) {
    let (deck, axes) = (lint.deck, lint.control.axes);
    let across = axes.iter().find(|axis| axis.diameter);
    let along = axes.iter().find(|axis| axis.letter == Address::Z);
    let (Some(across), Some(along)) = (across, along) else { return };
    let axes = [across, along];
    let increments = lint.increments()[0];
    let least = lint.control.limits.increment;
    let value = |word: &Word| match word.form {
        Dimensioning::Plain => measure(word, increments, least).unwrap_or(f64::NAN),
        _ => f64::NAN,
    };
    for program in &deck.programs {
        let (mut at, mut free, mut cuts) = (NOWHERE, NOWHERE, false);
        for (index, block) in (program.first..).zip(deck.blocks_of(program)) {
            if !matches!(block.stmt, Stmt::Words { .. }) {
                if !matches!(block.stmt, Stmt::Empty | Stmt::Assign { .. } | Stmt::Message(_)) {
                    (at, free) = (NOWHERE, NOWHERE);
                }
                continue;
            }
            let words = deck.words_of(block);
            let bits = roles.block(words);
            if bits & INCREMENTAL != 0 {
                break;
            }
            cuts = (cuts || bits & LINEAR != 0) && bits & (RAPID | CURVED) == 0;
            if bits & UNKNOWN != 0 {
                (at, free) = (NOWHERE, NOWHERE);
                continue;
            }
            let (mut to, mut last) = (at, None);
            for word in words {
                for (place, axis) in to.iter_mut().zip(axes) {
                    if word.letter == axis.letter {
                        *place = value(word);
                    } else if axis.incremental == Some(word.letter) {
                        *place = f64::NAN;
                    } else {
                        continue;
                    }
                    last = Some(word);
                }
            }
            let Some(last) = last else { continue };
            let out = at[0] >= free[0] && to[0] >= free[0];
            if !cuts {
                free = to;
            } else if out && at[1] < free[1] && to[1] > free[1] {
                let (place, word) = lint.written(index, last.span(block));
                lint.warn(place, msg!("lint.slow-retract", word));
                break;
            }
            at = to;
        }
    }
}
