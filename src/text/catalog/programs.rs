//! Chinese translations of texts in programs written by macroline: comments, titles, alarms and messages.
//!
//! The machines write them in English; a file has the Chinese texts, with the English ones as keys.

use std::sync::OnceLock;

use super::rows::words_of;

/// Chinese by English text, sorted by key. `{axis}` is a placeholder.
const CHINESE: &str = include_str!("programs_zh.properties");

/// Chinese translation of a comment, title, alarm or message.
pub fn chinese(text: &str) -> Option<String> {
    let whole = words_of(CHINESE, text).map(str::to_owned);
    whole.or_else(|| patterns().iter().find_map(|(english, chinese)| filled(text, english, chinese)))
}

/// All English texts with their Chinese translations.
pub fn all() -> impl Iterator<Item = (String, &'static str)> {
    CHINESE.lines().filter_map(|line| line.split_once('=')).map(|(key, chinese)| (key.replace('\\', ""), chinese))
}

/// The rows with placeholders, collected once.
fn patterns() -> &'static [(String, &'static str)] {
    static PATTERNS: OnceLock<Vec<(String, &'static str)>> = OnceLock::new();
    PATTERNS.get_or_init(|| all().filter(|(english, _)| english.contains('{')).collect())
}

/// The Chinese of a pattern with the values of a text; `None` if the text does not match the pattern.
fn filled(text: &str, english: &str, chinese: &str) -> Option<String> {
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
