//! Tokens of a line for syntax colouring, without checks.

use super::cursor::Cursor;
use super::keywords::{COMPARISONS, IGNORED_STATEMENTS, KEYWORDS, OPERATORS, SYMBOLIC_STATEMENTS};
use crate::controls::Control;
use crate::controls::syntax::Names;
use crate::text::Span;

/// Kind of a token.
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
    /// A character missing on the control.
    Error,
}

/// Operators of a language with names, besides [`OPERATORS`].
const SYMBOLIC_OPERATORS: [&str; 2] = ["NOT", "DIV"];

/// Statements, comparisons and operators of a control's macro language that are words.
pub fn keywords(control: &Control) -> Vec<&'static str> {
    let operators = OPERATORS.iter().map(|(word, _)| *word);
    if control.syntax.names().is_some() {
        return SYMBOLIC_STATEMENTS.iter().chain(&SYMBOLIC_OPERATORS).copied().chain(operators).collect();
    }
    let then = control.syntax.if_then.then_some("THEN");
    let operators = operators.filter(|word| *word != "MOD" || control.syntax.modulo);
    KEYWORDS.iter().copied().chain(then).chain(COMPARISONS.map(|(word, _)| word)).chain(operators).collect()
}

/// The tokens of a line (or of several lines), without white space, in order.
pub fn tokens(text: &str, control: &Control) -> Vec<(Span, TokenKind)> {
    let mut out = Vec::new();
    let mut base = 0;
    for line in text.split_inclusive('\n') {
        let bytes = line.strip_suffix('\n').unwrap_or(line).as_bytes();
        let mut cursor = Cursor { line: bytes, base, at: 0 };
        cursor.blank();
        while !cursor.ended() {
            let start = cursor.at;
            let named = control.syntax.names().and_then(|names| symbolic_piece(&cursor, names, control));
            let (length, kind) = named.unwrap_or_else(|| piece(&cursor, control));
            cursor.at += length;
            out.push((Span::new(base + start as u32, base + cursor.at as u32), kind));
            cursor.blank();
        }
        base += line.len() as u32;
    }
    out
}

/// Number of bytes of a number for colouring: digits and points.
fn number(cursor: &Cursor, from: usize) -> usize {
    Cursor { at: cursor.at + from, ..*cursor }.run(|byte| byte.is_ascii_digit() || byte == b'.')
}

/// Length and kind of the token at the cursor.
fn piece(cursor: &Cursor, control: &Control) -> (usize, TokenKind) {
    match cursor.peek() {
        b'(' => (cursor.enclosed(b')').0, TokenKind::Comment),
        b'%' => (1, TokenKind::Percent),
        b'#' => match (Cursor { at: cursor.at + 1, ..*cursor }).digits() {
            0 => (1, TokenKind::Operator),
            digits => (1 + digits, TokenKind::Variable),
        },
        b'0'..=b'9' | b'.' => (number(cursor, 0), TokenKind::Number),
        b'+' | b'-' | b'*' | b'/' | b'=' | b'[' | b']' | b',' | b';' | b')' => (1, TokenKind::Operator),
        b'<' | b'>' if control.syntax.comparison_signs => (1, TokenKind::Operator),
        byte if byte.is_ascii_alphabetic() => match (keyword(cursor, control), number(cursor, 1)) {
            (Some(length), _) => (length, TokenKind::Keyword),
            (None, digits @ 1..) if matches!(byte | 0x20, b'g' | b'm') => (1 + digits, TokenKind::Code),
            (None, digits @ 1..) if matches!(byte | 0x20, b'n' | b'o') => (1 + digits, TokenKind::Sequence),
            _ => (1, TokenKind::Address),
        },
        // A character of several bytes is one token.
        _ => (1 + (Cursor { at: cursor.at + 1, ..*cursor }).run(|byte| byte & 0xC0 == 0x80), TokenKind::Error),
    }
}

/// Length of the keyword or function name at the cursor.
fn keyword(cursor: &Cursor, control: &Control) -> Option<usize> {
    let words = KEYWORDS.iter().chain(&["THEN"]).chain(&IGNORED_STATEMENTS).copied();
    let operators = OPERATORS.iter().chain(&COMPARISONS).map(|(word, _)| *word);
    let functions = control.syntax.functions.iter().map(|(word, _)| *word);
    words.chain(operators).chain(functions).filter(|word| cursor.ahead(word)).map(str::len).max()
}

/// Length and kind of a token that only languages with names have.
fn symbolic_piece(cursor: &Cursor, names: &Names, control: &Control) -> Option<(usize, TokenKind)> {
    match cursor.peek() {
        b';' => Some((cursor.rest().len(), TokenKind::Comment)),
        b'%' => Some((cursor.rest().len(), TokenKind::Sequence)),
        b'"' => Some((cursor.enclosed(b'"').0, TokenKind::Comment)),
        b'(' | b':' => Some((1, TokenKind::Operator)),
        byte if byte.is_ascii_alphabetic() || byte == b'_' => Some(name(cursor, names, control)),
        _ => None,
    }
}

/// Length and kind of the name or word at the cursor.
fn name(cursor: &Cursor, names: &Names, control: &Control) -> (usize, TokenKind) {
    // An address is one letter, without another letter after it.
    if cursor.peek() != b'_' && !cursor.byte(1).is_ascii_alphabetic() && cursor.byte(1) != b'_' {
        return match (cursor.peek() | 0x20, number(cursor, 1)) {
            (b'g' | b'm', digits @ 1..) => (1 + digits, TokenKind::Code),
            (b'n', digits @ 1..) => (1 + digits, TokenKind::Sequence),
            (b'r', 1..) => (1 + Cursor { at: cursor.at + 1, ..*cursor }.digits(), TokenKind::Variable),
            _ => (1, TokenKind::Address),
        };
    }
    let name = cursor.name();
    let is = |word: &str| name.eq_ignore_ascii_case(word);
    let words = SYMBOLIC_STATEMENTS.iter().chain(&SYMBOLIC_OPERATORS).copied();
    let operators = OPERATORS.iter().map(|(word, _)| *word);
    let functions = control.syntax.functions.iter().map(|(word, _)| *word);
    let kind = if names.code(&name.to_ascii_uppercase()).is_some() {
        TokenKind::Code
    } else if words.chain(operators).chain(functions).any(is) {
        TokenKind::Keyword
    } else if cursor.byte(name.len()) == b':' {
        TokenKind::Sequence
    } else {
        TokenKind::Address
    };
    (name.len(), kind)
}
