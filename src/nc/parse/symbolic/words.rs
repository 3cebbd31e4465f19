//! NC words of a language with names: addresses of several letters, values after `=`, codes with names.

use crate::controls::Address;
use crate::controls::AddressSet;
use crate::controls::{Alarm, Code, CodeDef, CodeId, Group};
use crate::msg;
use crate::nc::ast::{Dimensioning, Expr, Stmt, Word, WordValue};
use crate::nc::codes::{g_number, m_number};
use crate::nc::dec::Dec;
use crate::nc::parse::failure::{IgnoredFeature, ParseFailure, Read};
use crate::nc::parse::reader::{Reader, starts_value};
use crate::nc::program_names::split_repeats;
use crate::text::{Diagnostic, DiagnosticKind};

/// Dimensioning of a value by its own notation.
const FORMS: [(&str, Dimensioning); 5] = [
    ("AC", Dimensioning::Absolute),
    ("IC", Dimensioning::Incremental),
    ("DC", Dimensioning::Shortest),
    ("ACP", Dimensioning::Positive),
    ("ACN", Dimensioning::Negative),
];

/// Addresses whose values may have a dimensioning of their own, beside AP, RP and SPOS.
const POSITIONS: AddressSet = AddressSet::letters("ABCIJKUVWXYZ");

/// Facts about the words of a block that decide whether [`Reader::check_symbolic_words`] is needed.
#[derive(Default)]
struct Seen {
    letters: AddressSet,
    /// Bits of the groups of all codes.
    groups: u32,
    /// Number of codes that define the meaning of the words.
    syntax: u32,
    /// The words need a check.
    odd: bool,
}

impl Seen {
    /// Records a code.
    #[inline]
    fn code(&mut self, row: &CodeDef) {
        let bit = 1 << row.group as u32;
        self.odd |= self.groups & bit != 0 || row.stands_alone();
        if row.defines_syntax() {
            self.odd |= self.syntax > 0;
            self.syntax += 1;
        } else if !matches!(row.group, Group::Other | Group::OneShot) {
            self.groups |= bit;
        }
    }
}

/// Value of a word: `500` in `S1=500` (index 1), `IC(10)` in `X=IC(10)`.
struct SymbolicValue {
    /// Number in an extended address.
    index: Option<u8>,
    dimensioning: Dimensioning,
    value: WordValue,
}

impl SymbolicValue {
    /// A value without index and dimensioning.
    #[inline]
    fn plain(value: WordValue) -> SymbolicValue {
        SymbolicValue { index: None, dimensioning: Dimensioning::Plain, value }
    }
}

impl Reader<'_> {
    pub(in crate::nc::parse) fn symbolic_words(&mut self) -> Read<Stmt> {
        let first = self.deck.words.len();
        let mut seen = Seen::default();
        loop {
            let byte = self.next_byte();
            if !byte.is_ascii_alphabetic() {
                if self.cursor.ended() {
                    break;
                }
                self.between_symbolic_words(byte)?;
                continue;
            }
            let start = self.cursor.at;
            let Some(letter) = Address::of(byte) else { return Err(self.unexpected()) };
            let second = self.cursor.byte(1);
            if second.is_ascii_alphabetic() || second == b'_' {
                self.long_word(start, &mut seen)?;
                continue;
            }
            self.cursor.at += 1;
            let SymbolicValue { index, dimensioning: form, value } = self.symbolic_value(start, letter)?;
            if !matches!(form, Dimensioning::Plain | Dimensioning::Absolute | Dimensioning::Incremental) {
                self.check_approach(start, letter, form);
            }
            match (letter, value) {
                (Address::G, WordValue::Number(number)) => {
                    self.symbolic_code(Address::G, number, start);
                    if let Some(row) = self.row(Address::G, number) {
                        seen.code(row);
                    }
                }
                (Address::M, WordValue::Number(number)) => {
                    self.symbolic_code(Address::M, number, start);
                    if number == Dec::int(99) {
                        self.foreign_return(start);
                    }
                    if let Some(row) = self.row(Address::M, number) {
                        seen.code(row);
                    }
                    // The number of such words is limited.
                    seen.odd |= seen.letters.contains(letter);
                }
                _ => seen.odd |= seen.letters.contains(letter),
            }
            seen.odd |= index.is_some();
            seen.letters = seen.letters.with(letter);
            let len = (self.cursor.at - start).min(u8::MAX as usize) as u8;
            self.deck.words.push(Word { letter, len, offset: start as u16, index, form, value });
        }
        let count = self.deck.words.len() - first;
        // Each word is compared with those before it, so only where their number is allowed.
        if count > self.tables.most_words {
            let message = msg!("nc.too-many-words", most = self.tables.most_words as u32);
            self.report(Alarm::BlockWords, 0, self.cursor.line.len(), message);
        } else if seen.odd || !seen.letters.within(self.tables.letters) {
            self.check_symbolic_words(first);
        }
        Ok(if count == 0 { Stmt::Empty } else { Stmt::Words { first: first as u32, count: count as u16 } })
    }

    /// Looks a code up. Not inlined: the words of languages without names have their own copy.
    #[inline(never)]
    fn symbolic_code(&mut self, letter: Address, number: Dec, start: usize) {
        if letter == Address::G {
            self.g_code(number, start)
        } else {
            self.m_code(number, start)
        };
    }

    /// Reports `M99`, the subprogram end of other controls.
    #[cold]
    fn foreign_return(&mut self, start: usize) {
        let row = self.control.codes.iter().find(|row| row.code == Code::SubEnd);
        let end = row.map_or(String::new(), |row| self.control.code_name(row.id));
        let place = self.place(self.span(start, self.cursor.at));
        let finding = Diagnostic::warning(msg!("nc.foreign-return", code = "M99", end = end.as_str())).at(place);
        self.add_finding(finding.fix(msg!("nc.fix.write", text = end.as_str()), vec![(place, end)]));
    }

    /// Row of a G or M code as written.
    #[inline]
    fn row(&self, letter: Address, number: Dec) -> Option<&'static CodeDef> {
        self.tables.codes.row(match letter {
            Address::G => CodeId::G(g_number(number)?),
            _ => CodeId::M(m_number(number)?),
        })
    }

    /// Reads the value after a letter: a number, or a formula after `=`.
    #[inline]
    fn symbolic_value(&mut self, start: usize, letter: Address) -> Read<SymbolicValue> {
        let mut next = self.next_byte();
        let negative = next == b'-';
        if negative || next == b'+' {
            let digit = self.cursor.byte(1);
            if digit.is_ascii_digit() || digit == b'.' {
                self.cursor.at += 1;
                next = digit;
            }
        }
        if !(next.is_ascii_digit() || next == b'.') {
            return self.equals(start, letter);
        }
        let mut number = self.unsigned_number()?;
        if self.cursor.peek() | 0x20 == b'e' {
            number = self.exponent(number, start);
        }
        if negative {
            number.mantissa = -number.mantissa;
        }
        match self.cursor.peek() {
            b'=' | b'+' | b'-' | b'*' | b'/' | b'.' | b' ' => self.after_number(start, letter, number),
            _ => Ok(SymbolicValue::plain(WordValue::Number(self.whole_number(number, start)))),
        }
    }

    /// Completes a number of a formula, which ends at the cursor: reads its exponent and checks its range.
    #[inline]
    pub(in crate::nc::parse) fn symbolic_number(&mut self, number: Dec, start: usize) -> Dec {
        let number = if self.cursor.peek() | 0x20 == b'e' { self.exponent(number, start) } else { number };
        self.whole_number(number, start)
    }

    /// Reports a number without a point above the range of whole numbers.
    #[inline]
    fn whole_number(&mut self, number: Dec, start: usize) -> Dec {
        if number.mantissa.unsigned_abs() > 2_147_483_647 && !number.point {
            self.check_whole(number, start);
        }
        number
    }

    #[cold]
    fn check_whole(&mut self, number: Dec, start: usize) {
        let most = self.names().map_or(i64::MAX, |names| names.whole_max);
        if number.mantissa.unsigned_abs() > most.unsigned_abs() && !number.point {
            let finding = self.finding(
                Alarm::OutOfRange,
                start,
                self.cursor.at,
                msg!("nc.whole-range", most = Dec::int(most).to_string()),
            );
            self.report_replacing(Alarm::OutOfRange, finding, self.cursor.at, self.cursor.at, ".0");
        }
    }

    /// Continues after the number of a word: usually a blank, rarely the rest of an extended address or of a formula.
    fn after_number(&mut self, start: usize, letter: Address, number: Dec) -> Read<SymbolicValue> {
        let end = self.cursor.at;
        let next = self.next_byte();
        if next == b'=' && self.cursor.byte(1) != b'=' {
            return self.extended(start, letter, number);
        }
        match next {
            b'.' => self.stray_point(),
            b'+' | b'-' | b'*' | b'/' => {
                // A formula without `=`.
                self.cursor.at = start + 1;
                return self.insert_equals(letter);
            }
            _ => self.cursor.at = end,
        }
        Ok(SymbolicValue::plain(WordValue::Number(self.whole_number(number, start))))
    }

    /// Reads `S1=500`: the number is the index of the address.
    fn extended(&mut self, start: usize, letter: Address, number: Dec) -> Read<SymbolicValue> {
        let known = self.names().is_some_and(|names| names.extended.contains(letter));
        let index = u8::try_from(number.mantissa).ok().filter(|_| number.scale == 0 && !number.point && known);
        // `R1=5` behind words is an assignment, which the check of the words reports.
        if index.is_none() && letter != Address::R {
            let address = letter.to_string();
            self.report(Alarm::Format, start, self.cursor.at, msg!("nc.extended-address", address));
        }
        Ok(SymbolicValue { index, ..self.equals(start, letter)? })
    }

    /// End of `[2]` in `S[2]=4`.
    fn index_ahead(&self) -> Option<usize> {
        let rest = self.cursor.line.get(self.cursor.at + 1..)?;
        let close = rest.iter().position(|byte| *byte == b']')?;
        let after = rest.get(close + 1..)?.trim_ascii_start();
        (after.first() == Some(&b'=')).then_some(self.cursor.at + close + 2)
    }

    /// Reads `= value`, or fails for an address without a value.
    fn equals(&mut self, start: usize, letter: Address) -> Read<SymbolicValue> {
        match self.next_byte() {
            b'=' => self.cursor.at += 1,
            b'[' if self.index_ahead().is_some() => {
                let end = self.index_ahead().unwrap_or(self.cursor.at);
                let address = self.control.address(letter);
                let message = match letter {
                    Address::M | Address::S => msg!("nc.index-in-brackets", address),
                    _ => msg!("nc.no-index", address),
                };
                return Err(self.failure(Alarm::Format, self.cursor.at, end, message));
            }
            b'#' | b'[' | b'(' | b'-' | b'+' => return self.insert_equals(letter),
            byte if !byte.is_ascii() => return Err(self.unexpected()),
            _ if self.parameter_ahead() => return self.insert_equals(letter),
            _ => {
                let message = msg!("nc.no-value", address = self.control.address(letter));
                return Err(self.failure(Alarm::NoNumber, start, start + 1, message).at_word());
            }
        }
        if matches!(letter, Address::G | Address::N | Address::L) {
            let message = msg!("nc.no-formula", address = letter.to_string());
            return Err(self.failure(Alarm::Format, start, self.cursor.at, message));
        }
        if self.next_byte() == b'"' {
            return Err(self.text_value(&self.control.address(letter)));
        }
        let dimensioning = self.dimensioning();
        if dimensioning != Dimensioning::Plain {
            if !POSITIONS.contains(letter) && !matches!(letter, Address::Ap | Address::Rp | Address::Spos) {
                let address = self.control.address(letter);
                self.report(Alarm::Format, start, self.cursor.at, msg!("nc.no-dimensioning", address));
            }
            self.pass_blanks();
            self.deeper()?;
            let open = self.open(b')');
            let inner = self.constant_or_formula()?;
            self.close(open)?;
            self.formulas.depth -= 1;
            return Ok(SymbolicValue { dimensioning, ..SymbolicValue::plain(inner) });
        }
        Ok(SymbolicValue::plain(self.constant_or_formula()?))
    }

    /// The failure of a text as the value of an address or a variable, from the quotation mark at the cursor on.
    #[cold]
    pub(super) fn text_value(&self, address: &str) -> Box<ParseFailure> {
        let end = self.cursor.at + self.cursor.enclosed(b'"').0;
        self.failure(Alarm::Format, self.cursor.at, end, msg!("nc.text-value", address))
    }

    /// Reads `AC` or the like in front of a bracket.
    fn dimensioning(&mut self) -> Dimensioning {
        if !self.next_byte().is_ascii_alphabetic() {
            return Dimensioning::Plain;
        }
        let name = self.cursor.name();
        let after = self.cursor.line.get(self.cursor.at + name.len()..).unwrap_or_default().trim_ascii_start();
        let form = FORMS.iter().find(|row| name.eq_ignore_ascii_case(row.0) && after.first() == Some(&b'('));
        self.cursor.at += form.map_or(0, |row| row.0.len());
        form.map_or(Dimensioning::Plain, |row| row.1)
    }

    /// Reads a formula; a constant one becomes a number.
    fn constant_or_formula(&mut self) -> Read<WordValue> {
        let id = self.symbolic_formula()?;
        Ok(match self.deck.expr(id) {
            Expr::Number(number) => {
                self.deck.exprs.pop();
                self.places.exprs.pop();
                WordValue::Number(number)
            }
            _ => WordValue::Expr(id),
        })
    }

    /// Reports a formula directly after its address, as on other controls; reads it as intended.
    #[cold]
    fn insert_equals(&mut self, letter: Address) -> Read<SymbolicValue> {
        let (from, found) = (self.cursor.at, self.findings.list.len());
        let value = self.constant_or_formula()?;
        let address = self.control.address(letter);
        if self.cursor.line.get(from) == Some(&b'[') && self.equals_before_square(&address, from, found) {
            return Ok(SymbolicValue::plain(value));
        }
        let finding = self.finding(Alarm::Format, from, self.cursor.at, msg!("nc.no-equals-sign", address));
        self.report_replacing(Alarm::Format, finding, from, from, "=");
        Ok(SymbolicValue::plain(value))
    }

    /// Adds the missing `=` to the finding about the square bracket at `from`, which is among those behind the first `found`: neither fix is
    /// right alone. Returns whether there is such a finding.
    fn equals_before_square(&mut self, address: &str, from: usize, found: usize) -> bool {
        let start = self.span(from, from).start;
        let text = self.file.text;
        let at_bracket = |finding: &&mut Diagnostic| finding.place.is_some_and(|place| place.span.start == start);
        let Some(finding) = self.findings.list.iter_mut().skip(found).rev().find(at_bracket) else { return false };
        let written = finding.place.map_or("", |place| place.span.of(text));
        let inner = written.get(1..written.len().saturating_sub(1)).unwrap_or("");
        let correct = format!("{address}=({inner})");
        finding.message = msg!("nc.square-value", control = self.control.name, correct = correct.as_str());
        if let Some(fix) = finding.fixes.first_mut() {
            fix.title = msg!("nc.fix.write", text = correct);
            if let Some((_, bracket)) = fix.edits.first_mut() {
                bracket.insert(0, '=');
            }
        }
        true
    }

    /// Whether a name is an address with a variable or number and a missing `=`: `XR1`, `LIMS3000`.
    pub(in crate::nc::parse) fn missing_equals(&self, name: &str) -> bool {
        let variable = |rest: &str| rest.len() > 1 && rest.bytes().skip(1).all(|b| b.is_ascii_digit());
        let known =
            name.bytes().next().and_then(Address::of).is_some_and(|letter| self.tables.letters.contains(letter));
        known && name.get(1..).is_some_and(|rest| rest.starts_with(['R', 'r']) && variable(rest))
    }

    /// Reads an address or a code of several letters.
    #[cold]
    fn long_word(&mut self, start: usize, seen: &mut Seen) -> Read<()> {
        let written = self.cursor.name();
        let name = written.to_ascii_uppercase();
        let Some(names) = self.names() else { return Err(self.unexpected()) };
        if let Some(place) = names.code(&name) {
            return self.long_code((start, &name), place, seen);
        }
        let longest = names.addresses.iter().filter(|row| name.starts_with(row.0)).max_by_key(|row| row.0.len());
        if let Some(&(address, letter)) = longest {
            let rest = name.get(address.len()..).unwrap_or("");
            if rest.is_empty() || rest.bytes().all(|b| b.is_ascii_digit()) || self.missing_equals(&format!("X{rest}")) {
                return self.long_address((start, address), letter, seen);
            }
        }
        if self.missing_equals(written) {
            self.cursor.at += 1;
            let Some(letter) = name.bytes().next().and_then(Address::of) else { return Err(self.unexpected()) };
            let value = self.insert_equals(letter)?;
            return self.push_long(start, letter, value);
        }
        let after = self.cursor.line.get(start + name.len()..).unwrap_or_default();
        if matches!(name.as_str(), "IF" | "GOTOF" | "GOTOB" | "MSG") {
            return Err(self.failure(Alarm::Mixed, start, self.cursor.line.len(), msg!("nc.mixed")));
        }
        if after.first() == Some(&b'(') && self.function_ahead() {
            return Err(self.failure(
                Alarm::Format,
                start,
                self.cursor.line.len(),
                msg!("nc.no-address", address = name),
            ));
        }
        Err(self.unknown_name(start, written))
    }

    /// Reads a named code, by its index in the list of names: a G function, or SETMS with the number of a spindle.
    fn long_code(&mut self, (start, name): (usize, &str), place: usize, seen: &mut Seen) -> Read<()> {
        self.cursor.at += name.len();
        let id = CodeId::Named(place as u16);
        let row = self.tables.codes.row(id);
        if let Some(row) = row {
            seen.code(row);
        }
        let index = match row.map(|row| row.code) {
            Some(code) if code.is_left_out() => {
                self.long_code_not_simulated((start, name), row)?;
                None
            }
            Some(Code::MasterSpindle) => self.spindle_number(start)?,
            _ => None,
        };
        let value = WordValue::Number(Dec::int(place as i64));
        self.push_long(start, Address::Name, SymbolicValue { index, ..SymbolicValue::plain(value) })
    }

    /// Reports a code that is not simulated, once; skips arguments such as in `TRACYL(40)`.
    fn long_code_not_simulated(&mut self, (start, name): (usize, &str), row: Option<&CodeDef>) -> Read<()> {
        let Some(row) = row else { return Ok(()) };
        let what = format!("{name} ({})", row.text);
        self.code_not_simulated(row, IgnoredFeature::Code(row.id), &what, start);
        if self.next_byte() != b'(' {
            return Ok(());
        }
        let open = self.cursor.at;
        let Some(close) = self.cursor.rest().iter().position(|&b| b == b')') else {
            return Err(self.failure(Alarm::BracketPair, open, open + 1, msg!("nc.unclosed-group")));
        };
        self.cursor.at += close + 1;
        Ok(())
    }

    /// Reads an address of several letters with its value.
    fn long_address(&mut self, (start, address): (usize, &str), letter: Address, seen: &mut Seen) -> Read<()> {
        self.cursor.at += address.len();
        let value = self.long_value(start, address, letter)?;
        let earlier = self.deck.words.iter().rev().take(64);
        seen.odd |= earlier.clone().any(|word| word.letter == letter && word.offset < start as u16);
        if let Some(row) = self.control.syntax.corners.iter().find(|row| row.0 == letter) {
            let message = msg!("nc.corner-not-simulated", word = address, meaning = row.1);
            self.report_once(IgnoredFeature::Address(letter), start, self.cursor.at, message);
        }
        self.push_long(start, letter, value)
    }

    /// Reports a direction of approach (DC, ACP, ACN) for a linear axis.
    #[cold]
    fn check_approach(&mut self, start: usize, letter: Address, form: Dimensioning) {
        let (alarm, name) = match form {
            Dimensioning::Positive => (Alarm::PositiveWay, "ACP"),
            Dimensioning::Negative => (Alarm::NegativeWay, "ACN"),
            _ => (Alarm::ShortestWay, "DC"),
        };
        if self.control.axis(letter).is_some() && !self.tables.rotary.contains(letter) {
            self.report(alarm, start, self.cursor.at, msg!("nc.way-of-angle", word = name, axis = letter.to_string()));
        }
    }

    /// Reads `(2)` after SETMS; without it the master spindle is the one after power-on.
    fn spindle_number(&mut self, start: usize) -> Read<Option<u8>> {
        if self.next_byte() != b'(' {
            return Ok(None);
        }
        let open = self.open(b')');
        self.pass_blanks();
        let number = self.unsigned_number()?;
        self.close(open)?;
        match u8::try_from(number.mantissa) {
            Ok(index @ 1..) if number.scale == 0 => Ok(Some(index)),
            _ => Err(self.failure(Alarm::OutOfRange, start, self.cursor.at, msg!("nc.spindle-number"))),
        }
    }

    fn push_long(&mut self, start: usize, letter: Address, value: SymbolicValue) -> Read<()> {
        let len = (self.cursor.at - start).min(u8::MAX as usize) as u8;
        let SymbolicValue { index, dimensioning: form, value } = value;
        self.deck.words.push(Word { letter, len, offset: start as u16, index, form, value });
        Ok(())
    }

    /// Reads the value after an address of several letters, with or without an index in brackets.
    fn long_value(&mut self, start: usize, address: &str, letter: Address) -> Read<SymbolicValue> {
        let mut index = None;
        if self.cursor.peek() == b'[' {
            self.cursor.at += 1;
            let number = self.unsigned_number()?;
            index = u8::try_from(number.mantissa).ok();
            if self.next_byte() != b']' {
                return Err(self.failure(Alarm::Format, start, self.cursor.at, msg!("nc.unclosed-group")));
            }
            self.cursor.at += 1;
        }
        if self.next_byte() == b'=' {
            return Ok(SymbolicValue { index, ..self.equals(start, letter)? });
        }
        let end = start + address.len();
        let next = self.cursor.peek();
        if !(starts_value(next) || next == b'(' || self.parameter_ahead()) {
            let message = msg!("nc.no-value", address);
            return Err(self.failure(Alarm::NoNumber, start, end, message));
        }
        let from = self.cursor.at;
        let value = self.constant_or_formula()?;
        let finding = self.finding(Alarm::Format, start, self.cursor.at, msg!("nc.no-equals-sign", address));
        self.report_replacing(Alarm::Format, finding, end.min(from), from, "=");
        Ok(SymbolicValue { index, ..SymbolicValue::plain(value) })
    }

    /// Handles text between words other than white space.
    #[cold]
    fn between_symbolic_words(&mut self, byte: u8) -> Read<()> {
        match byte {
            b'(' if self.foreign_comment() => Ok(()),
            b'.' => {
                self.stray_point();
                Ok(())
            }
            b'$' => Err(self.system_variable()),
            b'_' => Err(self.unknown_name(self.cursor.at, self.cursor.name())),
            b'#' => Err(self.failure(Alarm::Mixed, self.cursor.at, self.cursor.line.len(), msg!("nc.mixed")).at_word()),
            _ => Err(self.unexpected()),
        }
    }

    /// Reports `( comment )` of other controls, with its fix, and reads on after it.
    #[cold]
    pub(in crate::nc::parse) fn foreign_comment(&mut self) -> bool {
        let start = self.cursor.at;
        let rest = self.cursor.line.get(start..).unwrap_or_default();
        let Some(close) = rest.iter().position(|&b| b == b')') else { return false };
        let inner = String::from_utf8_lossy(rest.get(1..close).unwrap_or_default()).into_owned();
        self.cursor.at = start + close + 1;
        let mut finding =
            self.finding(Alarm::Format, start, self.cursor.at, msg!("nc.foreign-remark", control = self.control.name));
        // Behind a name they may be arguments: `RET(5)`.
        if start > 0 && self.cursor.line.get(start - 1).is_some_and(u8::is_ascii_alphabetic) {
            finding.kind = DiagnosticKind::GuessedFix;
        }
        // In the middle of a block the fix would turn the rest into a comment.
        let last = self.next_byte() == 0 && self.cursor.ended() && self.block.comment.is_none();
        self.report_replacing(
            Alarm::Format,
            finding,
            start,
            start + close + 1,
            &if last { format!(";{inner}") } else { String::new() },
        );
        true
    }

    /// Reports words that exclude each other.
    #[cold]
    fn check_symbolic_words(&mut self, first: usize) {
        let words = self.deck.words.get(first..).unwrap_or_default().to_vec();
        if self.foreign_call(&words) {
            return;
        }
        let rows: Vec<Option<&CodeDef>> = words.iter().map(|word| self.row_of(word)).collect();
        self.check_numbered_axes(&words, &rows);
        let end = |word: &Word| word.offset as usize + word.len as usize;
        // M, H, D, and all of them with S and T.
        let mut counts = [0_u8; 4];
        for (at, word) in words.iter().enumerate() {
            let start = word.offset as usize;
            let before = words.get(..at).unwrap_or_default();
            let name = self.control.address(word.letter);
            if !word.letter.is_long() && !self.tables.letters.contains(word.letter) {
                if self.radius_by_letter(word, &rows) {
                    continue;
                }
                let (alarm, message) = match word.letter {
                    Address::N => (Alarm::SequencePlace, msg!("nc.number-not-first", letter = "N")),
                    Address::R if words.len() == 1 => (Alarm::Format, msg!("nc.no-parameter-number")),
                    Address::R => (Alarm::Mixed, msg!("nc.assignments-alone")),
                    Address::P if words.iter().any(|other| other.letter == Address::L) => continue,
                    Address::L | Address::P => (Alarm::Format, msg!("nc.call-alone", program = name)),
                    _ => {
                        (Alarm::IllegalAddress, msg!("nc.no-such-address", address = name, control = self.control.name))
                    }
                };
                self.report(alarm, start, end(word), message);
                continue;
            }
            let again = |other: &&Word| (other.letter, other.index) == (word.letter, word.index);
            let others = before.iter().filter(again).count();
            if others > 0 && !matches!(word.letter, Address::G | Address::M | Address::Name) {
                // Reported once; a repeated word does not count toward the maximum number.
                if others == 1 {
                    self.report(Alarm::AddressTwice, start, end(word), msg!("nc.address-twice", address = name));
                }
                continue;
            }
            if let Some(row) = rows.get(at).copied().flatten()
                && self.check_code(row, word, &rows[..at.min(rows.len())], words.len())
            {
                return;
            }
            let kind = match word.letter {
                Address::M => 0,
                Address::H => 1,
                Address::D => 2,
                Address::S | Address::T => 3,
                _ => continue,
            };
            counts[kind] += 1;
            counts[3] += u8::from(kind < 3);
            let most = self.names().map_or([u8::MAX; 4], |names| names.auxiliary);
            if kind < 3 && counts[kind] == most[kind] + 1 || counts[3] == most[3] + 1 {
                let most = if kind < 3 && counts[kind] > most[kind] { most[kind] } else { most[3] };
                self.report(
                    Alarm::Auxiliaries,
                    start,
                    end(word),
                    msg!("nc.too-many-auxiliaries", most = u32::from(most)),
                );
            }
        }
    }

    /// Reports `R5` beside an arc, the radius on other controls; returns false for other words.
    fn radius_by_letter(&mut self, word: &Word, rows: &[Option<&CodeDef>]) -> bool {
        let arc = rows.iter().flatten().any(|row| matches!(row.code, Code::ArcCw | Code::ArcCcw));
        if word.letter != Address::R || word.index.is_some() || !arc {
            return false;
        }
        let (start, end) = (word.offset as usize, word.offset as usize + word.len as usize);
        let value = String::from_utf8_lossy(self.cursor.line.get(start + 1..end).unwrap_or_default()).into_owned();
        let value = value.trim().trim_start_matches('=');
        // `R1=5` is an assignment.
        if value.contains('=') {
            return false;
        }
        let radius = format!("CR={value}");
        self.report_replaced(Alarm::Mixed, start, end, msg!("nc.radius-by-letter", word = radius.as_str()), &radius);
        true
    }

    /// Reports G4 with the time of other controls (`G4 X1.5`, `G4 P500`), with the words of this one; returns false for other blocks.
    fn dwell_of_others(&mut self, dwell: &Word, other: &Word) -> bool {
        let WordValue::Number(time) = other.value else { return false };
        let seconds = match other.letter {
            Address::X | Address::U => time.to_f64(),
            Address::P => time.to_f64() / 1000.0,
            _ => return false,
        };
        let span = |word: &Word| (word.offset as usize, word.offset as usize + word.len as usize);
        let (from, to) = span(other);
        let finding = self.finding(Alarm::NotAlone, span(dwell).0, to, msg!("nc.dwell-by-name"));
        let title = msg!("nc.fix.dwell", text = format!("F{seconds}"), seconds = seconds.to_string());
        let edit = (self.place(self.span(from, to)), format!("F{seconds}"));
        self.report_as(Alarm::NotAlone, finding.fix(title, vec![edit]));
        true
    }

    /// Warns of the first axis or centre with a number, such as `X1=10`, that no code of the block takes: points take axes, an arc through a
    /// point takes centres, which may be modal.
    fn check_numbered_axes(&mut self, words: &[Word], rows: &[Option<&CodeDef>]) {
        let codes = || rows.iter().flatten();
        let points = codes().any(|row| matches!(row.code, Code::GoTo(_)));
        let through = codes().any(|row| row.code == Code::ArcThrough);
        let other = codes().any(|row| row.group == Group::Motion && row.code != Code::ArcThrough);
        let idle = |word: &&Word| match word.letter {
            Address::I | Address::J | Address::K => !through && (other || points),
            letter => self.control.axis(letter).is_some() && !points,
        };
        let Some(word) = words.iter().filter(|word| word.index.is_some()).find(idle) else { return };
        let (start, end) = (word.offset as usize, word.offset as usize + word.len as usize);
        let written = self.cursor.line.get(start..end).unwrap_or_default();
        let number = written.iter().position(|&b| b == b'=').unwrap_or(1);
        let name = String::from_utf8_lossy(written.get(..number).unwrap_or_default()).trim_ascii().to_ascii_uppercase();
        let letter = word.letter.to_string();
        let place = self.place(self.span(start, start + number));
        let finding = Diagnostic::warning(msg!("nc.numbered-axis", word = name, axis = letter.as_str()));
        let finding = finding.at(self.place(self.span(start, end)));
        self.add_finding(finding.fix(msg!("nc.fix.write", text = format!("{letter}=")), vec![(place, letter)]));
    }

    /// Reports `M98 P9100 L2`, the program call of other controls; returns whether the block is one.
    fn foreign_call(&mut self, words: &[Word]) -> bool {
        let value = |letter: Address| {
            let word = words.iter().find(|word| word.letter == letter)?;
            Some((word, if let WordValue::Number(number) = word.value { Some(number) } else { None }?))
        };
        let (Some((call, number)), Some((_, program))) = (value(Address::M), value(Address::P)) else { return false };
        if number != Dec::int(98) || words.len() > 3 || words.len() == 3 && value(Address::L).is_none() {
            return false;
        }
        let (start, end) = (call.offset as usize, self.cursor.line.len());
        // Without L, digits in front of the four of the program count the runs.
        let called = match (value(Address::L), program) {
            (Some((_, repeats)), _) => format!("L{program} P{repeats}"),
            (None, Dec { mantissa: 10_000.., scale: 0, .. }) => {
                let (repeats, called) = split_repeats(program.mantissa);
                format!("L{called} P{repeats}")
            }
            _ => format!("L{program}"),
        };
        self.report_replaced(Alarm::Format, start, end, msg!("nc.foreign-call"), &called);
        true
    }

    /// Row of a code word.
    fn row_of(&self, word: &Word) -> Option<&'static CodeDef> {
        let WordValue::Number(Dec { scale: 0, .. }) = word.value else { return None };
        // M codes of a second spindle have their own groups.
        let own = word.letter != Address::M || word.index.is_none_or(|spindle| spindle <= 1);
        if own { self.tables.codes.row_of(word) } else { None }
    }

    /// Reports a code that excludes earlier codes or other words; returns whether the block has to be divided.
    fn check_code(&mut self, row: &CodeDef, word: &Word, before: &[Option<&CodeDef>], count: usize) -> bool {
        let (start, end) = (word.offset as usize, word.offset as usize + word.len as usize);
        let name = self.control.code_name(row.id);
        let mut before = before.iter().flatten();
        if row.stands_alone() {
            let fits = |word: &Word| match row.code {
                Code::Dwell => matches!(word.letter, Address::F | Address::S),
                _ => word.letter == Address::S || self.control.axis(word.letter).is_some(),
            };
            let words = self.deck.words.get(self.deck.words.len() - count..).unwrap_or_default();
            if count == 1 {
                let base = self.cursor.base as usize;
                self.warn(base + start, base + end, msg!("nc.no-values", code = name));
                return true;
            }
            let both = words.iter().any(|word| word.letter == Address::S) && words.len() > 2;
            if let ([first, second], Code::Dwell) = (words, row.code)
                && let (first, second) = (*first, *second)
                && first.offset == word.offset
                && self.dwell_of_others(&first, &second)
            {
                return true;
            }
            let words = self.deck.words.get(self.deck.words.len() - count..).unwrap_or_default();
            let others = || words.iter().filter(|other| other.offset != word.offset);
            if both || others().any(|word| !fits(word)) {
                let of_dwell = |word: &Word| fits(word) || self.control.axis(word.letter).is_some();
                let message = match row.code {
                    Code::Dwell if others().all(of_dwell) => msg!("nc.dwell-one-time", code = name),
                    _ => msg!("nc.not-alone", code = name),
                };
                self.report(Alarm::NotAlone, start, end, message);
                return true;
            }
        } else if row.defines_syntax() {
            if let Some(other) = before.find(|other| other.defines_syntax()) {
                let other = self.control.code_name(other.id);
                self.report(Alarm::SyntaxTwice, start, end, msg!("nc.syntax-twice", first = other, second = name));
            }
        } else if !matches!(row.group, Group::Other | Group::OneShot)
            && let Some(other) = before.find(|other| other.group == row.group)
        {
            let other = self.control.code_name(other.id);
            let alarm = if matches!(row.id, CodeId::M(_)) { Alarm::AuxiliaryTwice } else { Alarm::GroupTwice };
            self.report(alarm, start, end, msg!("nc.group-twice", first = other, second = name));
        }
        false
    }
}
