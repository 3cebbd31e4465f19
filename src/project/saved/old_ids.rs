//! Ids of warnings and fields as project files had them until November 2026, and the ids that they have now.

use crate::machines::form::FieldInfo;

/// Area, and the old and the present subject in it.
const OLD: &[(&str, &str, &str)] = &[
    ("interp", "other-spindle-stands", "other-spindle-at-rest"),
    ("lint", "slow-way-back", "slow-retract"),
    ("motion", "spindle-stands", "spindle-at-rest"),
    ("motion", "standing-work", "feed-without-rotation"),
    ("nc", "stands-alone", "not-alone"),
];

/// The present id of a warning; other ids stay.
pub(super) fn warning_id(saved: &str) -> String {
    let (area, subject) = saved.split_once('.').unwrap_or_default();
    let row = OLD.iter().find(|row| (row.0, row.1) == (area, subject));
    row.map_or_else(|| saved.to_owned(), |row| format!("{area}.{}", row.2))
}

/// A field that has become several, each on the machines that have it.
const FIELDS: &[(&str, &[&str])] = &[
    ("encoder-counts", &["encoder-counts-x", "encoder-counts-z", "encoder-counts-work", "encoder-counts-tool"]),
    ("encoder-resolution", &["encoder-resolution-x", "encoder-resolution-y"]),
];

/// The present ids of a field on the machine with these fields; other ids stay.
pub(super) fn field_ids<'s>(saved: &'s str, fields: &[FieldInfo]) -> Vec<&'s str> {
    let present = FIELDS.iter().find(|row| row.0 == saved).map_or(&[][..], |row| row.1);
    let present: Vec<&str> = present.iter().copied().filter(|id| fields.iter().any(|field| field.id == *id)).collect();
    if present.is_empty() { vec![saved] } else { present }
}
