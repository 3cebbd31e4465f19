//! Escapes characters that a terminal or a document would interpret, in external texts.

use std::borrow::Cow;

/// Whether a terminal interprets a character: C0 and C1 controls, and controls of the writing direction.
pub fn is_terminal_control(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Maximum characters of an external text in a sentence.
const CLIPPED: usize = 60;

/// Characters of a shortened text, without its ellipsis.
const SHORTENED: usize = 24;

/// An external text as a part of a sentence: its first 60 characters, without control characters.
pub fn clip(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(CLIPPED).collect()
}

/// Beginning of a text for a message: its first 24 characters, and an ellipsis for the rest.
pub fn shortened(text: &str) -> String {
    match text.char_indices().nth(SHORTENED) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or("")),
        None => text.to_owned(),
    }
}

/// A text for a terminal: characters that the terminal interprets become U+FFFD, except line feeds and tabs.
pub fn terminal(text: &str) -> Cow<'_, str> {
    let replaced = |c: char| is_terminal_control(c) && !matches!(c, '\n' | '\t');
    if text.contains(replaced) { Cow::Owned(text.replace(replaced, "\u{fffd}")) } else { Cow::Borrowed(text) }
}

/// A text within a line of Markdown: no HTML, no links or pictures, no line end.
pub fn markdown(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '(' if out.ends_with(']') => out.push_str("\\("),
            '\n' | '\r' | '\t' | '\u{2028}' | '\u{2029}' => out.push(' '),
            c if is_terminal_control(c) => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}
