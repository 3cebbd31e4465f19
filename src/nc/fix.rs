//! Applying the fix of a diagnostic to files.

use super::files::Files;
use crate::text::{Fix, Place};

/// The files with the edits of a fix made. Edits whose place does not fit the text, or that overlap one before, are left out.
pub fn fix(files: &Files, fix: &Fix) -> Files {
    edited(files, &fix.edits)
}

fn edited(files: &Files, edits: &[(Place, String)]) -> Files {
    let mut files = files.clone();
    for (index, file) in files.0.iter_mut().enumerate() {
        let mut edits: Vec<_> = edits.iter().filter(|(place, _)| usize::from(place.file.0) == index).collect();
        edits.sort_by_key(|(place, _)| place.span.start);
        let mut text = String::with_capacity(file.text.len());
        let mut copied = 0;
        for (place, new) in edits {
            let (from, to) = (place.span.start as usize, place.span.end as usize);
            let Some(kept) = file.text.get(copied..from).filter(|_| file.text.get(from..to).is_some()) else {
                continue;
            };
            text.push_str(kept);
            text.push_str(new);
            copied = to;
        }
        text.push_str(file.text.get(copied..).unwrap_or(""));
        file.text = text;
    }
    files
}

/// The files with the edits of several fixes made, and how many were made: one that meets the edits of a fix before it is left out.
pub fn fix_all<'f>(files: &Files, fixes: impl IntoIterator<Item = &'f Fix>) -> (Files, usize) {
    let (mut made, mut count) = (Vec::<(Place, String)>::new(), 0);
    for one in fixes {
        let meets = |(at, _): &(Place, String)| made.iter().any(|(other, _)| touches(*at, *other));
        if !one.edits.iter().any(meets) {
            made.extend(one.edits.iter().cloned());
            count += 1;
        }
    }
    (edited(files, &made), count)
}

/// Whether two edits overlap, or insert at one point.
fn touches(a: Place, b: Place) -> bool {
    a.file == b.file && a.span.start <= b.span.end && b.span.start <= a.span.end
}
