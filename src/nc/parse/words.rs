//! NC words: the fast path for nearly every block.

use crate::controls::Address;
use crate::controls::AddressSet;
use crate::controls::macros::CallKind;
use crate::controls::{Alarm, Code, CodeDef, CodeId, Group};
use crate::msg;
use crate::nc::ast::{Expr, ExprId, Op, Stmt, Word, WordValue};
use crate::nc::codes::{g_number, m_number};
use crate::nc::dec::Dec;
use crate::nc::lex::cursor::Digits;
use crate::nc::lex::spelling::needs_brackets;
use crate::nc::parse::failure::{IgnoredFeature, LineFix, Read};
use crate::nc::parse::reader::Reader;
use crate::text::{Diagnostic, DiagnosticKind, Message, either};

impl<'a> Reader<'a> {
    /// The next byte after white space and comments, which it passes; 0 at the end.
    #[inline]
    pub(super) fn next_byte(&mut self) -> u8 {
        let byte = self.cursor.peek();
        // White space and the bracket of a comment sort below all bytes of words.
        if byte > b'(' { byte } else { self.pass_blanks() }
    }

    /// Passes white space and comments; returns the following byte, 0 at the end.
    pub(super) fn pass_blanks(&mut self) -> u8 {
        loop {
            match self.cursor.peek() {
                b' ' | b'\t' | b'\r' => self.cursor.at += 1,
                b'(' if self.names().is_none() && !(self.formulas.rounds && self.arithmetic_ahead()) => {
                    self.take_comment()
                }
                byte => return byte,
            }
        }
    }

    /// Reads the comment at the cursor; the first one belongs to the block.
    fn take_comment(&mut self) {
        let open = self.cursor.at;
        let (length, closed) = self.cursor.enclosed(b')');
        let end = open + length - usize::from(closed);
        // The same comment is passed again where a word is read again.
        let last = self.findings.list.last().filter(|last| last.kind == DiagnosticKind::OpenComment);
        let reported = last.and_then(|last| last.place).is_some_and(|at| at == self.place(self.span(open, end)));
        if !closed && !reported {
            let finding = self
                .finding(Alarm::CommentBracket, open, end, msg!("nc.open-comment"))
                .kind(DiagnosticKind::OpenComment);
            self.report_replacing(Alarm::CommentBracket, finding, end, end, ")");
        }
        let (from, to) = (self.cursor.base as usize + open + 1, self.cursor.base as usize + end);
        self.note_foreign(from, to);
        if self.block.comment.is_none() {
            let text = self.file.text.get(from..to).unwrap_or("");
            self.block.comment = Some(self.add_text(text, self.span(open + 1, end)));
        }
        self.cursor.at = (end + 1).min(self.cursor.line.len());
    }

    /// Stores the first character of a comment that is missing on the control.
    pub(super) fn note_foreign(&mut self, from: usize, to: usize) {
        let text = self.file.text.get(from..to).unwrap_or("");
        if self.notes.foreign.is_none() && !text.is_ascii() {
            let characters = self.tables.rules.characters;
            let found = text.char_indices().find(|(_, c)| !characters.has(*c));
            let span = |(offset, c): (usize, char)| {
                let start = (from + offset) as u32;
                crate::text::Span::new(start, start + c.len_utf8() as u32)
            };
            self.notes.foreign = found.map(span);
        }
    }

    /// Reads a whole block: skip mark, sequence number, then macro text or words.
    pub(super) fn statement(&mut self) -> Read<Stmt> {
        let mut first = self.block_skip();
        if first | 0x20 == b'n' {
            self.sequence_number()?;
            first = self.next_byte();
        }
        if first == b'#' {
            return self.assignment();
        }
        let letters = first.is_ascii_alphabetic()
            && self.cursor.line.get(self.cursor.at + 1).is_some_and(u8::is_ascii_alphabetic)
            || first | 0x20 == b'g' && self.cursor.ahead("G0TO");
        let keyword = if letters { self.keyword()? } else { None };
        keyword.map_or_else(|| self.words(), Ok)
    }

    /// Reads the optional block skip, `/` or `/2`, at the start of the block; returns the following byte.
    pub(super) fn block_skip(&mut self) -> u8 {
        let first = self.next_byte();
        if first != b'/' {
            return first;
        }
        self.cursor.at += 1;
        self.block.skip_switch = 1;
        let switch = self.next_byte();
        if !switch.is_ascii_digit() {
            return switch;
        }
        self.cursor.at += 1;
        self.block.skip_switch = (switch - b'0').max(1);
        self.next_byte()
    }

    fn sequence_number(&mut self) -> Read<()> {
        let start = self.cursor.at;
        self.note_case(start);
        self.cursor.at += 1;
        self.cursor.blank();
        let digits = self.cursor.digits();
        if digits == 0 {
            let digit = self.cursor.byte(1).is_ascii_digit();
            if digit && self.zero_after_letter(start).is_some()
                || self.cursor.peek() == b'l' && self.one_after_letter(start).is_some()
            {
                return Ok(());
            }
            return Err(self.failure(Alarm::NoNumber, start, start + 1, msg!("nc.no-sequence-number")).at_word());
        }
        let text = self.cursor.line.get(self.cursor.at..self.cursor.at + digits).unwrap_or_default();
        self.cursor.at += digits;
        if self.zero_for_o() || self.one_within_number() {
            return Ok(());
        }
        let number = core::str::from_utf8(text).ok().and_then(|text| text.parse::<u32>().ok());
        let most = self.control.syntax.sequence_digits;
        match number {
            Some(0) if self.control.syntax.sequence_zero => {
                let base = self.cursor.base as usize;
                self.warn(base + start, base + self.cursor.at, msg!("nc.sequence-zero"));
            }
            Some(0) => self.report(Alarm::NumberZero, start, self.cursor.at, msg!("nc.sequence-zero")),
            Some(_) if digits <= most as usize => {}
            _ => self.report(
                Alarm::SequenceDigits,
                start,
                self.cursor.at,
                msg!("nc.sequence-digits", most = u32::from(most)),
            ),
        }
        (self.block.number, self.block.number_at) = (number, self.extent(start, self.cursor.at));
        Ok(())
    }

    fn words(&mut self) -> Read<Stmt> {
        let first = self.deck.words.len();
        self.block.first_word = first;
        let (mut seen, mut again) = (AddressSet::EMPTY, false);
        let mut calls = false;
        loop {
            let byte = self.next_byte();
            if !byte.is_ascii_alphabetic() {
                if self.cursor.ended() {
                    break;
                }
                self.between_words(byte, first)?;
                continue;
            }
            let start = self.cursor.at;
            let Some(letter) = Address::of(byte) else { return Err(self.unexpected()) };
            if byte.is_ascii_lowercase() {
                self.note_case(start);
            }
            self.cursor.at += 1;
            let value = self.value(start, letter)?;
            again |= !seen.insert(letter);
            match (letter, value) {
                (Address::G, WordValue::Number(number)) => calls |= self.g_code(number, start),
                (Address::M, WordValue::Number(number)) => calls |= self.m_code(number, start),
                _ => {}
            }
            let len = (self.cursor.at - start).min(u8::MAX as usize) as u8;
            self.deck.words.push(Word { len, offset: start as u16, ..Word::new(letter, value) });
        }
        let count = self.deck.words.len() - first;
        if seen.contains(Address::P) && seen.contains(Address::G) {
            self.more_coordinates(first);
        }
        let tables = self.tables;
        let twice = again && !tables.once.is_empty();
        if calls {
            self.check_call(first);
        } else if !seen.within(tables.letters) || !seen.and(tables.whole.or(tables.corners)).is_empty() || twice {
            self.check_words(first);
            self.corner(first);
        }
        if count > self.tables.most_words {
            let start = self.deck.words.get(first + self.tables.most_words).map_or(0, |word| word.offset as usize);
            let message = msg!("nc.too-many-words", most = self.tables.most_words as u32);
            self.report(Alarm::BlockWords, start, self.cursor.line.len(), message);
        }
        Ok(if count == 0 { Stmt::Empty } else { Stmt::Words { first: first as u32, count: count as u16 } })
    }

    /// Reports that the additional work coordinate system of `G54 P3` is not simulated.
    #[cold]
    fn more_coordinates(&mut self, first: usize) {
        let words = self.deck.words.get(first..).unwrap_or_default();
        let meant = words.iter().find_map(|word| {
            let row = self.tables.codes.row_of(word)?;
            let more = self.tables.codes.meant(row, words);
            (more.id != row.id).then_some((*word, more))
        });
        if let Some((word, more)) = meant {
            let (start, end) = (word.offset as usize, word.offset as usize + word.len as usize);
            let code = format!("{} ({})", self.control.code_name(more.id), more.text);
            self.report_once(IgnoredFeature::Code(more.id), start, end, msg!("nc.not-simulated", code));
        }
    }

    /// Reports the first word of each letter that is not an address here, the second word of each letter allowed once, and forbidden
    /// decimal points.
    fn check_words(&mut self, first: usize) {
        let (mut seen, mut twice) = (AddressSet::EMPTY, AddressSet::EMPTY);
        for at in first..self.deck.words.len() {
            let Some(word) = self.deck.words.get(at).copied() else { break };
            let (letter, start) = (word.letter, word.offset as usize);
            let end = start + word.len as usize;
            // A skip in the middle of the block is not a letter.
            if word.letter == Address::Skip {
                continue;
            }
            if !self.tables.letters.contains(letter) && !seen.contains(letter) {
                if self.deck.words.get(first..at).unwrap_or_default().iter().any(|word| self.calls_sub(word))
                    && word.letter == Address::O
                {
                    self.letter_for_p(Alarm::Format, start)
                } else {
                    self.odd_letter(word.letter, start)
                }
            } else if self.tables.once.and(seen).contains(letter) && twice.insert(letter) {
                self.report(Alarm::AddressTwice, start, end, msg!("nc.address-twice", address = letter.to_string()));
            } else if let WordValue::Number(number @ Dec { point: true, .. }) = word.value
                && self.tables.whole.contains(letter)
            {
                match letter {
                    Address::P => self.point_in_p(first, number, start, end),
                    // A small L is easily a 1: X1l0.
                    _ => self.needless_point((letter, number), start, end, letter == Address::L),
                }
            }
            seen = seen.with(letter);
        }
    }

    /// Reports that a chamfer or rounding after a motion is not simulated.
    #[cold]
    fn corner(&mut self, first: usize) {
        let words = self.deck.words.get(first..).unwrap_or_default();
        // Cycles, threads and calls use these letters otherwise.
        let plain = |word: &Word| match (word.letter, word.value) {
            (Address::G | Address::M, WordValue::Number(_)) => {
                let row = self.tables.codes.row_of(word);
                !row.is_some_and(|row| row.code.is_left_out() || matches!(row.code, Code::Thread | Code::SubCall))
            }
            _ => true,
        };
        let axis = |word: &Word| self.control.is_axis(word.letter);
        let motion = words.iter().all(plain) && words.iter().any(axis);
        let corners = self.control.syntax.corners;
        let found =
            words.iter().find_map(|word| Some((*word, corners.iter().find(|corner| corner.0 == word.letter)?.1)));
        if let (true, Some((word, what))) = (motion, found) {
            let start = word.offset as usize;
            let message = msg!("nc.corner-not-simulated", word = word.letter.to_string(), meaning = what);
            self.report_once(IgnoredFeature::Address(word.letter), start, start + word.len as usize, message);
        }
    }

    /// Reports a decimal point in the number of an integer address; `guess`: the number may be another than the one without the point.
    pub(super) fn needless_point(&mut self, (letter, number): (Address, Dec), start: usize, end: usize, guess: bool) {
        let message = msg!("nc.point-not-allowed", address = letter.to_string());
        let mut finding = self.finding(Alarm::PointNotAllowed, start, end, message);
        if guess {
            finding.kind = DiagnosticKind::GuessedFix;
        }
        let text = self.cursor.line.get(start..end).unwrap_or_default();
        match text.iter().position(|&b| b == b'.') {
            Some(point) if number.to_f64().fract() == 0.0 => {
                self.report_replacing(Alarm::PointNotAllowed, finding, start + point, end, "");
            }
            // Dropping decimals other than zeros would change the meaning, so there is no fix.
            _ => self.report_as(Alarm::PointNotAllowed, finding),
        }
    }

    /// Reports a decimal point in P. In a dwell it most likely means seconds, where P counts milliseconds.
    #[cold]
    fn point_in_p(&mut self, first: usize, number: Dec, start: usize, end: usize) {
        let message = msg!("nc.point-not-allowed", address = "P");
        let finding = self.finding(Alarm::PointNotAllowed, start, end, message).kind(DiagnosticKind::GuessedFix);
        match self.with_dwell_fixes(finding, first, number, (start, end)) {
            Some(finding) => self.report_as(Alarm::PointNotAllowed, finding),
            None => {
                // Without a code it may be the dwell of a cycle in force.
                let words = self.deck.words.get(first..).unwrap_or_default();
                let alone = !words.iter().any(|word| matches!(word.letter, Address::G | Address::M));
                self.needless_point((Address::P, number), start, end, alone);
            }
        }
    }

    /// Adds the spellings of a time in P with a decimal separator, from `start` to `end`: milliseconds, and seconds in X. `None` in a block without a
    /// dwell; its words so far begin with the one of index `first`.
    #[cold]
    fn with_dwell_fixes(
        &self,
        mut finding: Diagnostic,
        first: usize,
        number: Dec,
        (start, end): (usize, usize),
    ) -> Option<Diagnostic> {
        let words = self.deck.words.get(first..).unwrap_or_default();
        let row = |word: &Word| self.tables.codes.row_of(word);
        let dwell = words.iter().filter_map(row).any(|row| row.code == Code::Dwell);
        let cycle = words.iter().filter_map(row).any(|row| row.group == Group::Cycle && row.code.is_left_out());
        if !(dwell || cycle) {
            return None;
        }
        let milliseconds = number.to_f64() * 1000.0;
        let in_x = dwell && self.control.syntax.dwell_addresses.contains(Address::X);
        let text = String::from_utf8_lossy(self.cursor.line.get(start + 1..end).unwrap_or_default()).replace(',', ".");
        let seconds = (milliseconds.fract() == 0.0).then(|| (format!("P{milliseconds}"), number.to_f64()));
        let word = in_x.then(|| (format!("X{}", text.trim()), number.to_f64()));
        let whole = number.to_f64();
        let plain = (whole.fract() == 0.0).then(|| (format!("P{whole}"), whole / 1000.0));
        for (word, seconds) in [seconds, word, plain].into_iter().flatten() {
            let title = msg!("nc.fix.dwell", text = word.as_str(), seconds = seconds.to_string());
            finding = finding.fix(title, vec![(self.place(self.span(start, end)), word)]);
        }
        Some(finding)
    }

    /// Reports a decimal comma in the number of an address without points, from `start` to the cursor: a point would be the next mistake.
    #[cold]
    pub(super) fn comma_in_whole(&mut self, letter: Address, start: usize, number: Option<Dec>) {
        let end = self.cursor.at;
        let finding = self.finding(Alarm::Format, start, end, msg!("nc.decimal-comma"));
        let finding = finding.hint(msg!("nc.point-not-allowed", address = letter.to_string()));
        let fixed = number.filter(|_| letter == Address::P).and_then(|number| {
            let finding = finding.clone().kind(DiagnosticKind::GuessedFix);
            self.with_dwell_fixes(finding, self.block.first_word, number, (start, end))
        });
        self.report_as(Alarm::Format, fixed.unwrap_or(finding));
    }

    /// Reports a letter that is not an address here.
    fn odd_letter(&mut self, letter: Address, start: usize) {
        let (alarm, message) = match letter {
            Address::N => (Alarm::SequencePlace, msg!("nc.number-not-first", letter = "N")),
            Address::O => (Alarm::Format, msg!("nc.number-not-first", letter = "O")),
            _ => (
                Alarm::IllegalAddress,
                msg!("nc.no-such-address", address = letter.to_string(), control = self.control.name),
            ),
        };
        self.report(alarm, start, start + 1, message);
    }

    /// Handles text between words other than white space.
    fn between_words(&mut self, byte: u8, first: usize) -> Read<()> {
        let start = self.cursor.at;
        match byte {
            // Directly after a sequence number `/` cannot be a division.
            b'/' if self.skip_mark_ahead()
                || self.deck.words.len() == first && matches!(self.cursor.line.get(start + 1), Some(b'1'..=b'9')) =>
            {
                self.cursor.at += 1;
                let switch = match self.cursor.peek() {
                    digit @ b'1'..=b'9' => {
                        self.cursor.at += 1;
                        digit - b'0'
                    }
                    _ => 1,
                };
                let len = (self.cursor.at - start) as u8;
                let value = WordValue::Number(Dec::int(switch.into()));
                self.deck.words.push(Word { len, offset: start as u16, ..Word::new(Address::Skip, value) });
            }
            b',' => {
                self.cursor.at += 1;
                let Some(letter) = Address::of(self.next_byte()) else { return Err(self.unexpected()) };
                if !self.control.syntax.comma_addresses.contains(letter) {
                    self.comma_between(start);
                    return Ok(());
                }
                self.cursor.at += 1;
                self.value(start, letter)?;
                let name = format!(",{letter}");
                self.not_simulated(IgnoredFeature::Comma(letter), start, self.cursor.at, &name);
            }
            b'#' if self.deck.words.len() > first => {
                return Err(self.failure(Alarm::Mixed, start, self.cursor.line.len(), msg!("nc.mixed")).at_word());
            }
            b'<' if self.is_call_by_name(first) => return Err(self.call_by_name()),
            b'.' => self.stray_point(),
            b')' => self.stray_round()?,
            b']' => self.stray_square(),
            _ => return Err(self.unexpected()),
        }
        Ok(())
    }

    /// Reports a comma between words, which need no separator. Behind a number without a point it may be the point: X8, or X8.
    #[cold]
    fn comma_between(&mut self, at: usize) {
        let mut finding = self.finding(Alarm::IllegalAddress, at, at + 1, msg!("nc.comma-between"));
        finding = self.with_fix(finding, LineFix::Write(at, at + 1, ""));
        let digit = at > 0 && self.cursor.line.get(at - 1).is_some_and(u8::is_ascii_digit);
        let number = |word: &Word| matches!(word.value, WordValue::Number(Dec { point: false, .. }));
        if digit && self.deck.words.last().is_some_and(number) {
            finding = self.with_fix(finding, LineFix::Write(at, at + 1, "."));
        }
        self.report_as(Alarm::IllegalAddress, finding);
    }

    /// Reads the value after an address letter.
    #[inline]
    fn value(&mut self, start: usize, letter: Address) -> Read<WordValue> {
        let mut next = self.next_byte();
        let mut sign = 1;
        let value_at = self.cursor.at;
        if matches!(next, b'-' | b'+') {
            let rest = self.cursor.line.get(self.cursor.at + 1..).unwrap_or_default();
            let gap = rest.iter().take_while(|b| **b == b' ').count();
            if let Some(&digit) = rest.get(gap).filter(|&&b| b.is_ascii_digit() || b == b'.') {
                sign = if next == b'-' { -1 } else { 1 };
                self.cursor.at += 1 + gap;
                next = digit;
            }
        }
        if next.is_ascii_digit() || next == b'.' {
            let mut number = self.unsigned_number()?;
            number.mantissa *= sign;
            let end = self.cursor.at;
            match self.next_byte() {
                b'+' | b'-' | b'*' | b'/' | b'A' | b'M' | b'O' | b'X' | b'a' | b'm' | b'o' | b'x'
                    if self.operator_ahead() =>
                {
                    self.cursor.at = value_at;
                }
                b'.' => {
                    self.stray_point();
                    return Ok(WordValue::Number(number));
                }
                _ => {
                    self.cursor.at = end;
                    if end - value_at >= self.tables.word_chars {
                        self.too_long(start, end);
                    }
                    return Ok(WordValue::Number(number));
                }
            }
        } else if !matches!(next, b'#' | b'[' | b'-' | b'+' | b'(') && !self.function_ahead() {
            return self.no_value(start, letter, next);
        }
        let value = self.formula_of_word()?;
        if self.tables.rules.enclosed {
            self.check_enclosed(value, value_at);
        }
        while self.next_byte() == b'.' {
            let lone = !self.cursor.line.get(self.cursor.at + 1).is_some_and(u8::is_ascii_digit);
            if lone && self.tables.rules.variable_point {
                self.cursor.at += 1;
            } else {
                self.stray_point();
            }
        }
        Ok(WordValue::Expr(value))
    }

    /// Reports a word with more characters than the control allows, unless its digits were already too many.
    #[cold]
    fn too_long(&mut self, from: usize, to: usize) {
        let digits = self.cursor.line.get(from..to).unwrap_or_default().iter().filter(|b| b.is_ascii_digit()).count();
        if digits <= self.tables.rules.digits {
            self.report(Alarm::Digits, from, to, msg!("nc.word-too-long", most = self.tables.word_chars as u32));
        }
    }

    /// Checks that a formula after an address, from `from` on, is in brackets.
    #[cold]
    fn check_enclosed(&mut self, value: ExprId, from: usize) {
        if !matches!(self.deck.expr(value), Expr::Binary(op, ..) if !matches!(op, Op::Atan | Op::Power)) {
            return;
        }
        let read = self.cursor.line.get(from..self.cursor.at).unwrap_or_default();
        // The reader has passed a comment behind the formula, looking for an operator.
        let comment = read.iter().position(|&byte| byte == b'(').filter(|_| !self.formulas.rounds);
        let text = read.get(..comment.unwrap_or(read.len())).unwrap_or_default().trim_ascii_end();
        if needs_brackets(text) {
            let to = from + text.len();
            let finding = self.finding(Alarm::Format, from, to, msg!("nc.formula-brackets"));
            self.report_enclosing(Alarm::Format, finding, from, to);
        }
    }

    /// Handles text after an address letter that starts no value.
    #[cold]
    fn no_value(&mut self, start: usize, letter: Address, next: u8) -> Read<WordValue> {
        match next {
            b'=' => {
                self.equals_in_word();
                return self.value(start, letter);
            }
            b'O' | b'o' => {
                if let Some(number) = self.zero_after_letter(start) {
                    return Ok(WordValue::Number(number));
                }
            }
            b'l' | b'I' => {
                if let Some(number) = self.one_after_letter(start) {
                    return Ok(WordValue::Number(number));
                }
            }
            byte if !byte.is_ascii() => return Err(self.unexpected()),
            _ => {}
        }
        // The address alone: X, or the start of something other than a word.
        self.cursor.at = start;
        if self.keyword_ahead() {
            return Err(self.failure(Alarm::Mixed, start, self.cursor.line.len(), msg!("nc.mixed")));
        }
        let message = msg!("nc.no-value", address = letter.to_string());
        Err(self.failure(Alarm::NoNumber, start, start + 1, message).at_word())
    }

    /// Reads an unsigned number, from a digit or a point on.
    #[inline]
    pub(super) fn unsigned_number(&mut self) -> Read<Dec> {
        let start = self.cursor.at;
        let Digits { value, length, full, after } = self.cursor.take_digits();
        if matches!(after, b',' | b'O' | b'o' | b'l' | b'I') {
            self.odd_digit();
        }
        if length == usize::from(value.point) {
            return Err(self.failure(Alarm::Format, start, self.cursor.at, msg!("nc.lone-point")));
        }
        if full || length > self.tables.rules.digits + usize::from(value.point) {
            self.report(
                Alarm::Digits,
                start,
                self.cursor.at,
                msg!("nc.too-many-digits", most = self.tables.rules.digits as u32),
            );
        }
        Ok(value)
    }

    /// Looks a G code up; returns whether it is a macro call, which allows any letter.
    #[inline(always)]
    pub(super) fn g_code(&mut self, number: Dec, start: usize) -> bool {
        let Some(id) = g_number(number).map(CodeId::G) else { return self.unknown_g_code(number, start) };
        if let Some(call) = self.tables.codes.call(id) {
            return call.kind != CallKind::Sub;
        }
        match self.tables.codes.row(id) {
            None => self.unknown_g_code(number, start),
            Some(row) => self.known_g_code(row, number, start),
        }
    }

    #[inline]
    fn known_g_code(&mut self, row: &CodeDef, number: Dec, start: usize) -> bool {
        let left_out = row.code.is_left_out() && !(row.code == Code::Roughing && self.contour_named());
        if left_out || matches!(row.code, Code::Skip | Code::Tapping | Code::CancelForAxes) {
            self.code_not_simulated(row, IgnoredFeature::Code(row.id), &format!("G{number} ({})", row.text), start);
        }
        matches!(row.code, Code::MacroCall | Code::MacroModal | Code::MacroModalBlock)
    }

    /// Whether the rest of the block names the blocks of a contour, `P10 Q20`: the check before a run reports that they are skipped.
    #[cold]
    fn contour_named(&self) -> bool {
        self.names_ahead(b'P', |byte| byte.is_ascii_digit()) && self.names_ahead(b'Q', |byte| byte.is_ascii_digit())
    }

    /// Whether the rest of the block has a word with this letter and one of these bytes behind it.
    #[cold]
    fn names_ahead(&self, letter: u8, value: impl Fn(u8) -> bool) -> bool {
        let (mut comment, mut before) = (false, 0);
        self.cursor.rest().iter().any(|&byte| {
            comment = byte == b'(' || comment && byte != b')';
            let named = before == letter && value(byte);
            before = if comment { 0 } else { byte.to_ascii_uppercase() };
            named && !comment
        })
    }

    /// Reports a code that is not or not fully simulated, once per kind; `code` is its name in the message.
    #[cold]
    pub(super) fn code_not_simulated(&mut self, row: &CodeDef, key: IgnoredFeature, code: &str, start: usize) {
        let message = match row.code {
            Code::Skip => msg!("nc.no-skip", code),
            Code::Tapping => msg!("nc.no-tapping", code),
            Code::TakesAxisWords => msg!("nc.takes-axis-words", code),
            Code::ReplacesPositions => msg!("nc.replaces-positions", code),
            Code::CancelForAxes => msg!("nc.cancel-for-axes", code),
            // The control would take S as a cutting speed; the run goes on with the unit that it had.
            Code::NotSimulated if row.group == Group::SurfaceSpeed => msg!("nc.no-surface-speed", code),
            _ => msg!("nc.not-simulated", code),
        };
        self.report_once(key, start, self.cursor.at, message);
    }

    /// Reports a G code missing on the control.
    #[cold]
    fn unknown_g_code(&mut self, number: Dec, start: usize) -> bool {
        let code = format!("G{number}");
        let message = msg!("nc.unknown-code", code, control = self.control.name);
        let mut finding = self.finding(Alarm::UnknownCode, start, self.cursor.at, message);
        let letters = self.control.axes.iter().filter_map(|axis| axis.incremental);
        let letters: Vec<String> = letters.map(|letter| letter.to_string()).collect();
        if number.to_f64() == 91.0 && !letters.is_empty() {
            finding = finding.hint(msg!("nc.hint.increments", addresses = either(&letters)));
        }
        self.report_as(Alarm::UnknownCode, finding);
        false
    }

    /// Looks an M code up; returns whether it is a macro call.
    #[inline(always)]
    pub(super) fn m_code(&mut self, number: Dec, start: usize) -> bool {
        let Some(id) = m_number(number).filter(|_| number.scale == 0).map(CodeId::M) else { return false };
        if let Some(call) = self.tables.codes.call(id) {
            return call.kind != CallKind::Sub;
        }
        match self.tables.codes.row(id).map(|row| (row, row.code)) {
            Some((row, Code::NotSimulated)) => {
                let name = format!("M{number} ({})", row.text);
                self.not_simulated(IgnoredFeature::Code(id), start, self.cursor.at, &name);
            }
            Some((_, Code::SubCall)) => self.defer_check(),
            _ => {}
        }
        false
    }

    /// Reports a feature of the control that is not simulated, once per kind.
    pub(super) fn not_simulated(&mut self, key: IgnoredFeature, from: usize, to: usize, name: &str) {
        self.report_once(key, from, to, msg!("nc.not-simulated", code = name));
    }

    /// Adds a warning, once per kind.
    pub(super) fn report_once(&mut self, key: IgnoredFeature, from: usize, to: usize, message: Message) {
        if !self.findings.ignored.contains(&key) {
            self.findings.ignored.push(key);
            let base = self.cursor.base as usize;
            self.warn(base + from, base + to, message);
        }
    }

    /// Stores the place of the first small letter.
    #[inline]
    pub(super) fn note_case(&mut self, at: usize) {
        if self.notes.small.is_none() && self.cursor.line.get(at).is_some_and(u8::is_ascii_lowercase) {
            self.notes.small = Some(self.cursor.base + at as u32);
        }
    }

    /// Reports a surplus decimal point, `X#107.` or `X1.5.`, with its fix, and reads on after it.
    pub(super) fn stray_point(&mut self) {
        let start = self.cursor.at;
        while self.cursor.peek() == b'.' || self.cursor.peek().is_ascii_digit() {
            self.cursor.at += 1;
        }
        let text =
            String::from_utf8_lossy(self.cursor.line.get(start..self.cursor.at).unwrap_or_default()).into_owned();
        self.report_replaced(Alarm::Format, start, self.cursor.at, msg!("nc.stray-point", text), "");
    }

    /// Reports a `]` without its `[`, with its fix, and reads on after it.
    pub(super) fn stray_square(&mut self) {
        let start = self.cursor.at;
        self.cursor.at += 1;
        self.report_replaced(Alarm::BracketPair, start, self.cursor.at, msg!("nc.unopened-square"), "");
    }
}
