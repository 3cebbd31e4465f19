//! Texts of the programs that macroline writes, with their Chinese: comments, titles, alarms and messages.
//!
//! They are written in English where the program is made; a file has the Chinese with these as keys.

use super::rows::words_of;

/// Chinese by the English text, sorted by key. `{axis}` is the place of a value.
const CHINESE: &str = include_str!("programs_zh.properties");

/// The Chinese of a comment, title, alarm or message.
pub fn chinese(text: &str) -> Option<String> {
    let whole = words_of(CHINESE, text).map(str::to_owned);
    whole.or_else(|| patterns().find_map(|(english, chinese)| filled(text, english, chinese)))
}

/// Every English text with its Chinese.
pub fn all() -> impl Iterator<Item = (String, &'static str)> {
    CHINESE.lines().filter_map(|line| line.split_once('=')).map(|(key, chinese)| (key.replace('\\', ""), chinese))
}

fn patterns() -> impl Iterator<Item = (String, &'static str)> {
    all().filter(|(english, _)| english.contains('{'))
}

/// The Chinese of a pattern with the values of a text, where the text is of the pattern.
fn filled(text: &str, english: String, chinese: &str) -> Option<String> {
    let mut rest = text;
    let mut out = chinese.to_owned();
    let mut parts = english.split(['{', '}']);
    rest = rest.strip_prefix(parts.next()?)?;
    while let (Some(place), Some(behind)) = (parts.next(), parts.next()) {
        let end = if behind.is_empty() { rest.len() } else { rest.find(behind)? };
        let (value, after) = rest.split_at_checked(end)?;
        if value.is_empty() || value.contains(' ') {
            return None;
        }
        out = out.replace(&format!("{{{place}}}"), value);
        rest = after.strip_prefix(behind)?;
    }
    rest.is_empty().then_some(out)
}
