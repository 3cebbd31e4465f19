//! Look-ups of one control for the reader, prepared once per read.

use crate::controls::dialect::ReadingRules;
use crate::controls::{Address, AddressSet, Control, Dialect};
use crate::nc::codes::Codes;

/// Letters allowed only once in a block, on controls with such a rule.
const ONCE: AddressSet = AddressSet::letters("ABCDEFHIJKLNOPQRSTUVWXYZ");

/// Look-ups for every word.
pub(super) struct Tables<'a> {
    pub(super) codes: &'a Codes,
    /// Letters of words outside macro calls.
    pub(super) letters: AddressSet,
    /// Letters allowed only once in a block.
    pub(super) once: AddressSet,
    /// Letters of integer words: no decimal point allowed.
    pub(super) whole: AddressSet,
    /// Letters of rotary axes.
    pub(super) rotary: AddressSet,
    /// Letters that insert a corner after a motion.
    pub(super) corners: AddressSet,
    /// Maximum words of a block.
    pub(super) most_words: usize,
    /// Maximum characters of a word with a number.
    pub(super) word_chars: usize,
    /// Reading rules of the control under its settings.
    pub(super) rules: ReadingRules,
}

impl<'a> Tables<'a> {
    pub(super) fn new(control: &Control, dialect: &Dialect, codes: &'a Codes) -> Tables<'a> {
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
