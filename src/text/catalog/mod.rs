//! Catalog of sentences, one file per language: text of message ids with their values.
//!
//! The files are Java properties (`key=sentence`), a format of translation tools, with named placeholders as in ICU messages ([`parts`]):
//! `{speed}` is a value, `{count, plural, one {head} other {heads}}` a singular or plural form, `{diameter, unit, mm}` a length with its
//! unit in the shown system ([`units`]). Keys are the ids of messages and labels. Rows of controls contain their English text
//! ([`Phrase`](super::Phrase)); a file of another language has these texts as keys too.
//!
//! One language is in use at a time ([`speak`]). The command line contains all files; the browser loads one beside the page's module.

use std::borrow::Cow;
use std::cell::Cell;

pub mod parts;
pub mod programs;
mod rows;

use parts::{Form, SentencePart, parts};
pub use rows::words_of;
use rows::{key_length, row_of};

use super::message::{Message, MessageValue};
use super::number::{self, Figures, Plain};
use super::units;

/// A language of the sentences.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Language {
    /// English.
    English,
    /// Chinese in simplified characters.
    Chinese,
}

impl Language {
    /// All languages.
    pub const ALL: [Language; 2] = [Language::English, Language::Chinese];

    /// BCP 47 code, for `lang` attributes and file names.
    pub fn code(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Chinese => "zh",
        }
    }

    /// The language with this code.
    pub fn of_code(code: &str) -> Option<Language> {
        Language::ALL.into_iter().find(|language| language.code() == code)
    }

    /// Name of the language in itself.
    pub fn name(self) -> &'static str {
        match self {
            Language::English => "English",
            Language::Chinese => "中文",
        }
    }

    /// Catalog file. The page contains none: it loads the one it needs.
    #[cfg(any(not(feature = "web"), feature = "package", test))]
    pub fn sentences(self) -> &'static str {
        match self {
            Language::English => include_str!("en.properties"),
            Language::Chinese => include_str!("zh.properties"),
        }
    }
}

/// Initial catalog file.
const FIRST: &str = if cfg!(all(feature = "web", not(test))) { "" } else { include_str!("en.properties") };

thread_local! {
    static SPOKEN: Cell<&'static str> = const { Cell::new(FIRST) };
}

/// Sets the catalog file for this thread, and the number format of its language: Chinese without separators and with `-`
/// (`docs/glossary.md`, rule 6).
pub fn speak(sentences: &'static str) {
    SPOKEN.set(sentences);
    number::write_figures(match spoken() {
        Language::English => Figures::Spaced,
        Language::Chinese => Figures::Plain,
    });
}

/// The language in use, from the file's row `language`.
pub fn spoken() -> Language {
    Language::of_code(words("language")).unwrap_or(Language::English)
}

/// Key and sentence of a row in the catalog in use.
fn row(key: &str) -> Option<(&'static str, &'static str)> {
    row_of(SPOKEN.get(), key)
}

/// Translation of a text of a program. `None` for English, and for texts not written by macroline.
pub fn of_program(text: &str) -> Option<String> {
    match spoken() {
        Language::English => None,
        Language::Chinese => programs::chinese(text.trim()),
    }
}

/// Ids with this prefix, in their order.
pub fn ids(start: &str) -> impl Iterator<Item = &'static str> {
    let lines = SPOKEN.get().lines().filter(move |line| line.starts_with(start));
    lines.filter_map(|line| line.get(..key_length(line)))
}

/// Sentence of a key without values (label, help, title); the key itself if the catalog lacks it.
pub fn words(key: &'static str) -> &'static str {
    row(key).map_or(key, |(_, sentence)| sentence)
}

/// Catalog id equal to a text, if there is one.
pub fn id(text: &str) -> Option<&'static str> {
    row(text).map(|(id, _)| id)
}

/// Name of a placeholder in the sentence of an id, from the catalog.
pub fn place(id: &'static str, name: &str) -> Option<&'static str> {
    parts(words(id)).find_map(|part| match part {
        SentencePart::Place(place, _) if place == name => Some(place),
        _ => None,
    })
}

/// A piece of a message's sentence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SentencePiece<'m> {
    /// Text of the piece.
    pub text: Cow<'m, str>,
    /// Whether the piece is a value, and not words of the catalog.
    pub is_value: bool,
}

/// Pieces of a message's sentence, in order.
pub fn pieces(message: &Message) -> impl Iterator<Item = SentencePiece<'_>> {
    parts(words(message.id)).map(|part| match part {
        SentencePart::Words(words) => SentencePiece { text: Cow::Borrowed(words), is_value: false },
        SentencePart::Place(name, form) => {
            let text = message.value(name).map(|value| shown(message, value, form));
            let text = text.unwrap_or_else(|| Cow::Owned(format!("{{{name}}}")));
            SentencePiece { text, is_value: !matches!(form, Form::Plural(_)) }
        }
    })
}

/// Sentence of a message.
pub fn sentence(message: &Message) -> String {
    pieces(message).map(|piece| piece.text).collect()
}

/// Text of a value in its placeholder.
fn shown<'m>(message: &'m Message, value: &'m MessageValue, form: Form<'m>) -> Cow<'m, str> {
    match form {
        Form::Plain => plain(value),
        Form::Plural([one, other]) => Cow::Borrowed(if plain(value) == "1" { one } else { other }),
        Form::Program => {
            let text = plain(value);
            match of_program(&text) {
                Some(words) => Cow::Owned(format!("{text}（{words}）")),
                None => text,
            }
        }
        Form::Unit => Cow::Owned(units::unit(&plain(value)).to_owned()),
        Form::Number(unit) => length(value, &unit_named(message, unit)).map_or_else(|| plain(value), Cow::Owned),
        Form::WithUnit(unit) => {
            let unit = unit_named(message, unit);
            Cow::Owned(match length(value, &unit) {
                Some(number) => units::with_unit(&number, &unit),
                None => [plain(value), unit].join(" "),
            })
        }
    }
}

/// Text of a value, without unit conversion.
pub fn plain(value: &MessageValue) -> Cow<'_, str> {
    match value {
        MessageValue::Number(number, decimals) => Cow::Owned(number_text(*number, *decimals)),
        MessageValue::Text(text) => Cow::Borrowed(text),
        MessageValue::Label(key) => Cow::Borrowed(words(key)),
    }
}

/// Unit by its own name, or by the placeholder that holds it.
fn unit_named<'m>(message: &'m Message, unit: &'m str) -> Cow<'m, str> {
    message.value(unit).map_or(Cow::Borrowed(unit), plain)
}

/// Least number of decimals of converted form entries.
const ENTRY: usize = 3;

/// A number of a metric unit in the shown unit. A text is a form entry, or several separated by slashes, shown as in its field. `None` for
/// other values.
fn length(value: &MessageValue, metric: &str) -> Option<String> {
    match value {
        MessageValue::Number(number, decimals) => Some(units::plain(*number, *decimals, metric)),
        MessageValue::Text(text) => {
            let entry = |text: &str| {
                let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
                Some(units::exact(number::read(text)?, ENTRY.max(decimals) as u8, metric))
            };
            Some(text.split(" / ").map(entry).collect::<Option<Vec<_>>>()?.join(" / "))
        }
        MessageValue::Label(_) => None,
    }
}

/// A number with at most `decimals` decimals as text; see [`Plain`].
pub fn number_text(number: f64, decimals: u8) -> String {
    Plain(number, decimals).to_string()
}
