//! The comments of machines' programs in Chinese. They stand in English where they are written; a file has the Chinese with these as keys.

use crate::controls::Control;
use crate::nc::{Deck, is_message};
use crate::text::catalog::words_of;

/// Chinese by the English comment, sorted by key. `{axis}` is the place of a value.
const CHINESE: &str = include_str!("comments_zh.properties");

/// Puts the comments and titles of a deck in Chinese. Messages to the operator, settings of the form and what has no Chinese stay as they are.
pub fn put_in_chinese(deck: &mut Deck, control: &Control) {
    let comments = deck.blocks.iter().filter(|block| !is_message(deck, control, block)).map(|block| block.comment);
    let titles = deck.programs.iter().map(|program| program.title);
    let texts: Vec<_> = comments.chain(titles).flatten().collect();
    for id in texts {
        if let Some(text) = deck.text_mut(id)
            && let Some(chinese) = chinese(text)
        {
            *text = chinese.into();
        }
    }
}

/// The Chinese of a comment.
pub fn chinese(comment: &str) -> Option<String> {
    let whole = words_of(CHINESE, comment).map(str::to_owned);
    whole.or_else(|| patterns().find_map(|(english, chinese)| filled(comment, english, chinese)))
}

/// Every English comment with its Chinese.
pub fn all() -> impl Iterator<Item = (String, &'static str)> {
    CHINESE.lines().filter_map(|line| line.split_once('=')).map(|(key, chinese)| (key.replace('\\', ""), chinese))
}

fn patterns() -> impl Iterator<Item = (String, &'static str)> {
    all().filter(|(english, _)| english.contains('{'))
}

/// The Chinese of a pattern with the values of a comment, where the comment is of the pattern.
fn filled(comment: &str, english: String, chinese: &str) -> Option<String> {
    let mut rest = comment;
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
