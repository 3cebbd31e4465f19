//! Blocks that do not parse: known mistakes, each reported once with its fix.
//!
//! Tried in this order: a comment with brackets in it; an unbracketed comment or one after `//`, alone or after a complete block; round
//! brackets for arithmetic; else the failure as the control meets it. In each case the block is bad: the control would stop there.

use crate::controls::Alarm;
use crate::msg;
use crate::nc::ast::{Block, Stmt};
use crate::nc::lex::keywords::KEYWORDS;
use crate::nc::lex::spelling::{arithmetic, holds_macro, holds_word, keyword_in_prose, prose, states};
use crate::nc::parse::failure::{ParseFailure, Read};
use crate::nc::parse::reader::{Mark, Reader};
use crate::text::escape::shortened;
use crate::text::{DiagnosticKind, Place};

/// Length limit of lines for the search for known mistakes, because of its cost. Longer lines get their plain failure.
const LOOKED_AT: usize = 1000;

impl Reader<'_> {
    /// Reports the reason why the present line does not parse.
    pub(in crate::nc::parse) fn recover(&mut self, mark: Mark, first: Box<ParseFailure>) {
        let (alarm, whole) = (first.alarm, self.cursor.line);
        if whole.len() > LOOKED_AT || !self.lists_findings() {
            return self.add_finding(first.finding);
        }
        // An unclosed comment is already reported and hides the rest.
        if self.findings.list.iter().skip(mark.found).any(|finding| finding.kind == DiagnosticKind::OpenComment) {
            return;
        }
        if let Some((open, inner, close)) = self.nested_comment() {
            self.rollback(&mark);
            return self.report_nested(alarm, open, &inner, close);
        }
        if let Some(finding) = self.foreign_syntax(&first) {
            self.rollback(&mark);
            return self.add_finding(finding);
        }
        let Some(at) = self.bare_comment(&first) else { return self.try_rounds(&mark, *first) };
        self.rollback(&mark);
        let head = whole.get(..at).unwrap_or_default().trim_ascii_end();
        // `#101-----Spindle reduction ratio` is a comment from its start, without a statement in front.
        let from = variable_alone(head).unwrap_or(at);
        let head = head.get(..from.min(head.len())).unwrap_or_default().trim_ascii_end();
        let before = mark;
        self.report_bare_comment(alarm, head.len(), from);
        let mark = self.mark();
        self.cursor.line = head;
        self.rewind();
        match self.statement() {
            // The apparent comment is in place of a value.
            Err(failure) if failure.finding.kind == DiagnosticKind::EndsEarly => {
                self.rollback(&before);
                self.add_finding(first.finding);
            }
            Err(failure) => self.try_rounds(&mark, *failure),
            Ok(_) => {}
        }
        self.cursor.line = whole;
    }

    /// Reads the line again with round brackets that group. If it parses then, they are the mistake.
    fn try_rounds(&mut self, mark: &Mark, failure: ParseFailure) {
        if !self.cursor.line.contains(&b'(') {
            return self.add_finding(failure.finding);
        }
        let first = self.take_back(mark);
        self.formulas.rounds = true;
        let again = self.statement();
        self.formulas.rounds = false;
        let brackets = core::mem::take(&mut self.formulas.round_brackets);
        if again.is_err() || brackets.is_empty() {
            self.rollback(mark);
            self.put_back(first);
            return self.add_finding(failure.finding);
        }
        let from = brackets.iter().map(|pair| pair.0).min().unwrap_or(0);
        let to = brackets.iter().map(|pair| pair.1 + 1).max().unwrap_or(0);
        let edit = |at: usize, bracket: &str| (self.place(self.span(at, at + 1)), bracket.to_owned());
        let mut edits: Vec<(Place, String)> =
            brackets.iter().flat_map(|&(open, close)| [edit(open, "["), edit(close, "]")]).collect();
        edits.sort_by_key(|(place, _)| place.span.start);
        let finding = self.finding(failure.alarm, from, to, msg!("nc.round-brackets", control = self.control.name));
        self.add_finding(finding.hint(msg!("nc.hint.round-brackets")).fix(msg!("nc.fix.square"), edits));
    }

    /// Start of an unbracketed comment: a run of dashes, or prose in place of a word.
    fn bare_comment(&self, failure: &ParseFailure) -> Option<usize> {
        let mut at = 0;
        let mut comment = false;
        while let Some(&byte) = self.cursor.line.get(at) {
            let run = dashes(self.cursor.line, at);
            let slashes = self.cursor.line.get(at..).is_some_and(|rest| rest.starts_with(b"//"));
            if !comment && (slashes || starts_comment(self.cursor.line, at, run)) {
                return Some(at);
            }
            comment = match byte {
                b'(' => true,
                b')' => false,
                _ => comment,
            };
            at += run.max(1);
        }
        let rest = self.cursor.line.get(failure.from..).unwrap_or_default();
        let condition = [&b"IF"[..], b"WHILE"].iter().any(|word| {
            let after = rest.get(word.len()..).unwrap_or_default().trim_ascii_start();
            rest.starts_with(word) && after.first() == Some(&b'[')
        });
        let remark = prose(rest) && !holds_macro(rest) || other_script(rest);
        let behind_semicolon = failure.from == 0 && self.is_keyword_remark(rest);
        (failure.at_word && !condition && remark || behind_semicolon).then_some(failure.from)
    }

    /// Whether the block is words of plain language behind a `;`, the first of them a keyword: `; end`, `; if needed`. `; END` may lack its
    /// number where a loop is open.
    fn is_keyword_remark(&self, block: &[u8]) -> bool {
        let before = self.file.text.get(..self.cursor.base as usize).unwrap_or("");
        let loops = |block: &Block| match block.stmt {
            Stmt::While { .. } => 1,
            Stmt::End { .. } => -1,
            _ => 0,
        };
        before.trim_end_matches([' ', '\t']).ends_with(';')
            && keyword_in_prose(block, &KEYWORDS)
            && (!block.eq_ignore_ascii_case(b"END") || self.deck.blocks.iter().map(loops).sum::<i32>() <= 0)
    }

    /// Reports an unbracketed comment from `from` on, with a fix that puts it in brackets; the kept part of the block ends at `cut`.
    fn report_bare_comment(&mut self, alarm: Alarm, cut: usize, from: usize) {
        let end = self.cursor.line.len();
        let start = self.cursor.base as usize;
        let text = self.file.text.get(start + from..start + end).unwrap_or("");
        let bare = text.trim_start_matches(|c: char| c.is_whitespace() || c == '/' || is_dash(c));
        let mut finding = self.finding(alarm, from, end, msg!("nc.bare-comment", text = shortened(bare.trim())));
        let marked = text.len() > bare.len() && !text.starts_with(char::is_whitespace);
        // A statement or a word that became a comment would no longer act.
        if !marked && (states(bare.as_bytes(), &KEYWORDS) || holds_word(bare.as_bytes())) {
            finding.kind = DiagnosticKind::GuessedFix;
        }
        if let Some((title, number)) = program_in(text).filter(|_| from == 0 && self.only_comments()) {
            let letter = self.program_letter();
            let edit = format!("{letter}{number}{}", comment(title).unwrap_or_default());
            finding = finding.hint(msg!("nc.hint.program-letter", letter = letter.as_str())).fix(
                msg!("nc.fix.program-number", program = format!("{letter}{number}")),
                vec![(self.place(self.span(0, end)), edit)],
            );
        }
        // A `;` in front was meant to start the comment.
        let before = self.file.text.get(..start + cut).unwrap_or("").trim_end_matches([' ', '\t']);
        let semicolon = self.notes.semicolon.filter(|&at| cut == 0 && before.len() == at as usize + 1);
        let mut place = self.place(self.span(cut, end));
        let mut cut = cut;
        if let Some(at) = semicolon {
            self.notes.semicolon = None;
            let head = before.strip_suffix(';').unwrap_or(before).trim_end_matches([' ', '\t']).len();
            place.span.start = head as u32;
            cut = usize::from(!self.file.text.get(..at as usize).unwrap_or("").ends_with('\n'));
        }
        finding = match comment(bare) {
            Some(comment) => {
                let gap = if cut > 0 { " " } else { "" };
                finding.fix(msg!("nc.fix.comment"), vec![(place, format!("{gap}{comment}"))])
            }
            None => finding.fix(msg!("nc.fix.drop", text = shortened(text.trim())), vec![(place, String::new())]),
        };
        self.report_as(alarm, finding);
    }

    /// A comment with brackets in it, which ends too early: its opening byte, the brackets inside, and its intended closing byte.
    fn nested_comment(&self) -> Option<(usize, Vec<usize>, usize)> {
        let mut from = 0;
        loop {
            let open = from + self.cursor.line.get(from..)?.iter().position(|&b| b == b'(')?;
            let mut depth = 0_u32;
            let mut inner = Vec::new();
            for (at, &byte) in self.cursor.line.iter().enumerate().skip(open + 1) {
                match byte {
                    b'(' => {
                        depth += 1;
                        inner.push(at);
                    }
                    b')' if depth == 0 => {
                        if !inner.is_empty() && !self.arithmetic(open) {
                            return Some((open, inner, at));
                        }
                        break;
                    }
                    b')' => {
                        depth -= 1;
                        inner.push(at);
                    }
                    _ => {}
                }
            }
            from = open + 1 + self.cursor.line.get(open + 1..)?.iter().position(|&b| b == b')')?;
        }
    }

    fn report_nested(&mut self, alarm: Alarm, open: usize, inner: &[usize], close: usize) {
        let edit = |&at: &usize| {
            let bracket = if self.cursor.line.get(at) == Some(&b'(') { "[" } else { "]" };
            (self.place(self.span(at, at + 1)), bracket.to_owned())
        };
        let edits = inner.iter().map(edit).collect();
        let finding = self.finding(alarm, open, close + 1, msg!("nc.nested-comment"));
        self.report_as(alarm, finding.fix(msg!("nc.fix.nested-comment"), edits));
    }

    /// Reports a `)` without its `(`, with its fix, and reads on after it. Fails if it ends a comment with brackets in it.
    pub(in crate::nc::parse) fn stray_round(&mut self) -> Read<()> {
        let close = self.cursor.at;
        let short = self.cursor.line.len() <= LOOKED_AT;
        if short && self.nested_comment().is_some_and(|(_, _, end)| end == close) {
            return Err(self.failure(Alarm::CommentBracket, close, close + 1, msg!("nc.unopened-round")));
        }
        self.cursor.at += 1;
        self.report_replaced(Alarm::CommentBracket, close, close + 1, msg!("nc.unopened-round"), "");
        Ok(())
    }

    /// Whether the round bracket at the cursor contains arithmetic and no prose.
    pub(in crate::nc::parse) fn arithmetic_ahead(&self) -> bool {
        self.arithmetic(self.cursor.at)
    }

    fn arithmetic(&self, open: usize) -> bool {
        let inner = self.cursor.line.get(open + 1..).unwrap_or_default();
        let len = inner.iter().position(|&b| b == b')').unwrap_or(inner.len());
        arithmetic(inner.get(..len).unwrap_or_default(), self.control.syntax.functions)
    }
}

fn is_dash(c: char) -> bool {
    matches!(c, '-' | '\u{2010}'..='\u{2015}' | '\u{2500}')
}

/// Bytes of the run of dashes at `at`; 0 for none.
fn dashes(line: &[u8], at: usize) -> usize {
    let rest = line.get(at..).unwrap_or_default();
    let ascii = rest.iter().take_while(|b| **b == b'-').count();
    let wide =
        rest.chunks_exact(3).take_while(|c| core::str::from_utf8(c).is_ok_and(|s| s.chars().all(is_dash))).count();
    if wide > 0 && ascii == 0 { wide * 3 } else { ascii }
}

/// Whether a run of dashes starts a comment: no formula has two signs in a row before a letter.
fn starts_comment(line: &[u8], at: usize, run: usize) -> bool {
    let wide = line.get(at).is_some_and(|b| !b.is_ascii());
    let mut after = line.get(at + run..).unwrap_or_default().iter().skip_while(|b| **b == b' ');
    let letter = after.next().is_none_or(|b| b.is_ascii_alphabetic() || !b.is_ascii());
    // A wide dash directly in front of a value is a minus sign.
    let value = line.get(at + run).is_some_and(|b| b.is_ascii_digit() || matches!(b, b'.' | b'#' | b'['));
    let sign = value && at.checked_sub(1).and_then(|at| line.get(at)).is_some_and(|b| !b.is_ascii_whitespace());
    run > 0 && (wide && !sign || run >= 2 && letter)
}

/// Whether a text is in a script without look-alikes of addresses (Chinese, Japanese, Korean), or an ellipsis, so that it contains no words
/// of the control.
fn other_script(rest: &[u8]) -> bool {
    let text = core::str::from_utf8(rest).unwrap_or_default();
    let begins = text.chars().next().is_some_and(|c| matches!(c, '\u{3040}'..='\u{d7a3}' | '\u{2026}'));
    begins && !text.contains(|c: char| c.is_ascii_alphanumeric())
}

/// Start of a variable alone in front of a comment, after at most a sequence number.
fn variable_alone(head: &[u8]) -> Option<usize> {
    let at = head.iter().position(|&b| b == b'#')?;
    let (number, variable) = head.split_at_checked(at)?;
    let number = number.strip_prefix(b"N").or(number.strip_prefix(b"n")).unwrap_or(number).trim_ascii();
    let digits = |text: &[u8]| text.iter().all(u8::is_ascii_digit);
    (digits(number) && digits(variable.get(1..)?)).then_some(at)
}

/// Title and number in `Title: P9100`.
fn program_in(text: &str) -> Option<(&str, u32)> {
    let (title, word) = text.trim_end().rsplit_once(' ')?;
    let number = word.strip_prefix(['P', 'p'])?.parse().ok()?;
    (number > 0).then_some((title.trim_end().trim_end_matches(':'), number))
}

/// A comment in the control's form: capitals, one pair of round brackets; `None` if nothing is left.
fn comment(text: &str) -> Option<String> {
    let mut out = String::from("(");
    let mut depth = 0_u32;
    for c in text.chars() {
        match c {
            '(' => {
                depth += 1;
                out.push('[');
            }
            ')' if depth > 0 => {
                depth -= 1;
                out.push(']');
            }
            ')' => {}
            c if is_dash(c) => out.push('-'),
            c if c.is_ascii_graphic() || c == ' ' => out.push(c.to_ascii_uppercase()),
            _ => {}
        }
    }
    if out.trim_end().len() == 1 {
        // The control can show none of it; the text is kept all the same.
        let kept = text.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '\u{2026}'));
        out.extend(kept.map(|c| if c == '\u{2026}' { '.' } else { c }));
    }
    let text = out.trim_end().to_owned();
    (text.len() > 1).then_some(text + ")")
}
