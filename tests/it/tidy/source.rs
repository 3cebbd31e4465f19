//! The project's own sources as the laws read them: code without comments, strings apart, words with their lines.

use std::fs;
use std::path::Path;

/// A string literal of the code.
pub(super) struct Literal {
    /// Offset of its opening quote.
    pub(super) at: usize,
    /// Its content, escapes as they were written.
    pub(super) text: String,
}

/// One source file.
pub(super) struct Source {
    /// Path in the repository, with `/`.
    pub(super) path: String,
    /// The file as it is.
    pub(super) text: String,
    /// The same, byte for byte in place, with comments and the contents of strings and characters blanked.
    pub(super) code: String,
    /// Every string literal, in order.
    pub(super) literals: Vec<Literal>,
    /// Where its unit tests begin (the end of the file when there are none).
    pub(super) shipped: usize,
}

impl Source {
    /// Reads every `.rs` below a folder of the repository.
    pub(super) fn all_in(folder: &str) -> Vec<Source> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let mut found = Vec::new();
        let mut folders = vec![root.join(folder)];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(&folder).into_iter().flatten() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|kind| kind == "rs") {
                    let name = path.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/");
                    found.push(Source::new(name, fs::read_to_string(&path).unwrap()));
                }
            }
        }
        found.sort_by(|a, b| a.path.cmp(&b.path));
        found
    }

    fn new(path: String, text: String) -> Source {
        let (code, literals) = strip(&text);
        let shipped = if path.ends_with("/tests.rs") { 0 } else { code.find("#[cfg(test)]").unwrap_or(code.len()) };
        Source { path, text, code, literals, shipped }
    }

    /// The modules that the file stands in, from the crate's root: `["nc", "lex"]`; none for `lib.rs` and the binaries.
    pub(super) fn modules(&self) -> Vec<&str> {
        let path = self.path.strip_prefix("src/").unwrap_or_default();
        let path = path.strip_suffix(".rs").unwrap_or_default();
        let path = path.strip_suffix("/mod").unwrap_or(path);
        if matches!(path, "" | "lib" | "main") || path.starts_with("bin/") { vec![] } else { path.split('/').collect() }
    }

    /// Whether an offset is shipped code, not one of its unit tests.
    pub(super) fn ships(&self, at: usize) -> bool {
        at < self.shipped
    }

    /// `path:line` of an offset.
    pub(super) fn place(&self, at: usize) -> String {
        format!("{}:{}", self.path, self.text[..at].matches('\n').count() + 1)
    }

    /// Every identifier and keyword of the code, with its offset.
    pub(super) fn words(&self) -> impl Iterator<Item = (usize, &str)> {
        words(&self.code)
    }

    /// Where the shipped code has one of these words.
    pub(super) fn find_words(&self, wanted: &[&str]) -> Vec<String> {
        let hits = self.words().filter(|(at, word)| self.ships(*at) && wanted.contains(word));
        hits.map(|(at, word)| format!("{}: {word}", self.place(at))).collect()
    }

    /// Where the shipped code has one of these pieces of text.
    pub(super) fn find_text(&self, wanted: &[&str]) -> Vec<String> {
        let code = &self.code[..self.shipped];
        let hits = wanted.iter().flat_map(|text| code.match_indices(text));
        hits.map(|(at, text)| format!("{}: {text}", self.place(at))).collect()
    }
}

/// The words of a text, with their offsets. A word is letters, digits and `_`, and begins with no digit.
pub(super) fn words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut rest = 0;
    std::iter::from_fn(move || {
        let inside = |c: char| c.is_alphanumeric() || c == '_';
        loop {
            let begin = rest + text[rest..].find(inside)?;
            let end = begin + text[begin..].find(|c| !inside(c)).unwrap_or(text.len() - begin);
            rest = end;
            if !text[begin..].starts_with(|c: char| c.is_ascii_digit()) {
                return Some((begin, &text[begin..end]));
            }
        }
    })
}

/// Blanks comments and the contents of literals with spaces, so that every offset stays, and collects the strings.
fn strip(text: &str) -> (String, Vec<Literal>) {
    let bytes = text.as_bytes();
    let mut code = bytes.to_vec();
    let mut literals = Vec::new();
    let mut at = 0;
    let blank = |code: &mut [u8], from: usize, to: usize| {
        code[from..to].iter_mut().filter(|byte| **byte != b'\n').for_each(|byte| *byte = b' ');
    };
    while at < bytes.len() {
        let rest = &text[at..];
        let word_before = at > 0 && (bytes[at - 1].is_ascii_alphanumeric() || bytes[at - 1] == b'_');
        if rest.starts_with("//") {
            let end = at + rest.find('\n').unwrap_or(rest.len());
            blank(&mut code, at, end);
            at = end;
        } else if rest.starts_with("/*") {
            let end = at + comment_length(rest);
            blank(&mut code, at, end);
            at = end;
        } else if let Some((open, close)) = raw_quotes(rest).filter(|_| !word_before) {
            let begin = at + open;
            let length = text[begin..].find(&close).unwrap_or(text.len() - begin);
            literals.push(Literal { at, text: text[begin..begin + length].to_owned() });
            blank(&mut code, begin, begin + length);
            at = (begin + length + close.len()).min(bytes.len());
        } else if bytes[at] == b'"' {
            let length = quoted_length(&bytes[at + 1..], b'"');
            literals.push(Literal { at, text: text[at + 1..at + 1 + length].to_owned() });
            blank(&mut code, at + 1, at + 1 + length);
            at += length + 2;
        } else if bytes[at] == b'\'' && is_character(rest) {
            let length = quoted_length(&bytes[at + 1..], b'\'');
            blank(&mut code, at + 1, at + 1 + length);
            at += length + 2;
        } else {
            at += rest.chars().next().map_or(1, char::len_utf8);
        }
    }
    (String::from_utf8(code).unwrap(), literals)
}

/// Length of the block comment that a text begins with; they nest.
fn comment_length(text: &str) -> usize {
    let mut depth = 0;
    for (at, _) in text.char_indices() {
        if text[at..].starts_with("/*") {
            depth += 1;
        } else if text[at..].starts_with("*/") {
            depth -= 1;
            if depth == 0 {
                return at + 2;
            }
        }
    }
    text.len()
}

/// Length of the opening of the raw string that a text begins with, and its closing.
fn raw_quotes(text: &str) -> Option<(usize, String)> {
    let tail = text.strip_prefix("br").or_else(|| text.strip_prefix('r'))?;
    let hashes = tail.len() - tail.trim_start_matches('#').len();
    let open = text.len() - tail.len() + hashes + 1;
    tail[hashes..].starts_with('"').then(|| (open, format!("\"{}", "#".repeat(hashes))))
}

/// Bytes up to the closing quote, past escapes.
fn quoted_length(bytes: &[u8], quote: u8) -> usize {
    let mut at = 0;
    while at < bytes.len() && bytes[at] != quote {
        at += if bytes[at] == b'\\' { 2 } else { 1 };
    }
    at.min(bytes.len())
}

/// Whether a text that begins with `'` begins with a character and not with a lifetime.
fn is_character(text: &str) -> bool {
    let mut chars = text[1..].chars();
    match chars.next() {
        Some('\\') => true,
        Some(_) => chars.next() == Some('\''),
        None => false,
    }
}

#[test]
fn code_is_told_from_comments_and_strings() {
    let text = r##"let a = "x \" // no"; // c "d"
/* e /* f */ g */ let b = ('"', 'l', '\'', r#"raw " h"#, b"i"); fn j<'k>() {}"##;
    let source = Source::new("src/nc/lex.rs".to_owned(), text.to_owned());
    let found: Vec<&str> = source.words().map(|(_, word)| word).collect();
    assert_eq!(found, ["let", "a", "let", "b", "r", "b", "fn", "j", "k"]);
    let strings: Vec<&str> = source.literals.iter().map(|literal| literal.text.as_str()).collect();
    assert_eq!(strings, [r#"x \" // no"#, "raw \" h", "i"]);
    assert_eq!((source.modules(), source.code.len()), (vec!["nc", "lex"], text.len()));
}
