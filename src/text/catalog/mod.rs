//! Catalog of sentences, one file per language: turns message ids and values into text.
//!
//! A line is an id, a space and its sentence; `{0}`, `{1}` … are the places of the values, `{0|head|heads}` is the word that goes with the
//! number of a place: the first for one, the second for all others. Another language is another file of the same ids.
//!
//! The command line carries the files with it. The browser loads that of one language beside the page's module ([`load`]).

use std::cmp::Ordering;
use std::sync::OnceLock;

use super::message::{Message, MessageValue};
use super::number::Plain;

/// A language of the sentences.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
}

/// The file that comes with the program: none with the page, which loads its own.
const CARRIED: &str = if cfg!(all(feature = "web", not(test))) { "" } else { include_str!("en.txt") };

static LOADED: OnceLock<String> = OnceLock::new();

/// Takes the file of the page's language, once. Until then a sentence of the page is its id.
pub fn load(file: String) {
    let _ = LOADED.set(file);
}

impl Language {
    /// The file of the language.
    fn file(self) -> &'static str {
        match self {
            Language::English => LOADED.get().map_or(CARRIED, String::as_str),
        }
    }
}

/// The line of an id, in halves: the lines are sorted.
fn row(language: Language, id: &str) -> Option<(&'static str, &'static str)> {
    let mut rest = language.file();
    loop {
        let (before, behind) = rest.as_bytes().split_at_checked(rest.len() / 2)?;
        let start = before.iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
        let end = before.len() + behind.iter().position(|byte| *byte == b'\n')?;
        let (key, sentence) = rest.get(start..end)?.split_once(' ')?;
        rest = match key.cmp(id) {
            Ordering::Less => rest.get(end + 1..)?,
            Ordering::Equal => return Some((key, sentence)),
            Ordering::Greater => rest.get(..start)?,
        };
    }
}

/// The sentence of an id without values (labels, help, titles); the id itself where the catalog lacks it.
pub fn words(language: Language, id: &'static str) -> &'static str {
    row(language, id).map_or(id, |(_, sentence)| sentence)
}

/// The id that reads so, where the catalog has it.
pub fn id(text: &str) -> Option<&'static str> {
    row(Language::default(), text).map(|(id, _)| id)
}

/// The message as a sentence.
pub fn sentence(language: Language, message: &Message) -> String {
    let mut out = String::new();
    let mut rest = words(language, message.id);
    while let Some((before, tail)) = rest.split_once('{') {
        out.push_str(before);
        let value = tail.split_once('}').and_then(|(place, behind)| Some((fill(language, message, place)?, behind)));
        rest = match value {
            Some((text, behind)) => {
                out.push_str(&text);
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

/// The text of a place, `0` or `0|head|heads`.
fn fill(language: Language, message: &Message, place: &str) -> Option<String> {
    let (at, forms) = place.split_once('|').map_or((place, None), |(at, forms)| (at, Some(forms)));
    let value = match message.values.get(at.parse::<usize>().ok()?)? {
        MessageValue::Number(number, decimals) => number_text(*number, *decimals),
        MessageValue::Text(text) => text.clone(),
        MessageValue::Label(id) => words(language, id).to_owned(),
    };
    let Some(forms) = forms else { return Some(value) };
    let (one, many) = forms.split_once('|')?;
    Some(if value == "1" { one } else { many }.to_owned())
}

/// A number with at most `decimals` decimals as text; see [`Plain`].
pub fn number_text(number: f64, decimals: u8) -> String {
    Plain(number, decimals).to_string()
}
