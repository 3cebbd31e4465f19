//! Catalog of sentences, one file per language: turns message ids and values into text.
//!
//! The files are Java properties (`key=sentence`), which the tools of translators read, with the named places of ICU messages
//! ([`parts`]): `{speed}` is a value, `{count, plural, one {head} other {heads}}` the word that goes with a number, `{diameter, unit, mm}` a length
//! with its unit as it is shown ([`units`]). Keys are the ids of messages and labels. The rows of controls stand in English where they are ([`Phrase`](super::Phrase)); a file of another language has them as keys too.
//!
//! One language is spoken at a time ([`speak`]). The command line carries all files with it; the browser loads one beside the page's module.

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
    /// Every language.
    pub const ALL: [Language; 2] = [Language::English, Language::Chinese];

    /// Its code after BCP 47, for `lang` and the names of files.
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

    /// Its own name.
    pub fn name(self) -> &'static str {
        match self {
            Language::English => "English",
            Language::Chinese => "中文",
        }
    }

    /// Its file. The page carries none: it loads the one that it needs.
    #[cfg(any(not(feature = "web"), feature = "package", test))]
    pub fn sentences(self) -> &'static str {
        match self {
            Language::English => include_str!("en.properties"),
            Language::Chinese => include_str!("zh.properties"),
        }
    }
}

/// The file that is spoken at first.
const FIRST: &str = if cfg!(all(feature = "web", not(test))) { "" } else { include_str!("en.properties") };

thread_local! {
    static SPOKEN: Cell<&'static str> = const { Cell::new(FIRST) };
}

/// Takes the sentences of a file from now on, in this thread, and writes figures as its language does: Chinese without separators and with `-`
/// (`docs/glossary.md`, rule 6).
pub fn speak(sentences: &'static str) {
    SPOKEN.set(sentences);
    number::write_figures(match spoken() {
        Language::English => Figures::Spaced,
        Language::Chinese => Figures::Plain,
    });
}

/// The language that is spoken. A file tells it in its row `language`.
pub fn spoken() -> Language {
    Language::of_code(words("language")).unwrap_or(Language::English)
}

/// The line of a key in the sentences that are spoken.
fn row(key: &str) -> Option<(&'static str, &'static str)> {
    row_of(SPOKEN.get(), key)
}

/// A text of a program in the language that is spoken. `None` where that is English, or macroline did not write the text.
pub fn of_program(text: &str) -> Option<String> {
    match spoken() {
        Language::English => None,
        Language::Chinese => programs::chinese(text.trim()),
    }
}

/// The ids of sentences that begin so, in their order.
pub fn ids(start: &str) -> impl Iterator<Item = &'static str> {
    let lines = SPOKEN.get().lines().filter(move |line| line.starts_with(start));
    lines.filter_map(|line| line.get(..key_length(line)))
}

/// The sentence of a key without values (labels, help, titles); the key itself where the catalog lacks it.
pub fn words(key: &'static str) -> &'static str {
    row(key).map_or(key, |(_, sentence)| sentence)
}

/// The id that reads so, where the catalog has it.
pub fn id(text: &str) -> Option<&'static str> {
    row(text).map(|(id, _)| id)
}

/// The name of a place in the sentence of an id, as the catalog has it.
pub fn place(id: &'static str, name: &str) -> Option<&'static str> {
    parts(words(id)).find_map(|part| match part {
        SentencePart::Place(place, _) if place == name => Some(place),
        _ => None,
    })
}

/// The message as a sentence.
pub fn sentence(message: &Message) -> String {
    let mut out = String::new();
    for part in parts(words(message.id)) {
        match part {
            SentencePart::Words(words) => out.push_str(words),
            SentencePart::Place(name, form) => match message.value(name) {
                Some(value) => out.push_str(&shown(message, value, form)),
                None => out.extend(["{", name, "}"]),
            },
        }
    }
    out
}

/// The text of a value at its place.
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

/// A value as text, whatever it measures.
pub fn plain(value: &MessageValue) -> Cow<'_, str> {
    match value {
        MessageValue::Number(number, decimals) => Cow::Owned(number_text(*number, *decimals)),
        MessageValue::Text(text) => Cow::Borrowed(text),
        MessageValue::Label(key) => Cow::Borrowed(words(key)),
    }
}

/// A unit by its own name, or by that of the place that has it.
fn unit_named<'m>(message: &'m Message, unit: &'m str) -> Cow<'m, str> {
    message.value(unit).map_or(Cow::Borrowed(unit), plain)
}

/// Decimals to which an entry of the form is kept where its text has fewer.
const ENTRY: usize = 3;

/// A number of a metric unit in the unit that is shown. A text is an entry of the form, or several with strokes between: it is shown as the
/// field shows it. `None` where it is neither.
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
