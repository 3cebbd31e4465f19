//! Macro statements: assignments, jumps, loops, and the conditions in them.

use crate::controls::{Alarm, VarKind};
use crate::msg;
use crate::nc::ast::{Assignment, Expr, ExprId, Extent, JumpDirection, Op, Stmt};
use crate::nc::lex::keywords::{COMPARISONS, IGNORED_STATEMENTS, KEYWORDS, LOGIC, SIGNS, letters_of};
use crate::nc::lex::spelling::{meant, zero_as_letter};
use crate::nc::parse::failure::{IgnoredFeature, ParseFailure, Read};
use crate::nc::parse::formula::VariableAccess;
use crate::nc::parse::reader::{Reader, starts_value};

/// Words and signs that join conditions in other languages.
const JOINTS: [&str; 5] = ["AND", "OR", "XOR", "&&", "||"];

impl Reader<'_> {
    /// Reads `GOTO`, with or without spaces in it.
    fn take_goto(&mut self) -> bool {
        let start = self.cursor.at;
        if self.take("GOTO") {
            return true;
        }
        let value = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'#' | b'[');
        if self.cursor.ahead("GOT0") && value(self.cursor.byte(4)) {
            self.o_for_zero(start + 3);
            return true;
        }
        // `G0T010` is G0 T010.
        if self.cursor.ahead("G0TO") && value(self.cursor.byte(4)) {
            self.o_for_zero(start + 1);
            self.cursor.at = start + 4;
            return true;
        }
        let split = self.take("GO") && {
            self.cursor.blank();
            self.take("TO")
        };
        if !split {
            self.cursor.at = start;
        }
        split
    }

    /// Reports the digit 0 in place of the letter O in a keyword, with its fix, and reads on after it.
    #[cold]
    fn o_for_zero(&mut self, at: usize) {
        self.report_replaced(Alarm::Format, at, at + 1, msg!("nc.digit-zero"), "O");
        self.cursor.at = at + 1;
    }

    /// Whether a macro statement starts here.
    pub(super) fn keyword_ahead(&self) -> bool {
        KEYWORDS.iter().any(|word| self.cursor.ahead(word)) || self.cursor.ahead("THEN")
    }

    /// Reads a statement that starts with a keyword; `None` without one.
    pub(super) fn keyword(&mut self) -> Read<Option<Stmt>> {
        let start = self.cursor.at;
        let word = KEYWORDS.into_iter().find(|word| self.take(word)).or_else(|| self.take_goto().then_some("GOTO"));
        if let Some(index) = IGNORED_STATEMENTS.iter().position(|name| word.is_none() && self.cursor.ahead(name)) {
            let end = self.cursor.line.len();
            self.not_simulated(IgnoredFeature::Statement(index), start, end, IGNORED_STATEMENTS[index]);
            self.cursor.at = end;
            return Ok(Some(Stmt::Empty));
        }
        Ok(Some(match word.or_else(|| self.misspelt_keyword()) {
            None => return Ok(None),
            Some("IF") => self.if_statement(start)?,
            Some("GOTO") => {
                let target = self.target()?;
                self.end_of_macro()?;
                Stmt::Goto { target, way: JumpDirection::Around, keyword: Extent::default() }
            }
            Some("WHILE") => {
                let cond = self.condition(Alarm::WhileSentence, "WHILE")?;
                self.no_other_condition(Alarm::WhileSentence)?;
                let head = self.cursor.at;
                if self.cursor.ahead("D0") && self.cursor.byte(2).is_ascii_digit() {
                    self.o_for_zero(head + 1);
                } else if !self.take("DO") {
                    return Err(self.while_without_do(start));
                }
                let (label, keyword) = self.loop_number("DO", head)?;
                Stmt::While { cond: Some(cond), label, keyword }
            }
            Some("DO") => {
                let (label, keyword) = self.loop_number("DO", start)?;
                Stmt::While { cond: None, label, keyword }
            }
            Some(_) => {
                let (label, keyword) = self.loop_number("END", start)?;
                Stmt::End { label, keyword }
            }
        }))
    }

    /// The keyword closest to a misspelt run of letters.
    fn misspelt_keyword(&mut self) -> Option<&'static str> {
        let rest = self.cursor.rest();
        let letters = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        let name = String::from_utf8_lossy(rest.get(..letters).unwrap_or_default()).to_ascii_uppercase();
        let after = rest.get(letters..).unwrap_or_default().trim_ascii_start().first();
        if letters < 3
            || zero_as_letter(&name)
            || !after.is_some_and(|b| b.is_ascii_digit() || matches!(b, b'#' | b'['))
        {
            return None;
        }
        let word = KEYWORDS[meant(&name, KEYWORDS.into_iter())?];
        let start = self.cursor.at;
        self.cursor.at += letters;
        self.report_replaced(Alarm::Format, start, self.cursor.at, msg!("nc.unknown-keyword", word = name), word);
        Some(word)
    }

    /// Reads the rest of a statement after `IF`.
    fn if_statement(&mut self, start: usize) -> Read<Stmt> {
        let cond = self.condition(Alarm::IfSentence, "IF")?;
        self.no_other_condition(Alarm::IfSentence)?;
        let then = self.cursor.at;
        let named = self.take("THEN");
        let after = self.cursor.at;
        self.pass_blanks();
        let goto = self.take_goto();
        if goto || self.sequence_number_ahead() {
            if !goto {
                // `IF[…]N10`: a block has a sequence number only at its start.
                self.cursor.at += 1;
                let from = if named { then } else { self.cursor.at - 1 };
                self.report_replaced(Alarm::IfSentence, from, self.cursor.at, msg!("nc.if-without-goto"), "GOTO");
            } else if named {
                self.report_replaced(Alarm::IfSentence, then, after, msg!("nc.then-goto"), "");
            }
            let target = self.target()?;
            self.end_of_macro()?;
            return Ok(Stmt::If { cond, target, way: JumpDirection::Around, keyword: Extent::default() });
        }
        if self.cursor.peek() != b'#' && !named {
            let end = self.cursor.at.max(start + 2);
            let mut failure = self.failure(Alarm::IfSentence, start, end, msg!("nc.if-without-goto"));
            let next = self.cursor.line.get(self.cursor.at + 1..).unwrap_or_default().trim_ascii_start().first();
            let value = next.is_some_and(|b| starts_value(*b));
            if self.cursor.peek().is_ascii_alphabetic() && value {
                failure.finding = self.jump_instead(failure.finding, (then, then), &[]);
            }
            return Err(failure);
        }
        let stmt = if self.cursor.peek() == b'#' {
            let Assignment { to, value } = self.assigned()?;
            if self.next_byte() == b'#' && self.assigns_ahead() {
                // In a block of its own it would no longer depend on the condition.
                let end = self.cursor.line.len();
                let mut finding = self.finding(Alarm::Format, self.cursor.at, end, msg!("nc.second-assignment"));
                if self.tables.rules.if_then {
                    finding = self.jump_instead(finding, (then, after), &[self.cursor.at]);
                }
                self.cursor.at = end;
                self.report_as(Alarm::Format, finding);
            }
            self.end_of_macro()?;
            if self.tables.rules.if_then {
                if !named {
                    self.report_replaced(Alarm::IfSentence, then, then, msg!("nc.no-then"), "THEN ");
                }
                return Ok(Stmt::IfThen { cond, to, value });
            }
            Stmt::IfThen { cond, to, value }
        } else {
            self.cursor.at = self.cursor.line.len();
            Stmt::Empty
        };
        let message = if self.tables.rules.if_then {
            msg!("nc.then-no-assignment")
        } else {
            msg!("nc.no-if-then", control = self.control.name)
        };
        let finding = self.finding(Alarm::IfSentence, then, if named { after } else { then + 1 }, message);
        let finding = self.jump_instead(finding, (then, after), &[]);
        self.report_as(Alarm::IfSentence, finding);
        Ok(stmt)
    }

    /// Whether N and its number are at the cursor.
    fn sequence_number_ahead(&self) -> bool {
        let next = self.cursor.line.get(self.cursor.at + 1..).unwrap_or_default().trim_ascii_start().first();
        self.cursor.peek() | 0x20 == b'n' && next.is_some_and(|b| b.is_ascii_digit() || matches!(b, b'#' | b'['))
    }

    /// Reads the sequence number after `GOTO`.
    fn target(&mut self) -> Read<ExprId> {
        let start = self.cursor.at;
        self.pass_blanks();
        if self.cursor.ended() {
            let message = msg!("nc.no-operand", keyword = "GOTO");
            return Err(self.failure(Alarm::IfSentence, start.saturating_sub(4), start, message));
        }
        let at = self.cursor.at;
        if self.sequence_number_ahead() {
            self.report_replaced(Alarm::IfSentence, at, at + 1, msg!("nc.goto-n"), "");
            self.cursor.at += 1;
        }
        self.formula()
    }

    /// Reads `[ expr comparison expr ]`.
    pub(super) fn condition(&mut self, alarm: Alarm, keyword: &str) -> Read<ExprId> {
        self.formulas.sentence = alarm;
        let cond = self.bracketed_condition(alarm, keyword);
        self.formulas.sentence = Alarm::Format;
        cond
    }

    fn bracketed_condition(&mut self, alarm: Alarm, keyword: &str) -> Read<ExprId> {
        let start = self.cursor.at;
        let byte = self.next_byte();
        let close = match byte {
            b'[' => b']',
            b'(' => b')',
            _ => return self.bare_condition(alarm, keyword, start),
        };
        let open = self.open(close);
        self.pass_blanks();
        if self.tables.rules.joined_conditions == Some(true) && self.condition_ahead() {
            let joined = self.joined_conditions(alarm, keyword, start)?;
            self.close(open)?;
            return Ok(joined);
        }
        if let Some(word) = COMPARISONS.iter().map(|row| row.0).find(|word| self.cursor.ahead(word)) {
            return Err(self.failure(alarm, self.cursor.at, self.cursor.at + word.len(), msg!("nc.comparison-sides")));
        }
        let left = self.formula()?;
        self.pass_blanks();
        let at = self.cursor.at;
        let Some(op) = self.comparison(alarm) else {
            return Err(match self.cursor.peek() {
                byte if byte == close => self.failure(alarm, open.at, at + 1, msg!("nc.no-comparison")),
                // `WHILE[#1 DO1`: the condition breaks off.
                _ if self.keyword_ahead() => self.failure(alarm, open.at, self.ended_at(), msg!("nc.no-comparison")),
                _ if self.letters_ahead() > 1 => {
                    let letters = self.letters_ahead();
                    let word = String::from_utf8_lossy(self.cursor.rest().get(..letters).unwrap_or_default());
                    let message = msg!("nc.unknown-comparison", word = word.to_ascii_uppercase());
                    self.failure(alarm, at, at + letters, message)
                }
                _ => self.unexpected(),
            });
        };
        if self.next_byte() == close {
            return Err(self.failure(alarm, at, self.formulas.compared.1, msg!("nc.comparison-sides")));
        }
        let right = self.formula()?;
        if self.next_byte() == close {
            self.close(open)?;
            return self.add_expr(Expr::Binary(op, left, right), start);
        }
        if let Some(stray) = self.stray_comparison(alarm) {
            return Err(stray);
        }
        if self.keyword_ahead() {
            // A keyword follows, so the missing bracket belongs in front of it.
            let to = self.ended_at();
            let finding = self.finding(Alarm::BracketPair, open.at, open.at + 1, msg!("nc.unclosed-square"));
            self.report_replacing(Alarm::BracketPair, finding, to, to, "]");
        } else {
            self.close(open)?;
        }
        self.add_expr(Expr::Binary(op, left, right), start)
    }

    /// Whether a bracket follows that has a comparison directly inside, and is not only a part of one.
    fn condition_ahead(&self) -> bool {
        let rest = self.cursor.rest();
        let mut depth = 0;
        for (at, byte) in rest.iter().enumerate() {
            match byte {
                b'[' => depth += 1,
                b']' if depth <= 1 => return false,
                b']' => depth -= 1,
                _ if depth == 0 => return false,
                _ => {}
            }
            let tail = rest.get(at..).unwrap_or_default();
            let compares =
                |word: &str| tail.get(..word.len()).is_some_and(|text| text.eq_ignore_ascii_case(word.as_bytes()));
            if depth == 1 && COMPARISONS.iter().any(|row| compares(row.0)) {
                return true;
            }
        }
        false
    }

    /// Reads conditions in brackets with AND, OR or XOR between them, from left to right.
    fn joined_conditions(&mut self, alarm: Alarm, keyword: &str, start: usize) -> Read<ExprId> {
        self.deeper()?;
        let mut joined = self.bracketed_condition(alarm, keyword)?;
        self.pass_blanks();
        while let Some(&(_, op)) = LOGIC.iter().find(|(word, _)| self.take(word)) {
            let next = self.bracketed_condition(alarm, keyword)?;
            joined = self.add_expr(Expr::Binary(op, joined, next), start)?;
            self.pass_blanks();
        }
        self.formulas.depth -= 1;
        Ok(joined)
    }

    /// Length of the word of letters that follows.
    fn letters_ahead(&self) -> usize {
        self.cursor.run(|byte| byte.is_ascii_alphabetic())
    }

    /// Reads a condition with missing brackets.
    fn bare_condition(&mut self, alarm: Alarm, keyword: &str, start: usize) -> Read<ExprId> {
        let from = self.cursor.at;
        let failure = |reader: &Self| {
            let message = msg!("nc.no-condition", keyword);
            reader.failure(alarm, start.saturating_sub(keyword.len()), start, message)
        };
        let Ok(left) = self.formula() else { return Err(failure(self)) };
        self.pass_blanks();
        let Some(op) = self.comparison(alarm) else { return Err(failure(self)) };
        let Ok(right) = self.formula() else { return Err(failure(self)) };
        let to = self.ended_at();
        let finding = self.finding(alarm, from, to, msg!("nc.no-condition", keyword));
        if self.next_byte() == b']' {
            // The closing bracket is present.
            self.cursor.at += 1;
            self.report_replacing(alarm, finding, from, from, "[");
        } else {
            self.report_enclosing(alarm, finding, from, to);
        }
        self.add_expr(Expr::Binary(op, left, right), from)
    }

    /// Reads a comparison, as letters or signs.
    pub(super) fn comparison(&mut self, alarm: Alarm) -> Option<Op> {
        let from = self.cursor.at;
        if let Some((word, op)) = COMPARISONS.iter().find(|(word, _)| self.cursor.ahead(word)) {
            self.take(word);
            self.formulas.compared = (from, self.cursor.at, *op);
            return Some(*op);
        }
        let (sign, op, known) = *SIGNS.iter().find(|(sign, ..)| self.cursor.ahead(sign))?;
        self.cursor.at += sign.len();
        self.formulas.compared = (from, self.cursor.at, op);
        if !(known && self.control.syntax.comparison_signs) {
            let letters = letters_of(op);
            let message = msg!("nc.comparison-sign", sign, control = self.control.name, correct = letters);
            let letters = self.spaced(from, self.cursor.at, letters);
            self.report_replaced(alarm, from, self.cursor.at, message, &letters);
        }
        Some(op)
    }

    /// The failure of a comparison ahead that does not belong to a condition.
    pub(super) fn stray_comparison(&self, alarm: Alarm) -> Option<Box<ParseFailure>> {
        let signs = SIGNS.iter().map(|(sign, ..)| *sign).filter(|sign| *sign != "=");
        let word = COMPARISONS.iter().map(|(word, _)| *word).chain(signs).find(|word| self.cursor.ahead(word))?;
        Some(self.one_comparison(alarm, word.len()))
    }

    /// Reports operators that join another condition to the one read.
    fn no_other_condition(&mut self, alarm: Alarm) -> Read<()> {
        while self.next_byte() == b']' {
            self.stray_square();
        }
        match JOINTS.iter().find(|word| self.cursor.ahead(word)) {
            Some(word) => Err(self.one_comparison(alarm, word.len())),
            None => Ok(()),
        }
    }

    /// The failure of a misplaced or second comparison; its operator is the next `len` bytes.
    fn one_comparison(&self, alarm: Alarm, len: usize) -> Box<ParseFailure> {
        let condition = matches!(alarm, Alarm::IfSentence | Alarm::WhileSentence);
        let message = if condition { msg!("nc.two-comparisons") } else { msg!("nc.lost-comparison") };
        let mut failure = self.failure(alarm, self.cursor.at, self.cursor.at + len, message);
        if condition {
            failure.finding = failure.finding.hint(msg!("nc.hint.two-conditions"));
            if self.tables.rules.joined_conditions == Some(false) {
                failure.finding = failure.finding.hint(msg!("nc.hint.joined-conditions"));
            }
        }
        failure
    }

    /// Reads the number after `DO` or `END`; the keyword starts at `head`. Returns the number and the bytes of both.
    fn loop_number(&mut self, keyword: &str, head: usize) -> Read<(u16, Extent)> {
        let start = self.cursor.at;
        self.pass_blanks();
        let from = self.cursor.at;
        while self.cursor.peek().is_ascii_digit() {
            self.cursor.at += 1;
        }
        let most = self.control.syntax.do_max;
        let mut number =
            core::str::from_utf8(self.cursor.line.get(from..self.cursor.at).unwrap_or_default()).unwrap_or("");
        if number.is_empty() && matches!(self.cursor.name(), "l" | "L" | "I") {
            self.cursor.at += 1;
            self.report_ones(Alarm::DoNumber, from);
            number = "1";
        }
        let label = match number.parse::<u16>() {
            Ok(label) if label > 0 && u32::from(label) <= most => label,
            _ => {
                let (from, to) =
                    if number.is_empty() { (start - keyword.len(), start) } else { (from, self.cursor.at) };
                // `END OF PROGRAM` is an unbracketed comment.
                let word = self.cursor.peek().is_ascii_alphabetic();
                let mut failure = self.failure(Alarm::DoNumber, from, to, msg!("nc.do-number", keyword, most));
                failure.at_word = word;
                return Err(failure);
            }
        };
        let extent = self.extent(head, self.cursor.at);
        self.end_of_macro()?;
        Ok((label, extent))
    }

    /// Reads `#… = expr`.
    pub(super) fn assignment(&mut self) -> Read<Stmt> {
        let Assignment { to, value } = self.assigned()?;
        if !self.tables.rules.assignments || self.next_byte() != b'#' {
            self.end_of_macro()?;
            return Ok(Stmt::Assign { to, value });
        }
        let first = self.deck.assignments.len();
        self.deck.assignments.push(Assignment { to, value });
        while self.next_byte() == b'#' {
            let assignment = self.assigned()?;
            self.deck.assignments.push(assignment);
        }
        self.end_of_macro()?;
        Ok(Stmt::Assigns { first: first as u32, count: (self.deck.assignments.len() - first) as u16 })
    }

    /// Reads the variable and the value of an assignment.
    fn assigned(&mut self) -> Read<Assignment> {
        let start = self.cursor.at;
        let to = self.variable(VariableAccess::Write)?;
        let end = self.cursor.at;
        if self.next_byte() == b'.' {
            self.stray_point();
        }
        if self.next_byte() == b':' && self.cursor.line.get(self.cursor.at + 1) == Some(&b'=') {
            self.report_replaced(Alarm::NoEquals, self.cursor.at, self.cursor.at + 1, msg!("nc.double-equals"), "");
            self.cursor.at += 1;
        }
        self.equals_sign(start, end)?;
        let value = self.formula()?;
        if let (Expr::Var(number), Expr::Number(value)) = (self.deck.expr(to), self.deck.expr(value)) {
            self.user_alarm(number, value.to_f64(), start);
        }
        Ok(Assignment { to, value })
    }

    /// Reads the `=` of an assignment to the variable from `start` to `end`; `==` is read as one, with a fix, and so are more of them.
    pub(super) fn equals_sign(&mut self, start: usize, end: usize) -> Read<()> {
        if self.next_byte() != b'=' {
            return Err(self.failure(Alarm::NoEquals, start, end, msg!("nc.no-equals")).at_word());
        }
        self.cursor.at += 1;
        if self.next_byte() == b'=' {
            let (from, mut to) = (self.cursor.at, self.cursor.at);
            while self.cursor.peek() == b'=' {
                to = self.cursor.at + 1;
                self.cursor.at = to;
                self.cursor.blank();
            }
            self.report_replaced(Alarm::Format, from, to, msg!("nc.double-equals"), "");
        }
        Ok(())
    }

    /// Checks the number of a user alarm, if the variable raises one.
    fn user_alarm(&mut self, variable: u32, value: f64, start: usize) {
        if self.control.var(variable).is_some_and(|row| row.kind == VarKind::AlarmMessage) {
            self.check_user_alarm(value, start, self.cursor.at);
        }
    }

    /// Whether `#n =` follows.
    fn assigns_ahead(&self) -> bool {
        let rest = self.cursor.line.get(self.cursor.at + 1..).unwrap_or_default();
        rest.iter().find(|b| !b.is_ascii_digit() && **b != b' ') == Some(&b'=') || rest.first() == Some(&b'[')
    }

    /// Reports text other than comments after a macro statement.
    fn end_of_macro(&mut self) -> Read<()> {
        loop {
            let byte = self.next_byte();
            let start = self.cursor.at;
            match byte {
                _ if self.cursor.ended() => return Ok(()),
                b'.' => self.stray_point(),
                b']' => self.stray_square(),
                b')' => self.stray_round()?,
                b'#' if self.assigns_ahead() => {
                    let finding =
                        self.finding(Alarm::Format, start, self.cursor.line.len(), msg!("nc.second-assignment"));
                    let place = self.place(self.span(start, start));
                    let edit = format!("{}{}", self.newline(), self.skip_mark());
                    let finding = finding.fix(msg!("nc.fix.own-block"), vec![(place, edit)]);
                    self.report_as(Alarm::Format, finding);
                    self.cursor.at = self.cursor.line.len();
                    return Ok(());
                }
                _ => {
                    let failure = match self.stray_comparison(Alarm::Format) {
                        Some(stray) => stray,
                        None if byte.is_ascii_alphabetic() => {
                            self.failure(Alarm::Mixed, start, self.cursor.line.len(), msg!("nc.mixed")).at_word()
                        }
                        None => self.unexpected(),
                    };
                    return Err(failure);
                }
            }
        }
    }
}
