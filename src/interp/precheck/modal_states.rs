//! Modal states that the codes of all programs can produce, reduced to the parts that change the meaning of words.

use super::super::context::BlockContext;
use super::super::modal::Modal;
use super::clean::is_code;
use crate::controls::macros::CallKind;
use crate::controls::{Code, CodeDef, Group};
use crate::nc::WordValue;

/// Whether the meaning of words depends on this code.
fn matters(row: &CodeDef) -> bool {
    use Code::{FeedPerMinute, FeedPerRevolution, Inch, Metric, SurfaceSpeed, SurfaceSpeedOff};
    matches!(row.group, Group::Motion | Group::Cycle | Group::Positions)
        || matches!(row.code, FeedPerMinute | FeedPerRevolution | Inch | Metric | SurfaceSpeed | SurfaceSpeedOff)
}

/// The part of a modal state that changes the meaning of words; see [`matters`].
fn key(modal: &Modal) -> ([bool; 5], u8) {
    let words = match modal.motion {
        _ if modal.unmoved.any() => 0,
        Code::NotSimulated => 0,
        Code::Thread => 1,
        Code::ArcCw | Code::ArcCcw => 2,
        Code::ArcThrough | Code::ArcTangent => 4,
        Code::Tapping => 5,
        _ => 3,
    };
    let leads = matches!(modal.motion, Code::Thread | Code::Tapping);
    ([modal.inch, modal.inch_feed, modal.per_revolution, modal.spindle.surface, leads], words)
}

/// Adds the modal states that the codes of all programs can produce. Returns whether no modal call uses the words of blocks as arguments.
pub(super) fn reachable(cx: &BlockContext, modals: &mut Vec<Modal>) -> bool {
    let control = cx.control;
    let mut rows: Vec<&CodeDef> = Vec::new();
    let (mut any, mut words) = (false, true);
    for word in cx.deck.words.iter().filter(|word| is_code(word)) {
        let WordValue::Number(_) = word.value else {
            any = true;
            continue;
        };
        if let Some(row) = cx.codes().row_of(word) {
            words &= row.code != Code::MacroModalBlock;
            if matters(row) && !rows.iter().any(|other| core::ptr::eq(*other, row)) {
                rows.push(row);
            }
        }
    }
    words &= cx.codes().calls().iter().all(|call| call.kind != CallKind::ModalBlock);
    if any {
        rows = control.codes.iter().filter(|row| matters(row)).collect();
    }
    let mut at = 0;
    while let Some(modal) = modals.get(at).cloned() {
        for row in &rows {
            let mut next = modal.clone();
            next.set(control, row);
            if modals.iter().all(|other| key(other) != key(&next)) {
                modals.push(next);
            }
        }
        at += 1;
    }
    words
}
