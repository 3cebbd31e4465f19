//! Expressions in macro statements and after addresses.

use crate::controls::syntax::{ArcTangent, Function};
use crate::controls::vars::is_fitted;
use crate::controls::{Alarm, VarKind};
use crate::msg;
use crate::nc::ast::{BadBlock, Expr, ExprId, Op};
use crate::nc::dec::Dec;
use crate::nc::lex::keywords::OPERATORS;
use crate::nc::lex::spelling::{meant, several_meant, zero_as_letter};
use crate::nc::parse::failure::{IgnoredFeature, LineFix, Misused, ParseFailure, Read};
use crate::nc::parse::reader::{Reader, starts_value};
use crate::nc::parsed::ExprSpan;
use crate::text::{Diagnostic, DiagnosticKind, Message};

/// Maximum parts of the formulas of one block; limits the depth of every tree.
const PARTS: u32 = 250;

/// Maximum nesting of brackets and signs, far beyond the limit of any control.
const DEPTH: u32 = 40;

/// Meaning of `/` in a formula.
#[derive(Clone, Copy, PartialEq)]
enum Slash {
    /// Division.
    Divides,
    /// Block skip before a letter, else division: after an address.
    MaySkip,
}

/// Operators of one precedence.
#[derive(Clone, Copy, PartialEq)]
enum Level {
    /// Sum, difference, OR, XOR.
    Sum,
    /// Product, quotient, AND, MOD.
    Product,
}

/// Side of an assignment that a variable is on.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum VariableAccess {
    /// The value of the variable is used.
    Read,
    /// The variable is assigned.
    Write,
}

/// An open bracket: its position and its closing byte.
pub(super) struct OpenBracket {
    pub(super) at: usize,
    close: u8,
}

/// Function names of other languages.
const OTHER_NAMES: [(&str, Function); 13] = [
    ("INT", Function::Fix),
    ("TRUNC", Function::Fix),
    ("CEIL", Function::Fup),
    ("TG", Function::Tan),
    ("ARCSIN", Function::Asin),
    ("ARCCOS", Function::Acos),
    ("ARCTAN", Function::Atan),
    ("ATN", Function::Atan),
    ("ATAN", Function::Atan),
    ("ATAN2", Function::Atan),
    ("SQR", Function::Sqrt),
    ("POT", Function::Square),
    ("POW", Function::Power),
];

impl Reader<'_> {
    /// Reads this word if it is at the cursor.
    pub(super) fn take(&mut self, word: &str) -> bool {
        let ahead = self.cursor.ahead(word);
        if ahead {
            for at in self.cursor.at..self.cursor.at + word.len() {
                self.note_case(at);
            }
            self.cursor.at += word.len();
        }
        ahead
    }

    /// Counts a part of a formula, from `start` to the cursor, and adds it to the tree.
    pub(super) fn add_expr(&mut self, expr: Expr, start: usize) -> Read<ExprId> {
        self.formulas.parts += 1;
        if self.formulas.parts > PARTS {
            return Err(self.failure(
                Alarm::Format,
                0,
                self.cursor.line.len(),
                msg!("nc.formula-too-long", most = PARTS),
            ));
        }
        self.deck.exprs.push(expr);
        self.places.exprs.push(ExprSpan {
            start: self.cursor.base + start as u32,
            len: self.cursor.at.saturating_sub(start) as u16,
        });
        Ok(ExprId(self.deck.exprs.len() as u32 - 1))
    }

    /// Reads an expression.
    pub(super) fn formula(&mut self) -> Read<ExprId> {
        self.sum(Slash::Divides)
    }

    /// Reads an expression after an address.
    pub(super) fn formula_of_word(&mut self) -> Read<ExprId> {
        self.sum(Slash::MaySkip)
    }

    fn sum(&mut self, slash: Slash) -> Read<ExprId> {
        let start = self.cursor.at;
        let mut left = self.term(slash)?;
        while let Some(op) = self.operator(slash, Level::Sum) {
            let right = self.term(slash)?;
            left = self.add_expr(Expr::Binary(op, left, right), start)?;
        }
        Ok(left)
    }

    fn term(&mut self, slash: Slash) -> Read<ExprId> {
        let start = self.cursor.at;
        let mut left = self.factor()?;
        loop {
            let end = self.cursor.at;
            let Some(op) = self.operator(slash, Level::Product) else {
                let quotient = self.names().is_some() && self.cursor.peek() | 0x20 == b'd' && self.quotient_ahead();
                if !quotient {
                    return Ok(left);
                }
                let right = self.factor()?;
                let ratio = self.add_expr(Expr::Binary(Op::Divide, left, right), start)?;
                left = self.add_expr(Expr::Call(Function::Fix, ratio), start)?;
                continue;
            };
            let after = self.cursor.at;
            if op == Op::Multiply && self.cursor.peek() == b'*' {
                left = self.power(left, start, end)?;
                continue;
            }
            let right = self.factor()?;
            if op == Op::Modulo && !self.tables.rules.modulo {
                self.no_modulo(start, end, after);
            }
            left = self.add_expr(Expr::Binary(op, left, right), start)?;
        }
    }

    /// Reports `a MOD b`, which ends at the cursor, on a control without MOD: `a` ends at `end`, `b` starts at `after`.
    fn no_modulo(&mut self, start: usize, end: usize, after: usize) {
        let text = |from: usize, to: usize| {
            String::from_utf8_lossy(self.cursor.line.get(from..to).unwrap_or_default()).trim().to_owned()
        };
        let (left, right) = (text(start, end), text(after, self.cursor.at));
        let blank = self.cursor.line.get(start..end).unwrap_or_default();
        let start = end - blank.trim_ascii_start().len();
        let finding = self.finding(Alarm::Format, after - 3, after, msg!("nc.no-modulo", control = self.control.name));
        let finding = finding.hint(msg!("nc.hint.modulo"));
        self.report_replacing(
            Alarm::Format,
            finding,
            start,
            self.cursor.at,
            &format!("[{left}-FIX[{left}/{right}]*{right}]"),
        );
    }

    /// Whether an operator follows the value of a word.
    pub(super) fn operator_ahead(&self) -> bool {
        match self.cursor.peek() {
            b'+' | b'-' | b'*' => true,
            b'/' => !self.skip_mark_ahead(),
            // Usually the next word follows: a letter with its number.
            _ => {
                let letters = self.cursor.line.get(self.cursor.at + 1).is_some_and(u8::is_ascii_alphabetic);
                letters && OPERATORS.iter().any(|(word, _)| self.cursor.ahead(word))
            }
        }
    }

    /// Whether the `/` at the cursor precedes a word: a block skip inside a block.
    pub(super) fn skip_mark_ahead(&self) -> bool {
        let mut rest = self.cursor.line.get(self.cursor.at + 1..).unwrap_or_default();
        // `/2 Z1.` after a blank: skip switch 2.
        if let [b'1'..=b'9', b' ', ..] = rest
            && self.cursor.at > 0
            && self.cursor.line.get(self.cursor.at - 1) == Some(&b' ')
        {
            rest = &rest[1..];
        }
        let mut letters = rest.iter().skip_while(|b| **b == b' ');
        letters.next().is_some_and(u8::is_ascii_alphabetic) && !letters.next().is_some_and(u8::is_ascii_alphabetic)
    }

    /// Reads an operator of one level.
    fn operator(&mut self, slash: Slash, level: Level) -> Option<Op> {
        let multiplicative = level == Level::Product;
        let op = match self.next_byte() {
            b'+' if !multiplicative => Op::Add,
            b'-' if !multiplicative => Op::Subtract,
            b'*' if multiplicative => Op::Multiply,
            b'/' if multiplicative && !(slash == Slash::MaySkip && self.skip_mark_ahead()) => Op::Divide,
            byte if byte.is_ascii_alphabetic() => {
                let (name, op) = OPERATORS.iter().find(|(name, _)| self.cursor.ahead(name))?;
                // In a language with names, logic operators bind weaker than sums and stronger than comparisons.
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
        self.cursor.at += 1;
        Some(op)
    }

    /// Enters one nesting level, within the budget.
    pub(super) fn deeper(&mut self) -> Read<()> {
        self.formulas.depth += 1;
        if self.formulas.depth > DEPTH {
            return Err(self.failure(Alarm::BracketDepth, self.cursor.at, self.cursor.at, self.too_deep()));
        }
        Ok(())
    }

    fn too_deep(&self) -> Message {
        msg!("nc.bracket-depth", most = u32::from(self.control.syntax.bracket_depth))
    }

    pub(super) fn factor(&mut self) -> Read<ExprId> {
        let byte = self.next_byte();
        let start = self.cursor.at;
        match byte {
            b'R' | b'r' if self.parameter_ahead() => self.variable(VariableAccess::Read),
            b'#' if self.names().is_some() => self.hash_variable(VariableAccess::Read),
            b'[' if self.names().is_some() => self.square_group(),
            b'$' if self.names().is_some() => Err(self.system_variable()),
            b'_' if self.names().is_some() => Err(self.unknown_name(start, self.cursor.name())),
            b'#' => self.variable(VariableAccess::Read),
            b'0'..=b'9' | b'.' => {
                let number = self.formula_number(start)?;
                self.add_expr(Expr::Number(number), start)
            }
            b'+' | b'-' => {
                self.cursor.at += 1;
                let next = self.next_byte();
                if matches!(next, b'+' | b'-') {
                    self.two_signs(start);
                }
                if next.is_ascii_digit() || next == b'.' {
                    let mut number = self.formula_number(start)?;
                    number.mantissa *= if byte == b'-' { -1 } else { 1 };
                    return self.add_expr(Expr::Number(number), start);
                }
                self.deeper()?;
                let inner = self.factor()?;
                self.formulas.depth -= 1;
                if byte == b'-' { self.add_expr(Expr::Negate(inner), start) } else { Ok(inner) }
            }
            b'[' => self.group(b']'),
            b'(' => self.group(b')'),
            _ if byte.is_ascii_alphabetic() => self.function(),
            _ => Err(self.unexpected()),
        }
    }

    /// Reads an unsigned number of a formula; with its sign it starts at `start`.
    #[inline]
    fn formula_number(&mut self, start: usize) -> Read<Dec> {
        let number = self.unsigned_number()?;
        Ok(if self.names().is_some() { self.symbolic_number(number, start) } else { number })
    }

    /// Reports several signs in a row, from `start` on; reads them as arithmetic does.
    #[cold]
    fn two_signs(&mut self, start: usize) {
        let after = self.cursor.line.get(start..).unwrap_or_default();
        let run = after.iter().take_while(|b| matches!(b, b'+' | b'-' | b' ' | b'\t')).count();
        let signs = after.get(..run).unwrap_or_default().trim_ascii_end();
        let place = self.place(self.span(start, start + signs.len()));
        let last = self.findings.list.last().filter(|last| last.kind == DiagnosticKind::TwoSigns);
        if last.and_then(|last| last.place).is_some_and(|last| last.covers(place)) {
            return;
        }
        let written = String::from_utf8_lossy(signs).into_owned();
        let positive = signs.iter().filter(|b| **b == b'-').count() % 2 == 0;
        let (read, other) = if positive { ("+", "-") } else { ("-", "+") };
        let mut finding =
            Diagnostic::warning(msg!("nc.two-signs", written, read)).kind(DiagnosticKind::TwoSigns).at(place);
        for sign in [read, other] {
            let text = if sign == "+" { "" } else { sign };
            finding = finding.fix(msg!("nc.fix.sign", sign), vec![(place, text.to_owned())]);
        }
        self.add_finding(finding);
    }

    /// Reads `FUNCTION[expr]`, or reports other letters in place of a value.
    fn function(&mut self) -> Read<ExprId> {
        let start = self.cursor.at;
        let (name, function) = match self.function_here() {
            Some(known) => {
                self.take(known.0);
                known
            }
            None => self.misspelt_function()?,
        };
        let atan = self.control.syntax.atan;
        if function == Function::Atan
            && atan == ArcTangent::OfTwo
            && let Some(comma) = self.comma_within()
        {
            let message = msg!("nc.atan-alone", control = self.control.name);
            let mut failure = self.failure(Alarm::AtanForm, start, start + 4, message);
            failure.finding =
                self.with_fix(failure.finding.hint(msg!("nc.hint.atan")), LineFix::Write(comma, comma + 1, "]/["));
            return Err(failure);
        }
        let inner = match self.next_byte() {
            b'(' if self.names().is_some() && function == Function::Atan => {
                return self.two_arguments(Op::Atan, b')', start);
            }
            b'[' if self.names().is_some() => self.square_group()?,
            b'[' if function == Function::Power => return self.two_arguments(Op::Power, b']', start),
            b'[' if function == Function::Atan && self.comma_within().is_some() && atan.takes_two() => {
                return self.two_arguments(Op::Atan, b']', start);
            }
            b'[' => self.group(b']')?,
            b'(' if self.formulas.rounds => self.group(b')')?,
            _ => self.bare_argument(start, name)?,
        };
        let second = atan == ArcTangent::OfTwo || atan.takes_two() && self.next_byte() == b'/' && self.bracket_after();
        if function == Function::Atan && second {
            return self.second_argument(inner, start);
        }
        self.add_expr(Expr::Call(function, inner), start)
    }

    /// Reads `[left,right]` after the name of a function of two numbers; the cursor is at the bracket, closed by `close`.
    pub(super) fn two_arguments(&mut self, op: Op, close: u8, start: usize) -> Read<ExprId> {
        let name = String::from_utf8_lossy(self.cursor.line.get(start..self.cursor.at).unwrap_or_default())
            .trim()
            .to_ascii_uppercase();
        let open = self.open_group(close)?;
        let left = self.inner_formula()?;
        if self.next_byte() != b',' {
            return Err(self.failure(
                Alarm::AtanForm,
                start,
                self.cursor.at,
                msg!("nc.two-arguments", function = name),
            ));
        }
        self.cursor.at += 1;
        let right = self.inner_formula()?;
        self.close_group(open)?;
        self.add_expr(Expr::Binary(op, left, right), start)
    }

    /// Whether an opening bracket follows the byte at the cursor.
    fn bracket_after(&self) -> bool {
        let rest = self.cursor.line.get(self.cursor.at + 1..).unwrap_or_default();
        rest.trim_ascii_start().first() == Some(&b'[')
    }

    /// Whether the text before a byte of the line ends in an operator that needs a right operand. `-` and `/` count only in languages with
    /// names; in others they may introduce an unbracketed comment.
    fn after_operator(&self, at: usize) -> bool {
        match self.cursor.line.get(..at).unwrap_or_default().trim_ascii_end().last() {
            Some(b'=' | b'+' | b'*' | b'(' | b'[' | b',') => true,
            Some(b'-' | b'/') => self.names().is_some(),
            _ => false,
        }
    }

    /// The function closest to a misspelt name.
    fn misspelt_function(&mut self) -> Read<(&'static str, Function)> {
        let start = self.cursor.at;
        let rest = self.cursor.line.get(start..).unwrap_or_default();
        let written = self.cursor.name();
        if self.is_local_variable(written) {
            return Err(self.local_variable(start, written));
        }
        if self.names().is_some() && written.starts_with(['R', 'r']) && zero_as_letter(written) {
            return Err(self.letter_for_zero(start, written));
        }
        let mut letters = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        if OTHER_NAMES.iter().any(|row| row.0.eq_ignore_ascii_case(written)) {
            letters = written.len();
        }
        let name = String::from_utf8_lossy(rest.get(..letters).unwrap_or_default()).to_ascii_uppercase();
        let bracket = rest.get(letters..).unwrap_or_default().trim_ascii_start().first();
        if !matches!(bracket, Some(b'[' | b'(')) {
            let message = msg!("nc.no-operand-but", text = name);
            // A comment in place of a value would leave the operator without one.
            let mut failure = self.failure(Alarm::Format, start, start + letters, message);
            failure.at_word = !self.after_operator(start);
            return Err(failure);
        }
        let message = msg!("nc.unknown-function", function = name.as_str(), control = self.control.name);
        let functions = self.control.syntax.functions;
        let names = functions.iter().map(|(name, _)| *name);
        let other = OTHER_NAMES.iter().find(|row| row.0 == name).map(|row| row.1);
        let place = match other {
            Some(function) => functions.iter().position(|row| row.1 == function),
            None => meant(&name, names.clone()),
        };
        match place {
            Some(at) => {
                let (known, function) = functions[at];
                self.cursor.at += letters;
                let mut finding = self.finding(Alarm::Format, start, self.cursor.at, message);
                // One letter of three may be any letter.
                if other.is_none() && (self.names().is_some() || letters <= 3 || several_meant(&name, names)) {
                    finding.kind = DiagnosticKind::GuessedFix;
                }
                self.report_replacing(Alarm::Format, finding, start, self.cursor.at, known);
                Ok((known, function))
            }
            None if matches!(other, Some(Function::Square | Function::Power)) => {
                let mut failure = self.failure(Alarm::Format, start, start + letters, message);
                failure.finding = failure.finding.hint(msg!("nc.hint.power"));
                Err(failure)
            }
            None if self.control.syntax.random.contains(&name.as_str()) => {
                let message = msg!("nc.random", function = name.as_str());
                Err(self.stops_here(start, start + letters, message))
            }
            None => Err(self.failure(Alarm::Format, start, start + letters, message)),
        }
    }

    /// Reads the argument of a function without brackets.
    fn bare_argument(&mut self, start: usize, name: &str) -> Read<ExprId> {
        let from = self.cursor.at;
        self.deeper()?;
        let argument = self.factor();
        self.formulas.depth -= 1;
        if self.control.syntax.bare_functions {
            return argument;
        }
        if self.names().is_some() {
            let end = start + name.len();
            return Err(self.failure(Alarm::Format, start, end, msg!("nc.function-round", function = name)));
        }
        let finding = self.finding(Alarm::Format, start, from, msg!("nc.function-bracket", function = name));
        let Ok(argument) = argument else {
            return Err(self.failure(
                Alarm::Format,
                start,
                start + name.len(),
                msg!("nc.function-bracket", function = name),
            ));
        };
        self.report_enclosing(Alarm::Format, finding, from, self.cursor.at);
        Ok(argument)
    }

    /// Position of the comma between two arguments in the brackets that open at the cursor.
    fn comma_within(&mut self) -> Option<usize> {
        if self.next_byte() != b'[' {
            return None;
        }
        let mut depth = 0_u32;
        for (at, byte) in self.cursor.line.iter().enumerate().skip(self.cursor.at) {
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

    /// Reads the second number of `ATAN[y]/[x]`.
    fn second_argument(&mut self, y: ExprId, start: usize) -> Read<ExprId> {
        let end = self.cursor.at;
        let name = start + 4;
        if self.next_byte() == b'/' {
            self.cursor.at += 1;
            let byte = self.next_byte();
            let from = self.cursor.at;
            let x = self.factor()?;
            if byte != b'[' && !self.formulas.rounds {
                let finding = self.finding(Alarm::AtanForm, from, self.cursor.at, msg!("nc.atan-bracket"));
                self.report_enclosing(Alarm::AtanForm, finding, from, self.cursor.at);
            }
            return self.add_expr(Expr::Binary(Op::Atan, y, x), start);
        }
        self.cursor.at = end;
        let finding = self.finding(Alarm::AtanForm, start, name, msg!("nc.atan-alone", control = self.control.name));
        self.report_replacing(Alarm::AtanForm, finding.hint(msg!("nc.hint.atan")), end, end, "/[1]");
        let x = self.add_expr(Expr::Number(Dec::int(1)), end)?;
        self.add_expr(Expr::Binary(Op::Atan, y, x), start)
    }

    /// The function at the cursor; the longest spelling wins.
    fn function_here(&self) -> Option<(&'static str, Function)> {
        self.cursor.longest(self.control.syntax.functions)
    }

    /// Whether a function with its argument follows.
    pub(super) fn function_ahead(&self) -> bool {
        self.function_here().is_some_and(|(name, _)| {
            let rest = self.cursor.line.get(self.cursor.at + name.len()..).unwrap_or_default();
            match rest.iter().find(|b| !b.is_ascii_whitespace()) {
                Some(b'[' | b'(') => true,
                Some(b'#' | b'0'..=b'9' | b'.') => self.control.syntax.bare_functions,
                _ => false,
            }
        })
    }

    /// Reads the bracketed expression at the cursor.
    pub(super) fn group(&mut self, close: u8) -> Read<ExprId> {
        let open = self.open_group(close)?;
        let inner = self.inner_formula()?;
        self.close_group(open)?;
        Ok(inner)
    }

    /// Opens a bracket around a formula, one level deeper.
    fn open_group(&mut self, close: u8) -> Read<OpenBracket> {
        self.deeper()?;
        self.formulas.brackets += 1;
        let open = self.open(close);
        if self.formulas.brackets == u32::from(self.control.syntax.bracket_depth) + 1 {
            let message = self.too_deep();
            self.report(Alarm::BracketDepth, open.at, open.at + 1, message);
        }
        Ok(open)
    }

    /// Closes a bracket around a formula.
    fn close_group(&mut self, open: OpenBracket) -> Read<()> {
        self.close(open)?;
        self.formulas.brackets -= 1;
        self.formulas.depth -= 1;
        Ok(())
    }

    /// A formula within brackets.
    fn inner_formula(&mut self) -> Read<ExprId> {
        if self.names().is_some() { self.symbolic_formula() } else { self.formula() }
    }

    pub(super) fn open(&mut self, close: u8) -> OpenBracket {
        let at = self.cursor.at;
        self.cursor.at += 1;
        OpenBracket { at, close }
    }

    pub(super) fn close(&mut self, open: OpenBracket) -> Read<()> {
        let byte = self.next_byte();
        if byte == open.close {
            if byte == b')' && self.names().is_none() {
                self.formulas.round_brackets.push((open.at, self.cursor.at));
            }
            self.cursor.at += 1;
            return Ok(());
        }
        if self.cursor.ended() || byte == b',' && self.names().is_some() {
            let message = if self.names().is_some() { msg!("nc.unclosed-group") } else { msg!("nc.unclosed-square") };
            return Err(self.failure(Alarm::BracketPair, open.at, open.at + 1, message));
        }
        if let Some(stray) = self.stray_comparison(self.formulas.sentence) {
            return Err(stray);
        }
        if let Some(failure) = self.closed_late(&open) {
            return Err(failure);
        }
        let mut failure = self.unexpected();
        failure.at_word = false;
        Err(failure)
    }

    /// The failure of a bracket that is not closed before the next word, at the cursor.
    #[cold]
    fn closed_late(&self, open: &OpenBracket) -> Option<Box<ParseFailure>> {
        let rest = self.cursor.rest();
        let value = rest.get(1..).unwrap_or_default().trim_ascii_start().first();
        let word =
            rest.first().is_some_and(u8::is_ascii_alphabetic) && value.is_some_and(|b| starts_value(*b) || *b == b'=');
        // A bracket closed after the word has an error inside.
        if !word || rest.contains(&open.close) {
            return None;
        }
        let (opening, closing) = if open.close == b')' { ("(", ")") } else { ("[", "]") };
        let letter = char::from(rest.first().copied().unwrap_or(b' ')).to_string();
        let message = msg!("nc.unclosed-before-word", bracket = opening, word = letter);
        let mut failure = self.failure(Alarm::BracketPair, open.at, open.at + 1, message);
        let end = self.ended_at();
        failure.finding = self.with_fix(failure.finding, LineFix::Write(end, end, closing));
        Some(failure)
    }

    /// Reads `#n`, `#[expr]`, `##n` or `#9nnn`, from the `#` on.
    pub(super) fn variable(&mut self, access: VariableAccess) -> Read<ExprId> {
        let start = self.cursor.at;
        self.cursor.at += 1;
        match self.next_byte() {
            b'0'..=b'9' => {
                let from = self.cursor.at;
                let mut number = 0_u32;
                for &byte in self.cursor.line.get(from..).unwrap_or_default().iter().take_while(|b| b.is_ascii_digit())
                {
                    // Saturates: a number that is too large stays too large.
                    number = number.saturating_mul(10).saturating_add(u32::from(byte - b'0'));
                    self.cursor.at += 1;
                }
                if matches!(self.cursor.peek(), b'O' | b'o') && self.zero_for_o() {
                    return self.add_expr(Expr::Var(0), start);
                }
                if let (true, 4, 9000..=9999) = (self.control.syntax.nine_hash, self.cursor.at - from, number) {
                    self.check_variable(number - 9000, start, VariableAccess::Read);
                    let inner = self.add_expr(Expr::Var(number - 9000), start)?;
                    return self.add_expr(Expr::Indirect(inner), start);
                }
                self.check_variable(number, start, access);
                self.add_expr(Expr::Var(number), start)
            }
            b'#' => {
                let from = self.cursor.at;
                self.deeper()?;
                let inner = self.variable(VariableAccess::Read)?;
                self.formulas.depth -= 1;
                if !self.control.syntax.double_hash {
                    let finding = self.finding(
                        Alarm::Format,
                        start,
                        self.cursor.at,
                        msg!("nc.double-hash", control = self.control.name),
                    );
                    self.report_enclosing(Alarm::Format, finding, from, self.cursor.at);
                }
                self.add_expr(Expr::Indirect(inner), start)
            }
            b'[' => {
                let inner = self.group(b']')?;
                self.add_expr(Expr::Indirect(inner), start)
            }
            b'(' if self.formulas.rounds => {
                let inner = self.group(b')')?;
                self.add_expr(Expr::Indirect(inner), start)
            }
            _ => {
                let name = self.cursor.line.get(start + 1..).unwrap_or_default();
                if !name.first().is_none_or(u8::is_ascii) {
                    self.cursor.at = start + 1;
                    return Err(self.unexpected());
                }
                let name = name.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
                let message = if name > 1 { msg!("nc.variable-name") } else { msg!("nc.variable-number") };
                Err(self.failure(Alarm::Format, start, start + 1 + name, message))
            }
        }
    }

    /// Checks that a variable exists and is allowed on this side.
    #[inline]
    fn check_variable(&mut self, number: u32, start: usize, access: VariableAccess) {
        if !self.formulas.plain.contains(&number) {
            self.check_row(number, start, access);
        }
    }

    fn check_row(&mut self, number: u32, start: usize, access: VariableAccess) {
        let written = access == VariableAccess::Write;
        let alarm = match self.control.var(number) {
            None => Alarm::VariableRange,
            Some(row) if row.kind.common() && !is_fitted(self.tables.rules.fitted, number) => Alarm::VariableRange,
            Some(row) => match row.kind {
                VarKind::Local | VarKind::Common | VarKind::Retained => {
                    let last = self.tables.rules.fitted.iter().map(|range| range.1).find(|&last| number <= last);
                    self.formulas.plain = row.first..row.last.min(last.unwrap_or(u32::MAX)).saturating_add(1);
                    return;
                }
                VarKind::NotSimulated => {
                    let message =
                        msg!("nc.variable-stops", variable = self.control.variable(number), meaning = row.text);
                    return self.report_once(IgnoredFeature::Variables(row.first), start, self.cursor.at, message);
                }
                VarKind::Vacant if written => Alarm::VacantWritten,
                kind if written && !kind.writable() => Alarm::ReadOnly,
                VarKind::AlarmMessage | VarKind::StopMessage if !written => Alarm::VariableSide,
                _ => return,
            },
        };
        // Reported once per number, after the file is read and a free variable is known.
        let span = self.span(start, self.cursor.at);
        self.block.bad.get_or_insert(BadBlock { alarm, finding: span });
        let known = self.findings.misused.iter().any(|m| m.number == number && m.alarm == alarm);
        if !known && self.findings.misused.len() < 100 {
            self.findings.misused.push(Misused { number, alarm, span });
        }
    }
}
