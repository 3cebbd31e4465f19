//! Rows of a properties file, found by their keys.

use std::cmp::Ordering;

/// Sentence of a key in any catalog file.
pub fn words_of(sentences: &'static str, key: &str) -> Option<&'static str> {
    row_of(sentences, key).map(|(_, sentence)| sentence)
}

/// Key and sentence of a row, by binary search in the sorted lines.
pub(super) fn row_of(sentences: &'static str, key: &str) -> Option<(&'static str, &'static str)> {
    let mut rest = sentences;
    loop {
        let (before, behind) = rest.as_bytes().split_at_checked(rest.len() / 2)?;
        let start = before.iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
        let end = before.len() + behind.iter().position(|byte| *byte == b'\n')?;
        let line = rest.get(start..end)?;
        rest = match unescaped(line).cmp(key.bytes()) {
            Ordering::Less => rest.get(end + 1..)?,
            Ordering::Equal => {
                return line
                    .split_at_checked(key_length(line))
                    .map(|(key, rest)| (key, rest.get(1..).unwrap_or_default()));
            }
            Ordering::Greater => rest.get(..start)?,
        };
    }
}

/// Length of a line's key in bytes: up to the first `=` without a backslash before it.
pub(super) fn key_length(line: &str) -> usize {
    let mut escaped = false;
    let end = line.bytes().position(|byte| {
        let ends = byte == b'=' && !escaped;
        escaped = byte == b'\\';
        ends
    });
    end.unwrap_or(line.len())
}

/// Key of a line without the backslashes before spaces, colons and equals signs. Keys contain no other backslashes.
fn unescaped(line: &str) -> impl Iterator<Item = u8> {
    line.bytes().take(key_length(line)).filter(|byte| *byte != b'\\')
}
