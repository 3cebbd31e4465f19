//! Mistakes with one obvious correction: reported once with the fix, and read as corrected.

use crate::controls::syntax::Function;
use crate::controls::{Address, Alarm};
use crate::msg;
use crate::nc::ast::{Expr, ExprId, Op, fresh_numbers};
use crate::nc::dec::Dec;
use crate::nc::lex::cursor::Cursor;
use crate::nc::lex::keywords::letters_of;
use crate::nc::lex::spelling::zero_behind_letter;
use crate::nc::parse::failure::{LineFix, ParseFailure, Read};
use crate::nc::parse::reader::Reader;
use crate::text::{Diagnostic, DiagnosticKind, Message};

/// Size limit (bytes) of files for fixes that need unused sequence numbers.
const NUMBERED: usize = 1 << 20;

impl Reader<'_> {
    /// Reports a finding, with a fix that replaces some bytes of the line.
    pub(in crate::nc::parse) fn report_replacing(
        &mut self,
        alarm: Alarm,
        finding: Diagnostic,
        from: usize,
        to: usize,
        new: &str,
    ) {
        let finding = self.with_fix(finding, LineFix::Write(from, to, new));
        self.report_as(alarm, finding);
    }

    /// Reports some bytes of the line, with a fix that replaces them.
    pub(in crate::nc::parse) fn report_replaced(
        &mut self,
        alarm: Alarm,
        from: usize,
        to: usize,
        message: Message,
        new: &str,
    ) {
        let finding = self.finding(alarm, from, to, message);
        self.report_replacing(alarm, finding, from, to, new);
    }

    /// Reports a finding, with a fix that puts some bytes of the line in square brackets.
    pub(in crate::nc::parse) fn report_enclosing(&mut self, alarm: Alarm, finding: Diagnostic, from: usize, to: usize) {
        let finding = self.with_fix(finding, LineFix::Enclose(from, to));
        self.report_as(alarm, finding);
    }

    /// Adds a fix to a finding.
    pub(in crate::nc::parse) fn with_fix(&self, finding: Diagnostic, fix: LineFix) -> Diagnostic {
        let place = |from, to| self.place(self.span(from, to));
        match fix {
            LineFix::Write(from, to, new) => {
                let old = String::from_utf8_lossy(self.cursor.line.get(from..to).unwrap_or_default()).into_owned();
                let title = match (old.trim(), new.trim()) {
                    (old, "") => msg!("nc.fix.drop", text = old),
                    ("", new) => msg!("nc.fix.insert", text = new),
                    (_, new) => msg!("nc.fix.write", text = new),
                };
                finding.fix(title, vec![(place(from, to), new.to_owned())])
            }
            LineFix::Enclose(from, to) => {
                let edit = |at, bracket: &str| (place(at, at), bracket.to_owned());
                finding.fix(msg!("nc.fix.square"), vec![edit(from, "["), edit(to, "]")])
            }
            LineFix::Plain(character) => {
                let start = self.cursor.base as usize;
                let text =
                    self.file.text.get(start..start + self.cursor.line.len()).filter(|_| plain(character) != character);
                let Some(text) = text else { return finding };
                let line = text.chars().map(plain).collect();
                let finding = match plain(character) {
                    like @ 'A'..='Z' if character < '\u{1000}' => {
                        let message =
                            msg!("nc.look-alike", character = character.to_string(), letter = like.to_string());
                        Diagnostic { message, ..finding }
                    }
                    _ => finding,
                };
                finding.fix(msg!("nc.fix.plain-characters"), vec![(place(0, self.cursor.line.len()), line)])
            }
        }
    }

    /// A sequence number that is unused in the file and in other fixes.
    fn fresh_number(&mut self) -> Option<u32> {
        if self.file.text.len() > NUMBERED {
            return None;
        }
        if self.fresh.known.is_empty() {
            let runs = self.file.text.split(|c: char| !c.is_ascii_digit());
            self.fresh.known = runs.filter_map(|run| run.parse().ok()).chain([0]).collect();
            self.fresh.known.sort_unstable();
        }
        let mut candidates = (0..).zip(fresh_numbers()).skip(self.fresh.tried);
        let found = candidates.find(|(_, number)| self.fresh.known.binary_search(number).is_err());
        self.fresh.tried = found.map_or(usize::MAX, |(at, _)| at + 1);
        found.map(|(_, number)| number)
    }

    /// Adds a fix for `IF … THEN`, from `then` to `after`: a jump over the conditional part, which is split into a new
    /// block at each place in `blocks`.
    pub(in crate::nc::parse) fn jump_instead(
        &mut self,
        finding: Diagnostic,
        (then, after): (usize, usize),
        blocks: &[usize],
    ) -> Diagnostic {
        let rest = self.cursor.line.get(after..).unwrap_or_default();
        let after = after + rest.len() - rest.trim_ascii_start().len();
        let end = self.cursor.line.len();
        let number = if after < end { self.fresh_number() } else { None };
        let Some(number) = number else { return finding };
        let (from, to, op) = self.formulas.compared;
        let newline = self.newline();
        let skip = self.skip_mark();
        let opposite = self.spaced(from, to, letters_of(op.opposite()));
        let mut edits = vec![
            (self.place(self.span(from, to)), opposite),
            (self.place(self.span(then, after)), format!("GOTO{number}{newline}{skip}")),
        ];
        edits.extend(blocks.iter().map(|at| (self.place(self.span(*at, *at)), format!("{newline}{skip}"))));
        edits.push((self.place(self.span(end, end)), format!("{newline}N{number}")));
        finding.fix(msg!("nc.fix.jump"), edits)
    }

    /// Failure of a `WHILE` without `DO`. The check of the loops adds the fix, with the number of the next unpaired `END`.
    pub(in crate::nc::parse) fn while_without_do(&self, start: usize) -> Box<ParseFailure> {
        let at = self.ended_at().max(start + 5);
        let mut failure = self.failure(Alarm::WhileSentence, start, at, msg!("nc.while-without-do"));
        failure.finding.kind = DiagnosticKind::WhileWithoutDo;
        failure
    }

    /// Reports `=` after an address, which these controls do not have, and reads on after it. Before what begins a value the `=` can go;
    /// before letters, `X=R1+4`, the value is that of another control.
    pub(in crate::nc::parse) fn equals_in_word(&mut self) {
        let at = self.cursor.at;
        while self.next_byte() == b'=' {
            self.cursor.at += 1;
        }
        let to = self.ended_at();
        let is_value = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'#' | b'[' | b'.' | b'+' | b'-');
        if is_value(self.next_byte()) {
            self.report_replaced(Alarm::Format, at, to, msg!("nc.equals-in-word"), "");
        } else {
            self.report(Alarm::Format, at, to, msg!("nc.equals-in-word"));
        }
    }

    /// The number after an address that starts with the letter O in place of the digit 0; it is read as a number. `None` for other text.
    #[cold]
    pub(in crate::nc::parse) fn zero_after_letter(&mut self, start: usize) -> Option<Dec> {
        let at = core::mem::replace(&mut self.cursor.at, start);
        let other = self.keyword_ahead() || !zero_behind_letter(self.cursor.line.get(start..).unwrap_or_default());
        self.cursor.at = at;
        if at != start + 1 || other || !self.zero_for_o() {
            return None;
        }
        let text = self.cursor.line.get(at..self.cursor.at).unwrap_or_default();
        let digits: Vec<u8> = text.iter().map(|b| if matches!(b, b'O' | b'o') { b'0' } else { *b }).collect();
        Some(Cursor { line: &digits, base: 0, at: 0 }.take_digits().value)
    }

    /// The number after an address that starts with the letter l or I in place of the digit 1; it is read as a number. `None` for other
    /// text.
    #[cold]
    pub(in crate::nc::parse) fn one_after_letter(&mut self, start: usize) -> Option<Dec> {
        let at = self.cursor.at;
        let number = self.cursor.rest().iter().skip(1).take_while(|b| matches!(b, b'.' | b'0'..=b'9')).count();
        if at != start + 1 || number == 0 {
            return None;
        }
        self.cursor.at += 1 + number;
        let digits = self.report_ones(Alarm::Format, at);
        Some(Cursor { line: digits.as_bytes(), base: 0, at: 0 }.take_digits().value)
    }

    /// Reports a small letter l inside a number of a line of capitals, `X1l0`, and reads on after the number; returns whether there was one.
    /// With P, it may be the repeats of a call.
    #[cold]
    pub(in crate::nc::parse) fn one_within_number(&mut self) -> bool {
        let small = |b: &u8| b.is_ascii_lowercase() && *b != b'l' || *b == b'P';
        let digit = self.cursor.byte(1).is_ascii_digit();
        if self.cursor.peek() != b'l' || !digit || self.cursor.line.iter().any(small) {
            return false;
        }
        let from = self.cursor.at;
        self.cursor.at += self.cursor.run(|b| matches!(b, b'l' | b'.' | b'0'..=b'9'));
        self.report_ones(Alarm::Format, from);
        true
    }

    /// Reports letters l or I in place of digits 1, from a byte of the line up to the cursor; returns the text with digits.
    #[cold]
    pub(in crate::nc::parse) fn report_ones(&mut self, alarm: Alarm, from: usize) -> String {
        let text = String::from_utf8_lossy(self.cursor.line.get(from..self.cursor.at).unwrap_or_default()).into_owned();
        let small = text.bytes().zip(self.cursor.base + from as u32..).filter(|(byte, _)| *byte == b'l');
        self.notes.ones.extend(small.map(|(_, at)| at));
        let letter = text.trim_start_matches(|c: char| !c.is_ascii_alphabetic()).chars().take(1).collect::<String>();
        let digits = text.replace(['l', 'L', 'I'], "1");
        let mut finding =
            self.finding(alarm, from, self.cursor.at, msg!("nc.letter-for-one", letter = letter.as_str()));
        // I is also an address: in `XI5.` the value of X may be missing. L may repeat a cycle.
        let behind = from > 0 && self.cursor.line.get(from - 1).is_some_and(|b| b.is_ascii_digit() || *b == b'.');
        let within = behind && self.cursor.line.get(from + 1).is_some_and(u8::is_ascii_digit);
        if alarm == Alarm::Format && (letter == "I" || within) {
            finding.kind = DiagnosticKind::GuessedFix;
        }
        self.report_replacing(alarm, finding, from, self.cursor.at, &digits);
        digits
    }

    /// Reports a comma or a letter O, l or I in a number, at the cursor.
    #[cold]
    pub(in crate::nc::parse) fn odd_digit(&mut self) {
        // An address has a value: `1l.` is 11.
        if matches!(self.cursor.peek(), b'l' | b'I') {
            if self.cursor.byte(1) == b'.' && !self.cursor.byte(2).is_ascii_digit() {
                let from = self.cursor.at;
                self.cursor.at += 2;
                self.report_ones(Alarm::Format, from);
            } else {
                self.one_within_number();
            }
            return;
        }
        self.zero_for_o();
        // In brackets a comma separates two numbers.
        let parts = self.names().is_some() || self.control.syntax.has(Function::Power);
        if self.cursor.peek() != b',' || parts && self.formulas.depth > 0 {
            return;
        }
        let at = self.cursor.at;
        let after = self.cursor.line.get(at + 1..).unwrap_or_default();
        let digits = after.iter().take_while(|b| b.is_ascii_digit()).count();
        if digits == 0 {
            return;
        }
        if let Some((letter, start)) = self.whole_address_before(at) {
            let written = self.cursor.line.get(start + 1..at + 1 + digits).unwrap_or_default();
            let mantissa = written
                .iter()
                .filter(|byte| byte.is_ascii_digit())
                .try_fold(0_i64, |sum, digit| sum.checked_mul(10)?.checked_add(i64::from(digit - b'0')));
            let scale = u8::try_from(digits).ok().filter(|scale| *scale <= 18);
            let number = mantissa.zip(scale).map(|(mantissa, scale)| Dec { mantissa, scale, point: true });
            self.cursor.at += 1 + digits;
            return self.comma_in_whole(letter, start, number);
        }
        self.report_replaced(Alarm::Format, at, at + 1, msg!("nc.decimal-comma"), ".");
        self.cursor.at += 1 + digits;
    }

    /// The address of the number that ends at `at`, with its place, if it takes whole numbers alone.
    fn whole_address_before(&self, at: usize) -> Option<(Address, usize)> {
        let head = self.cursor.line.get(..at)?;
        let start = head.iter().rposition(|byte| !(byte.is_ascii_digit() || *byte == b' '))?;
        let letter = Address::of(*head.get(start)?)?;
        self.tables.whole.contains(letter).then_some((letter, start))
    }

    /// Reports letters O in place of zeros in a number and reads on after them and the following digits; returns whether there were any.
    #[cold]
    pub(in crate::nc::parse) fn zero_for_o(&mut self) -> bool {
        let from = self.cursor.at;
        if !matches!(self.cursor.peek(), b'O' | b'o') || self.cursor.ahead("OR") {
            return false;
        }
        while matches!(self.cursor.peek(), b'O' | b'o' | b'.' | b'0'..=b'9') {
            self.cursor.at += 1;
        }
        let text = String::from_utf8_lossy(self.cursor.line.get(from..self.cursor.at).unwrap_or_default()).into_owned();
        self.report_replaced(Alarm::Format, from, self.cursor.at, msg!("nc.letter-o"), &text.replace(['O', 'o'], "0"));
        true
    }

    /// Reports `a**b`, which no control has; `a` is from `start` to `end`, the cursor is at the second `*`.
    #[cold]
    pub(in crate::nc::parse) fn power(&mut self, base: ExprId, start: usize, end: usize) -> Read<ExprId> {
        self.cursor.at += 1;
        let exponent = self.factor()?;
        let finding = self.finding(Alarm::Format, end, self.cursor.at, msg!("nc.no-power")).hint(msg!("nc.hint.power"));
        let text = String::from_utf8_lossy(self.cursor.line.get(start..end).unwrap_or_default()).trim().to_owned();
        // A power binds more strongly than the sign in front of its base.
        let sign = text.starts_with(['-', '+']);
        match (self.deck.expr(base), self.deck.expr(exponent)) {
            (Expr::Var(_) | Expr::Number(_), Expr::Number(Dec { mantissa: times @ 2..=4, scale: 0, .. })) if !sign => {
                let product = format!("*{text}").repeat(times as usize - 1);
                self.report_replacing(Alarm::Format, finding, end, self.cursor.at, &product);
            }
            _ => self.report_as(Alarm::Format, finding),
        }
        self.add_expr(Expr::Binary(Op::Multiply, base, exponent), start)
    }
}

/// Plain form of a character: for full-width characters, mathematical signs and non-breaking blanks.
fn plain(c: char) -> char {
    match c {
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(u32::from(c) - 0xfee0).unwrap_or(c),
        '\u{3000}' | '\u{a0}' => ' ',
        '\u{2010}'..='\u{2015}' | '\u{2212}' => '-',
        '\u{d7}' => '*',
        '\u{f7}' => '/',
        c => LIKE.0.chars().zip(LIKE.1.chars()).find(|pair| pair.0 == c).map_or(c, |pair| pair.1),
    }
}

/// Cyrillic and Greek letters, and the Latin letters they look like.
const LIKE: (&str, &str) = ("АВЕКМНОРСТУХЅІЈаеорсухΑΒΕΖΗΙΚΜΝΟΡΤΥΧ", "ABEKMHOPCTYXSIJAEOPCYXABEZHIKMNOPTYX");
