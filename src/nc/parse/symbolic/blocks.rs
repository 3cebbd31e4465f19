//! Blocks of a language with names: labels, jumps to labels, assignments, calls by name, messages.
//!
//! ```text
//! block  := [ '/' ] [ ( N | ':' ) uint ] [ name ':' ] ( assigns | jumps | call | message | words ) [ ';' comment ]
//! assigns:= { var '=' cond }
//! jumps  := ( GOTOF | GOTOB ) name | { IF cond ( GOTOF | GOTOB ) name }
//! call   := name [ P uint ]                           L128 is a name too
//! message:= MSG '(' [ '"' text '"' ] ')'
//! words  := { letter number | address [ uint ] '=' cond | address '=' form '(' cond ')' | code }
//! ```
//!
//! A `cond` is a formula of such a language (`formula.rs`).

use crate::controls::Alarm;
use crate::msg;
use crate::nc::ast::{Assignment, Expr, ExprId, Extent, Jump, JumpDirection, Stmt};
use crate::nc::dec::Dec;
use crate::nc::lex::keywords::{FOREIGN_STATEMENTS, SYMBOLIC_STATEMENTS};
use crate::nc::lex::names::{begins_as_name, meant_name};
use crate::nc::lex::spelling::{holds_word, meant, prose, states, zero_as_letter};
use crate::nc::parse::failure::{ParseFailure, Read};
use crate::nc::parse::file::begins_character;
use crate::nc::parse::formula::VariableAccess;
use crate::nc::parse::reader::{BLOCK_BYTES, Reader};
use crate::nc::parsed::FINDINGS;
use crate::text::{Diagnostic, DiagnosticKind, Place, Span};

impl<'a> Reader<'a> {
    /// Reads a line of a file: one block, `from < to`, without white space around it.
    pub(in crate::nc::parse) fn symbolic_block(&mut self, from: usize, to: usize) {
        let source = self.file.text;
        let line = source.as_bytes().get(from..to).unwrap_or_default();
        if self.take_directory_line(line) {
            return;
        }
        if line.len() > BLOCK_BYTES {
            self.take_line(line, from);
            self.report(Alarm::BlockTooLong, 0, line.len(), msg!("nc.block-too-long", most = BLOCK_BYTES as u32));
            return self.push(Stmt::Empty);
        }
        let mark = self.mark();
        let code = self.take_without_comment(from, to);
        let stmt = match self.symbolic_statement() {
            Ok(stmt) => stmt,
            Err(failure) => {
                self.deck.words.truncate(mark.words);
                self.deck.assignments.truncate(mark.assignments);
                self.deck.jumps.truncate(mark.jumps);
                self.symbolic_failure(*failure);
                Stmt::Empty
            }
        };
        let most = self.tables.rules.block_chars as usize;
        if code > most && self.block.bad.is_none() {
            let rest = self.cursor.line.get(most..code).unwrap_or_default();
            let at = most + rest.iter().position(|&byte| begins_character(byte)).unwrap_or(rest.len());
            self.report(Alarm::BlockTooLong, at, code, msg!("nc.block-too-long", most = most as u32));
        }
        self.cursor.line = line;
        self.push(stmt);
    }

    /// Sets the cursor to a line without its comment, stores the comment, and returns the length without it.
    fn take_without_comment(&mut self, from: usize, to: usize) -> usize {
        let source = self.file.text;
        let line = source.as_bytes().get(from..to).unwrap_or_default();
        let mut quoted = false;
        let semicolon = line.iter().position(|&b| {
            quoted ^= b == b'"';
            b == b';' && !quoted
        });
        let code = line.get(..semicolon.unwrap_or(line.len())).unwrap_or_default().trim_ascii_end();
        self.take_line(code, from);
        if let Some(at) = semicolon {
            self.note_foreign(from + at + 1, to);
            let span = Span::new((from + at + 1) as u32, to as u32);
            self.block.comment = Some(self.add_text(source.get(from + at + 1..to).unwrap_or(""), span));
        }
        code.len()
    }

    /// Reports the reason why a block does not parse.
    #[cold]
    fn symbolic_failure(&mut self, failure: ParseFailure) {
        let rest = self.cursor.line.get(failure.from..).unwrap_or_default();
        let comment =
            failure.at_word && self.block.comment.is_none() && prose(rest) && !states(rest, &SYMBOLIC_STATEMENTS);
        let label = self.no_label(failure.from);
        let ParseFailure { alarm, mut finding, from, .. } = failure;
        if let Some(label) = label {
            return self.report_as(Alarm::Format, label);
        }
        if comment && finding.fixes.is_empty() {
            let name = rest.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
            // `SUB(1)`, `SUB PR1`.
            let call = match rest.get(name..).unwrap_or_default().trim_ascii_start() {
                [b'(', ..] => true,
                [b'P' | b'p', count, after @ ..] => {
                    let digit = after.first().is_some_and(u8::is_ascii_digit);
                    !count.is_ascii_alphabetic() || count | 0x20 == b'r' && digit
                }
                _ => false,
            };
            // A call or a word that became a comment would no longer act.
            if call || holds_word(rest) {
                finding.kind = DiagnosticKind::GuessedFix;
            }
            let place = self.place(self.span(from, from));
            finding = finding.fix(msg!("nc.fix.comment"), vec![(place, ";".to_owned())]);
        }
        self.report_as(alarm, finding);
    }

    /// The finding of a name before `:` that no label can have, such as `A1:`, where the block fails at `from` or later.
    fn no_label(&self, from: usize) -> Option<Diagnostic> {
        let colon = self.cursor.line.iter().position(|&b| b == b':').filter(|&at| at > 0 && from <= at)?;
        let head = self.cursor.line.get(..colon)?.trim_ascii_end();
        let start = head.iter().rposition(|&b| !(b.is_ascii_alphanumeric() || b == b'_')).map_or(0, |at| at + 1);
        let name = core::str::from_utf8(head.get(start..)?).ok()?.to_ascii_uppercase();
        let before = head.get(..start)?.trim_ascii();
        let number = before.iter().all(|&b| b.is_ascii_digit() || matches!(b, b'N' | b'n' | b'/'));
        let (least, most) = self.label_length();
        let label = begins_as_name(&name) && (least..=most).contains(&name.len());
        let message = msg!("nc.label-name", label = name.as_str(), least = least as u32, most = most as u32);
        let letter = name.bytes().next().is_some_and(|b| b.is_ascii_alphabetic());
        (letter && number && !label).then(|| self.finding(Alarm::Format, start, head.len(), message))
    }

    /// Least and most characters of a label.
    fn label_length(&self) -> (usize, usize) {
        (self.names().map_or(2, |names| names.label_least), self.tables.rules.label_chars)
    }

    /// Reads block skip, block number and label, then the statement.
    fn symbolic_statement(&mut self) -> Read<Stmt> {
        let mut first = self.block_skip();
        let second = self.cursor.byte(1);
        if first == b':' || first | 0x20 == b'n' && (second.is_ascii_digit() || second == b' ') {
            self.block_number()?;
            first = self.next_byte();
        }
        if self.name_ahead()
            && let Some(stmt) = self.name_first()?
        {
            return Ok(stmt);
        }
        if self.block.label.is_some() {
            first = self.next_byte();
            if self.name_ahead()
                && let Some(stmt) = self.name_first()?
            {
                return Ok(stmt);
            }
        }
        match first | 0x20 {
            b'r' if self.parameter_ahead() => self.assignments(),
            b'l' if self.cursor.byte(1).is_ascii_digit() && self.label_ahead() => self.numbered_label(),
            b'l' if self.cursor.byte(1).is_ascii_digit() => self.call(),
            b'p' if self.cursor.byte(1).is_ascii_digit() && self.lone_name() => self.call(),
            b'o' if self.foreign_program_number() => Ok(Stmt::Empty),
            _ if first == b'#' => self.assignments(),
            _ => self.symbolic_words(),
        }
    }

    /// Whether a name of several letters follows, or a one-letter label.
    #[inline]
    fn name_ahead(&self) -> bool {
        let name = |b: u8| b.is_ascii_alphabetic() || b == b'_';
        name(self.cursor.peek()) && (name(self.cursor.byte(1)) || self.cursor.byte(1) == b':')
    }

    /// Whether a colon follows the name at the cursor.
    fn label_ahead(&self) -> bool {
        let after = self.cursor.rest().get(self.cursor.name().len()..).unwrap_or_default();
        after.trim_ascii_start().first() == Some(&b':')
    }

    /// Reports `L1:`, a label that the control reads as a program call; reads the rest of the block.
    fn numbered_label(&mut self) -> Read<Stmt> {
        let start = self.cursor.at;
        let name = self.cursor.name().to_ascii_uppercase();
        self.cursor.at += name.len();
        let end = self.cursor.at;
        self.pass_blanks();
        self.cursor.at += 1;
        let (least, most) = self.label_length();
        let message = msg!("nc.label-is-call", label = name.as_str(), least = least as u32, most = most as u32);
        let finding = self.finding(Alarm::Format, start, end, message);
        self.report_as(Alarm::Format, finding);
        self.block.label = Some(self.add_text(name, self.span(start, end)));
        self.pass_blanks();
        if self.cursor.ended() { Ok(Stmt::Empty) } else { self.symbolic_words() }
    }

    /// Whether only a name and a number of repeats follow.
    fn lone_name(&self) -> bool {
        let mut words = self.cursor.rest().split(|b| *b == b' ').filter(|word| !word.is_empty());
        let digits = |word: &[u8]| word.get(1..).unwrap_or_default().iter().all(u8::is_ascii_digit);
        words.next().is_some_and(digits) && words.all(|word| word.first().is_some_and(|b| b | 0x20 == b'p'))
    }

    /// Reads `N10` or `:10`.
    fn block_number(&mut self) -> Read<()> {
        let start = self.cursor.at;
        self.block.main = self.cursor.peek() == b':';
        self.cursor.at += 1;
        self.cursor.blank();
        let from = self.cursor.at;
        let mut number = 0_u32;
        while self.cursor.peek().is_ascii_digit() {
            number = number.saturating_mul(10).saturating_add(u32::from(self.cursor.peek() - b'0'));
            self.cursor.at += 1;
        }
        if self.cursor.at == from {
            return Err(self.failure(Alarm::NoNumber, start, start + 1, msg!("nc.no-sequence-number")).at_word());
        }
        if self.zero_for_o() {
            return Ok(());
        }
        let most = self.control.syntax.sequence_digits;
        if self.cursor.at - from > usize::from(most) {
            self.report(
                Alarm::SequenceDigits,
                start,
                self.cursor.at,
                msg!("nc.sequence-digits", most = u32::from(most)),
            );
        }
        (self.block.number, self.block.number_at) = (Some(number), self.extent(start, self.cursor.at));
        Ok(())
    }

    /// Reads a label, which is stored, or a statement that begins with a name; `None` for a label, a code or an address.
    fn name_first(&mut self) -> Read<Option<Stmt>> {
        let start = self.cursor.at;
        let written = self.cursor.name();
        let name = written.to_ascii_uppercase();
        let after = self.cursor.line.get(start + name.len()..).unwrap_or_default().trim_ascii_start();
        if after.first() == Some(&b':') && self.block.label.is_none() {
            self.cursor.at = self.cursor.line.len() - after.len() + 1;
            self.check_label(&name, start);
            let span = self.span(start, start + name.len());
            self.block.label = Some(self.add_text(name, span));
            return Ok(None);
        }
        match name.as_str() {
            "IF" => return self.conditions().map(Some),
            "GOTOF" | "GOTOB" => {
                let (target, way, keyword) = self.jump()?;
                self.end_of_symbolic_statement()?;
                return Ok(Some(Stmt::Goto { target, way, keyword }));
            }
            "MSG" => return self.message().map(Some),
            _ => {}
        }
        let Some(names) = self.names() else { return Ok(None) };
        if names.local_data && name == "DEF" {
            self.local_data();
            return Ok(Some(Stmt::Empty));
        }
        if names.lists(&name)
            && FOREIGN_STATEMENTS.contains(&name.as_str())
            && (after.starts_with(b"[") || self.ends_with_do())
        {
            return Err(self.other_loop(start, &name));
        }
        if let Some(failure) = self.listed_statement(start, &name) {
            return Err(failure);
        }
        let variable = name.strip_prefix("IF").is_some_and(|rest| self.missing_equals(&format!("X{rest}")));
        if variable && matches!(after.first(), Some(b'=' | b'<' | b'>' | b'+' | b'-' | b'*' | b'/')) {
            let end = start + 2;
            let mut failure = self.failure(Alarm::UnknownName, start, end, msg!("nc.blank-after", keyword = "IF"));
            let place = self.place(self.span(end, end));
            failure.finding = failure.finding.fix(msg!("nc.fix.blank"), vec![(place, " ".to_owned())]);
            return Err(failure);
        }
        let known = names.code(&name).is_some() || names.addresses.iter().any(|row| name.starts_with(row.0));
        if known || after.first() == Some(&b'=') || self.missing_equals(written) {
            return Ok(None);
        }
        let others = FOREIGN_STATEMENTS
            .iter()
            .any(|word| name.strip_prefix(word).is_some_and(|n| n.bytes().all(|b| b.is_ascii_digit())));
        if others || after.starts_with(b"[") && FOREIGN_STATEMENTS.contains(&name.as_str()) {
            return Err(self.other_statement(start, &name));
        }
        if let Some(at) = (!after.is_empty()).then(|| meant(&name, SYMBOLIC_STATEMENTS.into_iter())).flatten() {
            let message = msg!("nc.unknown-keyword", word = name);
            let mut failure = self.failure(Alarm::Format, start, start + written.len(), message);
            let place = self.place(self.span(start, start + written.len()));
            let title = msg!("nc.fix.write", text = SYMBOLIC_STATEMENTS[at]);
            failure.finding = failure.finding.fix(title, vec![(place, SYMBOLIC_STATEMENTS[at].to_owned())]);
            failure.finding.kind = DiagnosticKind::GuessedFix;
            return Err(failure);
        }
        self.call().map(Some)
    }

    /// The failure of a statement that is listed by its name: the control has it, may have it, or leaves it to other controls of its maker.
    #[cold]
    fn listed_statement(&self, start: usize, name: &str) -> Option<Box<ParseFailure>> {
        let names = self.names()?;
        let (end, control) = (self.cursor.line.len(), self.control.name);
        let message = if names.left_out.contains(&name) {
            msg!("nc.left-out-statement", word = name, control)
        } else if names.unsimulated.contains(&name) {
            msg!("nc.unsimulated-statement", word = name, control)
        } else if names.foreign.contains(&name) {
            let message = msg!("nc.foreign-statement", word = name, control);
            return Some(self.failure(Alarm::Format, start, start + name.len(), message));
        } else {
            return None;
        };
        Some(self.stops_here(start, end, message))
    }

    fn check_label(&mut self, name: &str, start: usize) {
        let (least, most) = self.label_length();
        if !begins_as_name(name) || !(least..=most).contains(&name.len()) {
            let message = msg!("nc.label-name", label = name, least = least as u32, most = most as u32);
            self.report(Alarm::Format, start, start + name.len(), message);
        }
    }

    /// Reads a program call: the name at the cursor, and the number of runs.
    fn call(&mut self) -> Read<Stmt> {
        let start = self.cursor.at;
        let written = self.cursor.name();
        self.cursor.at += written.len();
        let end = self.cursor.at;
        let mut repeats = None;
        if self.next_byte() | 0x20 == b'p'
            && (self.cursor.byte(1).is_ascii_digit() || matches!(self.cursor.byte(1), b'=' | b' ' | b'-'))
        {
            let from = self.cursor.at;
            self.cursor.at += 1;
            if self.next_byte() == b'=' {
                self.cursor.at += 1;
                repeats = Some(self.symbolic_formula()?);
            } else {
                repeats = Some(self.factor()?);
            }
            if let Some(Expr::Number(number)) = repeats.map(|id| self.deck.expr(id)) {
                let most = self.control.limits.repeat_max;
                if number.scale > 0 || !(1..=i64::from(most)).contains(&number.mantissa) {
                    self.report(Alarm::RepeatRange, from, self.cursor.at, msg!("nc.repeat-range", most));
                }
            }
        }
        self.pass_blanks();
        if !self.cursor.ended() {
            return Err(self.not_a_call(start, end, written));
        }
        let name = self.add_text(written.to_ascii_uppercase(), self.span(start, end));
        Ok(Stmt::Call { name, repeats })
    }

    /// The failure of a name followed by words, which is not a call: a label without its colon, or an unknown name.
    fn not_a_call(&self, start: usize, end: usize, name: &str) -> Box<ParseFailure> {
        if self.cursor.peek() == b':' {
            // A second label.
            return self.unexpected();
        }
        // Searching a large file for each such line would take too long.
        let is_small = self.file.text.len() < 1 << 16;
        if begins_as_name(name) && is_small && self.lists_findings() && self.jumped_to(name) {
            let mut failure = self.failure(Alarm::Format, start, end, msg!("nc.label-colon", label = name));
            let place = self.place(self.span(end, end));
            failure.finding = failure.finding.fix(msg!("nc.fix.insert", text = ":"), vec![(place, ":".to_owned())]);
            return failure;
        }
        if name.as_bytes().get(1).is_some_and(u8::is_ascii_digit) {
            return self.failure(Alarm::Format, start, end, msg!("nc.call-alone", program = name));
        }
        self.unknown_name(start, name)
    }

    /// The failure of an unknown name, with a guess for one wrong letter.
    pub(in crate::nc::parse) fn unknown_name(&self, start: usize, name: &str) -> Box<ParseFailure> {
        let end = start + name.len();
        let message = msg!("nc.unknown-name", name, control = self.control.name);
        let mut failure = self.failure(Alarm::UnknownName, start, end, message).at_word();
        let Some(names) = self.names() else { return failure };
        if let Some(listed) = self.listed_statement(start, &name.to_ascii_uppercase()) {
            return listed;
        }
        if self.is_local_variable(name) {
            return self.local_variable(start, name);
        }
        let after = self.cursor.line.get(end..).unwrap_or_default().trim_ascii_start();
        // `XO=5` is no `X0=5`, which is not allowed either; `RO=5` is R0=5.
        let assigned = after.first() == Some(&b'=') && !name.starts_with(['R', 'r']);
        if zero_as_letter(name) && !assigned && !self.assigns_name(name) {
            return self.letter_for_zero(start, name);
        }
        if name == "LF" && matches!(after.first(), None | Some(b';')) {
            let place = self.place(self.span(start, end));
            failure.finding.message = msg!("nc.printed-line-end");
            failure.finding = failure.finding.fix(msg!("nc.fix.drop", text = name), vec![(place, String::new())]);
            return failure;
        }
        if let Some(known) = meant_name(names, &name.to_ascii_uppercase(), after.first() == Some(&b'=')) {
            let place = self.place(self.span(start, end));
            failure.finding = failure.finding.fix(msg!("nc.fix.write", text = known.as_str()), vec![(place, known)]);
            failure.finding.kind = DiagnosticKind::GuessedFix;
        }
        failure
    }

    /// The failure of a name that is a letter with the letter O in place of the digit 0, with its fix.
    #[cold]
    pub(in crate::nc::parse) fn letter_for_zero(&self, start: usize, name: &str) -> Box<ParseFailure> {
        let (from, end) = (start + 1, start + name.len());
        let mut failure = self.failure(Alarm::UnknownName, from, end, msg!("nc.letter-o"));
        let digits = name.get(1..).unwrap_or("").replace(['O', 'o'], "0");
        let place = self.place(self.span(from, end));
        failure.finding = failure.finding.fix(msg!("nc.fix.write", text = digits.as_str()), vec![(place, digits)]);
        failure
    }

    /// Whether the file assigns a value to a name other than that of an R parameter.
    fn assigns_name(&self, name: &str) -> bool {
        // Searching a large file for each such name would take too long.
        let is_small = self.file.text.len() < 1 << 16;
        let assigned = |line: &str| {
            let code = line.split(';').next().unwrap_or("");
            let mut parts = code.split('=');
            parts.next_back();
            parts.any(|part| {
                part.rsplit([' ', '\t'])
                    .find(|word| !word.is_empty())
                    .is_some_and(|word| word.eq_ignore_ascii_case(name))
            })
        };
        is_small && !name.starts_with(['R', 'r']) && self.lists_findings() && self.file.text.lines().any(assigned)
    }

    /// Whether a jump in the file names a label.
    fn jumped_to(&self, name: &str) -> bool {
        let mut jump = false;
        self.file.text.split_ascii_whitespace().any(|word| {
            let to = word.split(';').next().unwrap_or("");
            let found = jump && to.eq_ignore_ascii_case(name);
            jump = word.eq_ignore_ascii_case("GOTOF") || word.eq_ignore_ascii_case("GOTOB");
            found
        })
    }

    /// Whether the block ends with DO and a number.
    fn ends_with_do(&self) -> bool {
        let head = self.cursor.line.trim_ascii_end();
        let digits = head.iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
        let head = head.get(..head.len() - digits).unwrap_or_default().trim_ascii_end();
        digits > 0 && head.get(head.len().saturating_sub(2)..).is_some_and(|word| word.eq_ignore_ascii_case(b"DO"))
    }

    /// The failure of `WHILE[…]DO1`, a loop of another macro language.
    #[cold]
    fn other_loop(&self, start: usize, name: &str) -> Box<ParseFailure> {
        let message = msg!("nc.other-loop", keyword = name, control = self.control.name);
        let mut failure = self.failure(Alarm::Format, start, start + name.len(), message);
        failure.finding = failure.finding.hint(msg!("nc.hint.other-jump"));
        failure
    }

    /// The failure of a statement of another macro language.
    fn other_statement(&self, start: usize, name: &str) -> Box<ParseFailure> {
        let end = start + name.len();
        let message = msg!("nc.other-jump", keyword = name, control = self.control.name);
        let mut failure = self.failure(Alarm::Format, start, end, message);
        failure.finding = failure.finding.hint(msg!("nc.hint.other-jump"));
        let edits = if self.lists_findings() { self.label_instead(start, name) } else { None };
        if let Some(edits) = edits {
            failure.finding = failure.finding.fix(msg!("nc.fix.jump-to-label"), edits);
        }
        failure
    }

    /// Edits that rewrite `GOTO 10` as a jump to a label, inserted in front of the first block with that number.
    fn label_instead(&self, start: usize, name: &str) -> Option<Vec<(Place, String)>> {
        let after = self.cursor.line.get(start..).and_then(|rest| core::str::from_utf8(rest).ok())?;
        let tail = after.get(4..).filter(|_| name.starts_with("GOTO"))?;
        let digits = tail.trim_start().trim_start_matches(['N', 'n']);
        let digits = digits.get(..digits.bytes().take_while(u8::is_ascii_digit).count()).filter(|d| !d.is_empty())?;
        let end = start + after.len() - (tail.len() - tail.find(digits)? - digits.len());
        let label = format!("LB{digits}");
        let mut from = 0;
        for line in self.file.text.split('\n').take(FINDINGS) {
            let lead = line.len() - line.trim_start().len() + 1;
            let number = line.get(lead..).filter(|_| line.trim_start().starts_with(['N', 'n']));
            let number = number
                .and_then(|line| line.strip_prefix(digits))
                .filter(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()));
            if number.is_some() {
                let at = (from + lead + digits.len()) as u32;
                let way = if at < self.cursor.base { "GOTOB" } else { "GOTOF" };
                let target = self.place(Span::new(at, at));
                let jump = self.spaced(start, end, way).trim_end().to_owned();
                let jump = if start == 0 { way.to_owned() } else { jump };
                return Some(vec![
                    (self.place(self.span(start, end)), format!("{jump} {label}")),
                    (target, format!(" {label}:")),
                ]);
            }
            from += line.len() + 1;
        }
        None
    }

    /// Reads `IF cond GOTOF label`, once or several times.
    fn conditions(&mut self) -> Read<Stmt> {
        let first = self.deck.jumps.len();
        while self.take_word("IF") {
            let start = self.cursor.at;
            self.pass_blanks();
            if self.symbolic_jump_ahead() || self.cursor.ended() {
                let message = msg!("nc.no-condition-before-jump");
                return Err(self.failure(Alarm::IfSentence, start.saturating_sub(2), start, message));
            }
            let cond = self.symbolic_condition()?;
            self.pass_blanks();
            self.needless_then();
            if !self.symbolic_jump_ahead() {
                let end = self.cursor.line.len();
                if self.cursor.ahead("GOTO") {
                    return Err(self.other_statement(self.cursor.at, "GOTO"));
                }
                if self.cursor.ended()
                    && let Some(failure) = self.branch(start.saturating_sub(2))
                {
                    return Err(failure);
                }
                return Err(self.failure(Alarm::IfSentence, start.saturating_sub(2), end, msg!("nc.if-without-jump")));
            }
            let (target, way, keyword) = self.jump()?;
            self.deck.jumps.push(Jump { cond: Some(cond), target, way, keyword });
            self.pass_blanks();
        }
        self.end_of_symbolic_statement()?;
        let count = self.deck.jumps.len() - first;
        match self.deck.jumps.last().copied() {
            Some(Jump { cond: Some(cond), target, way, keyword }) if count == 1 => {
                self.deck.jumps.pop();
                Ok(Stmt::If { cond, target, way, keyword })
            }
            _ => Ok(Stmt::Ifs { first: first as u32, count: count as u16 }),
        }
    }

    /// The failure of an IF, from `start` on, that ends with its condition: the head of IF … ENDIF where the control has or may have that.
    #[cold]
    fn branch(&self, start: usize) -> Option<Box<ParseFailure>> {
        let (names, control) = (self.names()?, self.control.name);
        let message = if names.left_out.contains(&"ENDIF") {
            msg!("nc.left-out-statement", word = "IF … ENDIF", control)
        } else if names.unsimulated.contains(&"ENDIF") {
            msg!("nc.unsimulated-statement", word = "IF … ENDIF", control)
        } else {
            return None;
        };
        Some(self.stops_here(start, self.cursor.line.len(), message))
    }

    fn symbolic_jump_ahead(&self) -> bool {
        self.cursor.is_name("GOTOF") || self.cursor.is_name("GOTOB")
    }

    /// Reports THEN between a condition and its jump, which has none.
    fn needless_then(&mut self) {
        let start = self.cursor.at;
        if self.take_word("THEN") {
            self.pass_blanks();
            if self.symbolic_jump_ahead() {
                self.report_replaced(Alarm::IfSentence, start, self.cursor.at, msg!("nc.needless-then"), "");
            } else {
                self.cursor.at = start;
            }
        }
    }

    /// Reads a keyword, if it is the next name.
    pub(super) fn take_word(&mut self, word: &str) -> bool {
        let ahead = self.cursor.is_name(word);
        self.cursor.at += if ahead { word.len() } else { 0 };
        ahead
    }

    /// Reads `GOTOF label`, from the start of the keyword.
    fn jump(&mut self) -> Read<(ExprId, JumpDirection, Extent)> {
        let word = self.cursor.at;
        let keyword = self.extent(word, word + 5);
        let way = if self.cursor.byte(4) | 0x20 == b'f' { JumpDirection::Forward } else { JumpDirection::Backward };
        self.cursor.at += 5;
        self.pass_blanks();
        let start = self.cursor.at;
        let name = self.cursor.name();
        let number = name.strip_prefix(['N', 'n']).unwrap_or(name);
        if !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()) {
            self.cursor.at += name.len();
            if !self.tables.rules.number_jumps {
                let finding = self.finding(
                    Alarm::NoSequence,
                    start,
                    self.cursor.at,
                    msg!("nc.number-jump", control = self.control.name),
                );
                self.report_as(Alarm::NoSequence, finding.hint(msg!("nc.hint.number-jump")));
            }
            let number = Dec::int(number.parse().unwrap_or(i64::from(u32::MAX)));
            return Ok((self.add_expr(Expr::Number(number), start)?, way, keyword));
        }
        if name.is_empty() || name.starts_with(|c: char| c.is_ascii_digit()) {
            let text =
                self.cursor.line.get(word..word + 5).and_then(|text| core::str::from_utf8(text).ok()).unwrap_or("");
            return Err(self.failure(Alarm::IfSentence, word, word + 5, msg!("nc.no-label", keyword = text)));
        }
        // Errors of the name are reported at the label itself.
        self.cursor.at += name.len();
        let label = self.add_text(name.to_ascii_uppercase(), self.span(start, self.cursor.at));
        Ok((self.add_expr(Expr::Label(label), start)?, way, keyword))
    }

    /// Reads `MSG("text")`.
    fn message(&mut self) -> Read<Stmt> {
        let start = self.cursor.at;
        self.cursor.at += 3;
        let form = |reader: &Self, end: usize| reader.failure(Alarm::Format, start, end, msg!("nc.message-form"));
        if self.next_byte() != b'(' {
            return Err(form(self, start + 3));
        }
        self.cursor.at += 1;
        let mut text = None;
        if self.next_byte() == b'"' {
            let from = self.cursor.at + 1;
            let inner = self.cursor.line.get(from..).unwrap_or_default();
            let Some(len) = inner.iter().position(|&b| b == b'"') else {
                return Err(form(self, self.cursor.line.len()));
            };
            let base = self.cursor.base as usize + from;
            self.note_foreign(base, base + len);
            text = Some(self.add_text(self.file.text.get(base..base + len).unwrap_or(""), self.span(from, from + len)));
            self.cursor.at = from + len + 1;
        }
        if self.next_byte() != b')' {
            return Err(form(self, self.cursor.line.len()));
        }
        self.cursor.at += 1;
        self.pass_blanks();
        if !self.cursor.ended() {
            let end = self.cursor.line.len();
            self.report(Alarm::NotAlone, start, end, msg!("nc.not-alone", code = "MSG"));
        }
        Ok(Stmt::Message(text))
    }

    /// Reads `R1=… R2=…` to the end of the block.
    fn assignments(&mut self) -> Read<Stmt> {
        let first = self.deck.assignments.len();
        loop {
            let start = self.cursor.at;
            let to = if self.cursor.peek() == b'#' {
                self.hash_variable(VariableAccess::Write)?
            } else {
                self.variable(VariableAccess::Write)?
            };
            let end = self.cursor.at;
            self.equals_sign(start, end)?;
            if self.next_byte() == b'"' {
                let variable = self.cursor.line.get(start..end).unwrap_or_default().trim_ascii_end();
                return Err(self.text_value(&String::from_utf8_lossy(variable)));
            }
            let value = self.symbolic_formula()?;
            self.deck.assignments.push(Assignment { to, value });
            self.pass_blanks();
            if !(self.parameter_ahead() || self.cursor.peek() == b'#') {
                break;
            }
        }
        let letter = self.cursor.peek().is_ascii_alphabetic();
        if letter && self.unknown_ahead() {
            return Err(self.unknown_name(self.cursor.at, self.cursor.name()));
        }
        if letter {
            let (start, end) = (self.cursor.at, self.cursor.line.len());
            let finding = self.finding(Alarm::Mixed, start, end, msg!("nc.assignments-alone"));
            let place = self.place(self.span(start, start));
            let edit = format!("{}{}", self.newline(), self.skip_mark());
            let finding = finding.fix(msg!("nc.fix.own-block"), vec![(place, edit)]);
            self.report_as(Alarm::Mixed, finding);
            self.cursor.at = end;
        }
        self.end_of_symbolic_statement()?;
        let count = self.deck.assignments.len() - first;
        match self.deck.assignments.last().copied() {
            Some(Assignment { to, value }) if count == 1 => {
                self.deck.assignments.pop();
                Ok(Stmt::Assign { to, value })
            }
            _ => Ok(Stmt::Assigns { first: first as u32, count: count as u16 }),
        }
    }

    /// The failure of a jump behind a complete statement: in a block of its own it means the same.
    #[cold]
    fn second_statement(&self) -> Box<ParseFailure> {
        let (start, end) = (self.cursor.at, self.cursor.line.len());
        let keyword = self.cursor.name().to_ascii_uppercase();
        let mut failure = self.failure(Alarm::Mixed, start, end, msg!("nc.statement-alone", keyword));
        let place = self.place(self.span(start, start));
        let edit = format!("{}{}", self.newline(), self.skip_mark());
        failure.finding = failure.finding.fix(msg!("nc.fix.own-block"), vec![(place, edit)]);
        failure
    }

    /// Whether a name of several letters follows that is no statement, code or address: an operator or a comment.
    fn unknown_ahead(&self) -> bool {
        let name = self.cursor.name().to_ascii_uppercase();
        let Some(names) = self.names().filter(|_| !self.cursor.byte(1).is_ascii_digit() && name.len() > 1) else {
            return false;
        };
        let address = names.addresses.iter().any(|row| name.starts_with(row.0));
        let statement = SYMBOLIC_STATEMENTS.contains(&name.as_str()) || names.lists(&name);
        !(statement || address || names.code(&name).is_some() || self.missing_equals(&name))
    }

    /// Reports text after the statement.
    fn end_of_symbolic_statement(&mut self) -> Read<()> {
        match self.next_byte() {
            _ if self.cursor.ended() => Ok(()),
            b'(' if self.foreign_comment() => Ok(()),
            b'I' | b'i' | b'G' | b'g' if self.cursor.is_name("IF") || self.symbolic_jump_ahead() => {
                Err(self.second_statement())
            }
            byte if byte.is_ascii_alphabetic() => {
                Err(self.failure(Alarm::Mixed, self.cursor.at, self.cursor.line.len(), msg!("nc.mixed")).at_word())
            }
            _ => Err(self.unexpected()),
        }
    }
}
