//! Retractions at cutting feed on a lathe: away from the cut, and past the end of the preceding rapid.

use super::super::ast::Stmt;
use super::context::Lint;
use super::position::{PositionReader, UNKNOWN, keeps_positions};
use super::roles::{CURVED, INCREMENTAL, LINEAR, RAPID, Roles};
use crate::controls::Address;
use crate::msg;

/// Positions across and along the spindle; `None` where unknown.
type Position = [Option<f64>; 2];

/// Whether a move leads from beside the end of the preceding rapid past it: not inward of it across the spindle, and beyond it along the
/// spindle. `None` where a position is unknown.
fn leads_out(free: Position, at: Position, to: Position) -> Option<bool> {
    let ([across, along], [at_across, at_along], [to_across, to_along]) = (free, at, to);
    let is_out = at_across? >= across? && to_across? >= across?;
    Some(is_out && at_along? < along? && to_along? > along?)
}

/// Reports the first retraction at cutting feed of every program.
pub(super) fn retracts(lint: &mut Lint, roles: &Roles) {
    let (deck, axes) = (lint.deck, lint.control.axes);
    let across = axes.iter().find(|axis| axis.diameter);
    let along = axes.iter().find(|axis| axis.letter == Address::Z);
    let (Some(across), Some(along)) = (across, along) else { return };
    let axes = [across, along];
    let reader = PositionReader::new(lint);
    for program in &deck.programs {
        let (mut at, mut free, mut cuts) = ([None; 2], [None; 2], false);
        for (index, block) in (program.first..).zip(deck.blocks_of(program)) {
            if !matches!(block.stmt, Stmt::Words { .. }) {
                if !keeps_positions(block.stmt) {
                    (at, free) = ([None; 2], [None; 2]);
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
                (at, free) = ([None; 2], [None; 2]);
                continue;
            }
            let (mut to, mut last) = (at, None);
            for word in words {
                for (place, axis) in to.iter_mut().zip(axes) {
                    if word.letter == axis.letter {
                        *place = reader.position(word);
                    } else if axis.incremental == Some(word.letter) {
                        *place = None;
                    } else {
                        continue;
                    }
                    last = Some(word);
                }
            }
            let Some(last) = last else { continue };
            if !cuts {
                free = to;
            } else if leads_out(free, at, to) == Some(true) {
                let (place, word) = lint.written(index, last.span(block));
                lint.warn(place, msg!("lint.slow-retract", word));
                break;
            }
            at = to;
        }
    }
}
