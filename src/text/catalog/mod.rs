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

/// The id that reads so, where the catalog has it.
pub fn id(text: &str) -> Option<&'static str> {
    areas(Language::English).iter().flat_map(|rows| rows.iter()).map(|row| row.0).find(|id| *id == text)
}

/// The message as a sentence.
pub fn sentence(language: Language, message: &Message) -> String {
    let mut out = String::new();
    let mut rest = words(language, message.id);
    while let Some((before, tail)) = rest.split_once('{') {
        out.push_str(before);
        let value = tail
            .split_once('}')
            .and_then(|(at, behind)| Some((message.values.get(at.parse::<usize>().ok()?)?, behind)));
        rest = match value {
            Some((Value::Number(number, decimals), behind)) => {
                out.push_str(&number_text(*number, *decimals));
                behind
            }
            Some((Value::Text(text), behind)) => {
                out.push_str(text);
                behind
            }
            None => {
                out.push('{');
                tail
            }
        };
    }
    out.push_str(rest);
    out
}

/// A number with at most `decimals` decimals as text; see [`Plain`].
pub fn number_text(number: f64, decimals: u8) -> String {
    Plain(number, decimals).to_string()
}
