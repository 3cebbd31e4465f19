//! [`Reader`]: the state of the parser.

use core::cell::Cell;
use std::collections::BTreeSet;

use super::failure::{IgnoredFeature, LineFix, Misused, ParseFailure};
use super::tables::Tables;
use crate::controls::syntax::{Names, RoundBrackets};
use crate::controls::{Alarm, Control};
use crate::msg;
use crate::nc::ast::{BadBlock, Deck, Extent, Op, TextId};
use crate::nc::lex::cursor::Cursor;
use crate::nc::parsed::{FINDINGS, PartPlaces};
use crate::text::lines::line_end;
use crate::text::{Diagnostic, DiagnosticKind, FileId, Message, Place, Severity, Span};

/// Maximum blocks read: five times those of the largest programs.
pub(super) const BLOCKS: usize = 5_000_000;

/// Maximum bytes of a block: a word's offset has 16 bits, and no control allows a tenth of that.
pub(super) const BLOCK_BYTES: usize = 60_000;

/// Lengths of the arenas before an attempt to read a block.
pub(super) struct Mark {
    pub(super) words: usize,
    pub(super) exprs: usize,
    pub(super) assignments: usize,
    pub(super) jumps: usize,
    pub(super) texts: usize,
    pub(super) found: usize,
    pub(super) variables: usize,
    pub(super) small: Option<u32>,
}

/// Findings of one attempt to read a line.
pub(super) struct BlockFindings {
    list: Vec<Diagnostic>,
    misused: Vec<Misused>,
    small: Option<u32>,
}

/// The file being read.
#[derive(Debug, Clone, Copy)]
pub(super) struct SourceFile<'a> {
    pub(super) id: FileId,
    pub(super) name: &'a str,
    pub(super) text: &'a str,
}

/// Findings so far, and records for checks at the end.
#[derive(Debug, Default)]
pub(super) struct ReaderFindings {
    pub(super) list: Vec<Diagnostic>,
    /// Features reported as not simulated.
    pub(super) ignored: Vec<IgnoredFeature>,
    /// Variables missing or read-only on the control, reported at the end of the file.
    pub(super) misused: Vec<Misused>,
    /// Blocks with calls and jumps in words, checked once all files are read.
    pub(super) deferred_checks: Vec<u32>,
}

/// Peculiarities of the file's spelling, each by its first place in the file.
#[derive(Debug, Default)]
pub(super) struct FileNotes {
    /// Small letter outside comments.
    pub(super) small: Option<u32>,
    /// Letters l typed for the digit 1.
    pub(super) ones: BTreeSet<u32>,
    /// `;` that ends a block.
    pub(super) semicolon: Option<u32>,
    /// Character in a comment that is missing on the control.
    pub(super) foreign: Option<Span>,
    /// `#` outside comments, on a control with a letter for variables.
    pub(super) hash: Option<u32>,
    /// The preceding line names a program; the next one may name its directory.
    pub(super) headed: bool,
    /// Names of variables that the file defines by `DEF`.
    pub(super) locals: Vec<String>,
}

/// Parts of the block read so far, besides its statement.
#[derive(Debug, Default)]
pub(super) struct BlockParts {
    pub(super) number: Option<u32>,
    pub(super) number_at: Extent,
    pub(super) skip_switch: u8,
    /// The block number is written after `:`.
    pub(super) main: bool,
    pub(super) comment: Option<TextId>,
    pub(super) label: Option<TextId>,
    /// Index of the first word of the block in the deck.
    pub(super) first_word: usize,
    /// The first alarm of the block.
    pub(super) bad: Option<BadBlock>,
}

/// State of the formulas of a block.
#[derive(Debug)]
pub(super) struct Formulas {
    /// Nesting depth of brackets, signs, NOT and functions without brackets, for the parser's own budget.
    pub(super) depth: u32,
    /// Number of open brackets around formulas, which the control limits.
    pub(super) brackets: u32,
    /// Number of expressions of the block so far.
    pub(super) parts: u32,
    /// Alarm for a mistake in the condition being read.
    pub(super) sentence: Alarm,
    /// The last comparison of the block: first byte, one past its last byte, operator.
    pub(super) compared: (usize, usize, Op),
    /// Round brackets with arithmetic in them group.
    pub(super) rounds: bool,
    /// Places of round brackets with arithmetic.
    pub(super) round_brackets: Vec<(usize, usize)>,
    /// Cache: the writable range of the last variable.
    pub(super) plain: core::ops::Range<u32>,
}

/// Unused sequence numbers for fixes.
#[derive(Debug, Default)]
pub(super) struct FreshNumbers {
    /// All numbers of the file in rising order, collected for the first fix that needs them.
    pub(super) known: Vec<u32>,
    /// Number of candidates, in the order of [`fresh_numbers`](crate::nc::ast::fresh_numbers), that are used or known.
    pub(super) tried: usize,
}

/// Whether a byte starts a value: a number, a sign, a variable or a square bracket.
pub(super) fn starts_value(byte: u8) -> bool {
    byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+' | b'#' | b'[')
}

/// The parser: tables, results and position.
pub(super) struct Reader<'a> {
    pub(super) control: &'static Control,
    pub(super) tables: &'a Tables<'a>,
    pub(super) file: SourceFile<'a>,
    pub(super) deck: Deck,
    /// Places of the parts of the deck.
    pub(super) places: PartPlaces,
    /// Cache: blocks of the present program before this index are comments.
    pub(super) comments: Cell<u32>,
    /// Index of the present program.
    pub(super) program: Option<usize>,
    pub(super) findings: ReaderFindings,
    pub(super) notes: FileNotes,
    pub(super) cursor: Cursor<'a>,
    pub(super) block: BlockParts,
    pub(super) formulas: Formulas,
    pub(super) fresh: FreshNumbers,
}

impl<'a> Reader<'a> {
    /// Rules for names, in a language with names.
    #[inline]
    pub(super) fn names(&self) -> Option<&'static Names> {
        self.control.syntax.names()
    }

    pub(super) fn new(
        control: &'static Control,
        tables: &'a Tables<'a>,
        id: FileId,
        text: &'a str,
        deck: Deck,
    ) -> Reader<'a> {
        Reader {
            control,
            tables,
            file: SourceFile { id, name: "", text },
            deck,
            places: PartPlaces::default(),
            comments: Cell::new(0),
            program: None,
            findings: ReaderFindings::default(),
            notes: FileNotes::default(),
            cursor: Cursor { line: &[], base: 0, at: 0 },
            block: BlockParts::default(),
            formulas: Formulas {
                depth: 0,
                brackets: 0,
                parts: 0,
                sentence: Alarm::Format,
                compared: (0, 0, Op::Equal),
                rounds: control.syntax.round == RoundBrackets::Group,
                round_brackets: Vec::new(),
                plain: 0..0,
            },
            fresh: FreshNumbers::default(),
        }
    }

    /// Whether a finding is still listed: a search of the file for the fix of another one would be in vain.
    pub(super) fn lists_findings(&self) -> bool {
        self.findings.list.len() <= FINDINGS
    }

    /// Trims blanks, tabs and carriage returns at both ends.
    pub(super) fn trimmed(&self, from: usize, to: usize) -> (usize, usize) {
        let bytes = self.file.text.as_bytes();
        let blank = |b: &u8| matches!(b, b' ' | b'\t' | b'\r');
        let line = bytes.get(from..to).unwrap_or_default();
        let lead = line.iter().take_while(|b| blank(b)).count();
        let trail = line.iter().rev().take_while(|b| blank(b)).count();
        (from + lead, (to - trail).max(from + lead))
    }

    /// A word, with spaces around it if the text has none.
    pub(super) fn spaced(&self, from: usize, to: usize, word: &str) -> String {
        let blank =
            |at: Option<usize>| at.and_then(|at| self.cursor.line.get(at)).is_some_and(|b| matches!(b, b' ' | b'\t'));
        let gap = |blank: bool| if blank { "" } else { " " };
        format!("{}{word}{}", gap(blank(from.checked_sub(1))), gap(blank(Some(to))))
    }

    /// The line end of the file.
    pub(super) fn newline(&self) -> &'static str {
        line_end(self.file.text)
    }

    /// The optional block skip of the block, as written.
    pub(super) fn skip_mark(&self) -> String {
        match self.block.skip_switch {
            0 => String::new(),
            1 => "/".to_owned(),
            switch => format!("/{switch}"),
        }
    }

    pub(super) fn take_line(&mut self, line: &'a [u8], from: usize) {
        self.cursor.line = line;
        self.cursor.base = from as u32;
        self.rewind();
    }

    /// Returns to the start of the line.
    pub(super) fn rewind(&mut self) {
        self.cursor.at = 0;
        self.block = BlockParts::default();
        self.formulas.depth = 0;
        self.formulas.brackets = 0;
        self.formulas.parts = 0;
        self.formulas.sentence = Alarm::Format;
    }

    pub(super) fn mark(&self) -> Mark {
        Mark {
            words: self.deck.words.len(),
            exprs: self.deck.exprs.len(),
            assignments: self.deck.assignments.len(),
            jumps: self.deck.jumps.len(),
            texts: self.deck.texts.len(),
            found: self.findings.list.len(),
            variables: self.findings.misused.len(),
            small: self.notes.small,
        }
    }

    /// Drops everything since the mark, to read the line again.
    pub(super) fn rollback(&mut self, mark: &Mark) {
        self.deck.words.truncate(mark.words);
        self.deck.exprs.truncate(mark.exprs);
        self.places.exprs.truncate(mark.exprs);
        self.deck.assignments.truncate(mark.assignments);
        self.deck.jumps.truncate(mark.jumps);
        self.deck.texts.truncate(mark.texts);
        self.places.texts.truncate(mark.texts);
        self.findings.list.truncate(mark.found);
        self.findings.misused.truncate(mark.variables);
        self.notes.small = mark.small;
        self.formulas.round_brackets.clear();
        self.rewind();
    }

    /// Drops everything since the mark and returns its findings.
    pub(super) fn take_back(&mut self, mark: &Mark) -> BlockFindings {
        let ReaderFindings { list, misused, .. } = &mut self.findings;
        let findings = BlockFindings {
            list: list.split_off(mark.found.min(list.len())),
            misused: misused.split_off(mark.variables.min(misused.len())),
            small: self.notes.small,
        };
        self.rollback(mark);
        findings
    }

    /// Restores the findings of an attempt to read the line.
    pub(super) fn put_back(&mut self, findings: BlockFindings) {
        self.findings.list.extend(findings.list);
        self.findings.misused.extend(findings.misused);
        self.notes.small = findings.small;
    }

    /// Bytes of the line as a span of the file.
    pub(super) fn span(&self, from: usize, to: usize) -> Span {
        Span::new(self.cursor.base + from.min(to) as u32, self.cursor.base + to as u32)
    }

    /// Bytes of the line as a part of the block.
    pub(super) fn extent(&self, from: usize, to: usize) -> Extent {
        let bytes = |count: usize| u16::try_from(count).unwrap_or(u16::MAX);
        Extent { offset: bytes(from), len: bytes(to.saturating_sub(from)) }
    }

    /// End of the text read so far, without trailing blanks.
    pub(super) fn ended_at(&self) -> usize {
        self.cursor.line.get(..self.cursor.at).unwrap_or_default().trim_ascii_end().len()
    }

    /// Adds a text to the deck, with its place in the file.
    pub(super) fn add_text(&mut self, text: impl Into<Box<str>>, span: Span) -> TextId {
        self.places.texts.push(span);
        self.deck.add_text(text)
    }

    pub(super) fn place(&self, span: Span) -> Place {
        Place { file: self.file.id, span }
    }

    /// An alarm of the control for some bytes of the line.
    pub(super) fn finding(&self, alarm: Alarm, from: usize, to: usize, message: Message) -> Diagnostic {
        Diagnostic::error(message).at(self.place(self.span(from, to))).alarm(self.control.alarm_shown(alarm))
    }

    /// The failure for some bytes of the line.
    pub(super) fn failure(&self, alarm: Alarm, from: usize, to: usize, message: Message) -> Box<ParseFailure> {
        Box::new(ParseFailure { alarm, from, finding: self.finding(alarm, from, to, message), at_word: false })
    }

    /// The failure of something that the control reads and the simulation does not: a warning, and a run stops at the block.
    #[cold]
    pub(super) fn stops_here(&self, from: usize, to: usize, message: Message) -> Box<ParseFailure> {
        let mut failure = self.failure(Alarm::NotSimulated, from, to, message);
        (failure.finding.severity, failure.finding.alarm, failure.finding.wording) = (Severity::Warning, None, None);
        failure
    }

    /// The failure of an unexpected byte.
    pub(super) fn unexpected(&self) -> Box<ParseFailure> {
        let start = self.cursor.at;
        if self.cursor.ended() {
            let before = self.cursor.line.get(..start).unwrap_or_default();
            let last = before.iter().rposition(|b| b & 0xC0 != 0x80).unwrap_or(0);
            let mut failure = self.failure(Alarm::Format, last, start, msg!("nc.ends-early"));
            failure.finding.kind = DiagnosticKind::EndsEarly;
            return failure;
        }
        let from = self.cursor.base as usize + start;
        let character = self.file.text.get(from..).and_then(|rest| rest.chars().next()).unwrap_or('\u{fffd}');
        let end = (start + character.len_utf8()).min(self.cursor.line.len());
        let shown = if character.is_control() { character.escape_default().to_string() } else { character.to_string() };
        // In a language with names quotation marks enclose texts.
        let quotes = character == '"' && self.names().is_some();
        let known = character.is_ascii_alphanumeric() || quotes || "+-*/.,#[]()=%;:".contains(character);
        if known {
            let message = match character {
                '0'..='9' => msg!("nc.number-without-address"),
                _ => msg!("nc.unexpected", text = shown),
            };
            let mut failure = self.failure(Alarm::Format, start, end, message);
            failure.at_word = !character.is_ascii_digit();
            failure
        } else {
            let message = match character {
                '\0' => msg!("nc.nul"),
                _ => msg!("nc.illegal-character", character = shown),
            };
            let mut failure = self.failure(Alarm::IllegalAddress, start, end, message);
            failure.at_word = character != '\0';
            failure.finding = if character == '\0' {
                let line = self.cursor.line.len();
                let text =
                    self.file.text.get(self.cursor.base as usize..self.cursor.base as usize + line).unwrap_or("");
                let edit = (self.place(self.span(0, line)), text.replace('\0', ""));
                failure.finding.fix(msg!("nc.fix.drop-nul"), vec![edit])
            } else {
                self.with_fix(failure.finding, LineFix::Plain(character))
            };
            failure
        }
    }

    /// Defers a check of the block until all files are read.
    pub(super) fn defer_check(&mut self) {
        if self.findings.deferred_checks.len() < FINDINGS {
            self.findings.deferred_checks.push(self.deck.blocks.len() as u32);
        }
    }

    pub(super) fn add_finding(&mut self, diagnostic: Diagnostic) {
        if self.findings.list.len() <= FINDINGS {
            self.findings.list.push(diagnostic);
        }
    }

    /// Reports an alarm and reads on; executing the block raises the alarm.
    pub(super) fn report(&mut self, alarm: Alarm, from: usize, to: usize, message: Message) {
        let finding = self.finding(alarm, from, to, message);
        self.report_as(alarm, finding);
    }

    pub(super) fn report_as(&mut self, alarm: Alarm, finding: Diagnostic) {
        let span = finding.place.map_or_else(Span::default, |place| place.span);
        self.add_finding(finding);
        self.block.bad.get_or_insert(BadBlock { alarm, finding: span });
    }

    /// Adds a warning for some bytes of the file.
    pub(super) fn warn(&mut self, from: usize, to: usize, message: Message) {
        let place = self.place(Span::new(from as u32, to as u32));
        self.add_finding(Diagnostic::warning(message).at(place));
    }
}
