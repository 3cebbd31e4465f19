//! Text to tree, as the control would read it: one pass over the bytes, never an `Err`, never a panic.
//!
//! ```text
//! file   := [lead] '%' EOB { program } '%'        lead and what stands behind a '%' up to its EOB is skipped
//! program:= [ O uint [comment] ] { block EOB }    several programs may stand in one file
//! block  := [ '/' [digit] ] [ N uint ] ( macro | words )
//! macro  := var '=' expr
//!         | IF '[' cond ']' GOTO expr | IF '[' cond ']' THEN var '=' expr | GOTO expr
//!         | WHILE '[' cond ']' DO uint | DO uint | END uint
//! words  := { letter ( number | expr ) | '/' }    X#1+10 and X[#1+10] are the same; '/' before a letter skips the rest
//! var    := '#' ( uint | var | '[' expr ']' )
//! expr   := term { ( '+' | '-' | OR | XOR ) term }
//! term   := factor { ( '*' | '/' | AND | MOD ) factor }
//! factor := number | var | ( '+' | '-' ) factor | FUNCTION '[' expr ']' | '[' expr ']' | ATAN '[' expr ']' '/' '[' expr ']'
//! cond   := expr ( EQ | NE | GT | GE | LT | LE ) expr
//! ```
//!
//! Which of it a control has, and what it has besides (`==`, `SIN30`, `#9100`), its rows say. Where programs, labels and codes have
//! names, blocks are those of `named`.
//!
//! Spaces mean nothing; `( … )` up to the first `)` is a comment and may stand anywhere; EOB is a line end or `;`. Small letters
//! are read as capitals. A block that does not read becomes [`Stmt::Bad`] and is reported once, at the place of the mistake, with
//! the control's alarm number. Where the mistake has a known shape, a fix comes with it (`slips`, `recover`, `mend`).

mod calls;
mod check;
mod check_names;
mod expr_span;
mod expression;
mod file_fixes;
mod foreign_syntax;
mod formula;
mod named;
mod named_words;
mod program_header;
mod quick_fixes;
mod recover;
mod statement;
mod words;

pub(super) use check_names::on_way;
pub(super) use program_header::number_in;

pub use expr_span::part_span;
pub use expression::{Formula, formula};

use std::rc::Rc;

use super::ast::{Block, Deck, Op, Program, Stmt, TextId};
use super::codes::Codes;
use super::files::Files;
use super::parsed::Parsed;
use crate::controls::dialect::ReadingRules;
use crate::controls::syntax::{Names, Percent, RoundBrackets, letter_bits};
use crate::controls::{Alarm, CodeId, Control, Dialect, Switches};
use crate::msg;
use crate::text::{Diagnostic, FileId, Message, Place, Span};

/// Findings that are listed; a file of garbage has millions.
const FINDINGS: usize = 1000;

/// Blocks that are read: five times what the largest programs have.
const BLOCKS: usize = 5_000_000;

/// Bytes of a block: a word's offset has 16 bits, and no control takes a tenth of that.
const BLOCK_BYTES: usize = 60_000;

/// What some editors write before a text in UTF-8.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Reads files as a control would whose open points are at their defaults. Total: any text gives a value.
pub fn parse(files: &Files, control: &'static Control) -> Parsed {
    parse_with(files, control, &Switches::default())
}

/// Reads files as a control would with its open points as they are set. Total: any text gives a value.
pub fn parse_with(files: &Files, control: &'static Control, switches: &Switches) -> Parsed {
    let dialect = Rc::new(Dialect::resolve(control, switches));
    let codes = Codes::new(control, &dialect);
    let tables = Tables::new(control, &dialect, &codes);
    let mut deck = Deck::default();
    let mut found = Vec::new();
    let mut later = Vec::new();
    for (index, file) in files.0.iter().enumerate() {
        let Ok(id) = u16::try_from(index) else {
            found.push(Diagnostic::error(msg!("nc.too-many-files", u32::from(u16::MAX))));
            break;
        };
        if u32::try_from(file.text.len()).is_err() {
            found.push(Diagnostic::error(msg!("nc.file-too-large", file.name.as_str())));
            continue;
        }
        let mut reader = Reader::new(control, &tables, FileId(id), &file.text, deck);
        reader.file_name = &file.name;
        reader.reserve();
        reader.file();
        deck = reader.deck;
        found.append(&mut reader.found);
        later.append(&mut reader.later);
    }
    check::programs(&deck, control, files, &later, &mut found);
    Diagnostic::in_order(&mut found);
    // A block that is read twice says some things twice.
    found.dedup();
    if found.len() > FINDINGS {
        found.truncate(FINDINGS);
        found.push(Diagnostic::info(msg!("nc.more-findings", FINDINGS as u32)));
    }
    deck.shrink();
    Parsed::new(files.clone(), deck, found, control, switches.clone(), dialect, codes)
}

/// What is looked up for every word, in the order of its first byte.
struct Tables<'a> {
    codes: &'a Codes,
    /// Bit `letter & 31`: letters of words outside macro calls.
    letters: u32,
    /// Bit `letter & 31`: letters that may stand only once in a block.
    once: u32,
    /// Bit `letter & 31`: letters whose number must not have a point.
    whole: u32,
    /// Bit `letter & 31`: letters of rotary axes.
    rotary: u32,
    /// Bit `letter & 31`: letters that may put a corner behind a motion.
    corners: u32,
    /// Words of a block.
    most_words: usize,
    /// Characters of a word with a number.
    word_chars: usize,
    /// The settings of the control that the reader acts on.
    rules: ReadingRules,
}

impl<'a> Tables<'a> {
    fn new(control: &Control, dialect: &Dialect, codes: &'a Codes) -> Tables<'a> {
        let mut tables = Tables {
            rules: dialect.reading,
            codes,
            letters: letter_bits(control.syntax.addresses.iter().copied().chain(control.axis_letters())),
            once: if control.syntax.address_twice { !letter_bits(b"GM".iter().copied()) } else { 0 },
            whole: 0,
            rotary: letter_bits(
                control.axes.iter().enumerate().filter(|(at, _)| dialect.is_rotary(*at)).map(|(_, row)| row.letter),
            ),
            corners: letter_bits(control.syntax.corners.iter().map(|corner| corner.0)),
            word_chars: control.syntax.word_chars as usize,
            most_words: (control.syntax.block_words as usize).min(u16::MAX as usize),
        };
        if control.syntax.point_alarm {
            // The point of G54.1 is part of its number.
            tables.whole = letter_bits(control.syntax.integer_addresses.iter().copied().filter(|&b| b != b'G'));
        }
        tables
    }
}

/// A block that does not read, and why.
struct Failure {
    alarm: Alarm,
    /// Where it shows, in bytes behind the start of the block.
    from: usize,
    finding: Diagnostic,
    /// The reader stood at a word: what follows may be a remark without brackets.
    at_word: bool,
}

type Read<T> = Result<T, Box<Failure>>;

/// How far the arenas were filled before a block was tried.
struct Mark {
    words: usize,
    exprs: usize,
    pairs: usize,
    texts: usize,
    found: usize,
    variables: usize,
    small: Option<u32>,
}

/// A feature that the simulation leaves out, reported once a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum LeftOut {
    Code(CodeId),
    /// A cycle by the number in its name.
    Cycle(u32),
    /// A range of variables by its first number.
    Variables(u32),
    /// An external input or output statement, by its index.
    Statement(usize),
    Address(u8),
    /// An address behind a comma.
    Comma(u8),
}

/// A variable that the control does not have, or that cannot be written.
struct Misused {
    number: u32,
    alarm: Alarm,
    span: Span,
}

struct Reader<'a> {
    control: &'static Control,
    tables: &'a Tables<'a>,
    id: FileId,
    /// Name of the file.
    file_name: &'a str,
    source: &'a str,
    deck: Deck,
    found: Vec<Diagnostic>,
    /// Features that were reported as not simulated.
    said: Vec<LeftOut>,
    misused: Vec<Misused>,
    /// Variables that can be read and written, the last such row.
    plain: core::ops::Range<u32>,
    /// First small letter outside comments.
    small: Option<u32>,
    /// First `;` that ends a block.
    semicolon: Option<u32>,
    /// First character in a comment that the control lacks.
    foreign: Option<Span>,
    /// First `#` outside comments, where variables have a letter.
    hash: Option<u32>,
    /// The line before names a program: the next may tell its directory.
    headed: bool,
    /// Index of the program that blocks go to.
    program: Option<usize>,

    // The block that is being read.
    line: &'a [u8],
    base: u32,
    at: usize,
    /// Round brackets with arithmetic in them group, for finding out whether that was meant.
    rounds: bool,
    /// Where such brackets stood.
    round_brackets: Vec<(usize, usize)>,
    number: Option<u32>,
    skip_switch: u8,
    /// Its number stands behind `:`.
    main: bool,
    comment: Option<TextId>,
    label: Option<TextId>,
    bad: Option<Alarm>,
    depth: u32,
    parts: u32,
    /// The alarm of the condition at hand, where one is read.
    sentence: Alarm,
    /// The comparison of the block: where it stands, and what it is.
    compared: (usize, usize, Op),
    /// Blocks with calls and jumps in words, to be looked at when all is read.
    later: Vec<u32>,
    /// Every number of the file in rising order, once a fix asks for one that is free.
    numbers: Vec<u32>,
    /// Sequence numbers that fixes have taken.
    taken: Vec<u32>,
    /// Where the parts of formulas stand in the block, in the order of the tree; kept only where somebody asks.
    places: Option<Vec<Span>>,
}

/// How many bytes are such, in pieces whose numbers fit a byte: many are counted at once.
fn count(bytes: &[u8], such: impl Fn(u8) -> bool) -> usize {
    bytes.chunks(255).map(|piece| usize::from(piece.iter().map(|&b| u8::from(such(b))).sum::<u8>())).sum()
}

impl<'a> Reader<'a> {
    /// What has names, where the language has such.
    #[inline]
    fn names(&self) -> Option<&'static Names> {
        self.control.syntax.names()
    }

    fn new(control: &'static Control, tables: &'a Tables<'a>, id: FileId, source: &'a str, deck: Deck) -> Reader<'a> {
        Reader {
            control,
            tables,
            id,
            file_name: "",
            source,
            deck,
            found: Vec::new(),
            said: Vec::new(),
            misused: Vec::new(),
            plain: 0..0,
            small: None,
            semicolon: None,
            foreign: None,
            hash: None,
            headed: false,
            program: None,
            line: &[],
            base: 0,
            at: 0,
            rounds: control.syntax.round == RoundBrackets::Group,
            round_brackets: Vec::new(),
            number: None,
            skip_switch: 0,
            main: false,
            comment: None,
            label: None,
            bad: None,
            depth: 0,
            parts: 0,
            sentence: Alarm::Format,
            compared: (0, 0, Op::Equal),
            later: Vec::new(),
            numbers: Vec::new(),
            taken: Vec::new(),
            places: None,
        }
    }

    /// Makes room once: growing by doubling would copy, and hold three times what is needed.
    fn reserve(&mut self) {
        let bytes = self.source.as_bytes();
        let lines = count(bytes, |b| b == b'\n') + 1;
        let letters = count(bytes, |b| b.is_ascii_alphabetic());
        self.deck.blocks.reserve(lines.min(bytes.len() / 4).min(BLOCKS));
        self.deck.words.reserve(letters.min(bytes.len() / 4).min(5 * BLOCKS));
    }

    fn file(&mut self) {
        let bytes = self.source.as_bytes();
        // A byte order mark is not part of the program; `mend_file` tells of it.
        let mut at = if self.source.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len_utf8() } else { 0 };
        // Whether a `%` would open the record (nothing but comments so far) or close it.
        let mut opened = false;
        let mut closed = None;
        let mut told = false;
        if let Some(record) = self.leader(at) {
            self.warn(at, record, msg!("nc.leader"));
            at = record;
        }
        while at < bytes.len() {
            let rest = self.source.get(at..).unwrap_or_default();
            let end = at + rest.find('\n').unwrap_or(rest.len());
            let (from, to) = self.trimmed(at, end);
            match bytes.get(from) {
                _ if from == to => {}
                Some(b'%') if self.names().is_some() => self.head(from, to),
                _ if self.names().is_some() => self.named_block(from, to),
                Some(b'%') => {
                    if !self.only_comments() {
                        closed = Some(from);
                        self.program = None;
                    } else {
                        opened = true;
                    }
                    self.behind_percent(from + 1, to);
                }
                _ => {
                    // Only what begins a program is worth reading behind the end of the record.
                    let begins = closed.is_some() && self.begins_program(from);
                    if let Some(percent) = closed.filter(|_| !told) {
                        let said = if begins { msg!("nc.next-record") } else { msg!("nc.behind-end") };
                        self.warn(percent, percent + 1, said);
                        told = true;
                    }
                    if closed.is_none() || begins {
                        (closed, told) = (None, false);
                        self.blocks(from, to);
                    }
                }
            }
            if self.deck.blocks.len() >= BLOCKS {
                let place = self.place(Span::new(from as u32, to as u32));
                self.found.push(Diagnostic::error(msg!("nc.too-many-blocks", BLOCKS as u32)).at(place));
                break;
            }
            at = end + 1;
        }
        self.mend_file(opened, closed.is_some());
    }

    /// Where a line begins with a program number, or with a comment, which may stand in front of one.
    fn begins_program(&self, at: usize) -> bool {
        let line = self.source.as_bytes().get(at..).unwrap_or_default();
        match line {
            [b'(', ..] => true,
            [b'O' | b'o' | b':', digit, ..] => digit.is_ascii_digit(),
            _ => false,
        }
    }

    /// Where the record begins, if something that is neither comment nor program stands in front of its `%`: leader of a tape.
    fn leader(&self, from: usize) -> Option<usize> {
        if self.control.syntax.percent != Percent::Both {
            return None;
        }
        let mut at = from;
        let mut stray = false;
        for line in self.source.get(from..)?.split_inclusive('\n') {
            let (begin, end) = self.trimmed(at, at + line.trim_end_matches('\n').len());
            match self.source.as_bytes().get(begin) {
                _ if begin == end => {}
                Some(b'%') => return stray.then_some(at),
                Some(b'(') | None => {}
                Some(byte) => {
                    // A digit tells a block; tapes carry names.
                    let digits =
                        self.source.get(begin..end).is_some_and(|text| text.bytes().any(|b| b.is_ascii_digit()));
                    if digits || *byte == b'#' || *byte == b'/' {
                        return None;
                    }
                    stray = true;
                }
            }
            at += line.len();
        }
        None
    }

    /// What stands behind a `%` in its line is skipped by the control.
    fn behind_percent(&mut self, from: usize, to: usize) {
        let (from, to) = self.trimmed(from, to);
        if from < to && self.source.as_bytes().get(from) != Some(&b'(') {
            self.warn(from, to, msg!("nc.skipped-lead"));
        }
    }

    /// Without white space at both ends, and without a `;` there.
    fn trimmed(&self, from: usize, to: usize) -> (usize, usize) {
        let bytes = self.source.as_bytes();
        let blank = |b: &u8| matches!(b, b' ' | b'\t' | b'\r');
        let line = bytes.get(from..to).unwrap_or_default();
        let lead = line.iter().take_while(|b| blank(b)).count();
        let trail = line.iter().rev().take_while(|b| blank(b)).count();
        (from + lead, (to - trail).max(from + lead))
    }

    /// Whether the program so far has nothing that runs.
    fn only_comments(&self) -> bool {
        match self.program.and_then(|index| self.deck.programs.get(index)) {
            None => true,
            Some(program) => {
                program.number == 0
                    && program.span == Span::default()
                    && self.deck.blocks_of(program).iter().all(|b| b.stmt == Stmt::Empty && b.number.is_none())
            }
        }
    }

    /// The blocks of a line: one, or several with `;` between them.
    fn blocks(&mut self, from: usize, to: usize) {
        let bytes = self.source.as_bytes();
        let line = bytes.get(from..to).unwrap_or_default();
        if !line.contains(&b';') {
            return self.block(from, to);
        }
        let mut comment = false;
        let mut start = from;
        for (offset, &byte) in line.iter().enumerate() {
            match byte {
                b'(' => comment = true,
                b')' => comment = false,
                b';' if !comment && self.deck.blocks.len() < BLOCKS => {
                    self.semicolon.get_or_insert((from + offset) as u32);
                    let (a, b) = self.trimmed(start, from + offset);
                    if a < b {
                        self.block(a, b);
                    }
                    start = from + offset + 1;
                }
                _ => {}
            }
        }
        let (a, b) = self.trimmed(start, to);
        if a < b {
            self.block(a, b);
        }
    }

    /// One block, `from < to`, without white space around it.
    fn block(&mut self, from: usize, to: usize) {
        let source = self.source;
        let line = source.as_bytes().get(from..to).unwrap_or_default();
        if line.len() > BLOCK_BYTES {
            self.take_line(line, from);
            self.report(Alarm::BlockTooLong, 0, line.len(), msg!("nc.block-too-long", BLOCK_BYTES as u32));
            return self.push(Stmt::Empty);
        }
        let letters = self.control.syntax.program_letters;
        let program = line.first().is_some_and(|b| letters.contains(&b.to_ascii_uppercase()) || *b == b':');
        self.take_line(line, from);
        if program && self.program_number() {
            let (from, to) = self.trimmed(from + self.at, to);
            let rest = source.as_bytes().get(from..to).unwrap_or_default();
            self.take_line(rest, from);
            if rest.is_empty() {
                return;
            }
        }
        let mark = self.mark();
        let stmt = match self.statement() {
            Ok(stmt) => stmt,
            Err(failure) => {
                // Whatever the block was meant to be, the control stops where it first does not read.
                let (number, skip_switch, bad) = (self.number, self.skip_switch, self.bad.or(Some(failure.alarm)));
                self.recover(mark, failure);
                (self.number, self.skip_switch, self.bad, self.comment) = (number, skip_switch, bad, None);
                Stmt::Empty
            }
        };
        if self.line.len() > self.tables.rules.block_chars as usize {
            self.check_length();
        }
        self.push(stmt);
    }

    /// A block has so many characters at most; comments do not count.
    #[cold]
    fn check_length(&mut self) {
        let (mut count, mut comment) = (0, false);
        let most = self.control.syntax.block_read_chars;
        for (at, &byte) in self.line.iter().enumerate() {
            comment |= byte == b'(';
            count += u32::from(!comment && begins_character(byte));
            comment &= byte != b')';
            if count > most && self.bad.is_none() {
                return self.report(Alarm::BlockTooLong, at, self.line.len(), msg!("nc.block-too-long", most));
            }
        }
    }

    fn take_line(&mut self, line: &'a [u8], from: usize) {
        self.line = line;
        self.base = from as u32;
        self.rewind();
    }

    /// Back to the start of the line.
    fn rewind(&mut self) {
        self.at = 0;
        self.number = None;
        self.skip_switch = 0;
        self.main = false;
        self.comment = None;
        self.label = None;
        self.bad = None;
        self.depth = 0;
        self.parts = 0;
        self.sentence = Alarm::Format;
    }

    /// `O9100(TITLE)` at the head of a line: starts a program. False where the letter is an ordinary address.
    fn program_number(&mut self) -> bool {
        let letter = self.line.first().map_or(0, u8::to_ascii_uppercase);
        let usual = self.control.syntax.program_letters.first() == Some(&letter);
        self.at = 1;
        self.blank();
        let digits = self.line.get(self.at..).unwrap_or_default().iter().take_while(|b| b.is_ascii_digit()).count();
        let (from, to) = (self.at, self.at + digits);
        let number = self.line.get(from..to).and_then(|d| core::str::from_utf8(d).ok()?.parse::<u32>().ok());
        self.at = to;
        let title = self.title();
        if digits == 0 || !usual && self.at < self.line.len() {
            self.at = 0;
            return false;
        }
        self.note_case(0);
        let span = self.span(0, to);
        let limit = self.control.syntax.program_digits as usize;
        match number {
            Some(0) => self.report(Alarm::NumberZero, 0, to, msg!("nc.program-zero")),
            Some(_) if digits <= limit => {}
            _ => self.report(Alarm::OutOfRange, 0, to, msg!("nc.program-digits", limit as u32)),
        }
        if !self.control.syntax.program_letters.contains(&letter) {
            let usual = self.program_letter();
            self.slip(Alarm::Format, 0, 1, msg!("nc.program-letter", usual.as_str()), &usual);
        }
        let number = number.unwrap_or(0);
        let title = title.map(|title| self.deck.add_text(title));
        if self.only_comments() && self.program.is_some() {
            // Comments above the number belong to its program.
            let program = self.program.and_then(|index| self.deck.programs.get_mut(index));
            if let Some(program) = program {
                (program.number, program.title, program.span) = (number, title, span);
            }
        } else {
            let at = self.deck.blocks.len() as u32;
            self.program = Some(self.deck.programs.len());
            let program = Program { file: self.id, number, name: None, sub: false, title, span, first: at, end: at };
            self.deck.programs.push(program);
        }
        true
    }

    /// The letter that program numbers have on this control.
    fn program_letter(&self) -> String {
        self.control.syntax.program_letters.first().map_or('O', |&letter| letter as char).to_string()
    }

    /// The comment behind a program number.
    fn title(&mut self) -> Option<&'a str> {
        self.blank();
        let rest = self.line.get(self.at..).unwrap_or_default();
        let inner = rest.strip_prefix(b"(")?;
        let len = inner.iter().position(|&b| b == b')')?;
        let from = self.base as usize + self.at + 1;
        self.at += len + 2;
        self.blank();
        let title = self.source.get(from..from + len);
        self.note_foreign(from, from + len);
        title
    }

    fn push(&mut self, stmt: Stmt) {
        let stmt = self.bad.map_or(stmt, Stmt::Bad);
        let span = Span::new(self.base, self.base + self.line.len() as u32);
        let (number, comment, label) = (self.number, self.comment, self.label);
        let block = Block { span, number, stmt, comment, label, skip: self.skip_switch, main: self.main };
        self.deck.blocks.push(block);
        let end = self.deck.blocks.len() as u32;
        match self.program.and_then(|index| self.deck.programs.get_mut(index)) {
            Some(program) => program.end = end,
            None => {
                self.program = Some(self.deck.programs.len());
                let (file, first, span) = (self.id, end - 1, Span::default());
                let (name, sub, number) = self.file_program();
                self.deck.programs.push(Program { file, number, name, sub, title: None, span, first, end });
            }
        }
    }

    fn mark(&self) -> Mark {
        Mark {
            words: self.deck.words.len(),
            exprs: self.deck.exprs.len(),
            pairs: self.deck.pairs.len(),
            texts: self.deck.texts.len(),
            found: self.found.len(),
            variables: self.misused.len(),
            small: self.small,
        }
    }

    /// Forgets everything since the mark, to read the line again.
    fn rollback(&mut self, mark: &Mark) {
        self.deck.words.truncate(mark.words);
        self.deck.exprs.truncate(mark.exprs);
        self.deck.pairs.truncate(mark.pairs);
        self.deck.texts.truncate(mark.texts);
        self.found.truncate(mark.found);
        self.misused.truncate(mark.variables);
        self.small = mark.small;
        self.round_brackets.clear();
        self.rewind();
    }

    /// Bytes of the line as a span of the file.
    fn span(&self, from: usize, to: usize) -> Span {
        Span::new(self.base + from.min(to) as u32, self.base + to as u32)
    }

    fn place(&self, span: Span) -> Place {
        Place { file: self.id, span }
    }

    /// An alarm of the control at bytes of the line.
    fn finding(&self, alarm: Alarm, from: usize, to: usize, message: Message) -> Diagnostic {
        Diagnostic::error(message).at(self.place(self.span(from, to))).alarm(self.control.alarm_shown(alarm))
    }

    /// Has the block looked at when all is read.
    fn note_later(&mut self) {
        if self.later.len() < FINDINGS {
            self.later.push(self.deck.blocks.len() as u32);
        }
    }

    fn add_finding(&mut self, diagnostic: Diagnostic) {
        if self.found.len() <= FINDINGS {
            self.found.push(diagnostic);
        }
    }

    /// Reports an alarm and reads on; the block will run into it.
    fn report(&mut self, alarm: Alarm, from: usize, to: usize, message: Message) {
        let finding = self.finding(alarm, from, to, message);
        self.report_as(alarm, finding);
    }

    fn report_as(&mut self, alarm: Alarm, finding: Diagnostic) {
        self.add_finding(finding);
        self.bad.get_or_insert(alarm);
    }

    /// A warning at bytes of the file.
    fn warn(&mut self, from: usize, to: usize, message: Message) {
        let place = self.place(Span::new(from as u32, to as u32));
        self.add_finding(Diagnostic::warning(message).at(place));
    }
}

/// Whether a byte of UTF-8 is the first of its character.
fn begins_character(byte: u8) -> bool {
    byte & 0b1100_0000 != 0b1000_0000
}
