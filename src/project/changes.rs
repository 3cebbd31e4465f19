//! Difference between two states of a project in words, for lists of steps and versions: `Pitch 8 → 9 mm`.

use super::variants::{entries, side_by_side, switches};
use super::{Project, operator};
use crate::msg;
use crate::text::Message;
use crate::text::catalog::{sentence, words};
use crate::view::ComparedRow;

/// Differences listed one by one; the rest is counted.
const NAMED: usize = 3;

/// Lists the differences between two projects: the first ones as phrases with semicolons between them, and the count of the others.
pub fn changes_in_words(before: &Project, after: &Project) -> String {
    let all = changes(before, after);
    let rest = all.len().saturating_sub(NAMED);
    let more = (rest > 0).then(|| sentence(&msg!("changes.more", count = rest as u32)));
    if all.is_empty() {
        words("changes.none").to_owned()
    } else {
        crate::text::clauses(all.into_iter().take(NAMED).chain(more))
    }
}

/// Lists the differences between two projects, a phrase for each. If the machine has changed, only that is listed, because two machines
/// have different entries. An entry that only one of the projects has is left out, because it follows from another difference.
pub fn changes(before: &Project, after: &Project) -> Vec<String> {
    if before.machine.id() != after.machine.id() {
        return vec![sentence(&msg!("changes.machine", machine = words(after.machine.name())))];
    }
    let mut out = Vec::new();
    let mut note = |differs: bool, message: Message| {
        if differs {
            out.push(sentence(&message));
        }
    };
    note(before.control.id != after.control.id, msg!("changes.control", control = after.control.name));
    note(before.name != after.name && !after.name.is_empty(), msg!("changes.name", name = after.name.as_str()));
    note(before.name != after.name && after.name.is_empty(), msg!("changes.no-name"));
    note(before.edited != after.edited && after.edited.is_some(), msg!("changes.edited"));
    note(before.edited != after.edited && after.edited.is_none(), msg!("changes.written"));
    if before.values != after.values {
        out.extend(side_by_side(&[entries(before), entries(after)]).iter().filter_map(phrase));
    }
    if before.control.id == after.control.id && before.switches != after.switches {
        out.extend(side_by_side(&[switches(before), switches(after)]).iter().filter_map(phrase));
    }
    if before.panel != after.panel {
        let one = operator::change_in_words(&before.panel, &after.panel, after.control);
        out.push(one.unwrap_or_else(|| words("changes.panel").to_owned()));
    }
    let others = [
        (before.provenance != after.provenance, "changes.origins"),
        (before.title_block != after.title_block, "changes.title-block"),
        (before.comments != after.comments, "changes.comments"),
        (before.silenced != after.silenced, "changes.silenced"),
        (before.parts != after.parts, "changes.parts"),
        (before.variants != after.variants, "changes.variants"),
    ];
    out.extend(others.into_iter().filter(|(differs, _)| *differs).map(|(_, id)| words(id).to_owned()));
    out
}

/// A row that both have, with both values.
fn phrase(row: &ComparedRow) -> Option<String> {
    match row.cells.as_slice() {
        [Some((before, _)), Some((after, _))] if row.differs => {
            let message = msg!(
                "changes.value",
                field = row.label.as_str(),
                before = before.as_str(),
                after = after.as_str(),
                unit = row.unit
            );
            Some(sentence(&message).trim_end().to_owned())
        }
        _ => None,
    }
}
