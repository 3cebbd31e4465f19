//! Conversion between offsets in bytes and in UTF-16 units, which browsers and editors count.

/// UTF-16 offset of a byte offset; limited to the end of the text, and moved to the start of a character.
pub fn units(text: &str, byte: u32) -> u32 {
    let before = text.get(..boundary(text, byte) as usize).unwrap_or(text);
    if before.is_ascii() { before.len() as u32 } else { before.encode_utf16().count() as u32 }
}

/// Byte offset of a UTF-16 offset; limited to the end of the text, and moved to the start of a character.
pub fn byte(text: &str, units: u32) -> u32 {
    let mut left = units;
    for (at, character) in text.char_indices() {
        let wide = character.len_utf16() as u32;
        if left < wide {
            return at as u32;
        }
        left -= wide;
    }
    text.len() as u32
}

/// Start of the character at a byte; the end of the text for bytes beyond it.
pub fn boundary(text: &str, byte: u32) -> u32 {
    let byte = text.len().min(byte as usize);
    (0..=byte).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0) as u32
}
