//! Columns that a text takes, on a terminal and in a drawing's label, and texts padded to a number of them.

use super::escape::is_obeyed;

/// Columns of a text: a Chinese character is as wide as two letters.
pub fn columns(text: &str) -> usize {
    text.chars().map(of_char).sum()
}

/// Columns of a character: 2 for those of East Asian width and pictures, 0 for marks on the one before.
pub fn of_char(c: char) -> usize {
    match c {
        c if is_obeyed(c) => 1,
        '\u{300}'..='\u{36f}' | '\u{200b}'..='\u{200f}' | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' => 0,
        '\u{1100}'..='\u{115f}'
        | '\u{2e80}'..='\u{a4cf}'
        | '\u{ac00}'..='\u{d7a3}'
        | '\u{f900}'..='\u{faff}'
        | '\u{fe30}'..='\u{fe6f}'
        | '\u{ff00}'..='\u{ff60}'
        | '\u{ffe0}'..='\u{ffe6}'
        | '\u{1f300}'..='\u{1faff}'
        | '\u{20000}'..='\u{3fffd}' => 2,
        _ => 1,
    }
}

/// A text with spaces behind it up to a number of columns.
pub fn left(text: &str, wide: usize) -> String {
    text.to_owned() + &gap(text, wide)
}

/// A text with spaces before it up to a number of columns.
pub fn right(text: &str, wide: usize) -> String {
    gap(text, wide) + text
}

fn gap(text: &str, wide: usize) -> String {
    " ".repeat(wide.saturating_sub(columns(text)))
}
