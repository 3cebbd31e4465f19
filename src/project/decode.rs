//! The bytes of a file as text: UTF-8, UTF-16, or bytes that are neither, with the way back to the offsets of the file.

/// How a file is encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, with or without a byte order mark.
    Utf8,
    /// UTF-16, in either byte order.
    Utf16,
    /// Neither: bytes of a national code page, for instance GBK.
    Unknown,
}

/// A file as text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Decoded {
    /// The text; bytes that are no text have become U+FFFD.
    pub text: String,
    /// Its encoding.
    pub encoding: Encoding,
    /// Offsets in the text and in the file of each piece behind which they differ; empty where they are the same.
    pieces: Vec<(u32, u32)>,
}

impl Decoded {
    /// Reads the bytes of a file. Total.
    pub fn new(bytes: Vec<u8>) -> Decoded {
        if let Some(text) = utf16(&bytes) {
            return Decoded { text, encoding: Encoding::Utf16, pieces: Vec::new() };
        }
        let bytes = match String::from_utf8(bytes) {
            Ok(text) => return Decoded { text, encoding: Encoding::Utf8, pieces: Vec::new() },
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
        Decoded { text, encoding: Encoding::Unknown, pieces }
    }

    /// The offset in the file of an offset in the text; `None` within a character that is not in the file, and in UTF-16.
    pub fn offset(&self, at: u32) -> Option<u32> {
        match self.encoding {
            Encoding::Utf8 => Some(at),
            Encoding::Utf16 => None,
            Encoding::Unknown => {
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
