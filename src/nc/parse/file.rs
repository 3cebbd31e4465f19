//! Files: lines, `%`, program numbers, and the blocks between them.

use super::reader::{BLOCK_BYTES, BLOCKS, BlockParts, Reader};
use crate::controls::Alarm;
use crate::controls::syntax::Percent;
use crate::msg;
use crate::nc::ast::{BadBlock, Block, Program, Stmt};
use crate::nc::lex::keywords::KEYWORDS;
use crate::nc::lex::spelling::{holds_word, prose, states};
use crate::nc::parse::failure::ParseFailure;
use crate::text::{Diagnostic, Span, without_byte_order_mark};

/// Character that ends a file on old systems (Ctrl-Z), and NUL, which follows a program on tape and in a punch file: no control reads them.
const END_OF_FILE: [char; 2] = ['\u{1a}', '\0'];

/// Number of bytes that fulfil a condition. Counts in pieces fit a byte, so the compiler can vectorize them.
fn count(bytes: &[u8], such: impl Fn(u8) -> bool) -> usize {
    bytes.chunks(255).map(|piece| usize::from(piece.iter().map(|&b| u8::from(such(b))).sum::<u8>())).sum()
}

impl<'a> Reader<'a> {
    /// Reserves memory once; growth by doubling would copy, and use three times as much.
    pub(super) fn reserve(&mut self) {
        let bytes = self.file.text.as_bytes();
        let lines = count(bytes, |b| b == b'\n') + 1;
        let letters = count(bytes, |b| b.is_ascii_alphabetic());
        self.deck.blocks.reserve(lines.min(bytes.len() / 4).min(BLOCKS));
        self.deck.words.reserve(letters.min(bytes.len() / 4).min(5 * BLOCKS));
    }

    pub(super) fn file(&mut self) {
        let bytes = self.file.text.trim_end_matches(END_OF_FILE).as_bytes();
        // A byte order mark is not part of the program; `report_file` reports it.
        let mut at = self.file.text.len() - without_byte_order_mark(self.file.text).len();
        // Whether a `%` opens the record (only comments so far) or closes it.
        let mut opened = false;
        let mut closed = None;
        let mut reported = false;
        if let Some(record) = self.leader(at) {
            let place = self.place(Span::new(at as u32, record as u32));
            self.add_finding(Diagnostic::info(msg!("nc.leader")).at(place));
            at = record;
        }
        while at < bytes.len() {
            let rest = self.file.text.get(at..).unwrap_or_default();
            let end = (at + rest.find('\n').unwrap_or(rest.len())).min(bytes.len());
            let (from, to) = self.trimmed(at, end);
            match bytes.get(from) {
                _ if from == to => {}
                Some(b'%') if self.names().is_some() => self.program_header(from, to),
                _ if self.names().is_some() => self.symbolic_block(from, to),
                _ if self.percent_behind_number(from, to) => {
                    let message = msg!("nc.number-before-percent", text = self.file.text.get(from..to).unwrap_or(""));
                    self.add_finding(Diagnostic::info(message).at(self.place(Span::new(from as u32, to as u32))));
                    closed = Some(to - 1);
                    self.program = None;
                }
                Some(byte) if *byte != b'%' && self.percent_behind_block(from, to) => {
                    self.block_before_percent(from, to - 1);
                    closed = Some(to - 1);
                    self.program = None;
                }
                Some(b'%') => {
                    if !self.only_comments() {
                        closed = Some(from);
                        self.program = None;
                    } else {
                        opened = true;
                    }
                    self.after_percent(from + 1, to);
                }
                _ => {
                    // After the end of the record only programs are read.
                    let begins = closed.is_some() && self.begins_program(from);
                    if let Some(percent) = closed.filter(|_| !reported) {
                        let message = if begins { msg!("nc.next-record") } else { msg!("nc.behind-end") };
                        self.warn(percent, percent + 1, message);
                        reported = true;
                    }
                    if closed.is_none() || begins {
                        (closed, reported) = (None, false);
                        self.blocks(from, to);
                    }
                }
            }
            if self.deck.blocks.len() >= BLOCKS {
                let place = self.place(Span::new(from as u32, to as u32));
                self.findings.list.push(Diagnostic::error(msg!("nc.too-many-blocks", most = BLOCKS as u32)).at(place));
                break;
            }
            at = end + 1;
        }
        self.report_file(opened, closed.is_some());
    }

    /// Whether a line begins with a program number, or with a comment, which may precede one.
    fn begins_program(&self, at: usize) -> bool {
        let line = self.file.text.as_bytes().get(at..).unwrap_or_default();
        match line {
            [b'(', ..] => true,
            [b'O' | b'o' | b':', digit, ..] => digit.is_ascii_digit(),
            [b'<', ..] => self.control.syntax.bracket_names,
            _ => false,
        }
    }

    /// Whether a line is a sequence number with the `%` that ends the record behind it, as in printed programs of the GSK 980TD: `N0120 %`.
    fn percent_behind_number(&self, from: usize, to: usize) -> bool {
        let line = self.file.text.as_bytes().get(from..to).unwrap_or_default();
        let number = line.strip_suffix(b"%").and_then(|head| head.strip_prefix(b"N").or(head.strip_prefix(b"n")));
        let digits = number.map(<[u8]>::trim_ascii).unwrap_or_default();
        !digits.is_empty() && digits.iter().all(u8::is_ascii_digit) && !self.only_comments()
    }

    /// Whether a line is a block of a program with the `%` that ends the record behind it: `M30%`.
    fn percent_behind_block(&self, from: usize, to: usize) -> bool {
        let line = self.file.text.as_bytes().get(from..to).unwrap_or_default();
        let comment = line.iter().rposition(|&b| b == b'(') > line.iter().rposition(|&b| b == b')');
        line.ends_with(b"%") && !comment && !self.only_comments()
    }

    /// Reads the block before a `%` of the same line, and warns if no end of block is between them.
    #[cold]
    fn block_before_percent(&mut self, from: usize, percent: usize) {
        let (from, to) = self.trimmed(from, percent);
        self.blocks(from, to);
        let bytes = self.file.text.as_bytes();
        if bytes.get(to.saturating_sub(1)) != Some(&b';') {
            let place = |from: usize, to: usize| self.place(Span::new(from as u32, to as u32));
            let edit = (place(to, percent), self.newline().to_owned());
            let finding = Diagnostic::warning(msg!("nc.percent-behind-block")).at(place(percent, percent + 1));
            self.add_finding(finding.fix(msg!("nc.fix.percent-alone"), vec![edit]));
        }
    }

    /// Start of the record, if its `%` follows text other than comments and programs: the leader of a tape.
    fn leader(&self, from: usize) -> Option<usize> {
        if self.control.syntax.percent != Percent::Both {
            return None;
        }
        let mut at = from;
        let mut stray = false;
        for line in self.file.text.get(from..)?.split_inclusive('\n') {
            let text = line.trim_matches(|c: char| c.is_ascii_control() || c == ' ');
            let begin = at + (line.len() - line.trim_start_matches(|c: char| c.is_ascii_control() || c == ' ').len());
            // Punched feed holes and start characters in front of the `%`.
            stray |= self.file.text.get(at..begin).is_some_and(|lead| lead.contains(unread_control));
            match text.as_bytes().first() {
                Some(b'%') => return stray.then_some(begin),
                Some(b'(') | None => {}
                Some(byte) => {
                    // Digits indicate a block, unless they are in a sentence; leaders of tapes are names.
                    let digits = text.bytes().any(|b| b.is_ascii_digit()) && !is_sentence(text);
                    if digits || matches!(byte, b'#' | b'/' | b'<') {
                        return None;
                    }
                    stray = true;
                }
            }
            at += line.len();
        }
        None
    }

    /// Warns about text after a `%` in the same line, which the control skips.
    fn after_percent(&mut self, from: usize, to: usize) {
        let (from, mut to) = self.trimmed(from, to);
        to = from + self.file.text.get(from..to).map_or(0, |text| text.trim_end_matches(unread_control).len());
        if from < to && self.file.text.as_bytes().get(from) != Some(&b'(') {
            self.warn(from, to, msg!("nc.skipped-lead"));
        }
    }

    /// Whether the program has only comments so far.
    pub(super) fn only_comments(&self) -> bool {
        match self.program.and_then(|index| self.deck.programs.get(index)) {
            None => true,
            Some(program) => {
                program.number == 0
                    && program.span == Span::default()
                    && self.comments_after(program.first) >= program.end
            }
        }
    }

    /// Index of the first block from `first` on other than a comment, or the number of blocks. Continues the last search.
    fn comments_after(&self, first: u32) -> u32 {
        let from = self.comments.get().max(first);
        let blocks = self.deck.blocks.get(from as usize..).unwrap_or_default();
        let comments = blocks.iter().take_while(|b| b.stmt == Stmt::Empty && b.number.is_none()).count();
        self.comments.set(from + comments as u32);
        from + comments as u32
    }

    /// Reads the blocks of a line: one, or several separated by `;`.
    fn blocks(&mut self, from: usize, to: usize) {
        let bytes = self.file.text.as_bytes();
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
                    self.notes.semicolon.get_or_insert((from + offset) as u32);
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

    /// Reads one block, `from < to`, without white space around it.
    pub(super) fn block(&mut self, from: usize, to: usize) {
        let source = self.file.text;
        let line = source.as_bytes().get(from..to).unwrap_or_default();
        if line.len() > BLOCK_BYTES {
            self.take_line(line, from);
            self.report(Alarm::BlockTooLong, 0, line.len(), msg!("nc.block-too-long", most = BLOCK_BYTES as u32));
            return self.push(Stmt::Empty);
        }
        let letters = self.control.syntax.program_letters;
        let program = line.first().is_some_and(|b| letters.contains(&b.to_ascii_uppercase()) || *b == b':');
        let named = self.control.syntax.bracket_names && line.first() == Some(&b'<');
        self.take_line(line, from);
        if program && self.program_number() || named && self.bracket_name() {
            let (from, to) = self.trimmed(from + self.cursor.at, to);
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
                // The control stops at the first error, whatever the block was meant to be.
                let (number, number_at) = (self.block.number, self.block.number_at);
                let (skip_switch, first) = (self.block.skip_switch, self.block.bad);
                let place = failure.finding.place.map_or_else(Span::default, |place| place.span);
                let first = first.unwrap_or(BadBlock { alarm: failure.alarm, finding: place });
                let (found, variables) = (mark.found, mark.variables);
                self.recover(mark, failure);
                let finding = self.reported_since(found, variables, first.finding);
                (self.block.number, self.block.number_at, self.block.skip_switch) = (number, number_at, skip_switch);
                self.block.comment = None;
                self.block.bad = Some(BadBlock { finding, ..first });
                Stmt::Empty
            }
        };
        if self.cursor.line.len() > self.tables.rules.block_chars as usize {
            self.check_length();
        }
        self.push(stmt);
    }

    /// Place of the finding for a block that does not parse: `first` if it is reported later with the variables of the file, else the first
    /// error since the block began. `found` and `variables` are the numbers of findings before the block.
    fn reported_since(&self, found: usize, variables: usize, first: Span) -> Span {
        if self.findings.misused.iter().skip(variables).any(|row| row.span == first) {
            return first;
        }
        let error = self.findings.list.iter().skip(found).find(|finding| finding.is_error());
        error.and_then(|error| error.place).map_or(first, |place| place.span)
    }

    /// Reports a block with too many characters; comments do not count.
    #[cold]
    fn check_length(&mut self) {
        let (mut count, mut comment) = (0, false);
        let most = self.tables.rules.block_chars;
        for (at, &byte) in self.cursor.line.iter().enumerate() {
            comment |= byte == b'(';
            count += u32::from(!comment && begins_character(byte));
            comment &= byte != b')';
            if count > most && self.block.bad.is_none() {
                return self.report(Alarm::BlockTooLong, at, self.cursor.line.len(), msg!("nc.block-too-long", most));
            }
        }
    }

    /// Reads `O9100(TITLE)` at the start of a line, which starts a program; false if the letter is an ordinary address.
    fn program_number(&mut self) -> bool {
        let letter = self.cursor.line.first().map_or(0, u8::to_ascii_uppercase);
        let letters = self.control.syntax.program_letters;
        let usual = letters.first() == Some(&letter) || letter == b':' && letters.contains(&letter);
        self.cursor.at = 1;
        self.cursor.blank();
        let digits = self.cursor.digits();
        let (from, to) = (self.cursor.at, self.cursor.at + digits);
        let number = self.cursor.line.get(from..to).and_then(|d| core::str::from_utf8(d).ok()?.parse::<u32>().ok());
        self.cursor.at = to;
        let title = self.title();
        if digits == 0 || !usual && self.cursor.at < self.cursor.line.len() {
            self.cursor.at = 0;
            return false;
        }
        self.note_case(0);
        let span = self.span(0, to);
        let limit = self.control.syntax.program_digits as usize;
        match number {
            Some(0) => self.report(Alarm::NumberZero, 0, to, msg!("nc.program-zero")),
            Some(_) if digits <= limit => {}
            _ => self.report(Alarm::OutOfRange, 0, to, msg!("nc.program-digits", most = limit as u32)),
        }
        if !letters.contains(&letter) {
            let usual = self.program_letter();
            self.report_replaced(Alarm::Format, 0, 1, msg!("nc.program-letter", letter = usual.as_str()), &usual);
        }
        let number = number.unwrap_or(0);
        let title = title.map(|(title, span)| self.add_text(title, span));
        self.begin_program(Program { number, title, ..self.empty_program(span) });
        true
    }

    /// Reads `<NAME>(TITLE)` at the start of a line, which starts a program; false without the closing bracket.
    #[cold]
    fn bracket_name(&mut self) -> bool {
        let (length, closed) = self.cursor.enclosed(b'>');
        if !closed {
            return false;
        }
        let span = self.span(0, length);
        self.cursor.at = length;
        self.title();
        let name = span.of(self.file.text).to_owned();
        self.add_finding(Diagnostic::warning(msg!("nc.bracket-name", program = name.as_str())).at(self.place(span)));
        let title = Some(self.add_text(name, span));
        self.begin_program(Program { title, ..self.empty_program(span) });
        true
    }

    /// The failure of a call of a program by its name in `< >`, such as `M98 <SUB1>`.
    #[cold]
    pub(super) fn call_by_name(&self) -> Box<ParseFailure> {
        let (length, closed) = self.cursor.enclosed(b'>');
        if !closed {
            return self.unexpected();
        }
        let (start, end) = (self.cursor.at, self.cursor.at + length);
        let name = self.span(start, end).of(self.file.text).to_owned();
        self.stops_here(start, end, msg!("nc.bracket-call", program = name))
    }

    /// A program without number and name at the next block.
    pub(super) fn empty_program(&self, span: Span) -> Program {
        let at = self.deck.blocks.len() as u32;
        Program { file: self.file.id, number: 0, name: None, sub: false, title: None, span, first: at, end: at }
    }

    /// Begins a program at the next block, or at the comments above its first line if there are any.
    pub(super) fn begin_program(&mut self, program: Program) {
        if self.only_comments()
            && let Some(comments) = self.program.and_then(|index| self.deck.programs.get_mut(index))
        {
            *comments = Program { first: comments.first, end: comments.end, ..program };
            return;
        }
        self.program = Some(self.deck.programs.len());
        self.deck.programs.push(program);
    }

    /// The letter of program numbers on this control.
    pub(super) fn program_letter(&self) -> String {
        self.control.syntax.program_letters.first().map_or('O', |&letter| letter as char).to_string()
    }

    /// The comment after a program number.
    fn title(&mut self) -> Option<(&'a str, Span)> {
        self.cursor.blank();
        let rest = self.cursor.rest();
        let inner = rest.strip_prefix(b"(")?;
        let len = inner.iter().position(|&b| b == b')')?;
        let from = self.cursor.base as usize + self.cursor.at + 1;
        self.cursor.at += len + 2;
        self.cursor.blank();
        let title = self.file.text.get(from..from + len)?;
        self.note_foreign(from, from + len);
        Some((title, Span::new(from as u32, (from + len) as u32)))
    }

    pub(super) fn push(&mut self, stmt: Stmt) {
        let stmt = self.block.bad.map_or(stmt, Stmt::Bad);
        let span = Span::new(self.cursor.base, self.cursor.base + self.cursor.line.len() as u32);
        let BlockParts { number, number_at, skip_switch: skip, main, comment, label, .. } = self.block;
        let block = Block { span, number, number_at, stmt, comment, label, skip, main };
        self.deck.blocks.push(block);
        let end = self.deck.blocks.len() as u32;
        match self.program.and_then(|index| self.deck.programs.get_mut(index)) {
            Some(program) => program.end = end,
            None => {
                self.program = Some(self.deck.programs.len());
                let (name, sub, number) = self.file_program();
                let program = Program { number, name, sub, first: end - 1, ..self.empty_program(Span::default()) };
                self.deck.programs.push(program);
            }
        }
    }
}

/// Whether a character is one of tape and line control that no program contains.
fn unread_control(c: char) -> bool {
    c.is_ascii_control() && !matches!(c, '\t' | '\r' | '\n')
}

/// Whether a line reads as a sentence and not as a block.
fn is_sentence(line: &str) -> bool {
    prose(line.as_bytes()) && !states(line.as_bytes(), &KEYWORDS) && !holds_word(line.as_bytes())
}

/// Whether a byte of UTF-8 is the first of its character.
pub(super) fn begins_character(byte: u8) -> bool {
    byte & 0b1100_0000 != 0b1000_0000
}
