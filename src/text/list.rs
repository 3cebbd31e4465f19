//! Lists, sentences and headings, joined by the rules of the language in use.

use super::catalog;
use crate::msg;

/// Items separated by commas.
pub fn listed<S: AsRef<str>>(items: impl IntoIterator<Item = S>) -> String {
    joined(items, between("list.items"))
}

/// Items separated by semicolons, for items that contain commas.
pub fn clauses<S: AsRef<str>>(items: impl IntoIterator<Item = S>) -> String {
    joined(items, between("list.clauses"))
}

/// Consecutive sentences.
pub fn sentences<S: AsRef<str>>(items: impl IntoIterator<Item = S>) -> String {
    joined(items, between("list.sentences"))
}

/// A name, a colon and a text.
pub fn headed(name: impl AsRef<str>, text: impl AsRef<str>) -> String {
    [name.as_ref(), between("list.headed"), text.as_ref()].concat()
}

/// A name and a detail of it, for labels: `Smear, 10 ×`.
pub fn detailed(name: impl AsRef<str>, detail: impl AsRef<str>) -> String {
    [name.as_ref(), between("list.detail"), detail.as_ref()].concat()
}

/// Both ends of a range of figures.
pub fn ranged(first: impl AsRef<str>, last: impl AsRef<str>) -> String {
    [first.as_ref(), between("list.range"), last.as_ref()].concat()
}

/// A text and an aside in parentheses.
pub fn with_aside(text: &str, aside: &str) -> String {
    catalog::sentence(&msg!("list.aside", text, aside))
}

/// The items as a choice: `M02, M30 or M99`.
pub fn either(items: &[String]) -> String {
    match items {
        [before @ .., last] if !before.is_empty() => listed(before) + between("list.either") + last,
        _ => listed(items),
    }
}

fn joined<S: AsRef<str>>(items: impl IntoIterator<Item = S>, between: &str) -> String {
    let mut out = String::new();
    for item in items {
        if !out.is_empty() {
            out.push_str(between);
        }
        out.push_str(item.as_ref());
    }
    out
}

/// Text between the two placeholders of a catalog row.
fn between(key: &'static str) -> &'static str {
    let behind = catalog::words(key).split_once('}').and_then(|(_, behind)| behind.rsplit_once('{'));
    behind.map_or(", ", |(between, _)| between)
}
