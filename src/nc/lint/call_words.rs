//! Words beside a macro call that are no arguments of it, or only on some controls.

use super::super::ast::{Block, Word};
use super::again::REPORTED_WORDS;
use super::context::Lint;
use super::roles::{CALL, Roles};
use crate::controls::{Address, Alarm};
use crate::msg;
use crate::text::Message;

impl Lint<'_> {
    /// Reports a word in front of the code that calls a macro, and one behind it with a letter that no argument has, on controls without
    /// an alarm for it; on a control whose calls by code stand alone, also the first command beside one.
    #[cold]
    pub(super) fn call_words(&mut self, roles: &Roles, (at, block): (u32, &Block), words: &[Word]) {
        let Some(index) = words.iter().position(|word| roles.word(word) & CALL != 0) else { return };
        let (before, [call, behind @ ..]) = words.split_at(index) else { return };
        let alone = self.control.macros.code_calls_alone && self.parsed.codes().call_of(call).is_some();
        let control = self.control;
        let raises = |alarm: Option<Alarm>| alarm.is_some_and(|alarm| control.raises(alarm));
        let mut report = |word: Option<&Word>, alarm, message: fn(&str, &str) -> Message| {
            let Some(word) = word.filter(|_| self.again < REPORTED_WORDS && !raises(alarm)) else { return };
            self.again += 1;
            let call = self.written(at, call.span(block)).1;
            let (place, word) = self.written(at, word.span(block));
            self.warn(place, message(word, call));
        };
        if is_code(call) {
            let argument = before.iter().find(|word| !is_code(word) && word.letter != Address::Skip);
            report(argument, Some(Alarm::CallNotFirst), |word, call| msg!("lint.argument-before-call", word, call));
        }
        if alone {
            let command = |word: &&Word| matches!(word.letter, Address::M | Address::S | Address::T);
            let first = before.iter().filter(|word| word.letter == Address::M).chain(behind).find(command);
            // No alarm of a control is known for it.
            report(first, None, |word, call| msg!("lint.call-not-alone", word, call));
        }
        let other = behind.iter().find(|word| matches!(word.letter, Address::G | Address::N | Address::O));
        report(other, Some(Alarm::ArgumentAddress), |word, call| msg!("lint.no-argument", word, call));
    }
}

fn is_code(word: &Word) -> bool {
    matches!(word.letter, Address::G | Address::M)
}
