//! Formulas of a language with names: comparisons, logic, integer division, and variables and brackets as other languages write them.
//!
//! ```text
//! cond   := logic { comparison logic }                comparisons come last
//! logic  := expr { ( AND | XOR | OR ) expr }
//! ```

use crate::controls::Alarm;
use crate::msg;
use crate::nc::ast::{BadBlock, Expr, ExprId, Op};
use crate::nc::dec::{Dec, POW10};
use crate::nc::lex::keywords::{COMPARISONS, LOGIC, SIGNS};
use crate::nc::lex::names::begins_as_name;
use crate::nc::parse::failure::{IgnoredFeature, ParseFailure, Read};
use crate::nc::parse::formula::VariableAccess;
use crate::nc::parse::reader::Reader;
use crate::nc::parsed::FINDINGS;

/// Signs that are read as comparisons.
#[derive(Clone, Copy, PartialEq)]
enum SignsRead {
    /// Those of the control.
    Known,
    /// Those of other languages too, with a finding.
    All,
}

impl Reader<'_> {
    /// Whether a variable follows: its letter with a number or an index.
    #[inline]
    pub(in crate::nc::parse) fn parameter_ahead(&self) -> bool {
        self.names().is_some()
            && self.cursor.peek() | 0x20 == b'r'
            && (self.cursor.byte(1).is_ascii_digit() || self.cursor.byte(1) == b'[')
    }

    /// Reads an expression with comparisons as the weakest operators.
    pub(in crate::nc::parse) fn symbolic_formula(&mut self) -> Read<ExprId> {
        self.compared(SignsRead::Known)
    }

    /// Reads a condition: an expression in which signs of other languages compare too, such as a single `=`.
    pub(in crate::nc::parse) fn symbolic_condition(&mut self) -> Read<ExprId> {
        self.compared(SignsRead::All)
    }

    fn compared(&mut self, signs: SignsRead) -> Read<ExprId> {
        let start = self.cursor.at;
        let mut left = self.logic(0)?;
        while let Some(op) = self.symbolic_comparison(signs) {
            let right = self.logic(0)?;
            left = self.add_expr(Expr::Binary(op, left, right), start)?;
        }
        Ok(left)
    }

    fn logic(&mut self, least: usize) -> Read<ExprId> {
        let start = self.cursor.at;
        let mut left = match self.negation()? {
            Some(left) => left,
            None => self.formula()?,
        };
        loop {
            let byte = self.next_byte();
            if !byte.is_ascii_alphabetic() {
                return Ok(left);
            }
            let Some(level) = LOGIC.iter().position(|(word, _)| self.cursor.is_name(word)) else {
                return Ok(left);
            };
            if level < least {
                return Ok(left);
            }
            let (word, op) = LOGIC[level];
            self.cursor.at += word.len();
            self.pass_blanks();
            let right = self.logic(level + 1)?;
            left = self.add_expr(Expr::Binary(op, left, right), start)?;
        }
    }

    /// Reads `NOT value` as `value == 0`.
    fn negation(&mut self) -> Read<Option<ExprId>> {
        let byte = self.next_byte();
        if byte | 0x20 != b'n' || !self.cursor.is_name("NOT") {
            return Ok(None);
        }
        let start = self.cursor.at;
        self.cursor.at += 3;
        self.deeper()?;
        let inner = self.factor()?;
        self.formulas.depth -= 1;
        let zero = self.add_expr(Expr::Number(Dec::int(0)), start)?;
        self.add_expr(Expr::Binary(Op::Equal, inner, zero), start).map(Some)
    }

    /// Reads an exponent `EX-3` after a number that starts at `start`, if present; the result has at most 18 digits.
    #[cold]
    pub(in crate::nc::parse) fn exponent(&mut self, number: Dec, start: usize) -> Dec {
        if self.cursor.ahead("EX") {
            self.cursor.at += 2;
        } else if self.foreign_exponent() {
            let at = self.cursor.at + 1;
            self.report_replaced(Alarm::Format, at - 1, at, msg!("nc.exponent", control = self.control.name), "EX");
            self.cursor.at = at;
        } else {
            return number;
        }
        let negative = self.cursor.peek() == b'-';
        self.cursor.at += usize::from(matches!(self.cursor.peek(), b'-' | b'+'));
        let mut exponent = 0_i32;
        while self.cursor.peek().is_ascii_digit() {
            exponent = exponent.saturating_mul(10).saturating_add(i32::from(self.cursor.peek() - b'0'));
            self.cursor.at += 1;
        }
        let exponent = if negative { -exponent } else { exponent };
        let scale = i32::from(number.scale).saturating_sub(exponent);
        let unit = |scale: i32| POW10.get(scale.unsigned_abs() as usize).copied();
        let whole = (scale < 0).then(|| number.mantissa.checked_mul(unit(scale)?)).flatten();
        let raised = match u8::try_from(scale) {
            Ok(scale @ 0..=18) => Some(Dec { scale, ..number }),
            _ => whole.map(|mantissa| Dec { mantissa, scale: 0, point: true }),
        };
        if raised.is_none() && number.mantissa != 0 {
            self.report(Alarm::Digits, start, self.cursor.at, msg!("nc.too-many-digits", most = 18));
        }
        Dec { point: true, ..raised.unwrap_or_default() }
    }

    /// Whether the E at the cursor starts an exponent of other languages: `E2`, `E-3`.
    fn foreign_exponent(&self) -> bool {
        let sign = usize::from(matches!(self.cursor.byte(1), b'-' | b'+'));
        self.cursor.byte(1 + sign).is_ascii_digit()
    }

    /// Reads `DIV`, the integer division.
    #[cold]
    pub(in crate::nc::parse) fn quotient_ahead(&mut self) -> bool {
        self.take_word("DIV")
    }

    fn symbolic_comparison(&mut self, signs: SignsRead) -> Option<Op> {
        let byte = self.next_byte();
        let from = self.cursor.at;
        if byte.is_ascii_alphabetic() {
            let &(word, op) = COMPARISONS.iter().find(|(word, _)| self.cursor.is_name(word))?;
            self.cursor.at += 2;
            let sign = sign_of(op);
            self.report_replaced(
                Alarm::Format,
                from,
                self.cursor.at,
                msg!("nc.comparison-sign", sign = word, control = self.control.name, correct = sign),
                sign,
            );
            return Some(op);
        }
        let &(sign, op, known) = SIGNS.iter().find(|(sign, ..)| self.cursor.ahead(sign))?;
        if !known && signs == SignsRead::Known {
            return None;
        }
        self.cursor.at += sign.len();
        if !known {
            let right = sign_of(op);
            self.report_replaced(
                Alarm::Format,
                from,
                self.cursor.at,
                msg!("nc.comparison-sign", sign, control = self.control.name, correct = right),
                right,
            );
        }
        Some(op)
    }

    /// Reports `[ expr ]` for grouping, as on other controls; reads it as intended.
    #[cold]
    pub(in crate::nc::parse) fn square_group(&mut self) -> Read<ExprId> {
        let start = self.cursor.at;
        let inner = self.group(b']')?;
        let finding =
            self.finding(Alarm::Format, start, self.cursor.at, msg!("nc.square-brackets", control = self.control.name));
        let edit = |at: usize, bracket: &str| (self.place(self.span(at, at + 1)), bracket.to_owned());
        let edits = vec![edit(start, "("), edit(self.cursor.at - 1, ")")];
        self.report_as(Alarm::Format, finding.fix(msg!("nc.fix.round"), edits));
        Ok(inner)
    }

    /// Reports `#1`, the spelling of variables on other controls, once per file.
    #[cold]
    pub(in crate::nc::parse) fn hash_variable(&mut self, access: VariableAccess) -> Read<ExprId> {
        let finding = self.span(self.cursor.at, self.cursor.at + 1);
        self.notes.hash.get_or_insert(finding.start);
        self.block.bad.get_or_insert(BadBlock { alarm: Alarm::Format, finding });
        self.variable(access)
    }

    /// The failure of `$P_S` or `$AA_IM[X]`: system data that the simulation does not keep.
    #[cold]
    pub(in crate::nc::parse) fn system_variable(&self) -> Box<ParseFailure> {
        let rest = self.cursor.rest();
        let name = rest.iter().take_while(|b| b.is_ascii_alphanumeric() || matches!(b, b'$' | b'_')).count();
        let index = rest.get(name..).filter(|after| after.first() == Some(&b'['));
        let len = name + index.and_then(|after| after.iter().position(|b| *b == b']')).map_or(0, |close| close + 1);
        let name = String::from_utf8_lossy(rest.get(..len).unwrap_or_default()).into_owned();
        self.stops_here(self.cursor.at, self.cursor.at + len, msg!("nc.system-variable", variable = name))
    }

    /// Reads `DEF REAL NAME=0`, which defines variables that the simulation does not keep; stores their names.
    #[cold]
    pub(in crate::nc::parse) fn local_data(&mut self) {
        let start = self.cursor.at;
        let text = String::from_utf8_lossy(self.cursor.line.get(start..).unwrap_or_default()).to_ascii_uppercase();
        let name = |part: &str| {
            let declared = part.split('=').next().unwrap_or("");
            let mut names = declared.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
            names.rfind(|name| begins_as_name(name)).map(str::to_owned)
        };
        if self.notes.locals.len() < FINDINGS {
            self.notes.locals.extend(text.split(',').filter_map(name));
        }
        self.cursor.at = self.cursor.line.len();
        self.report_once(IgnoredFeature::LocalData, start, self.cursor.at, msg!("nc.local-data", statement = "DEF"));
    }

    /// Whether a name is one of a variable that the file defines by `DEF`.
    pub(in crate::nc::parse) fn is_local_variable(&self, name: &str) -> bool {
        self.notes.locals.iter().any(|local| local.eq_ignore_ascii_case(name))
    }

    /// The failure of a variable defined by `DEF`.
    #[cold]
    pub(in crate::nc::parse) fn local_variable(&self, start: usize, name: &str) -> Box<ParseFailure> {
        let message = msg!("nc.local-variable", variable = name.to_ascii_uppercase());
        self.stops_here(start, start + name.len(), message)
    }
}

/// The sign of a comparison.
fn sign_of(op: Op) -> &'static str {
    SIGNS.iter().find(|row| row.1 == op && row.2).map_or("", |row| row.0)
}
