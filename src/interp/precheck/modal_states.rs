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

/// Whether the words of blocks are always commands: no program has a modal call that uses them as arguments.
pub(super) fn takes_words_as_commands(cx: &BlockContext) -> bool {
    let takes_arguments = |row: &CodeDef| row.code == Code::MacroModalBlock;
    let mut codes = cx.deck.words.iter().filter(|word| is_code(word) && matches!(word.value, WordValue::Number(_)));
    cx.codes().calls().iter().all(|call| call.kind != CallKind::ModalBlock)
        && (!cx.control.codes.iter().any(takes_arguments)
            || codes.all(|word| !cx.codes().row_of(word).is_some_and(takes_arguments)))
}

/// Modal states that the codes of all programs can produce from `start`, which is the first of them.
pub(super) fn reachable(cx: &BlockContext, start: Modal) -> Vec<Modal> {
    let control = cx.control;
    let mut rows: Vec<&CodeDef> = Vec::new();
    let mut any = false;
    for word in cx.deck.words.iter().filter(|word| is_code(word)) {
        let WordValue::Number(_) = word.value else {
            any = true;
            continue;
        };
        if let Some(row) = cx.codes().row_of(word)
            && matters(row)
            && !rows.iter().any(|other| core::ptr::eq(*other, row))
        {
            rows.push(row);
        }
    }
    if any {
        rows = control.codes.iter().filter(|row| matters(row)).collect();
    }
    let mut modals = vec![start];
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
    modals
}
