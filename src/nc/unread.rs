//! Parts of blocks that do not parse: codes, loop statements and names, by the tokens outside comments.

use super::ast::{Extent, Stmt};
use super::codes::{g_number, m_number};
use super::lex::cursor::Cursor;
use super::lex::tokens::{TokenKind, tokens};
use crate::controls::{CodeId, Control};
use crate::text::Span;

/// Loop number in a block that does not parse, if its number does not either.
pub(in crate::nc) const ANY_LOOP: u16 = 0;

/// Codes in the text of a block. Letters O in their numbers are read as zeros, as the parser reads them.
pub(in crate::nc) fn codes(text: &str, control: &Control) -> Vec<CodeId> {
    let code = |span: Span, kind: TokenKind| {
        if !matches!(kind, TokenKind::Code | TokenKind::Address) {
            return None;
        }
        let rest = text.get(span.start as usize..)?;
        let named = control.syntax.names().and_then(|names| names.code(&span.of(text).to_ascii_uppercase()));
        if let Some(at) = named.and_then(|at| u16::try_from(at).ok()) {
            return Some(CodeId::Named(at));
        }
        let digits = rest.bytes().skip(1).take_while(|byte| matches!(byte, b'0'..=b'9' | b'O' | b'o' | b'.'));
        let digits: Vec<u8> = digits.map(|byte| if byte | 0x20 == b'o' { b'0' } else { byte }).collect();
        let number = Cursor { line: &digits, base: 0, at: 0 }.take_digits().value;
        match rest.as_bytes().first().map(|letter| letter | 0x20) {
            _ if digits.is_empty() => None,
            Some(b'g') => g_number(number).map(CodeId::G),
            Some(b'm') => m_number(number).map(CodeId::M),
            _ => None,
        }
    };
    tokens(text, control).into_iter().filter_map(|(span, kind)| code(span, kind)).collect()
}

/// Whether the text of a block has a G word, with a constant number or a calculated one.
pub(in crate::nc) fn has_g_word(text: &str, control: &Control) -> bool {
    let is_g = |(span, kind): &(Span, TokenKind)| {
        let word = *kind == TokenKind::Code || *kind == TokenKind::Address && span.end - span.start == 1;
        word && span.of(text).starts_with(['G', 'g'])
    };
    tokens(text, control).iter().any(is_g)
}

/// The loop statement in the text of a block, with [`ANY_LOOP`] for a number that is missing or out of range.
pub(in crate::nc) fn loop_statement(text: &str, control: &Control) -> Option<Stmt> {
    // A file of garbage has millions of such blocks, nearly all without these words.
    let named =
        |word: &&str| text.as_bytes().windows(word.len()).any(|part| part.eq_ignore_ascii_case(word.as_bytes()));
    if !["DO", "END", "WHILE"].iter().any(named) {
        return None;
    }
    let pieces = tokens(text, control);
    let is = |at: usize, word: &str| {
        let piece = pieces.get(at).filter(|(_, kind)| *kind == TokenKind::Keyword);
        piece.is_some_and(|(span, _)| span.of(text).eq_ignore_ascii_case(word))
    };
    // `ENDWHILE` and `ENDDO` are ends of loops.
    let joined = |at: usize| pieces.get(at).zip(pieces.get(at + 1)).is_some_and(|(a, b)| a.0.end == b.0.start);
    let other_end = |at: usize| is(at, "END") && joined(at) && (is(at + 1, "WHILE") || is(at + 1, "DO"));
    let last = |word: &str| (0..pieces.len()).rev().find(|at| is(*at, word));
    // Number and bytes of the keyword at `at` with its number.
    let labelled = |at: usize| {
        let (head, _) = *pieces.get(at)?;
        let number = pieces.get(at + 1).filter(|(_, kind)| *kind == TokenKind::Number);
        let label = number.and_then(|(span, _)| span.of(text).parse().ok());
        let label = label.filter(|label| (1..=control.syntax.do_max).contains(&u32::from(*label)));
        let end = number.map_or(head.end, |(span, _)| span.end);
        let bytes = |count: u32| u16::try_from(count).unwrap_or(u16::MAX);
        let keyword = Extent { offset: bytes(head.start), len: bytes(end - head.start) };
        Some((label.unwrap_or(ANY_LOOP), keyword))
    };
    let end = last("END").and_then(labelled).map(|(label, keyword)| Stmt::End { label, keyword });
    if (0..pieces.len()).any(other_end) {
        return end;
    }
    let head = last("DO").and_then(labelled);
    let head = head.or_else(|| Some((ANY_LOOP, labelled(last("WHILE")?)?.1)));
    head.map(|(label, keyword)| Stmt::While { cond: None, label, keyword }).or(end)
}

/// Names in the text of a block, in capitals: a block number may touch a name, as in `N10AGAIN:`.
pub(in crate::nc) fn names(text: &str, control: &Control) -> Vec<String> {
    let mut upper = text.to_ascii_uppercase().into_bytes();
    for (span, _) in tokens(text, control).into_iter().filter(|(_, kind)| *kind == TokenKind::Comment) {
        upper.get_mut(span.start as usize..span.end as usize).into_iter().for_each(|comment| comment.fill(b' '));
    }
    let words = upper.split(|byte| !(byte.is_ascii_alphanumeric() || *byte == b'_'));
    let words = words.flat_map(|word| {
        let rest = word.iter().skip_while(|byte| **byte == b'N').skip_while(|byte| byte.is_ascii_digit());
        [word.to_vec(), rest.copied().collect()]
    });
    words.filter(|word| !word.is_empty()).filter_map(|word| String::from_utf8(word).ok()).collect()
}
