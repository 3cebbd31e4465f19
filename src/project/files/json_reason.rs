//! Reasons why a text is no JSON, or not of the expected shape: serde has them in English; here they are put in the chosen language.

use crate::msg;
use crate::text::catalog::{sentence, words};
use crate::text::escape::clip;
use crate::text::{either, listed};

/// Messages of serde_json about a text that is not JSON, and the catalog ids of our sentences for them.
const SYNTAX: [(&str, &str); 16] = [
    ("EOF while parsing a list", "project.json.ends-in-list"),
    ("EOF while parsing an object", "project.json.ends-in-object"),
    ("EOF while parsing a string", "project.json.ends-in-text"),
    ("EOF while parsing a value", "project.json.ends-before-value"),
    ("expected ident", "project.json.expected-word"),
    ("expected value", "project.json.expected-value"),
    ("invalid escape", "project.json.escape"),
    ("invalid unicode code point", "project.json.escape"),
    ("lone leading surrogate in hex escape", "project.json.escape"),
    ("unexpected end of hex escape", "project.json.escape"),
    ("invalid number", "project.json.bad-number"),
    ("number out of range", "project.json.large-number"),
    ("key must be a string", "project.json.bare-key"),
    ("trailing comma", "project.json.last-comma"),
    ("trailing characters", "project.json.behind-end"),
    ("recursion limit exceeded", "project.json.too-deep"),
];

/// Our sentence for a message of serde, without the place; serde's own text for an unknown message.
pub(super) fn reason(message: &str) -> String {
    let known = SYNTAX.iter().find(|(text, _)| *text == message).map(|(_, id)| words(id).to_owned());
    known.or_else(|| marks(message)).or_else(|| shape(message)).unwrap_or_else(|| message.to_owned())
}

/// Marks that are missing, and characters that do not belong into a text.
fn marks(message: &str) -> Option<String> {
    if message.starts_with("control character ") {
        return Some(words("project.json.control-character").to_owned());
    }
    let marks = message.strip_prefix("expected `")?.strip_suffix('`')?;
    let marks: Vec<String> = marks.split("` or `").map(|mark| format!("`{mark}`")).collect();
    Some(sentence(&msg!("project.json.expected", marks = either(&marks))))
}

/// Sentence about a key or a kind of value that does not fit the expected shape.
fn shape(message: &str) -> Option<String> {
    let key = |kind: &str| message.strip_prefix(kind).and_then(|key| key.strip_suffix('`'));
    if let Some(key) = key("missing field `") {
        return Some(sentence(&msg!("project.json.missing-key", key = clip(key))));
    }
    if let Some(key) = key("duplicate field `") {
        return Some(sentence(&msg!("project.json.key-twice", key = clip(key))));
    }
    for kind in ["unknown field `", "unknown variant `"] {
        if let Some((name, known)) = message.strip_prefix(kind).and_then(|rest| rest.rsplit_once("`, expected ")) {
            let known = listed(known.split('`').skip(1).step_by(2));
            return Some(sentence(&msg!("project.json.unknown", name = clip(name), known)));
        }
    }
    let (found, expected) = message.strip_prefix("invalid type: ")?.rsplit_once(", expected ")?;
    Some(sentence(&msg!("project.json.other-kind", found = found_kind(found), expected = expected_kind(expected))))
}

/// The kind of a value that serde found, `integer `3``.
fn found_kind(found: &str) -> String {
    let kind = match found.split(' ').next().unwrap_or_default() {
        "null" | "unit" | "Option" => "project.json.null",
        "boolean" => "project.json.flag",
        "integer" | "floating" | "number" => "project.json.number",
        "string" | "character" => "project.json.text",
        "sequence" => "project.json.list",
        "map" => "project.json.object",
        _ => return clip(found),
    };
    words(kind).to_owned()
}

/// The kind of a value that serde reads: `a string`, `u32`, `struct RequestV1`.
fn expected_kind(expected: &str) -> String {
    let kind = match expected {
        "a boolean" => "project.json.flag",
        "a string" | "a borrowed string" => "project.json.text",
        "a sequence" => "project.json.list",
        "a map" => "project.json.object",
        "u8" | "u16" | "u32" | "u64" | "usize" | "i8" | "i16" | "i32" | "i64" | "isize" | "f32" | "f64" => {
            "project.json.number"
        }
        of_ours if of_ours.starts_with("struct ") => "project.json.object",
        _ => return expected.to_owned(),
    };
    words(kind).to_owned()
}
