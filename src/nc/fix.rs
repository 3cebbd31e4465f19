//! Applying the fix of a diagnostic to files.

use super::files::Files;
use crate::text::Fix;

/// The files with the edits of a fix made. Edits whose place does not fit the text, or that overlap one before, are left out.
pub fn fix(files: &Files, fix: &Fix) -> Files {
    let mut files = files.clone();
    for (index, file) in files.0.iter_mut().enumerate() {
        let mut edits: Vec<_> = fix.edits.iter().filter(|(place, _)| usize::from(place.file.0) == index).collect();
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
