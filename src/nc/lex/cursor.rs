//! [`Cursor`]: the lexer. A position in the bytes of a block, and functions for the lexical elements after it.

use crate::nc::dec::Dec;

/// Mantissa below which one more digit fits an `i64`.
const FULL: i64 = 100_000_000_000_000_000;

/// A line of a file, or one block of it, and a position in it.
#[derive(Debug, Clone, Copy)]
pub(in crate::nc) struct Cursor<'a> {
    /// Bytes of the block.
    pub(in crate::nc) line: &'a [u8],
    /// Start of the block in the file, in bytes.
    pub(in crate::nc) base: u32,
    /// Position from the start of the block, in bytes.
    pub(in crate::nc) at: usize,
}

/// An unsigned decimal as written.
#[derive(Debug, Clone, Copy)]
pub(in crate::nc) struct Digits {
    pub(in crate::nc) value: Dec,
    /// Length in bytes, the point included.
    pub(in crate::nc) length: usize,
    /// More digits than `value` can hold.
    pub(in crate::nc) full: bool,
    /// The byte after the number; 0 at the end.
    pub(in crate::nc) after: u8,
}

impl<'a> Cursor<'a> {
    /// The byte at the cursor; 0 at the end of the block.
    #[inline]
    pub(in crate::nc) fn peek(&self) -> u8 {
        self.line.get(self.at).copied().unwrap_or(0)
    }

    /// A byte after the cursor; 0 beyond the end of the block.
    #[inline]
    pub(in crate::nc) fn byte(&self, offset: usize) -> u8 {
        self.line.get(self.at + offset).copied().unwrap_or(0)
    }

    /// The bytes from the cursor on.
    #[inline]
    pub(in crate::nc) fn rest(&self) -> &'a [u8] {
        self.line.get(self.at..).unwrap_or_default()
    }

    #[inline]
    pub(in crate::nc) fn ended(&self) -> bool {
        self.at >= self.line.len()
    }

    /// Passes white space.
    pub(in crate::nc) fn blank(&mut self) {
        while matches!(self.peek(), b' ' | b'\t' | b'\r') {
            self.at += 1;
        }
    }

    /// Whether a word is at the cursor, ignoring case.
    pub(in crate::nc) fn ahead(&self, word: &str) -> bool {
        let rest = self.line.get(self.at..self.at + word.len());
        rest.is_some_and(|rest| rest.eq_ignore_ascii_case(word.as_bytes()))
    }

    /// The longest of some words at the cursor.
    pub(in crate::nc) fn longest<T: Copy>(&self, words: &[(&'static str, T)]) -> Option<(&'static str, T)> {
        words.iter().filter(|(word, _)| self.ahead(word)).max_by_key(|(word, _)| word.len()).copied()
    }

    /// Number of consecutive bytes of one kind at the cursor.
    pub(in crate::nc) fn run(&self, kind: impl Fn(u8) -> bool) -> usize {
        self.rest().iter().take_while(|byte| kind(**byte)).count()
    }

    /// Number of digits at the cursor.
    pub(in crate::nc) fn digits(&self) -> usize {
        self.run(|byte| byte.is_ascii_digit())
    }

    /// Whether the name at the cursor is `word`, ignoring case. Unlike [`name`](Self::name) it reads no more of the line than the word.
    pub(in crate::nc) fn is_name(&self, word: &str) -> bool {
        self.ahead(word) && !in_name(self.byte(word.len()))
    }

    /// The name at the cursor: letters, digits and `_`; empty if there is none.
    pub(in crate::nc) fn name(&self) -> &'a str {
        let len = self.run(in_name);
        core::str::from_utf8(self.rest().get(..len).unwrap_or_default()).unwrap_or("")
    }

    /// Length in bytes of the comment or text at the cursor, opening and closing byte included, and whether it is closed in this line.
    pub(in crate::nc) fn enclosed(&self, close: u8) -> (usize, bool) {
        let rest = self.rest();
        match rest.iter().skip(1).position(|byte| *byte == close) {
            Some(inner) => (inner + 2, true),
            None => (rest.len(), false),
        }
    }

    /// Reads an unsigned number: digits with at most one point.
    #[inline]
    pub(in crate::nc) fn take_digits(&mut self) -> Digits {
        let (mut mantissa, mut scale, mut point, mut full) = (0_i64, 0_u8, false, false);
        let (mut length, mut after) = (0, 0);
        for &byte in self.rest() {
            let digit = byte.wrapping_sub(b'0');
            if digit < 10 {
                if mantissa >= FULL || scale >= 18 {
                    full = true;
                } else {
                    mantissa = mantissa * 10 + i64::from(digit);
                    scale += u8::from(point);
                }
            } else if byte == b'.' && !point {
                point = true;
            } else {
                after = byte;
                break;
            }
            length += 1;
        }
        self.at += length;
        Digits { value: Dec { mantissa, scale, point }, length, full, after }
    }
}

/// Whether a name may contain the byte.
fn in_name(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}
