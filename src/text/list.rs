//! Lists, sentences and headings joined as the language that is spoken joins them.

use super::catalog;

/// The items with commas between them.
pub fn listed<S: AsRef<str>>(items: impl IntoIterator<Item = S>) -> String {
    joined(items, between("list.items"))
}

/// The items with semicolons between them, for items that have commas of their own.
pub fn clauses<S: AsRef<str>>(items: impl IntoIterator<Item = S>) -> String {
    joined(items, between("list.clauses"))
}

/// Sentences one after the other.
pub fn sentences<S: AsRef<str>>(items: impl IntoIterator<Item = S>) -> String {
    joined(items, between("list.sentences"))
}

/// What stands behind a name and a colon.
pub fn headed(name: impl AsRef<str>, text: impl AsRef<str>) -> String {
    [name.as_ref(), between("list.headed"), text.as_ref()].concat()
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

/// What a row of the catalog has between its two places.
fn between(key: &'static str) -> &'static str {
    let behind = catalog::words(key).split_once('}').and_then(|(_, behind)| behind.rsplit_once('{'));
    behind.map_or(", ", |(between, _)| between)
}
