//! The byte order mark that some editors put in front of a text.

/// The mark.
pub const BYTE_ORDER_MARK: char = '\u{feff}';

/// A text without the byte order mark in front of it.
pub fn without_byte_order_mark(text: &str) -> &str {
    text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text)
}
