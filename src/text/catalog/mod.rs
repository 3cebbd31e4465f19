//! Catalog of sentences, one file per language: turns message ids and values into text.
//!
//! The files are Java properties (`key=sentence`), which the tools of translators read, with the places of ICU messages: `{0}`, `{1}` … are
//! values, `{0, plural, one {head} other {heads}}` is the word that goes with the number of a place, `{0, unit, mm}` a length with its unit as
//! it is shown ([`units`]). Keys are the ids of messages and labels. The rows of controls stand in English where they are ([`Phrase`](super::Phrase)); a file of another language has them as keys too.
//!
//! One language is spoken at a time ([`speak`]). The command line carries all files with it; the browser loads one beside the page's module.

use std::cell::Cell;
use std::cmp::Ordering;

use super::message::{Message, MessageValue};
use super::number::{self, Plain};
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

/// Takes the sentences of a file from now on, in this thread.
pub fn speak(sentences: &'static str) {
    SPOKEN.set(sentences);
}

/// The language that is spoken. A file tells it in its row `language`.
pub fn spoken() -> Language {
    Language::of_code(words("language")).unwrap_or(Language::English)
}

/// The line of a key in the sentences that are spoken.
fn row(key: &str) -> Option<(&'static str, &'static str)> {
    row_of(SPOKEN.get(), key)
}

/// The sentence of a key in a file of this format that is not the one spoken.
pub fn words_of(sentences: &'static str, key: &str) -> Option<&'static str> {
    row_of(sentences, key).map(|(_, sentence)| sentence)
}

/// The ids of sentences that begin so, in their order.
pub fn ids(start: &str) -> impl Iterator<Item = &'static str> {
    let lines = SPOKEN.get().lines().filter(move |line| line.starts_with(start));
    lines.filter_map(|line| line.get(..key_length(line)))
}

/// The line of a key, in halves: the lines are sorted.
fn row_of(sentences: &'static str, key: &str) -> Option<(&'static str, &'static str)> {
    let mut rest = sentences;
    loop {
        let (before, behind) = rest.as_bytes().split_at_checked(rest.len() / 2)?;
        let start = before.iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
        let end = before.len() + behind.iter().position(|byte| *byte == b'\n')?;
        let line = rest.get(start..end)?;
        rest = match unescaped(line).cmp(key.bytes()) {
            Ordering::Less => rest.get(end + 1..)?,
            Ordering::Equal => {
                return line
                    .split_at_checked(key_length(line))
                    .map(|(key, rest)| (key, rest.get(1..).unwrap_or_default()));
            }
            Ordering::Greater => rest.get(..start)?,
        };
    }
}

/// How many bytes of a line are its key: up to the first `=` without a backslash before it.
fn key_length(line: &str) -> usize {
    let mut escaped = false;
    let end = line.bytes().position(|byte| {
        let ends = byte == b'=' && !escaped;
        escaped = byte == b'\\';
        ends
    });
    end.unwrap_or(line.len())
}

/// The key of a line without the backslashes before its spaces, colons and equals signs. No key has a backslash of its own.
fn unescaped(line: &str) -> impl Iterator<Item = u8> {
    line.bytes().take(key_length(line)).filter(|byte| *byte != b'\\')
}

/// The sentence of a key without values (labels, help, titles); the key itself where the catalog lacks it.
pub fn words(key: &'static str) -> &'static str {
    row(key).map_or(key, |(_, sentence)| sentence)
}

/// The id that reads so, where the catalog has it.
pub fn id(text: &str) -> Option<&'static str> {
    row(text).map(|(id, _)| id)
}

/// The message as a sentence.
pub fn sentence(message: &Message) -> String {
    let mut out = String::new();
    let mut rest = words(message.id);
    while let Some((before, tail)) = rest.split_once('{') {
        out.push_str(before);
        rest = match filled(message, tail) {
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

/// The text of a place that begins here, behind its bracket, and what follows it.
fn filled<'s>(message: &Message, place: &'s str) -> Option<(String, &'s str)> {
    let (at, behind) = place.split_at_checked(place.find(|c: char| !c.is_ascii_digit())?)?;
    let value = message.values.get(at.parse::<usize>().ok()?)?;
    if let Some(behind) = behind.strip_prefix('}') {
        return Some((plain(value), behind));
    }
    if let Some(behind) = behind.strip_prefix(", plural, one {") {
        let (one, behind) = behind.split_once("} other {")?;
        let (other, behind) = behind.split_once("}}")?;
        return Some((if plain(value) == "1" { one } else { other }.to_owned(), behind));
    }
    let (kind, behind) = behind.strip_prefix(", ")?.split_once('}')?;
    let (kind, unit) = kind.split_once(", ").unwrap_or((kind, ""));
    let unit = unit_named(message, unit);
    let text = match (kind, unit.as_str()) {
        ("unit", "") => units::unit(&plain(value)).to_owned(),
        ("unit", unit) => match length(value, unit) {
            Some(number) => units::with_unit(&number, unit),
            None => [plain(value).as_str(), unit].join(" "),
        },
        ("number", unit) => length(value, unit).unwrap_or_else(|| plain(value)),
        _ => return None,
    };
    Some((text, behind))
}

/// A value as text, whatever it measures.
fn plain(value: &MessageValue) -> String {
    match value {
        MessageValue::Number(number, decimals) => number_text(*number, *decimals),
        MessageValue::Text(text) => text.clone(),
        MessageValue::Label(key) => words(key).to_owned(),
    }
}

/// A unit by its name, or by the number of the place that has it.
fn unit_named(message: &Message, unit: &str) -> String {
    let value = unit.parse::<usize>().ok().and_then(|at| message.values.get(at));
    value.map_or_else(|| unit.to_owned(), plain)
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
