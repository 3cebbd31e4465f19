//! Macro text: assignments, jumps, loops, and the expressions in them and behind addresses.

use super::super::ast::{Expr, ExprId, Op, Stmt};
use super::{Misused, Read, Reader};
use crate::controls::syntax::Function;
use crate::controls::{Alarm, VarKind};
use crate::msg;
use crate::text::Message;

/// Parts of the formulas of one block: bounds the depth of every tree, for whoever walks it.
const PARTS: u32 = 250;

/// Brackets and signs inside one another, far beyond what a control takes.
const DEPTH: u32 = 40;

/// Operators that are letters.
const LETTERED: [(&str, Op); 4] = [("AND", Op::And), ("MOD", Op::Modulo), ("OR", Op::Or), ("XOR", Op::Xor)];

const COMPARISONS: [(&str, Op); 6] = [
    ("EQ", Op::Equal),
    ("NE", Op::NotEqual),
    ("GT", Op::Greater),
    ("GE", Op::GreaterEqual),
    ("LT", Op::Less),
    ("LE", Op::LessEqual),
];

/// Statements that the control has and the simulation does not act on.
const OUTSIDE: [&str; 4] = ["POPEN", "PCLOS", "DPRNT", "SETVN"];

/// An opened bracket: where, and which byte closes it.
struct Open {
    at: usize,
    close: u8,
}

impl Reader<'_> {
    /// Whether the line goes on with this word, in capitals or not.
    fn ahead(&self, word: &str) -> bool {
        let rest = self.line.get(self.at..self.at + word.len());
        rest.is_some_and(|rest| rest.eq_ignore_ascii_case(word.as_bytes()))
    }

    /// Takes this word if it stands here.
    fn take(&mut self, word: &str) -> bool {
        let ahead = self.ahead(word);
        if ahead {
            for at in self.at..self.at + word.len() {
                self.note_case(at);
            }
            self.at += word.len();
        }
        ahead
    }

    /// Whether a macro statement starts here.
    pub(super) fn keyword_ahead(&self) -> bool {
        ["IF", "GOTO", "WHILE", "DO", "END"].iter().any(|word| self.ahead(word))
    }

    /// A statement that starts with a keyword, `None` where none stands here.
    pub(super) fn keyword(&mut self) -> Read<Option<Stmt>> {
        let start = self.at;
        if self.take("IF") {
            return self.if_goto(start).map(Some);
        }
        if self.take("GOTO") {
            let target = self.operand(Alarm::IfSentence, "GOTO")?;
            self.end_of_macro()?;
            return Ok(Some(Stmt::Goto(target)));
        }
        if self.take("WHILE") {
            let cond = self.condition(Alarm::WhileSentence, "WHILE")?;
            self.skip();
            if !self.take("DO") {
                let message = msg!("nc.while-without-do");
                return Err(self.failure(Alarm::WhileSentence, start, self.at.max(start + 5), message, false));
            }
            let label = self.label("DO")?;
            return Ok(Some(Stmt::While { cond: Some(cond), label }));
        }
        if self.take("DO") {
            let label = self.label("DO")?;
            return Ok(Some(Stmt::While { cond: None, label }));
        }
        if self.take("END") {
            let label = self.label("END")?;
            return Ok(Some(Stmt::End { label }));
        }
        if let Some(index) = OUTSIDE.iter().position(|word| self.ahead(word)) {
            let end = self.line.len();
            self.not_simulated((b'!', index as u32), start, end, OUTSIDE[index]);
            self.at = end;
            return Ok(Some(Stmt::Empty));
        }
        Ok(None)
    }

    fn if_goto(&mut self, start: usize) -> Read<Stmt> {
        let cond = self.condition(Alarm::IfSentence, "IF")?;
        self.skip();
        if self.ahead("THEN") && !self.control.syntax.if_then {
            let message = msg!("nc.no-if-then", self.control.name);
            return Err(self.failure(Alarm::IfSentence, self.at, self.at + 4, message, false));
        }
        if !self.take("GOTO") {
            let message = msg!("nc.if-without-goto");
            return Err(self.failure(Alarm::IfSentence, start, self.at.max(start + 2), message, false));
        }
        let target = self.operand(Alarm::IfSentence, "GOTO")?;
        self.end_of_macro()?;
        Ok(Stmt::If { cond, target })
    }

    /// The expression behind a keyword.
    fn operand(&mut self, alarm: Alarm, keyword: &str) -> Read<ExprId> {
        let start = self.at;
        self.skip();
        if self.ended() {
            let message = msg!("nc.no-operand", keyword);
            return Err(self.failure(alarm, start.saturating_sub(keyword.len()), start, message, false));
        }
        self.formula(false)
    }

    /// `[ expr comparison expr ]`.
    pub(super) fn condition(&mut self, alarm: Alarm, keyword: &str) -> Read<ExprId> {
        let start = self.at;
        let byte = self.skip();
        let close = match byte {
            b'[' => b']',
            b'(' => b')',
            _ => {
                let message = msg!("nc.no-condition", keyword);
                return Err(self.failure(alarm, start.saturating_sub(keyword.len()), start, message, false));
            }
        };
        let open = self.open(close);
        let left = self.formula(false)?;
        self.skip();
        let at = self.at;
        let Some(op) = self.comparison() else {
            return Err(match self.peek() {
                b'=' | b'<' | b'>' | b'!' => self.failure(alarm, at, at + 1, msg!("nc.comparison-sign"), false),
                byte if byte == close => self.failure(alarm, open.at, at + 1, msg!("nc.no-comparison"), false),
                _ => self.unexpected(),
            });
        };
        let right = self.formula(false)?;
        self.skip();
        if self.comparison_ahead() {
            return Err(self.lost_comparison(alarm));
        }
        self.close(open)?;
        self.part(Expr::Binary(op, left, right))
    }

    /// Takes the comparison at hand.
    pub(super) fn comparison(&mut self) -> Option<Op> {
        let (word, op) = COMPARISONS.iter().find(|(word, _)| self.ahead(word))?;
        self.take(word);
        Some(*op)
    }

    fn comparison_ahead(&self) -> bool {
        COMPARISONS.iter().any(|(word, _)| self.ahead(word))
    }

    /// The failure of a comparison that is not the one of a condition.
    fn lost_comparison(&self, alarm: Alarm) -> Box<super::Failure> {
        self.failure(alarm, self.at, self.at + 2, msg!("nc.lost-comparison"), false)
    }

    /// The number behind `DO` or `END`.
    fn label(&mut self, keyword: &str) -> Read<u16> {
        let start = self.at;
        self.skip();
        let from = self.at;
        while self.peek().is_ascii_digit() {
            self.at += 1;
        }
        let most = self.control.syntax.do_max;
        let number = core::str::from_utf8(self.line.get(from..self.at).unwrap_or_default()).unwrap_or("");
        let label = match number.parse::<u16>() {
            Ok(label) if label > 0 && u32::from(label) <= most => label,
            _ => {
                let (from, to) = if number.is_empty() { (start - keyword.len(), start) } else { (from, self.at) };
                return Err(self.failure(Alarm::WhileSentence, from, to, msg!("nc.do-number", keyword, most), false));
            }
        };
        self.end_of_macro()?;
        Ok(label)
    }

    /// `#… = expr`.
    pub(super) fn assignment(&mut self) -> Read<Stmt> {
        let start = self.at;
        let to = self.variable(true)?;
        let end = self.at;
        if self.skip() != b'=' {
            return Err(self.failure(Alarm::NoEquals, start, end, msg!("nc.no-equals"), true));
        }
        self.at += 1;
        let value = self.formula(false)?;
        if let (Expr::Var(number), Expr::Number(value)) = (self.deck.expr(to), self.deck.expr(value)) {
            self.user_alarm(number, value.to_f64(), start);
        }
        self.end_of_macro()?;
        Ok(Stmt::Assign { to, value })
    }

    /// The number of a user alarm has a range.
    fn user_alarm(&mut self, variable: u32, value: f64, start: usize) {
        let (least, most) = self.control.macros.user_alarms;
        let row = self.control.var(variable);
        let alarm = row.is_some_and(|row| row.kind == VarKind::AlarmMessage);
        if alarm && !(f64::from(least)..=f64::from(most)).contains(&value) {
            self.report(Alarm::UserAlarmRange, start, self.at, msg!("nc.user-alarm-number", least, most));
        }
    }

    /// Nothing but comments may follow macro text.
    fn end_of_macro(&mut self) -> Read<()> {
        loop {
            let byte = self.skip();
            let start = self.at;
            match byte {
                _ if self.ended() => return Ok(()),
                b'.' => self.stray_point(),
                b']' => self.stray_square(),
                b')' => self.stray_round()?,
                b'#' => {
                    let finding = self.finding(Alarm::Format, start, self.line.len(), msg!("nc.second-assignment"));
                    let place = self.place(self.span(start, start));
                    let finding = finding.fix(msg!("nc.fix.own-block"), vec![(place, "\n".to_owned())]);
                    self.report_as(Alarm::Format, finding);
                    self.at = self.line.len();
                    return Ok(());
                }
                _ if self.comparison_ahead() => return Err(self.lost_comparison(Alarm::Format)),
                _ if byte.is_ascii_alphabetic() => {
                    return Err(self.failure(Alarm::Mixed, start, self.line.len(), msg!("nc.mixed"), true));
                }
                _ => return Err(self.unexpected()),
            }
        }
    }

    /// Counts a part of a formula and adds it to the tree.
    pub(super) fn part(&mut self, expr: Expr) -> Read<ExprId> {
        self.parts += 1;
        if self.parts > PARTS {
            return Err(self.failure(Alarm::Format, 0, self.line.len(), msg!("nc.formula-too-long", PARTS), false));
        }
        self.deck.exprs.push(expr);
        Ok(ExprId(self.deck.exprs.len() as u32 - 1))
    }

    /// An expression. Behind an address (`word`) a `/` before a letter is a block skip, not a division.
    pub(super) fn formula(&mut self, word: bool) -> Read<ExprId> {
        let mut left = self.term(word)?;
        while let Some(op) = self.operator(word, false) {
            let right = self.term(word)?;
            left = self.part(Expr::Binary(op, left, right))?;
        }
        Ok(left)
    }

    fn term(&mut self, word: bool) -> Read<ExprId> {
        let mut left = self.factor()?;
        while let Some(op) = self.operator(word, true) {
            let right = self.factor()?;
            left = self.part(Expr::Binary(op, left, right))?;
        }
        Ok(left)
    }

    /// Whether an operator stands here, seen from behind the value of a word.
    pub(super) fn operator_ahead(&self) -> bool {
        match self.peek() {
            b'+' | b'-' | b'*' => true,
            b'/' => !self.skip_mark_ahead(),
            _ => LETTERED.iter().any(|(word, _)| self.ahead(word)),
        }
    }

    /// Whether the `/` at hand stands before a word: a block skip in the middle of a block.
    pub(super) fn skip_mark_ahead(&self) -> bool {
        let rest = self.line.get(self.at + 1..).unwrap_or_default();
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
                if matches!(op, Op::And | Op::Modulo) != multiplicative {
                    return None;
                }
                let start = self.at;
                self.take(name);
                if *op == Op::Modulo && !self.control.syntax.modulo {
                    let finding = self.finding(Alarm::Format, start, self.at, msg!("nc.no-modulo", self.control.name));
                    self.report_as(Alarm::Format, finding.hint(msg!("nc.hint.modulo")));
                }
                return Some(*op);
            }
            _ => return None,
        };
        self.at += 1;
        Some(op)
    }

    /// Goes one level down, within the budget.
    fn deeper(&mut self) -> Read<()> {
        self.depth += 1;
        if self.depth > DEPTH {
            return Err(self.failure(Alarm::BracketDepth, self.at, self.at, self.too_deep(), false));
        }
        Ok(())
    }

    fn too_deep(&self) -> Message {
        msg!("nc.bracket-depth", u32::from(self.control.syntax.bracket_depth))
    }

    fn factor(&mut self) -> Read<ExprId> {
        let byte = self.skip();
        match byte {
            b'#' => self.variable(false),
            b'0'..=b'9' | b'.' => {
                let number = self.digits()?;
                self.part(Expr::Number(number))
            }
            b'+' | b'-' => {
                self.at += 1;
                let next = self.skip();
                if next.is_ascii_digit() || next == b'.' {
                    let mut number = self.digits()?;
                    number.mantissa *= if byte == b'-' { -1 } else { 1 };
                    return self.part(Expr::Number(number));
                }
                self.deeper()?;
                let inner = self.factor()?;
                self.depth -= 1;
                if byte == b'-' { self.part(Expr::Negate(inner)) } else { Ok(inner) }
            }
            b'[' => self.group(b']'),
            b'(' => self.group(b')'),
            _ if byte.is_ascii_alphabetic() => {
                let start = self.at;
                let Some((name, function)) = self.function_here() else {
                    return Err(self.unknown_name(start));
                };
                self.take(name);
                match self.skip() {
                    b'[' => {}
                    b'(' if self.rounds => {}
                    _ => {
                        let message = msg!("nc.function-bracket", name);
                        return Err(self.failure(Alarm::Format, start, start + name.len(), message, false));
                    }
                }
                let close = if self.peek() == b'(' { b')' } else { b']' };
                let inner = self.group(close)?;
                self.part(Expr::Call(function, inner))
            }
            _ => Err(self.unexpected()),
        }
    }

    /// A name where a value should stand.
    fn unknown_name(&self, start: usize) -> Box<super::Failure> {
        let rest = self.line.get(start..).unwrap_or_default();
        let letters = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        let name = String::from_utf8_lossy(rest.get(..letters).unwrap_or_default()).to_ascii_uppercase();
        let bracket = rest.get(letters..).is_some_and(|rest| rest.iter().find(|b| **b != b' ') == Some(&b'['));
        let message = if bracket {
            msg!("nc.unknown-function", name, self.control.name)
        } else {
            msg!("nc.no-operand-but", name)
        };
        self.failure(Alarm::Format, start, start + letters, message, !bracket)
    }

    fn function_here(&self) -> Option<(&'static str, Function)> {
        // The longest spelling wins: `ATAN` over `ATN` never clash, `SQRT` over `SQR` would.
        let rows = self.control.syntax.functions.iter().filter(|(name, _)| self.ahead(name));
        rows.max_by_key(|(name, _)| name.len()).copied()
    }

    /// Whether a function stands here, with its bracket.
    pub(super) fn function_ahead(&self) -> bool {
        self.function_here().is_some_and(|(name, _)| {
            let rest = self.line.get(self.at + name.len()..).unwrap_or_default();
            matches!(rest.iter().find(|b| **b != b' '), Some(b'[' | b'('))
        })
    }

    /// The bracketed expression at hand.
    fn group(&mut self, close: u8) -> Read<ExprId> {
        self.deeper()?;
        let open = self.open(close);
        if self.depth == u32::from(self.control.syntax.bracket_depth) + 1 {
            let message = self.too_deep();
            self.report(Alarm::BracketDepth, open.at, open.at + 1, message);
        }
        let inner = self.formula(false)?;
        self.close(open)?;
        self.depth -= 1;
        Ok(inner)
    }

    fn open(&mut self, close: u8) -> Open {
        let at = self.at;
        self.at += 1;
        Open { at, close }
    }

    fn close(&mut self, open: Open) -> Read<()> {
        let byte = self.skip();
        if byte == open.close {
            if byte == b')' {
                self.round_brackets.push((open.at, self.at));
            }
            self.at += 1;
            return Ok(());
        }
        if self.ended() || byte == b',' {
            return Err(self.failure(Alarm::BracketPair, open.at, open.at + 1, msg!("nc.unclosed-square"), false));
        }
        if self.comparison_ahead() {
            return Err(self.lost_comparison(Alarm::Format));
        }
        let mut failure = self.unexpected();
        failure.at_word = false;
        Err(failure)
    }

    /// `#n`, `#[expr]` or `##n`; the reader stands at the `#`.
    fn variable(&mut self, written: bool) -> Read<ExprId> {
        let start = self.at;
        self.at += 1;
        match self.skip() {
            b'0'..=b'9' => {
                let from = self.at;
                while self.peek().is_ascii_digit() {
                    self.at += 1;
                }
                let digits = core::str::from_utf8(self.line.get(from..self.at).unwrap_or_default()).unwrap_or("");
                let number = digits.parse::<u32>().unwrap_or(u32::MAX);
                self.check_variable(number, start, written);
                self.part(Expr::Var(number))
            }
            b'#' => {
                self.deeper()?;
                let inner = self.variable(false)?;
                self.depth -= 1;
                self.part(Expr::Indirect(inner))
            }
            b'[' => {
                let inner = self.group(b']')?;
                self.part(Expr::Indirect(inner))
            }
            b'(' if self.rounds => {
                let inner = self.group(b')')?;
                self.part(Expr::Indirect(inner))
            }
            _ => Err(self.failure(Alarm::Format, start, start + 1, msg!("nc.variable-number"), false)),
        }
    }

    fn check_variable(&mut self, number: u32, start: usize, written: bool) {
        let alarm = match self.control.var(number) {
            None => Alarm::VariableRange,
            Some(row) => match row.kind {
                kind if kind == VarKind::NotSimulated || written && kind == VarKind::SuppressSingleBlock => {
                    let (key, to) = ((b'#', row.first), self.at);
                    return self.not_simulated(key, start, to, &format!("#{number} ({})", row.text));
                }
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
