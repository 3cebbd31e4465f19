//! A line of a program as pieces for colouring: what each is, not whether it is right.

use crate::controls::Control;
use crate::text::Span;

/// What a piece is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TokenKind {
    /// `( … )`.
    Comment,
    /// A G or M word with its number.
    Code,
    /// `N10`, `O9100`.
    Sequence,
    /// Any other address letter.
    Address,
    /// `#104`.
    Variable,
    /// A number.
    Number,
    /// `IF`, `GOTO`, functions, comparisons.
    Keyword,
    /// Signs and brackets.
    Operator,
    /// `%`.
    Percent,
    /// A character that the control lacks.
    Error,
}

const KEYWORDS: [&str; 20] = [
    "WHILE", "POPEN", "PCLOS", "DPRNT", "SETVN", "GOTO", "THEN", "END", "AND", "XOR", "MOD", "IF", "DO", "OR", "EQ",
    "NE", "GT", "GE", "LT", "LE",
];

/// The pieces of a line (or of several lines), without white space, in order.
pub fn tokens(text: &str, control: &Control) -> Vec<(Span, TokenKind)> {
    let bytes = text.as_bytes();
    let named = control.syntax.names();
    let mut out = Vec::new();
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        let start = at;
        let rest = text.get(start..).unwrap_or("");
        let digits = |rest: &str| rest.bytes().take_while(|b| b.is_ascii_digit() || *b == b'.').count();
        let kind = match byte {
            b' ' | b'\t' | b'\r' | b'\n' => {
                at += 1;
                continue;
            }
            b';' if named.is_some() => {
                at += rest.find('\n').unwrap_or(rest.len());
                TokenKind::Comment
            }
            b'%' if named.is_some() => {
                at += rest.find('\n').unwrap_or(rest.len());
                TokenKind::Sequence
            }
            b'"' if named.is_some() => {
                let line = rest.find('\n').unwrap_or(rest.len());
                at += rest.get(1..).and_then(|rest| rest.find('"')).map_or(line, |close| (close + 2).min(line));
                TokenKind::Comment
            }
            b'(' | b':' if named.is_some() => {
                at += 1;
                TokenKind::Operator
            }
            b if (b.is_ascii_alphabetic() || b == b'_') && named.is_some() => {
                let (len, kind) = named_token(rest, control);
                at += len;
                kind
            }
            b'(' => {
                let line = rest.find('\n').unwrap_or(rest.len());
                at += rest.find(')').map_or(line, |close| (close + 1).min(line));
                TokenKind::Comment
            }
            b'%' => {
                at += 1;
                TokenKind::Percent
            }
            b'#' => {
                at += 1 + rest.bytes().skip(1).take_while(u8::is_ascii_digit).count();
                if at == start + 1 { TokenKind::Operator } else { TokenKind::Variable }
            }
            b'0'..=b'9' | b'.' => {
                at += digits(rest);
                TokenKind::Number
            }
            b'+' | b'-' | b'*' | b'/' | b'=' | b'[' | b']' | b',' | b';' | b')' => {
                at += 1;
                TokenKind::Operator
            }
            b'<' | b'>' if control.syntax.comparison_signs => {
                at += 1;
                TokenKind::Operator
            }
            b if b.is_ascii_alphabetic() => {
                let word = word(rest, control);
                if word > 0 {
                    at += word;
                    TokenKind::Keyword
                } else {
                    let number = digits(rest.get(1..).unwrap_or(""));
                    let (taken, kind) = match b.to_ascii_uppercase() {
                        b'G' | b'M' if number > 0 => (1 + number, TokenKind::Code),
                        b'N' | b'O' if number > 0 => (1 + number, TokenKind::Sequence),
                        _ => (1, TokenKind::Address),
                    };
                    at += taken;
                    kind
                }
            }
            _ => {
                at += rest.chars().next().map_or(1, char::len_utf8);
                TokenKind::Error
            }
        };
        out.push((Span::new(start as u32, at as u32), kind));
    }
    out
}

/// A word of a language with names: how long it is, and what.
fn named_token(rest: &str, control: &Control) -> (usize, TokenKind) {
    let name = rest.bytes().take_while(|b| b.is_ascii_alphanumeric() || *b == b'_').count();
    let letters = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
    let digits = rest.bytes().skip(1).take_while(|b| b.is_ascii_digit() || *b == b'.').count();
    let is = |word: &str| rest.get(..name).is_some_and(|name| name.eq_ignore_ascii_case(word));
    let names = control.syntax.names();
    if letters == 1 && name > 1 || name == 1 {
        let kind = match rest.as_bytes().first().map(u8::to_ascii_uppercase) {
            Some(b'G' | b'M') if digits > 0 => TokenKind::Code,
            Some(b'N') if digits > 0 => TokenKind::Sequence,
            Some(b'R') if digits > 0 => return (1 + digits.min(name.saturating_sub(1)), TokenKind::Variable),
            _ => return (1, TokenKind::Address),
        };
        return (1 + digits, kind);
    }
    if names.is_some_and(|names| names.code(&rest.get(..name).unwrap_or("").to_ascii_uppercase()).is_some()) {
        return (name, TokenKind::Code);
    }
    if ["GOTOF", "GOTOB", "IF", "MSG", "AND", "OR", "XOR", "NOT", "MOD", "DIV"].into_iter().any(is)
        || control.syntax.functions.iter().any(|(function, _)| is(function))
    {
        return (name, TokenKind::Keyword);
    }
    let label = rest.get(name..).is_some_and(|rest| rest.starts_with(':'));
    (name, if label { TokenKind::Sequence } else { TokenKind::Address })
}

/// Length of the keyword or function name at the head of a text, 0 where none stands there.
fn word(rest: &str, control: &Control) -> usize {
    let functions = control.syntax.functions.iter().map(|(name, _)| *name);
    let ahead = |name: &&str| rest.get(..name.len()).is_some_and(|head| head.eq_ignore_ascii_case(name));
    KEYWORDS.into_iter().chain(functions).filter(ahead).map(str::len).max().unwrap_or(0)
}
