//! Macro calls: checks of G65, G66 and codes bound to macros, before a run.

use crate::controls::Address;
use crate::controls::AddressSet;
use crate::controls::macros::CallKind;
use crate::controls::syntax::Operation;
use crate::controls::{Alarm, Code, CodeId};
use crate::msg;
use crate::nc::ast::{Word, WordValue};
use crate::nc::codes::code_of;
use crate::nc::dec::Dec;
use crate::nc::parse::reader::Reader;
use crate::text::Message;

impl Reader<'_> {
    /// Reports errors of a macro call with the words from `first` on.
    #[cold]
    pub(super) fn check_call(&mut self, first: usize) {
        let words = self.deck.words.get(first..).unwrap_or_default().to_vec();
        let Some((at, code)) = words.iter().enumerate().find_map(|(at, word)| Some((at, self.caller(word)?))) else {
            return;
        };
        let (before, after) = (words.get(..at).unwrap_or_default(), words.get(at + 1..).unwrap_or_default());
        let caller = &words[at];
        let macros = &self.control.macros;
        if macros.call_first && code.is_some() && !before.is_empty() {
            return self.call_not_first(caller);
        }
        if self.control.raises(Alarm::CallMixed)
            && let Some(word) = words.iter().find(|word| self.is_end_call_or_stop(word))
        {
            return self.report_word(Alarm::CallMixed, word, msg!("interp.call-mixed"));
        }
        let functions = code == Some(Code::MacroCall) && !macros.functions.is_empty();
        let leading = after.iter().find(|word| matches!(word.letter, Address::H | Address::P));
        if let Some(number) = leading.filter(|word| functions && word.letter == Address::H) {
            return self.check_function(number, after);
        }
        if code.is_some() && !words.iter().any(|word| word.letter == Address::P) {
            if let Some(word) = words.iter().find(|word| word.letter == Address::O) {
                return self.letter_for_p(Alarm::NoCallProgram, word.offset as usize);
            }
            return self.report_word(Alarm::NoCallProgram, caller, msg!("interp.call-without-program"));
        }
        if macros.program_next
            && code.is_some()
            && let Some(word) = after.first().filter(|word| word.letter != Address::P)
        {
            return self.report_word(Alarm::NoCallProgram, word, msg!("interp.call-program-next"));
        }
        // The number of the program is no argument: it takes no point here either.
        let program = after.iter().find(|word| word.letter == Address::P && code.is_some());
        if let Some(Word { value: WordValue::Number(number @ Dec { point: true, .. }), offset, len, .. }) = program
            && self.tables.whole.contains(Address::P)
        {
            let start = *offset as usize;
            self.needless_point((Address::P, *number), start, start + *len as usize, false);
        }
        if self.control.raises(Alarm::ArgumentAddress) {
            let forbidden = AddressSet::letters(if code.is_some() { "GNO" } else { "GNOP" });
            if let Some(word) = after.iter().find(|word| forbidden.contains(word.letter)) {
                let letter = word.letter.to_string();
                self.report_word(Alarm::ArgumentAddress, word, msg!("interp.argument-address", address = letter));
            }
        }
    }

    /// Code of a word that calls a macro; the inner `None` is a call by parameter.
    fn caller(&self, word: &Word) -> Option<Option<Code>> {
        let id = code_of(word)?;
        match self.tables.codes.call(id).map(|call| call.kind) {
            Some(CallKind::Sub) => None,
            Some(_) => Some(None),
            None => {
                let code = self.tables.codes.row(id)?.code;
                matches!(code, Code::MacroCall | Code::MacroModal | Code::MacroModalBlock).then_some(Some(code))
            }
        }
    }

    /// Meaning of an M code.
    fn m_row(&self, word: &Word) -> Option<Code> {
        let WordValue::Number(Dec { scale: 0, .. }) = word.value else { return None };
        let id = code_of(word).filter(|id| matches!(id, CodeId::M(_)))?;
        self.tables.codes.row(id).map(|row| row.code)
    }

    /// Whether a word is a program end, call or stop.
    fn is_end_call_or_stop(&self, word: &Word) -> bool {
        use Code::*;
        matches!(self.m_row(word), Some(Stop | OptionalStop | End | EndRewind | SubCall | SubEnd))
    }

    /// Whether a word calls a subprogram.
    pub(super) fn calls_sub(&self, word: &Word) -> bool {
        self.m_row(word) == Some(Code::SubCall)
    }

    /// Whether a `<` behind the words of a block from `first` on begins the name of the program that they call.
    pub(super) fn is_call_by_name(&self, first: usize) -> bool {
        let calls = |word: &Word| self.calls_sub(word) || self.caller(word).is_some();
        self.control.syntax.bracket_names && self.deck.words[first..].iter().any(calls)
    }

    /// Reports a call with the letter of a program number in place of P.
    #[cold]
    pub(super) fn letter_for_p(&mut self, alarm: Alarm, start: usize) {
        let finding = self.finding(alarm, start, start + 1, msg!("interp.call-without-program"));
        let finding = finding.hint(msg!("nc.hint.program-letter", letter = "O"));
        self.report_replacing(alarm, finding, start, start + 1, "P");
    }

    fn call_not_first(&mut self, caller: &Word) {
        let start = caller.offset as usize;
        let finding =
            self.finding(Alarm::CallNotFirst, start, start + caller.len as usize, msg!("interp.call-not-first"));
        let gap = self.cursor.line.get(..start).unwrap_or_default();
        let from = gap.trim_ascii_end().len();
        let place = self.place(self.span(from, start));
        let new = format!("{}{}", self.newline(), self.skip_mark());
        self.report_as(Alarm::CallNotFirst, finding.fix(msg!("nc.fix.own-block"), vec![(place, new)]));
    }

    /// Checks `G65 Hnn P Q R`: number and operands.
    fn check_function(&mut self, number: &Word, words: &[Word]) {
        let WordValue::Number(dec) = number.value else { return };
        let value = dec.to_f64();
        let row = self.control.macros.functions.iter().find(|(number, _)| f64::from(*number) == value);
        let Some(&(_, operation)) = row else {
            return self.report_word(Alarm::CallFunction, number, msg!("interp.no-function", number = (value, 0)));
        };
        let operand = |letter: Address| words.iter().rfind(|word| word.letter == letter);
        if let Some(&letter) = operation.operands().iter().find(|&&letter| operand(letter).is_none()) {
            let message = msg!("interp.no-operand", address = letter.to_string(), number = (value, 0));
            return self.report_word(Alarm::CallOperands, number, message);
        }
        let Some(result @ Word { value: WordValue::Number(dec), .. }) = operand(Address::P) else { return };
        let start = result.offset as usize;
        if operation.jumps() {
            return self.defer_check();
        }
        if operation != Operation::Alarm {
            // A constant is probably the number of the intended variable.
            let end = start + result.len as usize;
            let finding = self.finding(Alarm::CallOperands, start, end, msg!("interp.function-result"));
            let digits = self.cursor.line.get(start + 1..end).unwrap_or_default();
            let digits = start + 1 + digits.len() - digits.trim_ascii_start().len();
            return self.report_replacing(Alarm::CallOperands, finding, digits, digits, "#");
        }
        self.check_user_alarm(dec.to_f64(), start, start + result.len as usize);
    }

    /// Checks the range of a user alarm's number, written from `from` to `to`.
    pub(super) fn check_user_alarm(&mut self, value: f64, from: usize, to: usize) {
        let (least, most) = self.control.macros.user_alarms;
        if !(f64::from(least)..=f64::from(most)).contains(&value) {
            self.report(Alarm::UserAlarmRange, from, to, msg!("nc.user-alarm-number", least, most));
        }
    }

    /// Reports an alarm at a word of the block.
    fn report_word(&mut self, alarm: Alarm, word: &Word, message: Message) {
        let start = word.offset as usize;
        self.report(alarm, start, start + word.len as usize, message);
    }
}
