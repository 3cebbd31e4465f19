//! Misspelt names, prose and arithmetic: the known name closest to a name, and whether a text is prose or arithmetic.

use super::keywords::{COMPARISONS, OPERATORS};
use crate::controls::syntax::Function;

/// Index of the name closest to a misspelt one: at most one wrong, missing, extra or exchanged letter, two in a long name.
pub(in crate::nc) fn meant<'n>(name: &str, names: impl Iterator<Item = &'n str>) -> Option<usize> {
    let most = if name.len() > 4 { 2 } else { 1 };
    let near = names.enumerate().map(|(at, known)| (distance(name.as_bytes(), known.as_bytes()), at));
    near.filter(|&(distance, _)| distance <= most).min().map(|(_, at)| at)
}

/// Whether several names are as close to a misspelt one as [`meant`] is.
pub(in crate::nc) fn several_meant<'n>(name: &str, names: impl Iterator<Item = &'n str> + Clone) -> bool {
    let near = || names.clone().map(|known| distance(name.as_bytes(), known.as_bytes()));
    near().min().is_some_and(|least| near().filter(|distance| *distance == least).count() > 1)
}

/// Edit distance between two names: letters to insert, delete, change, or exchange with the next.
fn distance(a: &[u8], b: &[u8]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut next = vec![i + 1];
        for (j, y) in b.iter().enumerate() {
            let mut least = (row[j] + usize::from(x != y)).min(row[j + 1] + 1).min(next[j] + 1);
            if i > 0 && j > 0 && a[i - 1] == *y && b[j - 1] == *x {
                least = least.min(before[j - 1] + 1);
            }
            next.push(least);
        }
        before = row;
        row = next;
    }
    row.last().copied().unwrap_or(0)
}

/// Whether the text looks like prose: two or more runs of letters, one of them long.
pub(in crate::nc) fn prose(rest: &[u8]) -> bool {
    let runs = rest.split(|b| !b.is_ascii_alphabetic()).filter(|run| run.len() >= 2);
    let (count, longest) = runs.fold((0, 0), |(count, longest), run| (count + 1, longest.max(run.len())));
    let start = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    start >= 2 && longest >= 3 && (count >= 2 || start == rest.len())
}

/// Whether a text that looks like prose holds a keyword, an assignment, a comparison or a quotation, so that it may be a statement.
pub(in crate::nc) fn states(rest: &[u8], keywords: &[&str]) -> bool {
    let is = |run: &[u8]| keywords.iter().any(|word| word.as_bytes().eq_ignore_ascii_case(run));
    let mut runs = rest.split(|b| !b.is_ascii_alphabetic()).filter(|run| !run.is_empty());
    // `ENDX` is a misspelt END.
    let first = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let misspelt = rest.get(..first).and_then(<[u8]>::split_last).is_some_and(|(_, head)| is(head));
    misspelt || rest.iter().any(|b| matches!(b, b'=' | b'<' | b'>' | b'"')) || runs.any(is)
}

/// Whether a name is a letter followed by the letter O in place of the digit 0: `XO`, `RO5`.
pub(in crate::nc) fn zero_as_letter(name: &str) -> bool {
    let mut bytes = name.bytes().map(|b| b.to_ascii_uppercase());
    bytes.next().is_some_and(|b| b.is_ascii_alphabetic())
        && bytes.next() == Some(b'O')
        && bytes.all(|b| b == b'O' || b.is_ascii_digit())
}

/// Whether the letter O behind the letter at the start of a text is meant as the digit 0: `MO6 T01`, `S1OOO`, `GOO XO YO`. Without a digit in
/// the word, what follows has to be words too: `TO START` is none.
pub(in crate::nc) fn zero_behind_letter(rest: &[u8]) -> bool {
    let plain = rest.split(|b| matches!(b, b'[' | b'#')).next().unwrap_or_default();
    let mut pieces = pieces(plain);
    let Some(word) = pieces.next().filter(|word| is_words(word)) else { return false };
    has_digit(word) || pieces.all(|piece| has_digit(piece) || is_words(piece))
}

/// Whether a text holds a word of the language outside round brackets, such as `T01` or `XO`, so that it may be more than a remark.
pub(in crate::nc) fn holds_word(rest: &[u8]) -> bool {
    let plain = |piece: &[u8]| PLAIN_WORDS.iter().any(|word| word.as_bytes().eq_ignore_ascii_case(piece));
    pieces(rest).any(|piece| is_words(piece) && !plain(piece))
}

/// Whether the text of a formula with an operator is not in one pair of square brackets.
pub(in crate::nc) fn needs_brackets(formula: &[u8]) -> bool {
    let mut depth = 0_i32;
    let closed = formula.iter().position(|&byte| {
        depth += i32::from(byte == b'[') - i32::from(byte == b']');
        depth <= 0
    });
    // Behind the closing bracket a round one is that of a comment, on a control that calculates with round ones, too.
    let rest = closed.map(|at| formula.get(at + 1..).unwrap_or_default().trim_ascii_start());
    rest.is_none_or(|rest| !rest.is_empty() && !rest.starts_with(b"("))
}

/// Whether a text is letters, spaces and punctuation alone and begins with one of these keywords: no statement, for every one has a number, a
/// variable or a bracket behind its keyword.
pub(in crate::nc) fn keyword_in_prose(rest: &[u8], keywords: &[&str]) -> bool {
    let first = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let first = rest.get(..first).unwrap_or_default();
    keywords.iter().any(|word| word.as_bytes().eq_ignore_ascii_case(first))
        && rest.iter().all(|b| b.is_ascii_alphabetic() || b" .,:!?'-".contains(b))
        && !holds_macro(rest)
        && !holds_word(rest)
}

/// Whether a text holds a part of a macro statement outside round brackets: a variable and a square bracket, `DO1`, `END1` or `GOTO`.
pub(in crate::nc) fn holds_macro(rest: &[u8]) -> bool {
    let numbered = |piece: &[u8], word: &str| {
        let (head, digits) = piece.split_at_checked(word.len()).unwrap_or_default();
        head.eq_ignore_ascii_case(word.as_bytes()) && digits.first().is_some_and(u8::is_ascii_digit)
    };
    let keyword = |piece: &[u8]| {
        numbered(piece, "DO")
            || numbered(piece, "END")
            || numbered(piece, "GOTO")
            || piece.eq_ignore_ascii_case(b"GOTO")
    };
    rest.contains(&b'[') && rest.contains(&b'#') || pieces(rest).any(keyword)
}

/// Words of plain language that also read as a letter with a zero.
const PLAIN_WORDS: [&str; 5] = ["DO", "NO", "SO", "TO", "TOO"];

/// The pieces of a text outside round brackets: letters, digits, points and signs.
fn pieces(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    let mut comment = false;
    let parts = text.split(move |&b| {
        let inside = comment;
        comment = b == b'(' || comment && b != b')';
        inside || comment || !(b.is_ascii_alphanumeric() || matches!(b, b'.' | b'+' | b'-'))
    });
    parts.filter(|piece| !piece.is_empty())
}

fn has_digit(piece: &[u8]) -> bool {
    piece.iter().any(u8::is_ascii_digit)
}

/// Whether a piece of text is words alone: letters, each with a number in which letters O may stand for zeros. Numbers of letters O alone
/// belong to codes and axes, so that `POS1` is a name.
fn is_words(piece: &[u8]) -> bool {
    let mut rest = piece;
    while let Some((letter, tail)) = rest.split_first() {
        let tail = tail.strip_prefix(b"-").or(tail.strip_prefix(b"+")).unwrap_or(tail);
        let len = tail.iter().take_while(|b| matches!(b, b'O' | b'o' | b'.' | b'0'..=b'9')).count();
        let (number, after) = tail.split_at(len);
        let named = !has_digit(number) && !after.is_empty() && !b"GMXYZgmxyz".contains(letter);
        if !letter.is_ascii_alphabetic() || number.is_empty() || named {
            return false;
        }
        rest = after;
    }
    !piece.is_empty()
}

/// Whether the text in a bracket is arithmetic and no comment: it has a digit, and all its words are operators or `functions`.
pub(in crate::nc) fn arithmetic(inner: &[u8], functions: &[(&str, Function)]) -> bool {
    let known = |word: &[u8]| {
        word.is_empty()
            || OPERATORS.iter().chain(&COMPARISONS).any(|row| row.0.as_bytes().eq_ignore_ascii_case(word))
            || functions.iter().any(|(name, _)| name.as_bytes().eq_ignore_ascii_case(word))
    };
    inner.iter().any(u8::is_ascii_digit) && inner.split(|b| !b.is_ascii_alphabetic()).all(known)
}
