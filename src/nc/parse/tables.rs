//! Look-ups of one control for the reader, prepared once per read.

use crate::controls::dialect::ReadingRules;
use crate::controls::{Address, AddressSet, Control, Dialect};
use crate::nc::codes::Codes;

/// Letters allowed only once in a block, on controls with such a rule.
const ONCE: AddressSet = AddressSet::letters("ABCDEFHIJKLNOPQRSTUVWXYZ");

/// Look-ups for every word.
pub(in crate::nc) struct Tables<'a> {
    pub(in crate::nc) codes: &'a Codes,
    /// Letters of words outside macro calls.
    pub(in crate::nc) letters: AddressSet,
    /// Letters allowed only once in a block.
    pub(in crate::nc) once: AddressSet,
    /// Letters of integer words: no decimal point allowed.
    pub(in crate::nc) whole: AddressSet,
    /// Letters of rotary axes.
    pub(in crate::nc) rotary: AddressSet,
    /// Letters that insert a corner after a motion.
    pub(in crate::nc) corners: AddressSet,
    /// Maximum words of a block.
    pub(in crate::nc) most_words: usize,
    /// Maximum characters of a word with a number.
    pub(in crate::nc) word_chars: usize,
    /// Reading rules of the control under its settings.
    pub(in crate::nc) rules: ReadingRules,
}

impl<'a> Tables<'a> {
    pub(in crate::nc) fn new(control: &Control, dialect: &Dialect, codes: &'a Codes) -> Tables<'a> {
        let mut tables = Tables {
            rules: dialect.reading,
            codes,
            letters: control.syntax.addresses.or(control.axis_letters().collect()),
            once: if control.syntax.address_twice { ONCE } else { AddressSet::EMPTY },
            whole: AddressSet::EMPTY,
            rotary: (control.axes.iter().enumerate())
                .filter(|(at, _)| dialect.is_rotary(*at))
                .map(|(_, row)| row.letter)
                .collect(),
            corners: control.syntax.corners.iter().map(|corner| corner.0).collect(),
            word_chars: control.syntax.word_chars as usize,
            most_words: (control.syntax.block_words as usize).min(u16::MAX as usize),
        };
        if control.syntax.point_alarm {
            // The point of G54.1 is part of its number.
            tables.whole = control.syntax.integer_addresses.without(Address::G);
        }
        tables
    }
}
