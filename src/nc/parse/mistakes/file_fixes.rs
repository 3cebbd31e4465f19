//! Findings about a whole file, with fixes: `%`, small letters, line ends, variables missing on the control.

use std::collections::BTreeSet;

use crate::controls::syntax::{Function, Percent};
use crate::controls::{Alarm, VarKind};
use crate::msg;
use crate::nc::lex::spelling::arithmetic;
use crate::nc::parse::failure::Misused;
use crate::nc::parse::reader::Reader;
use crate::nc::parsed::FINDINGS;
use crate::text::lines::line_end;
use crate::text::{BYTE_ORDER_MARK, Diagnostic, DiagnosticKind, Span};

/// Size limit (bytes) of files for fixes of the whole text.
const WHOLE: usize = 1 << 20;

impl Reader<'_> {
    /// Reports findings about the whole file: `%`, small letters, missing variables.
    pub(in crate::nc::parse) fn report_file(&mut self, opened: bool, closed: bool) {
        if self.foreign_bytes() {
            return;
        }
        if self.deck.programs.last().is_none_or(|program| program.file != self.file.id) {
            let place = self.place(Span::at(0));
            return self.findings.list.push(Diagnostic::warning(msg!("nc.empty-file")).at(place));
        }
        self.variables();
        let opened = opened || self.control.syntax.percent == Percent::End;
        // A `%` after comments alone opens the record.
        let begun = closed || !self.only_comments();
        if begun && !(opened && closed) && self.control.syntax.percent != Percent::Head {
            self.percent(opened, closed);
        }
        if let Some(at) = self.notes.hash {
            self.hashes(at);
        }
        if let Some(at) = self.notes.small.filter(|_| self.names().is_none()) {
            let place = self.place(Span::new(at, at + 1));
            let mut finding = Diagnostic::info(msg!("nc.small-letters", control = self.control.name)).at(place);
            if self.file.text.len() <= WHOLE {
                let all = self.place(Span::new(0, self.file.text.len() as u32));
                // A letter l in place of a 1 has a fix of its own; as a capital it would be an address.
                let capital = |(at, c): (usize, char)| {
                    if self.notes.ones.contains(&(at as u32)) { c } else { c.to_ascii_uppercase() }
                };
                let capitals = self.file.text.char_indices().map(capital).collect();
                finding = finding.fix(msg!("nc.fix.capitals"), vec![(all, capitals)]);
            }
            self.findings.list.push(finding);
        }
        if let Some(at) = self.notes.semicolon {
            let place = self.place(Span::new(at, at + 1));
            self.findings.list.push(Diagnostic::info(msg!("nc.semicolon")).at(place));
        }
        if let Some(span) = self.notes.foreign {
            let text = span.of(self.file.text).to_owned();
            let finding = Diagnostic::warning(msg!("nc.foreign-comment", character = text)).at(self.place(span));
            self.findings.list.push(finding);
        }
    }

    /// Reports a byte order mark, and line ends that no control reads. Returns whether such line ends were found; the text is one line
    /// then.
    fn foreign_bytes(&mut self) -> bool {
        if self.file.text.starts_with(BYTE_ORDER_MARK) {
            let place = self.place(Span::new(0, BYTE_ORDER_MARK.len_utf8() as u32));
            let finding = Diagnostic::warning(msg!("nc.byte-order-mark")).kind(DiagnosticKind::ByteOrderMark).at(place);
            self.findings.list.push(finding.fix(msg!("nc.fix.byte-order-mark"), vec![(place, String::new())]));
        }
        if !self.file.text.as_bytes().contains(&b'\n')
            && let Some(at) = self.file.text.trim_ascii_end().find('\r')
        {
            let at = self.place(Span::new(at as u32, at as u32 + 1));
            let mut finding = Diagnostic::error(msg!("nc.carriage-returns")).at(at);
            if self.file.text.len() <= WHOLE {
                let all = self.place(Span::new(0, self.file.text.len() as u32));
                finding = finding.fix(msg!("nc.fix.line-ends"), vec![(all, self.file.text.replace('\r', "\n"))]);
            }
            // Removes findings about the text as one line.
            self.findings.list.retain(|finding| finding.kind == DiagnosticKind::ByteOrderMark);
            self.findings.list.push(finding);
            return true;
        }
        false
    }

    fn percent(&mut self, opened: bool, closed: bool) {
        let newline = line_end(self.file.text);
        let len = self.file.text.len() as u32;
        let mut edits = Vec::new();
        if !opened {
            edits.push((self.place(Span::at(0)), format!("%{newline}")));
        }
        if !closed {
            let lead = if self.file.text.ends_with('\n') { "" } else { newline };
            edits.push((self.place(Span::at(len)), format!("{lead}%{newline}")));
        }
        let at = if opened { len } else { 0 };
        let message = match self.control.syntax.percent {
            Percent::Both => msg!("nc.no-percent"),
            Percent::End | Percent::Head => msg!("nc.no-last-percent"),
        };
        let finding = Diagnostic::info(message).at(self.place(Span::at(at)));
        self.findings.list.push(finding.fix(msg!("nc.fix.percent"), edits));
    }

    /// Finding for variables in the spelling of other controls, at the first of them.
    fn hash_misuse(&self, at: u32) -> Diagnostic {
        let letter = self.control.syntax.variable.to_string();
        let name: String = self.file.text.get(at as usize..).unwrap_or("").chars().take(1).collect();
        let message = msg!("nc.hash-variable", letter, control = self.control.name);
        let place = self.place(Span::new(at, at + name.len() as u32));
        Diagnostic::error(message).at(place).alarm(self.control.alarm_shown(Alarm::Format))
    }

    /// Reports variables in the spelling of other controls, with a fix for all of them.
    fn hashes(&mut self, at: u32) {
        let letter = self.control.syntax.variable.to_string();
        let mut finding = self.hash_misuse(at);
        if self.file.text.len() <= WHOLE {
            let mut edits = Vec::new();
            let (mut comment, mut quoted) = (false, false);
            for (at, byte) in (0..).zip(self.file.text.bytes()) {
                match byte {
                    b'\n' => (comment, quoted) = (false, false),
                    b'"' => quoted ^= !comment,
                    b';' if !quoted => comment = true,
                    b'#' if !(comment || quoted) => edits.push((self.place(Span::new(at, at + 1)), letter.clone())),
                    _ => {}
                }
            }
            // Quotes within a comment of another language hide variables seen by the parser.
            if !edits.is_empty() {
                finding = finding.fix(msg!("nc.fix.variables", letter), edits);
            }
        }
        self.add_finding(finding);
    }

    /// Finding for a variable that is missing or read-only on the control.
    fn misuse(&self, row: &Misused) -> Diagnostic {
        let name = row.span.of(self.file.text).trim();
        let message = match (row.alarm, self.control.var(row.number)) {
            (Alarm::VariableRange, None) => msg!("nc.no-such-variable", variable = name, control = self.control.name),
            (Alarm::VariableRange, Some(range)) => {
                msg!("nc.variable-not-fitted", variable = name, meaning = range.text, switch = self.control.fitted_by())
            }
            (_, Some(range)) => msg!("nc.read-only-variable", variable = name, meaning = range.text),
            _ => msg!("nc.read-only-variable", variable = name, meaning = ""),
        };
        Diagnostic::error(message).at(self.place(row.span)).alarm(self.control.alarm_shown(row.alarm))
    }

    /// Reports variables that are missing or read-only on the control, each once, with a free variable as replacement.
    fn variables(&mut self) {
        let misused = core::mem::take(&mut self.findings.misused);
        if misused.is_empty() {
            return;
        }
        let known = self.file.text.len() <= WHOLE && self.names().is_none();
        let named = if known { variables_of(self.file.text, self.control.syntax.functions) } else { Vec::new() };
        let numbers = |span_is: &dyn Fn(&Span) -> bool| -> BTreeSet<u32> {
            named.iter().filter(|(_, span)| span_is(span)).map(|(number, _)| *number).collect()
        };
        let is_assigned = |span: &Span| {
            let after = self.file.text.get(span.end as usize..).unwrap_or("");
            after.trim_start_matches(' ').starts_with('=')
        };
        // P of a `G65 H` function is its result.
        let is_result =
            |span: &Span| self.file.text.get(..span.start as usize).is_some_and(|before| before.ends_with(['P', 'p']));
        let (assigned, results) = (numbers(&is_assigned), numbers(&is_result));
        let read = numbers(&|span| !is_assigned(span) && !is_result(span));
        let mut used = numbers(&|_| true);
        for row in &misused {
            let mut finding = self.misuse(row);
            // Only variables that the file writes and reads are replaced as scratch variables. What is only written is meant for another
            // control's PLC, offsets or screen, what is only read comes from there.
            let is_scratch = row.alarm == Alarm::VariableRange
                && read.contains(&row.number)
                && matches!(row.number, 0..1000 | 1200..3000)
                && (assigned.contains(&row.number) || results.contains(&row.number));
            let free = if is_scratch { self.free_variable(&used, &assigned) } else { None };
            if let Some(free) = free {
                used.insert(free);
                // An option of the control: it may be fitted, and the other variable be in use elsewhere.
                if self.control.var(row.number).is_some() {
                    finding.kind = DiagnosticKind::GuessedFix;
                }
                let title = msg!(
                    "nc.fix.variable",
                    variable = format!("#{free}"),
                    present = row.span.of(self.file.text).trim()
                );
                let uses = named.iter().filter(|(number, _)| *number == row.number).take(FINDINGS);
                let edits = uses.map(|&(_, span)| (self.place(span), format!("#{free}"))).collect();
                finding = finding.fix(title, edits);
            } else if row.alarm == Alarm::VariableRange {
                finding.hints.extend(self.control.free_to_use());
            }
            self.add_finding(finding);
        }
    }

    /// A common variable unused in the file: the one before the lowest assigned one, else the lowest.
    fn free_variable(&self, used: &BTreeSet<u32>, assigned: &BTreeSet<u32>) -> Option<u32> {
        let range = self.control.vars.iter().find(|row| row.kind == VarKind::Common)?;
        let free = |number: &u32| (range.first..=range.last).contains(number) && !used.contains(number);
        let first = assigned.range(range.first..=range.last).next();
        first.and_then(|number| number.checked_sub(1)).filter(free).or_else(|| (range.first..=range.last).find(free))
    }
}

/// Every `#n` outside comments, in the order of the text. A round bracket with arithmetic is no comment: its variables count.
fn variables_of(text: &str, functions: &[(&str, Function)]) -> Vec<(u32, Span)> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut comment = false;
    // End of the last round bracket: another one that opens in it belongs to it.
    let mut closed = 0;
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        let start = at;
        at += 1;
        match byte {
            b'(' if at >= closed => {
                let inner = bytes.get(at..).unwrap_or_default();
                let inner = inner.split(|b| matches!(b, b')' | b'\n')).next().unwrap_or_default();
                comment = !arithmetic(inner, functions);
                closed = at + inner.len();
            }
            b')' | b'\n' => comment = false,
            b'#' if !comment => {
                let digits = bytes.get(at..).unwrap_or_default().iter().take_while(|b| b.is_ascii_digit()).count();
                let number = text.get(at..at + digits).and_then(|digits| digits.parse().ok());
                at += digits;
                found.extend(number.map(|number| (number, Span::new(start as u32, at as u32))));
            }
            _ => {}
        }
    }
    found
}
