//! Expressions: in macro statements and behind addresses.

use super::super::ast::{Expr, ExprId, Op};
use super::super::dec::Dec;
use super::quick_fixes::{Mend, meant};
use super::{LeftOut, Misused, Read, Reader};
use crate::controls::syntax::Function;
use crate::controls::vars::is_fitted;
use crate::controls::{Alarm, VarKind};
use crate::msg;
use crate::text::{Message, Severity, Span};

/// Parts of the formulas of one block: bounds the depth of every tree, for whoever walks it.
const PARTS: u32 = 250;

/// Brackets and signs inside one another, far beyond what a control takes.
const DEPTH: u32 = 40;

/// Operators that are letters.
const LETTERED: [(&str, Op); 4] = [("AND", Op::And), ("MOD", Op::Modulo), ("OR", Op::Or), ("XOR", Op::Xor)];

/// An opened bracket: where, and which byte closes it.
pub(super) struct Open {
    pub(super) at: usize,
    close: u8,
}

/// Names that functions have in other languages.
const OTHER_NAMES: [(&str, &str); 7] = [
    ("INT", "FIX"),
    ("TRUNC", "FIX"),
    ("CEIL", "FUP"),
    ("TG", "TAN"),
    ("ARCSIN", "ASIN"),
    ("ARCCOS", "ACOS"),
    ("ARCTAN", "ATAN"),
];

impl Reader<'_> {
    /// Whether the line goes on with this word, in capitals or not.
    pub(super) fn ahead(&self, word: &str) -> bool {
        let rest = self.line.get(self.at..self.at + word.len());
        rest.is_some_and(|rest| rest.eq_ignore_ascii_case(word.as_bytes()))
    }

    /// Takes this word if it stands here.
    pub(super) fn take(&mut self, word: &str) -> bool {
        let ahead = self.ahead(word);
        if ahead {
            for at in self.at..self.at + word.len() {
                self.note_case(at);
            }
            self.at += word.len();
        }
        ahead
    }

    /// Counts a part of a formula, which starts at `start` and ends at hand, and adds it to the tree.
    pub(super) fn part(&mut self, expr: Expr, start: usize) -> Read<ExprId> {
        self.parts += 1;
        if self.parts > PARTS {
            return Err(self.failure(Alarm::Format, 0, self.line.len(), msg!("nc.formula-too-long", PARTS), false));
        }
        if self.places.is_some() {
            self.note_place(start);
        }
        self.deck.exprs.push(expr);
        Ok(ExprId(self.deck.exprs.len() as u32 - 1))
    }

    /// Remembers where a part stands, without the blanks around it.
    #[cold]
    fn note_place(&mut self, start: usize) {
        let text = self.line.get(start..self.at).unwrap_or_default();
        let start = self.at - text.trim_ascii_start().len();
        let span = Span::new(start as u32, (start + text.trim_ascii().len()) as u32);
        self.places.get_or_insert_default().push(span);
    }

    /// An expression. Behind an address (`word`) a `/` before a letter is a block skip, not a division.
    pub(super) fn formula(&mut self, word: bool) -> Read<ExprId> {
        let start = self.at;
        let mut left = self.term(word)?;
        while let Some(op) = self.operator(word, false) {
            let right = self.term(word)?;
            left = self.part(Expr::Binary(op, left, right), start)?;
        }
        Ok(left)
    }

    fn term(&mut self, word: bool) -> Read<ExprId> {
        let start = self.at;
        let mut left = self.factor()?;
        loop {
            let end = self.at;
            let Some(op) = self.operator(word, true) else {
                let quotient = self.names().is_some() && self.peek() | 0x20 == b'd' && self.quotient_ahead();
                if !quotient {
                    return Ok(left);
                }
                let right = self.factor()?;
                let ratio = self.part(Expr::Binary(Op::Divide, left, right), start)?;
                left = self.part(Expr::Call(Function::Fix, ratio), start)?;
                continue;
            };
            let behind = self.at;
            if op == Op::Multiply && self.peek() == b'*' {
                left = self.power(left, start, end)?;
                continue;
            }
            let right = self.factor()?;
            if op == Op::Modulo && !self.tables.rules.modulo {
                self.no_modulo(start, end, behind);
            }
            left = self.part(Expr::Binary(op, left, right), start)?;
        }
    }

    /// `a MOD b`, ended at hand, on a control that lacks it: `a` ends at `end`, `b` starts at `behind`.
    fn no_modulo(&mut self, start: usize, end: usize, behind: usize) {
        let text = |from: usize, to: usize| {
            String::from_utf8_lossy(self.line.get(from..to).unwrap_or_default()).trim().to_owned()
        };
        let (left, right) = (text(start, end), text(behind, self.at));
        let blank = self.line.get(start..end).unwrap_or_default();
        let start = end - blank.trim_ascii_start().len();
        let finding = self.finding(Alarm::Format, behind - 3, behind, msg!("nc.no-modulo", self.control.name));
        let finding = finding.hint(msg!("nc.hint.modulo"));
        self.replace(Alarm::Format, finding, start, self.at, &format!("[{left}-FIX[{left}/{right}]*{right}]"));
    }

    /// Whether an operator stands here, seen from behind the value of a word.
    pub(super) fn operator_ahead(&self) -> bool {
        match self.peek() {
            b'+' | b'-' | b'*' => true,
            b'/' => !self.skip_mark_ahead(),
            // Mostly the next word stands here, a letter with its number.
            _ => {
                let letters = self.line.get(self.at + 1).is_some_and(u8::is_ascii_alphabetic);
                letters && LETTERED.iter().any(|(word, _)| self.ahead(word))
            }
        }
    }

    /// Whether the `/` at hand stands before a word: a block skip in the middle of a block.
    pub(super) fn skip_mark_ahead(&self) -> bool {
        let mut rest = self.line.get(self.at + 1..).unwrap_or_default();
        // `/2 Z1.` behind a blank: the second switch.
        if let [b'1'..=b'9', b' ', ..] = rest
            && self.at > 0
            && self.line.get(self.at - 1) == Some(&b' ')
        {
            rest = &rest[1..];
        }
        let mut letters = rest.iter().skip_while(|b| **b == b' ');
        letters.next().is_some_and(u8::is_ascii_alphabetic) && !letters.next().is_some_and(u8::is_ascii_alphabetic)
    }

    /// Takes an operator of one level.
    fn operator(&mut self, word: bool, multiplicative: bool) -> Option<Op> {
        let op = match self.skip() {
            b'+' if !multiplicative => Op::Add,
            b'-' if !multiplicative => Op::Subtract,
            b'*' if multiplicative => Op::Multiply,
            b'/' if multiplicative && !(word && self.skip_mark_ahead()) => Op::Divide,
            byte if byte.is_ascii_alphabetic() => {
                let (name, op) = LETTERED.iter().find(|(name, _)| self.ahead(name))?;
                // Where comparisons come last, the others stand between them and sums.
                if self.names().is_some() && *op != Op::Modulo {
                    return None;
                }
                if matches!(op, Op::And | Op::Modulo) != multiplicative {
                    return None;
                }
                self.take(name);
                return Some(*op);
            }
            _ => return None,
        };
        self.at += 1;
        Some(op)
    }

    /// Goes one level down, within the budget.
    pub(super) fn deeper(&mut self) -> Read<()> {
        self.depth += 1;
        if self.depth > DEPTH {
            return Err(self.failure(Alarm::BracketDepth, self.at, self.at, self.too_deep(), false));
        }
        Ok(())
    }

    fn too_deep(&self) -> Message {
        msg!("nc.bracket-depth", u32::from(self.control.syntax.bracket_depth))
    }

    pub(super) fn factor(&mut self) -> Read<ExprId> {
        let byte = self.skip();
        let start = self.at;
        match byte {
            b'R' | b'r' if self.parameter_ahead() => self.variable(false),
            b'#' if self.names().is_some() => self.hash_variable(false),
            b'[' if self.names().is_some() => self.square_group(),
            b'$' if self.names().is_some() => Err(self.system_variable()),
            b'#' => self.variable(false),
            b'0'..=b'9' | b'.' => {
                let mut number = self.digits()?;
                if self.names().is_some() {
                    number = self.named_number(number, start);
                }
                self.part(Expr::Number(number), start)
            }
            b'+' | b'-' => {
                self.at += 1;
                let next = self.skip();
                if next.is_ascii_digit() || next == b'.' {
                    let mut number = self.digits()?;
                    if self.names().is_some() {
                        number = self.named_number(number, start);
                    }
                    number.mantissa *= if byte == b'-' { -1 } else { 1 };
                    return self.part(Expr::Number(number), start);
                }
                self.deeper()?;
                let inner = self.factor()?;
                self.depth -= 1;
                if byte == b'-' { self.part(Expr::Negate(inner), start) } else { Ok(inner) }
            }
            b'[' => self.group(b']'),
            b'(' => self.group(b')'),
            _ if byte.is_ascii_alphabetic() => self.function(),
            _ => Err(self.unexpected()),
        }
    }

    /// `FUNCTION[expr]`, or what else starts with letters where a value should stand.
    fn function(&mut self) -> Read<ExprId> {
        let start = self.at;
        let (name, function) = match self.function_here() {
            Some(known) => {
                self.take(known.0);
                known
            }
            None => self.misspelt_function()?,
        };
        if function == Function::Atan
            && self.control.syntax.atan_of_two
            && let Some(comma) = self.comma_within()
        {
            let message = msg!("nc.atan-alone", self.control.name);
            let mut failure = self.failure(Alarm::AtanForm, start, start + 4, message, false);
            failure.finding =
                self.mend(failure.finding.hint(msg!("nc.hint.atan")), Mend::Write(comma, comma + 1, "]/["));
            return Err(failure);
        }
        let inner = match self.skip() {
            b'(' if self.names().is_some() && function == Function::Atan => return self.two_arguments(start),
            b'[' if self.names().is_some() => self.square_group()?,
            b'[' => self.group(b']')?,
            b'(' if self.rounds => self.group(b')')?,
            _ => self.bare_argument(start, name)?,
        };
        if function == Function::Atan && self.control.syntax.atan_of_two {
            return self.second_argument(inner, start);
        }
        self.part(Expr::Call(function, inner), start)
    }

    /// What a function's name with a slip in it was meant to be.
    fn misspelt_function(&mut self) -> Read<(&'static str, Function)> {
        let start = self.at;
        let rest = self.line.get(start..).unwrap_or_default();
        let letters = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        let name = String::from_utf8_lossy(rest.get(..letters).unwrap_or_default()).to_ascii_uppercase();
        let bracket = rest.get(letters..).unwrap_or_default().trim_ascii_start().first();
        if !matches!(bracket, Some(b'[' | b'(')) {
            return Err(self.failure(Alarm::Format, start, start + letters, msg!("nc.no-operand-but", name), true));
        }
        let message = msg!("nc.unknown-function", name.as_str(), self.control.name);
        let functions = self.control.syntax.functions;
        let alike = OTHER_NAMES.iter().find(|row| row.0 == name).map_or(name.as_str(), |row| row.1);
        match meant(alike, functions.iter().map(|(name, _)| *name)) {
            Some(at) => {
                let (known, function) = functions[at];
                self.at += letters;
                self.slip(Alarm::Format, start, self.at, message, known);
                Ok((known, function))
            }
            None if self.control.syntax.random.contains(&name.as_str()) => {
                let message = msg!("nc.random", name.as_str());
                let mut failure = self.failure(Alarm::Budget, start, start + letters, message, false);
                (failure.finding.severity, failure.finding.alarm, failure.finding.wording) =
                    (Severity::Warning, None, None);
                Err(failure)
            }
            None => Err(self.failure(Alarm::Format, start, start + letters, message, false)),
        }
    }

    /// The argument of a function without brackets.
    fn bare_argument(&mut self, start: usize, name: &str) -> Read<ExprId> {
        let from = self.at;
        self.deeper()?;
        let argument = self.factor();
        self.depth -= 1;
        if self.control.syntax.bare_functions {
            return argument;
        }
        if self.names().is_some() {
            let end = start + name.len();
            return Err(self.failure(Alarm::Format, start, end, msg!("nc.function-round", name), false));
        }
        let finding = self.finding(Alarm::Format, start, from, msg!("nc.function-bracket", name));
        let Ok(argument) = argument else {
            return Err(self.failure(
                Alarm::Format,
                start,
                start + name.len(),
                msg!("nc.function-bracket", name),
                false,
            ));
        };
        self.enclose(Alarm::Format, finding, from, self.at);
        Ok(argument)
    }

    /// Where a comma parts what stands in the brackets that open here.
    fn comma_within(&mut self) -> Option<usize> {
        if self.skip() != b'[' {
            return None;
        }
        let mut depth = 0_u32;
        for (at, byte) in self.line.iter().enumerate().skip(self.at) {
            match byte {
                b'[' => depth += 1,
                b']' if depth == 1 => return None,
                b']' => depth -= 1,
                b',' if depth == 1 => return Some(at),
                _ => {}
            }
        }
        None
    }

    /// The second number of `ATAN[y]/[x]`.
    fn second_argument(&mut self, y: ExprId, start: usize) -> Read<ExprId> {
        let end = self.at;
        let name = start + 4;
        if self.skip() == b'/' {
            self.at += 1;
            let byte = self.skip();
            let from = self.at;
            let x = self.factor()?;
            if byte != b'[' && !self.rounds {
                let finding = self.finding(Alarm::AtanForm, from, self.at, msg!("nc.atan-bracket"));
                self.enclose(Alarm::AtanForm, finding, from, self.at);
            }
            return self.part(Expr::Binary(Op::Atan, y, x), start);
        }
        self.at = end;
        let finding = self.finding(Alarm::AtanForm, start, name, msg!("nc.atan-alone", self.control.name));
        self.replace(Alarm::AtanForm, finding.hint(msg!("nc.hint.atan")), end, end, "/[1]");
        let x = self.part(Expr::Number(Dec::int(1)), end)?;
        self.part(Expr::Binary(Op::Atan, y, x), start)
    }

    fn function_here(&self) -> Option<(&'static str, Function)> {
        // The longest spelling wins: `ATAN` over `ATN` never clash, `SQRT` over `SQR` would.
        let rows = self.control.syntax.functions.iter().filter(|(name, _)| self.ahead(name));
        rows.max_by_key(|(name, _)| name.len()).copied()
    }

    /// Whether a function stands here, with its argument.
    pub(super) fn function_ahead(&self) -> bool {
        self.function_here().is_some_and(|(name, _)| {
            let rest = self.line.get(self.at + name.len()..).unwrap_or_default();
            match rest.iter().find(|b| !b.is_ascii_whitespace()) {
                Some(b'[' | b'(') => true,
                Some(b'#' | b'0'..=b'9' | b'.') => self.control.syntax.bare_functions,
                _ => false,
            }
        })
    }

    /// The bracketed expression at hand.
    pub(super) fn group(&mut self, close: u8) -> Read<ExprId> {
        self.deeper()?;
        let open = self.open(close);
        if self.depth == u32::from(self.control.syntax.bracket_depth) + 1 {
            let message = self.too_deep();
            self.report(Alarm::BracketDepth, open.at, open.at + 1, message);
        }
        let inner = if self.names().is_some() { self.named_formula(false)? } else { self.formula(false)? };
        self.close(open)?;
        self.depth -= 1;
        Ok(inner)
    }

    pub(super) fn open(&mut self, close: u8) -> Open {
        let at = self.at;
        self.at += 1;
        Open { at, close }
    }

    pub(super) fn close(&mut self, open: Open) -> Read<()> {
        let byte = self.skip();
        if byte == open.close {
            if byte == b')' && self.names().is_none() {
                self.round_brackets.push((open.at, self.at));
            }
            self.at += 1;
            return Ok(());
        }
        if self.ended() || byte == b',' && self.names().is_some() {
            let message = if self.names().is_some() { msg!("nc.unclosed-group") } else { msg!("nc.unclosed-square") };
            return Err(self.failure(Alarm::BracketPair, open.at, open.at + 1, message, false));
        }
        if let Some(lost) = self.lost_comparison(self.sentence) {
            return Err(lost);
        }
        let mut failure = self.unexpected();
        failure.at_word = false;
        Err(failure)
    }

    /// `#n`, `#[expr]`, `##n` or `#9nnn`; the reader stands at the `#`.
    pub(super) fn variable(&mut self, written: bool) -> Read<ExprId> {
        let start = self.at;
        self.at += 1;
        match self.skip() {
            b'0'..=b'9' => {
                let from = self.at;
                let mut number = 0_u32;
                for &byte in self.line.get(from..).unwrap_or_default().iter().take_while(|b| b.is_ascii_digit()) {
                    // What is too large stays too large.
                    number = number.saturating_mul(10).saturating_add(u32::from(byte - b'0'));
                    self.at += 1;
                }
                if matches!(self.peek(), b'O' | b'o') && self.zero_for_o() {
                    return self.part(Expr::Var(0), start);
                }
                if let (true, 4, 9000..=9999) = (self.control.syntax.nine_hash, self.at - from, number) {
                    self.check_variable(number - 9000, start, false);
                    let inner = self.part(Expr::Var(number - 9000), start)?;
                    return self.part(Expr::Indirect(inner), start);
                }
                self.check_variable(number, start, written);
                self.part(Expr::Var(number), start)
            }
            b'#' => {
                let from = self.at;
                self.deeper()?;
                let inner = self.variable(false)?;
                self.depth -= 1;
                if !self.control.syntax.double_hash {
                    let finding =
                        self.finding(Alarm::Format, start, self.at, msg!("nc.double-hash", self.control.name));
                    self.enclose(Alarm::Format, finding, from, self.at);
                }
                self.part(Expr::Indirect(inner), start)
            }
            b'[' => {
                let inner = self.group(b']')?;
                self.part(Expr::Indirect(inner), start)
            }
            b'(' if self.rounds => {
                let inner = self.group(b')')?;
                self.part(Expr::Indirect(inner), start)
            }
            _ => {
                let name = self.line.get(start + 1..).unwrap_or_default();
                if !name.first().is_none_or(u8::is_ascii) {
                    self.at = start + 1;
                    return Err(self.unexpected());
                }
                let name = name.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
                let message = if name > 1 { msg!("nc.variable-name") } else { msg!("nc.variable-number") };
                Err(self.failure(Alarm::Format, start, start + 1 + name, message, false))
            }
        }
    }

    /// Whether a variable exists and can stand on this side.
    #[inline]
    fn check_variable(&mut self, number: u32, start: usize, written: bool) {
        if !self.plain.contains(&number) {
            self.check_row(number, start, written);
        }
    }

    fn check_row(&mut self, number: u32, start: usize, written: bool) {
        let alarm = match self.control.var(number) {
            None => Alarm::VariableRange,
            Some(row) if row.kind.common() && !is_fitted(self.tables.rules.fitted, number) => Alarm::VariableRange,
            Some(row) => match row.kind {
                VarKind::Local | VarKind::Common | VarKind::Retained => {
                    let last = self.tables.rules.fitted.iter().map(|range| range.1).find(|&last| number <= last);
                    self.plain = row.first..row.last.min(last.unwrap_or(u32::MAX)).saturating_add(1);
                    return;
                }
                VarKind::NotSimulated => {
                    let message = msg!("nc.variable-stops", self.control.variable(number), row.text);
                    return self.say_once(LeftOut::Variables(row.first), start, self.at, message);
                }
                VarKind::Vacant if written => Alarm::VacantWritten,
                kind if written && !kind.writable() => Alarm::ReadOnly,
                VarKind::AlarmMessage | VarKind::StopMessage if !written => Alarm::VariableSide,
                _ => return,
            },
        };
        // Reported once per number, with the file read, when a free variable is known.
        self.bad.get_or_insert(alarm);
        let known = self.misused.iter().any(|m| m.number == number && m.alarm == alarm);
        if !known && self.misused.len() < 100 {
            self.misused.push(Misused { number, alarm, span: self.span(start, self.at) });
        }
    }
}
