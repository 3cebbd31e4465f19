//! Cache of words without findings: long programs repeat one form of block with other numbers.

use crate::controls::Address;
use crate::nc::{Word, WordValue};

/// Cache: a word already checked without findings, and the value range for which that holds.
pub(super) struct Clean {
    pub(super) word: Word,
    pub(super) least: i64,
    pub(super) most: i64,
    /// Whether the range may grow: true for lengths and feeds; other numbers may each have their own meaning.
    pub(super) ranges: bool,
}

impl Clean {
    /// Whether a word differs from this one at most in its value.
    pub(super) fn is_like(&self, word: &Word) -> bool {
        let (WordValue::Number(a), WordValue::Number(b)) = (self.word.value, word.value) else { return false };
        (self.word.letter, self.word.index, self.word.form, a.scale, a.point)
            == (word.letter, word.index, word.form, b.scale, b.point)
            && (self.ranges || a.mantissa == b.mantissa)
    }

    pub(super) fn holds(&self, word: &Word) -> bool {
        matches!(word.value, WordValue::Number(n) if (self.least..=self.most).contains(&n.mantissa))
            && self.is_like(word)
    }
}

/// Whether a word is a G code or a code with a name.
pub(super) fn is_code(word: &Word) -> bool {
    matches!(word.letter, Address::G | Address::Name)
}
