//! Applying the fix of a diagnostic to files.

use std::collections::BTreeMap;

use super::files::Files;
use crate::text::{FileId, Fix, Place};

/// Applies the edits of a fix to files. Edits outside the text, or overlapping an earlier one, are left out.
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

/// Applies several fixes to files and returns the number applied. A fix that touches edits of an earlier one is left out.
pub fn fix_all<'f>(files: &Files, fixes: impl IntoIterator<Item = &'f Fix>) -> (Files, usize) {
    let (mut made, mut count) = (Vec::<(Place, String)>::new(), 0);
    // Ends of the applied edits, by file and start. None touches another, so only the last edit that starts before an end can reach it.
    let mut ends = BTreeMap::<(FileId, u32), u32>::new();
    for one in fixes {
        let meets = |(at, _): &(Place, String)| {
            let before = ends.range(..=(at.file, at.span.end)).next_back();
            before.is_some_and(|(&(file, _), &end)| file == at.file && at.span.start <= end)
        };
        if !one.edits.iter().any(meets) {
            ends.extend(one.edits.iter().map(|(at, _)| ((at.file, at.span.start), at.span.end)));
            made.extend(one.edits.iter().cloned());
            count += 1;
        }
    }
    (edited(files, &made), count)
}
