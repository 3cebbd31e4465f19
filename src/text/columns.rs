//! Width of texts in columns, on a terminal and in a drawing's label, and padding to a width.

use super::escape::is_terminal_control;

/// Width of a text in columns; a Chinese character is as wide as two letters.
pub fn columns(text: &str) -> usize {
    text.chars().map(of_char).sum()
}

/// Width of a character in columns: 2 for East Asian wide characters and emoji, 0 for combining marks.
pub fn of_char(c: char) -> usize {
    match c {
        c if is_terminal_control(c) => 1,
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

/// A text padded with spaces on the right to a width.
pub fn left(text: &str, wide: usize) -> String {
    text.to_owned() + &gap(text, wide)
}

/// A text padded with spaces on the left to a width.
pub fn right(text: &str, wide: usize) -> String {
    gap(text, wide) + text
}

fn gap(text: &str, wide: usize) -> String {
    " ".repeat(wide.saturating_sub(columns(text)))
}
