//! Characters of comments and messages as a control can show them.

use crate::controls::options::CommentCharacters;

/// A character of a text as the control can show it: a space for white space, `?` for one that it lacks.
pub(super) fn shown(c: char, characters: CommentCharacters) -> char {
    match c {
        c if c.is_ascii_graphic() => c,
        c if c.is_whitespace() || c.is_control() => ' ',
        c if characters.has(c) => c,
        _ => '?',
    }
}
