//! Laws for tests: a short name of condition and result, and no assertion on wall-clock time.

use super::hold;
use super::source::Source;

/// Characters that a test's name may have.
const LONGEST: usize = 59;

/// Endings of test names that do not state a result.
const VAGUE: [&str; 8] = ["_works", "_is_ok", "_test", "_told", "_said", "_says_so", "_says_it", "_stands"];

fn tests() -> impl Iterator<Item = &'static Source> {
    Source::all().iter().filter(|source| source.path.starts_with("tests/") || source.path.starts_with("src/ui/"))
}

/// The names of the functions after `#[test]` and `#[wasm_bindgen_test]`, with their lines.
fn names(source: &Source) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    for (at, token) in source.tokens.iter().enumerate() {
        let is_attribute = matches!(token.text.as_str(), "test" | "wasm_bindgen_test");
        if !is_attribute || source.tokens.get(at + 1).is_none_or(|next| next.text != "]" && next.text != ")") {
            continue;
        }
        let behind = &source.tokens[at..source.tokens.len().min(at + 60)];
        let name = behind.windows(2).find(|pair| pair[0].text == "fn").map(|pair| &pair[1]);
        found.extend(name.map(|name| (name.line, name.text.as_str())));
    }
    found.dedup();
    found
}

#[test]
fn test_names_are_short_and_specific() {
    let mut broken = Vec::new();
    for source in tests() {
        for (line, name) in names(source) {
            if name.len() > LONGEST || VAGUE.iter().any(|ending| name.ends_with(ending)) {
                broken.push(format!("{}: {name}", source.place(line)));
            }
        }
    }
    let mend = "say condition and result in under 60 characters: reset_mid_cut_then_start_raises_alarm";
    hold("The name of a test says its condition and its result.", mend, broken);
}

#[test]
fn tests_read_no_wall_clock() {
    let clocks = ["Instant", "SystemTime", "elapsed"];
    let mut broken = Vec::new();
    for source in tests() {
        let hits = source.tokens.iter().filter(|token| token.kind == super::source::TokenKind::Word);
        let hits = hits.filter(|token| clocks.contains(&token.text.as_str()));
        broken.extend(hits.map(|token| format!("{}: {}", source.place(token.line), token.text)));
    }
    let mend = "count steps, measure processor time with room, or write a bench";
    hold("A busy machine fails no test.", mend, broken);
}
