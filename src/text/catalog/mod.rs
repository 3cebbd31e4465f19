//! The one place where kinds and values become sentences, one file of rows per area and language.
//!
//! A row is `(id, sentence)`; `{0}`, `{1}` … are the places of the values. Another language is another folder of the same rows.

mod en;

use super::message::{Message, Value};
use super::number::Plain;

/// A language of the sentences.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
}

/// Every row of a language, by area.
pub fn areas(language: Language) -> &'static [&'static [(&'static str, &'static str)]] {
    match language {
        Language::English => en::AREAS,
    }
}

/// The sentence of an id without values (labels, help, titles); the id itself where the catalog lacks it.
pub fn words(language: Language, id: &'static str) -> &'static str {
    areas(language).iter().flat_map(|rows| rows.iter()).find(|(key, _)| *key == id).map_or(id, |(_, text)| text)
}

/// The message as a sentence.
pub fn sentence(language: Language, message: &Message) -> String {
    let mut out = String::new();
    let mut rest = words(language, message.id);
    while let Some(open) = rest.find('{') {
        out.push_str(&rest[..open]);
        let tail = &rest[open + 1..];
        let value = tail.find('}').and_then(|end| Some((end, message.values.get(tail[..end].parse::<usize>().ok()?)?)));
        match value {
            Some((end, Value::Number(number, decimals))) => {
                out.push_str(&number_text(*number, *decimals));
                rest = &tail[end + 1..];
            }
            Some((end, Value::Text(text))) => {
                out.push_str(text);
                rest = &tail[end + 1..];
            }
            None => {
                out.push('{');
                rest = tail;
            }
        }
    }
    out.push_str(rest);
    out
}

/// A number with at most `decimals` decimals as text; see [`Plain`].
pub fn number_text(number: f64, decimals: u8) -> String {
    Plain(number, decimals).to_string()
}
