//! [`Reader`]: the state of the parser.

use core::cell::Cell;

use super::failure::{IgnoredFeature, Misused};
use super::tables::Tables;
use crate::controls::syntax::{Names, RoundBrackets};
use crate::controls::{Alarm, Control};
use crate::nc::ast::{BadBlock, Deck, Extent, Op, TextId};
use crate::nc::lex::cursor::Cursor;
use crate::nc::parsed::PartPlaces;
use crate::text::{Diagnostic, FileId, Message, Place, Span};

/// Maximum findings in the list; a file of garbage has millions.
pub(in crate::nc) const FINDINGS: usize = 1000;

/// Maximum blocks read: five times those of the largest programs.
pub(in crate::nc) const BLOCKS: usize = 5_000_000;

/// Maximum bytes of a block: a word's offset has 16 bits, and no control allows a tenth of that.
pub(in crate::nc) const BLOCK_BYTES: usize = 60_000;

/// Byte order mark that some editors write at the start of UTF-8 text.
pub(in crate::nc) const BYTE_ORDER_MARK: char = '\u{feff}';

/// Lengths of the arenas before an attempt to read a block.
pub(in crate::nc) struct Mark {
    pub(in crate::nc) words: usize,
    pub(in crate::nc) exprs: usize,
    pub(in crate::nc) pairs: usize,
    pub(in crate::nc) texts: usize,
    pub(in crate::nc) found: usize,
    pub(in crate::nc) variables: usize,
    pub(in crate::nc) small: Option<u32>,
}

/// Findings of one attempt to read a line.
pub(in crate::nc) struct BlockFindings {
    list: Vec<Diagnostic>,
    misused: Vec<Misused>,
    small: Option<u32>,
}

/// The file being read.
#[derive(Debug, Clone, Copy)]
pub(in crate::nc) struct SourceFile<'a> {
    pub(in crate::nc) id: FileId,
    pub(in crate::nc) name: &'a str,
    pub(in crate::nc) text: &'a str,
}

/// Findings so far, and records for checks at the end.
#[derive(Debug, Default)]
pub(in crate::nc) struct ReaderFindings {
    pub(in crate::nc) list: Vec<Diagnostic>,
    /// Features reported as not simulated.
    pub(in crate::nc) ignored: Vec<IgnoredFeature>,
    /// Variables missing or read-only on the control, reported at the end of the file.
    pub(in crate::nc) misused: Vec<Misused>,
    /// Blocks with calls and jumps in words, checked after all files are read.
    pub(in crate::nc) later: Vec<u32>,
}

/// Peculiarities of the file's spelling, each by its first place in the file.
#[derive(Debug, Default)]
pub(in crate::nc) struct FileNotes {
    /// Small letter outside comments.
    pub(in crate::nc) small: Option<u32>,
    /// `;` that ends a block.
    pub(in crate::nc) semicolon: Option<u32>,
    /// Character in a comment that is missing on the control.
    pub(in crate::nc) foreign: Option<Span>,
    /// `#` outside comments, on a control with a letter for variables.
    pub(in crate::nc) hash: Option<u32>,
    /// The preceding line names a program; the next one may name its directory.
    pub(in crate::nc) headed: bool,
}

/// Parts of the block read so far, besides its statement.
#[derive(Debug, Default)]
pub(in crate::nc) struct BlockParts {
    pub(in crate::nc) number: Option<u32>,
    pub(in crate::nc) number_at: Extent,
    pub(in crate::nc) skip_switch: u8,
    /// The block number is written after `:`.
    pub(in crate::nc) main: bool,
    pub(in crate::nc) comment: Option<TextId>,
    pub(in crate::nc) label: Option<TextId>,
    /// The first alarm of the block.
    pub(in crate::nc) bad: Option<BadBlock>,
}

/// State of the formulas of a block.
#[derive(Debug)]
pub(in crate::nc) struct Formulas {
    /// Number of open square brackets.
    pub(in crate::nc) depth: u32,
    /// Number of expressions of the block so far.
    pub(in crate::nc) parts: u32,
    /// Alarm for a mistake in the condition being read.
    pub(in crate::nc) sentence: Alarm,
    /// The last comparison of the block: first byte, one past its last byte, operator.
    pub(in crate::nc) compared: (usize, usize, Op),
    /// Round brackets with arithmetic in them group.
    pub(in crate::nc) rounds: bool,
    /// Places of round brackets with arithmetic.
    pub(in crate::nc) round_brackets: Vec<(usize, usize)>,
    /// Cache: the writable range of the last variable.
    pub(in crate::nc) plain: core::ops::Range<u32>,
}

/// Unused sequence numbers for fixes.
#[derive(Debug, Default)]
pub(in crate::nc) struct FreshNumbers {
    /// All numbers of the file in rising order, collected for the first fix that needs them.
    pub(in crate::nc) known: Vec<u32>,
    /// Number of candidates, in the order of [`fresh_numbers`](crate::nc::ast::fresh_numbers), that are used or known.
    pub(in crate::nc) tried: usize,
}

/// The parser: tables, results and position.
pub(in crate::nc) struct Reader<'a> {
    pub(in crate::nc) control: &'static Control,
    pub(in crate::nc) tables: &'a Tables<'a>,
    pub(in crate::nc) file: SourceFile<'a>,
    pub(in crate::nc) deck: Deck,
    /// Places of the parts of the deck.
    pub(in crate::nc) places: PartPlaces,
    /// Cache: blocks of the present program before this index are comments.
    pub(in crate::nc) comments: Cell<u32>,
    /// Index of the present program.
    pub(in crate::nc) program: Option<usize>,
    pub(in crate::nc) findings: ReaderFindings,
    pub(in crate::nc) notes: FileNotes,
    pub(in crate::nc) cursor: Cursor<'a>,
    pub(in crate::nc) block: BlockParts,
    pub(in crate::nc) formulas: Formulas,
    pub(in crate::nc) fresh: FreshNumbers,
}

impl<'a> Reader<'a> {
    /// Rules for names, in a language with names.
    #[inline]
    pub(in crate::nc) fn names(&self) -> Option<&'static Names> {
        self.control.syntax.names()
    }

    pub(in crate::nc) fn new(
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

    /// Trims white space at both ends, and a `;`.
    pub(in crate::nc) fn trimmed(&self, from: usize, to: usize) -> (usize, usize) {
        let bytes = self.file.text.as_bytes();
        let blank = |b: &u8| matches!(b, b' ' | b'\t' | b'\r');
        let line = bytes.get(from..to).unwrap_or_default();
        let lead = line.iter().take_while(|b| blank(b)).count();
        let trail = line.iter().rev().take_while(|b| blank(b)).count();
        (from + lead, (to - trail).max(from + lead))
    }

    pub(in crate::nc) fn take_line(&mut self, line: &'a [u8], from: usize) {
        self.cursor.line = line;
        self.cursor.base = from as u32;
        self.rewind();
    }

    /// Returns to the start of the line.
    pub(in crate::nc) fn rewind(&mut self) {
        self.cursor.at = 0;
        self.block = BlockParts::default();
        self.formulas.depth = 0;
        self.formulas.parts = 0;
        self.formulas.sentence = Alarm::Format;
    }

    pub(in crate::nc) fn mark(&self) -> Mark {
        Mark {
            words: self.deck.words.len(),
            exprs: self.deck.exprs.len(),
            pairs: self.deck.pairs.len(),
            texts: self.deck.texts.len(),
            found: self.findings.list.len(),
            variables: self.findings.misused.len(),
            small: self.notes.small,
        }
    }

    /// Drops everything since the mark, to read the line again.
    pub(in crate::nc) fn rollback(&mut self, mark: &Mark) {
        self.deck.words.truncate(mark.words);
        self.deck.exprs.truncate(mark.exprs);
        self.places.exprs.truncate(mark.exprs);
        self.deck.pairs.truncate(mark.pairs);
        self.deck.texts.truncate(mark.texts);
        self.places.texts.truncate(mark.texts);
        self.findings.list.truncate(mark.found);
        self.findings.misused.truncate(mark.variables);
        self.notes.small = mark.small;
        self.formulas.round_brackets.clear();
        self.rewind();
    }

    /// Drops everything since the mark and returns its findings.
    pub(in crate::nc) fn take_back(&mut self, mark: &Mark) -> BlockFindings {
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
    pub(in crate::nc) fn put_back(&mut self, findings: BlockFindings) {
        self.findings.list.extend(findings.list);
        self.findings.misused.extend(findings.misused);
        self.notes.small = findings.small;
    }

    /// Bytes of the line as a span of the file.
    pub(in crate::nc) fn span(&self, from: usize, to: usize) -> Span {
        Span::new(self.cursor.base + from.min(to) as u32, self.cursor.base + to as u32)
    }

    /// Bytes of the line as a part of the block.
    pub(in crate::nc) fn extent(&self, from: usize, to: usize) -> Extent {
        let bytes = |count: usize| u16::try_from(count).unwrap_or(u16::MAX);
        Extent { offset: bytes(from), len: bytes(to.saturating_sub(from)) }
    }

    /// Adds a text to the deck, with its place in the file.
    pub(in crate::nc) fn add_text(&mut self, text: impl Into<Box<str>>, span: Span) -> TextId {
        self.places.texts.push(span);
        self.deck.add_text(text)
    }

    pub(in crate::nc) fn place(&self, span: Span) -> Place {
        Place { file: self.file.id, span }
    }

    /// An alarm of the control for some bytes of the line.
    pub(in crate::nc) fn finding(&self, alarm: Alarm, from: usize, to: usize, message: Message) -> Diagnostic {
        Diagnostic::error(message).at(self.place(self.span(from, to))).alarm(self.control.alarm_shown(alarm))
    }

    /// Marks the block for a check after all files are read.
    pub(in crate::nc) fn note_later(&mut self) {
        if self.findings.later.len() < FINDINGS {
            self.findings.later.push(self.deck.blocks.len() as u32);
        }
    }

    pub(in crate::nc) fn add_finding(&mut self, diagnostic: Diagnostic) {
        if self.findings.list.len() <= FINDINGS {
            self.findings.list.push(diagnostic);
        }
    }

    /// Reports an alarm and reads on; executing the block raises the alarm.
    pub(in crate::nc) fn report(&mut self, alarm: Alarm, from: usize, to: usize, message: Message) {
        let finding = self.finding(alarm, from, to, message);
        self.report_as(alarm, finding);
    }

    pub(in crate::nc) fn report_as(&mut self, alarm: Alarm, finding: Diagnostic) {
        let span = finding.place.map_or_else(Span::default, |place| place.span);
        self.add_finding(finding);
        self.block.bad.get_or_insert(BadBlock { alarm, finding: span });
    }

    /// Adds a warning for some bytes of the file.
    pub(in crate::nc) fn warn(&mut self, from: usize, to: usize, message: Message) {
        let place = self.place(Span::new(from as u32, to as u32));
        self.add_finding(Diagnostic::warning(message).at(place));
    }
}
