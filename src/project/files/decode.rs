//! The bytes of a file as text: UTF-8, UTF-16, GBK if the control uses it, or unknown bytes; and the conversion of text offsets back to file offsets.

use super::encode::from_gbk;
use crate::text::Message;

/// Kinds of files that are no text, by their first bytes, each with the id of the sentence that names it.
const KINDS: [(&[u8], &str); 12] = [
    (b"PK\x03\x04", "project.is-zip"),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "project.is-office"),
    (b"{\\rtf", "project.is-rtf"),
    (b"%PDF-", "project.is-pdf"),
    (b"\x7fELF", "project.is-executable"),
    (b"MZ\x90\0", "project.is-executable"),
    (b"\0asm", "project.is-executable"),
    (b"\x1f\x8b", "project.is-archive"),
    (b"Rar!\x1a\x07", "project.is-archive"),
    (b"7z\xbc\xaf\x27\x1c", "project.is-archive"),
    (b"\x89PNG", "project.is-picture"),
    (b"\xff\xd8\xff", "project.is-picture"),
];

/// Sentence that names the kind of a file that is no text.
fn other_kind(bytes: &[u8]) -> Option<Message> {
    let (_, id) = KINDS.iter().find(|(start, _)| bytes.starts_with(start))?;
    Some(Message { id, values: Vec::new() })
}

/// How a file is encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, with or without a byte order mark.
    Utf8,
    /// UTF-16, in either byte order.
    Utf16,
    /// GBK, by the setting of the control.
    Gbk,
    /// None of these: bytes of a national code page.
    Unknown,
}

/// A file as text.
#[derive(Debug, Clone, PartialEq)]
pub struct Decoded {
    /// The text; bytes that are no text have become U+FFFD.
    pub text: String,
    /// Encoding of the file.
    pub encoding: Encoding,
    /// Sentence that names the kind of a file that is no text; the text is empty then.
    pub other: Option<Message>,
    /// The bytes, where the encoding is unknown.
    bytes: Vec<u8>,
    /// Pairs of an offset in the text and in the file, one after each piece whose length differs; empty if all offsets are equal.
    pieces: Vec<(u32, u32)>,
}

impl Decoded {
    /// Reads the bytes of a file. Total.
    pub fn new(bytes: Vec<u8>) -> Decoded {
        if let Some(other) = other_kind(&bytes) {
            return Decoded { other: Some(other), ..Decoded::plain(String::new(), Encoding::Utf8) };
        }
        if let Some(text) = utf16(&bytes) {
            return Decoded::plain(text, Encoding::Utf16);
        }
        let bytes = match String::from_utf8(bytes) {
            Ok(text) => return Decoded::plain(text, Encoding::Utf8),
            Err(error) => error.into_bytes(),
        };
        let (mut text, mut pieces, mut at) = (String::with_capacity(bytes.len()), Vec::new(), 0);
        for chunk in bytes.utf8_chunks() {
            pieces.push((text.len() as u32, at as u32));
            text.push_str(chunk.valid());
            at += chunk.valid().len();
            if !chunk.invalid().is_empty() {
                pieces.push((text.len() as u32, at as u32));
                text.push(char::REPLACEMENT_CHARACTER);
                at += chunk.invalid().len();
            }
        }
        pieces.push((text.len() as u32, at as u32));
        Decoded { text, encoding: Encoding::Unknown, other: None, bytes, pieces }
    }

    fn plain(text: String, encoding: Encoding) -> Decoded {
        Decoded { text, encoding, other: None, bytes: Vec::new(), pieces: Vec::new() }
    }

    /// Decodes the bytes as GBK; `None` unless the encoding is unknown and all bytes are text in GBK.
    pub fn in_gbk(&self) -> Option<Decoded> {
        let text = from_gbk(&self.bytes).filter(|_| self.encoding == Encoding::Unknown)?;
        let mut pieces = vec![(0, 0)];
        let mut file = 0;
        for (at, c) in text.char_indices() {
            file += if c.is_ascii() { 1 } else { 2 };
            if !c.is_ascii() {
                pieces.push(((at + c.len_utf8()) as u32, file));
            }
        }
        Some(Decoded { pieces, ..Decoded::plain(text, Encoding::Gbk) })
    }

    /// The offset in the file of an offset in the text; `None` within a character that is not in the file, and in UTF-16.
    pub fn offset(&self, at: u32) -> Option<u32> {
        match self.encoding {
            Encoding::Utf8 => Some(at),
            Encoding::Utf16 => None,
            Encoding::Gbk if !self.text.is_char_boundary(at as usize) => None,
            Encoding::Gbk | Encoding::Unknown => {
                let next = self.pieces.partition_point(|piece| piece.0 <= at);
                let (text, file) = *self.pieces.get(next.checked_sub(1)?)?;
                let offset = file + (at - text);
                self.pieces.get(next).is_none_or(|piece| offset < piece.1).then_some(offset)
            }
        }
    }
}

/// The text of UTF-16 with a byte order mark, or with the zeros of the first two characters in their places.
fn utf16(bytes: &[u8]) -> Option<String> {
    let (little, bytes) = match bytes {
        [0xff, 0xfe, rest @ ..] => (true, rest),
        [0xfe, 0xff, rest @ ..] => (false, rest),
        [a, 0, b, 0, ..] if *a != 0 && *b != 0 => (true, bytes),
        [0, a, 0, b, ..] if *a != 0 && *b != 0 => (false, bytes),
        _ => return None,
    };
    let unit = |pair: &[u8]| {
        let pair = [pair[0], pair.get(1).copied().unwrap_or(0)];
        if little { u16::from_le_bytes(pair) } else { u16::from_be_bytes(pair) }
    };
    let units = bytes.chunks(2).map(unit);
    Some(char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect())
}
