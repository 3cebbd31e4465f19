//! The text of a program as the bytes that its control reads, and back.

use encoding_rs::GBK;

use crate::controls::options::CommentCharacters;

/// Bytes of a text: GBK by the setting, else UTF-8. A character that the control does not have becomes `?` in GBK.
pub fn bytes(text: &str, characters: CommentCharacters) -> Vec<u8> {
    match characters {
        CommentCharacters::Ascii | CommentCharacters::Utf8 => text.as_bytes().to_vec(),
        CommentCharacters::Gbk => {
            let known = |c: char| if characters.has(c) { c } else { '?' };
            GBK.encode(&text.chars().map(known).collect::<String>()).0.into_owned()
        }
    }
}

/// Decodes GBK; `None` unless all bytes are text.
pub(in crate::project) fn from_gbk(bytes: &[u8]) -> Option<String> {
    let text = GBK.decode_without_bom_handling_and_without_replacement(bytes)?;
    text.chars().all(|c| CommentCharacters::Gbk.has(c)).then(|| text.into_owned())
}
