//! Look-ups of one control for the reader, prepared once per read.

use crate::controls::dialect::ReadingRules;
use crate::controls::syntax::letter_bits;
use crate::controls::{Control, Dialect};
use crate::nc::codes::Codes;

/// What is looked up for every word, in the order of its first byte.
pub(in crate::nc) struct Tables<'a> {
    pub(in crate::nc) codes: &'a Codes,
    /// Bit `letter & 31`: letters of words outside macro calls.
    pub(in crate::nc) letters: u32,
    /// Bit `letter & 31`: letters that may stand only once in a block.
    pub(in crate::nc) once: u32,
    /// Bit `letter & 31`: letters whose number must not have a point.
    pub(in crate::nc) whole: u32,
    /// Bit `letter & 31`: letters of rotary axes.
    pub(in crate::nc) rotary: u32,
    /// Bit `letter & 31`: letters that may put a corner behind a motion.
    pub(in crate::nc) corners: u32,
    /// Words of a block.
    pub(in crate::nc) most_words: usize,
    /// Characters of a word with a number.
    pub(in crate::nc) word_chars: usize,
    /// The settings of the control that the reader acts on.
    pub(in crate::nc) rules: ReadingRules,
}

impl<'a> Tables<'a> {
    pub(in crate::nc) fn new(control: &Control, dialect: &Dialect, codes: &'a Codes) -> Tables<'a> {
        let mut tables = Tables {
            rules: dialect.reading,
            codes,
            letters: letter_bits(control.syntax.addresses.iter().copied().chain(control.axis_letters())),
            once: if control.syntax.address_twice { !letter_bits(b"GM".iter().copied()) } else { 0 },
            whole: 0,
            rotary: letter_bits(
                control.axes.iter().enumerate().filter(|(at, _)| dialect.is_rotary(*at)).map(|(_, row)| row.letter),
            ),
            corners: letter_bits(control.syntax.corners.iter().map(|corner| corner.0)),
            word_chars: control.syntax.word_chars as usize,
            most_words: (control.syntax.block_words as usize).min(u16::MAX as usize),
        };
        if control.syntax.point_alarm {
            // The point of G54.1 is part of its number.
            tables.whole = letter_bits(control.syntax.integer_addresses.iter().copied().filter(|&b| b != b'G'));
        }
        tables
    }
}
