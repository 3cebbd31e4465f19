//! Checks of whole programs: loops, jump targets, the last block.

use crate::controls::Address;
use std::collections::BTreeSet;

use crate::controls::{Alarm, Code, CodeId, Control};
use crate::msg;
use crate::nc::ast::{Block, Deck, Expr, Program, Stmt, WordValue};
use crate::nc::codes::{code_of, m_number};
use crate::nc::dec::Dec;
use crate::nc::files::Files;
use crate::nc::parse::reader::FINDINGS;
use crate::text::lines::line_end;
use crate::text::{Diagnostic, Fix, Message, Place, Span};

/// Blocks that are searched for the end of a loop.
const SEARCHED: usize = 10_000;

/// Number of a loop that does not read.
const ANY: u16 = 0;

/// Checks every program; `later` are its blocks with calls and jumps in words.
pub(in crate::nc) fn programs(
    deck: &Deck,
    control: &Control,
    files: &Files,
    later: &[u32],
    found: &mut Vec<Diagnostic>,
) {
    for (program, repeated) in deck.programs.iter().zip(repeated(deck)) {
        if found.len() > 2 * FINDINGS {
            return;
        }
        let text = files.get(program.file).map_or("", |file| file.text.as_str());
        let mut check = Check { deck, control, program, text, numbers: None, found };
        check.loops();
        match control.syntax.names() {
            Some(_) => check.named(),
            None => check.targets(),
        }
        check.end();
        for block in later.iter().filter(|&&at| (program.first..program.end).contains(&at)) {
            if let Some(block) = deck.blocks.get(*block as usize) {
                check.sub_call(block);
                check.function_jump(block);
            }
        }
        if repeated {
            let place = Place { file: program.file, span: program.span };
            let name = program.name.map(|name| deck.text(Some(name)).to_owned());
            let message = msg!("nc.program-twice", name.unwrap_or_else(|| format!("O{}", program.number)));
            check.found.push(Diagnostic::warning(message).at(place));
        }
    }
}

/// For each program in the order of the deck: whether an earlier one has its number, or its name where programs have names.
fn repeated(deck: &Deck) -> Vec<bool> {
    let mut known = BTreeSet::new();
    let repeats = |program: &Program| {
        let name = deck.text(program.name);
        let identified = program.number != 0 || !name.is_empty();
        identified && !known.insert((program.number, program.sub, name))
    };
    deck.programs.iter().map(repeats).collect()
}

/// Whether a loop that is open ends in these blocks, before another of its number begins.
fn ends_in(blocks: &[Block], label: u16) -> bool {
    let found = blocks.iter().take(SEARCHED).find_map(|block| match block.stmt {
        Stmt::End { label: other } if other == label => Some(true),
        Stmt::While { label: other, .. } if other == label => Some(false),
        _ => None,
    });
    found == Some(true)
}

pub(super) struct Check<'a> {
    pub(super) deck: &'a Deck,
    pub(super) control: &'a Control,
    pub(super) program: &'a Program,
    pub(super) text: &'a str,
    /// Sequence numbers of the program in rising order, once asked for.
    numbers: Option<Vec<u32>>,
    pub(super) found: &'a mut Vec<Diagnostic>,
}

impl Check<'_> {
    pub(in crate::nc) fn report(&mut self, alarm: Alarm, span: Span, message: Message) {
        let place = Place { file: self.program.file, span };
        let finding = Diagnostic::error(message).at(place).alarm(self.control.alarm_shown(alarm));
        self.found.push(finding);
    }

    /// The part of a block from a keyword on, for loops and jumps.
    fn keyword_span(&self, block: &Block, keyword: &str) -> Span {
        let upper = block.span.of(self.text).to_ascii_uppercase();
        let at = upper.rfind(keyword).unwrap_or(0) as u32;
        let tail = upper.get(at as usize..).unwrap_or("");
        let comment = tail.find('(').unwrap_or(tail.len());
        let len = tail.get(..comment).unwrap_or(tail).trim_end().len() as u32;
        Span::new(block.span.start + at, block.span.start + at + len)
    }

    /// DO and END: paired, not crossing, not too deep.
    fn loops(&mut self) {
        let deck = self.deck;
        let blocks = deck.blocks_of(self.program);
        let deepest = self.control.syntax.do_depth as usize;
        // Loops that are open; a head that does not read was reported, and its end is not to blame.
        let mut open: Vec<(u16, &Block)> = Vec::new();
        for (at, block) in blocks.iter().enumerate() {
            let rest = blocks.get(at + 1..).unwrap_or_default();
            let stmt = match block.stmt {
                Stmt::Bad(_) => self.unread_loop(block),
                stmt => stmt,
            };
            match stmt {
                Stmt::While { label, .. } => {
                    let span = self.keyword_span(block, "DO");
                    if open.len() == deepest {
                        if let Stmt::Bad(_) = block.stmt {
                            return;
                        }
                        return self.report(Alarm::DoNesting, span, msg!("nc.do-nesting", deepest as u32));
                    }
                    if label != ANY && open.iter().any(|(other, _)| *other == label) {
                        self.report(Alarm::DoPair, span, msg!("nc.do-within-itself", u32::from(label)));
                    }
                    open.push((label, block));
                }
                Stmt::End { label } => {
                    match open.iter().rposition(|(other, _)| *other == label || label == ANY || *other == ANY) {
                        Some(at) if at + 1 == open.len() => {
                            open.pop();
                        }
                        Some(at) => {
                            // Of a loop without an END its DO is told.
                            for (inner, head) in open.split_off(at + 1) {
                                if ends_in(rest, inner) {
                                    open.push((inner, head));
                                } else {
                                    self.no_end_of_loop(inner, head);
                                }
                            }
                            let inner = open.get(at + 1..).and_then(|inner| Some(u32::from(inner.last()?.0)));
                            if let Some(inner) = inner.filter(|_| !matches!(block.stmt, Stmt::Bad(_))) {
                                let span = self.keyword_span(block, "END");
                                self.report(Alarm::DoPair, span, msg!("nc.do-crossing", u32::from(label), inner));
                            }
                            open.remove(at);
                        }
                        None if self.found.len() > 2 * FINDINGS => return,
                        None if matches!(block.stmt, Stmt::Bad(_)) => {}
                        None => {
                            let span = self.keyword_span(block, "END");
                            self.report(Alarm::MissingDo, span, msg!("nc.end-without-do", u32::from(label)));
                            // Where the innermost loop has no end, this is meant to be it.
                            let meant = open.pop_if(|(inner, _)| *inner != ANY && !ends_in(rest, *inner));
                            if let (Some((inner, _)), Some(finding)) = (meant, self.found.last_mut()) {
                                let (place, end) = (Place { file: self.program.file, span }, format!("END{inner}"));
                                finding
                                    .fixes
                                    .push(Fix { title: msg!("nc.fix.write", end.as_str()), edits: vec![(place, end)] });
                            }
                        }
                    }
                }
                _ => {}
            }
        }
        for (label, block) in open {
            self.no_end_of_loop(label, block);
        }
    }

    /// A loop without an END; a head that does not read was reported.
    fn no_end_of_loop(&mut self, label: u16, head: &Block) {
        if !matches!(head.stmt, Stmt::Bad(_)) {
            let span = self.keyword_span(head, "DO");
            self.report(Alarm::MissingEnd, span, msg!("nc.do-without-end", u32::from(label)));
        }
    }

    /// The loop that a block that does not read opens or ends, by what can be made out of it.
    fn unread_loop(&self, block: &Block) -> Stmt {
        let text = block.span.of(self.text).to_ascii_uppercase();
        let text = text.split('(').next().unwrap_or("");
        // With the number behind it, if one stands there.
        let label = |keyword: &str| {
            let behind = text.get(text.rfind(keyword)? + keyword.len()..).unwrap_or("").trim_start();
            let digits = behind.bytes().take_while(u8::is_ascii_digit).count();
            let label: Option<u16> = behind.get(..digits).and_then(|digits| digits.parse().ok());
            Some(label.filter(|&label| (1..=self.control.syntax.do_max).contains(&label.into())).unwrap_or(ANY))
        };
        let head = label("DO").or_else(|| text.contains("WHILE").then_some(ANY));
        // `ENDWHILE` and `ENDDO` are ends.
        let end = text.contains("ENDW") || text.contains("ENDD");
        match (head.filter(|_| !end), label("END")) {
            (Some(label), _) => Stmt::While { cond: None, label },
            (None, Some(label)) => Stmt::End { label },
            (None, None) => block.stmt,
        }
    }

    /// Jumps to a constant number that is not in the program.
    fn targets(&mut self) {
        let deck = self.deck;
        for block in deck.blocks_of(self.program) {
            let (Stmt::If { target, .. } | Stmt::Goto { target, .. }) = block.stmt else { continue };
            let Expr::Number(target) = deck.expr(target) else { continue };
            if !self.has_number(target) {
                let span = self.keyword_span(block, "GOTO");
                let span = Span::new((span.start + 4).min(span.end), span.end);
                let lead = span.of(self.text).len() - span.of(self.text).trim_start().len();
                self.no_target(Alarm::GotoTarget, target, Span::new(span.start + lead as u32, span.end));
            }
        }
    }

    /// Whether a block of the program has this sequence number.
    fn has_number(&mut self, number: Dec) -> bool {
        let numbers = self.numbers.get_or_insert_with(|| {
            let blocks = self.deck.blocks_of(self.program);
            let mut all: Vec<u32> = blocks.iter().filter_map(|block| block.number).collect();
            all.sort_unstable();
            all
        });
        let value = number.to_f64();
        value.fract() == 0.0 && value >= 0.0 && numbers.binary_search(&(value as u32)).is_ok()
    }

    fn no_target(&mut self, missing: Alarm, number: Dec, span: Span) {
        if self.found.len() <= 2 * FINDINGS {
            // Some numbers no block can have.
            let such = self.control.syntax.sequence_numbers().contains(&number.to_f64());
            let alarm = if such { missing } else { Alarm::JumpNumber };
            self.report(alarm, span, msg!("nc.no-such-sequence", format!("N{number}")));
        }
    }

    /// The word of a letter with a number, and its bytes.
    fn number_word(&self, block: &Block, letter: Address) -> Option<(Dec, Span)> {
        let word = self.deck.words_of(block).iter().rfind(|word| word.letter == letter)?;
        let start = block.span.start + u32::from(word.offset);
        match word.value {
            WordValue::Number(number) => Some((number, Span::new(start, start + u32::from(word.len)))),
            WordValue::Expr(_) => None,
        }
    }

    /// `M98 P21000` where repeats stand in L: it calls O21000, and there is none, but there is an O1000.
    fn sub_call(&mut self, block: &Block) {
        let Some((number, span)) = self.number_word(block, Address::P).filter(|_| !self.control.macros.repeats_in_p)
        else {
            return;
        };
        let program = |number: i64| u32::try_from(number).is_ok_and(|number| self.deck.program(number).is_some());
        let (repeats, called) = (number.mantissa / 10_000, number.mantissa % 10_000);
        let call = self.number_word(block, Address::M).is_some_and(|(code, _)| self.is_code(code, Code::SubCall));
        let told = self.number_word(block, Address::L).is_some();
        if !call || told || number.scale > 0 || repeats == 0 || program(number.mantissa) || !program(called) {
            return;
        }
        let place = Place { file: self.program.file, span };
        let right = format!("P{called} L{repeats}");
        let message = msg!("nc.repeats-in-p", format!("P{number}"), format!("O{number}"), right.as_str());
        let finding = Diagnostic::warning(message).at(place);
        self.found.push(finding.fix(msg!("nc.fix.write", right.as_str()), vec![(place, right.clone())]));
    }

    /// `G65 H80 P` and the like to a number that is not in the program.
    fn function_jump(&mut self, block: &Block) {
        let Some((function, (number, span))) =
            self.number_word(block, Address::H).zip(self.number_word(block, Address::P))
        else {
            return;
        };
        let row = self.control.macros.functions.iter().find(|row| f64::from(row.0) == function.0.to_f64());
        if row.is_some_and(|row| row.1.jumps()) && !self.has_number(number) {
            self.no_target(Alarm::NoSequence, number, span);
        }
    }

    /// Whether an M code of this number does this.
    fn is_code(&self, number: Dec, code: Code) -> bool {
        let id = m_number(number).filter(|_| number.scale == 0).map(CodeId::M);
        id.and_then(|id| self.control.code(id)).is_some_and(|row| row.code == code)
    }

    /// A program must not run out of blocks.
    fn end(&mut self) {
        let deck = self.deck;
        let blocks = deck.blocks_of(self.program);
        let remark = |block: &&Block| block.stmt == Stmt::Empty && block.number.is_none();
        let last = blocks.iter().rev().find(|block| !remark(block));
        if last.is_some_and(|block| !self.falls_through(blocks, block)) {
            return;
        }
        let span = last.or(blocks.last()).map_or(self.program.span, |block| block.span);
        let behind = self.text.get(span.end as usize..).unwrap_or("");
        let line = behind.find('\n').unwrap_or(behind.len());
        let newline = line_end(self.text);
        let tail = behind.get(..line).unwrap_or("");
        let at = span.end + tail.strip_suffix('\r').unwrap_or(tail).len() as u32;
        let place = Place { file: self.program.file, span };
        let insert = Place { file: self.program.file, span: Span::at(at) };
        let shown = self.control.alarm_shown(Alarm::NoProgramEnd);
        let mut finding =
            Diagnostic::error(msg!("nc.no-program-end", self.control.program_ends())).at(place).alarm(shown);
        // The builder's and the user's standard programs are called: there the return is the likelier end.
        let called = self.program.number >= 8000 || self.program.sub;
        let ends = if called { [Code::SubEnd, Code::EndRewind] } else { [Code::EndRewind, Code::SubEnd] };
        for end in ends {
            let Some(row) = self.control.codes.iter().find(|row| row.code == end) else { continue };
            let code = self.control.code_name(row.id);
            let title = match end {
                Code::SubEnd => msg!("nc.fix.end-sub", code.as_str()),
                _ => msg!("nc.fix.end-main", code.as_str()),
            };
            finding = finding.fix(title, vec![(insert, format!("{newline}{code}"))]);
        }
        self.found.push(finding);
    }

    /// Whether the program goes on behind a block.
    fn falls_through(&self, blocks: &[Block], block: &Block) -> bool {
        match block.stmt {
            Stmt::Words { .. } => !self.deck.words_of(block).iter().any(|word| match word.value {
                WordValue::Number(_) if word.letter == Address::Name => {
                    let row = code_of(word).and_then(|id| self.control.code(id));
                    row.is_some_and(|row| row.code == Code::Return)
                }
                WordValue::Number(number) if word.letter == Address::M => {
                    [Code::End, Code::EndRewind, Code::SubEnd].iter().any(|end| self.is_code(number, *end))
                }
                _ => false,
            }),
            Stmt::Goto { .. } => false,
            // The end of a loop without a condition is never passed.
            Stmt::End { label } => {
                let heads = blocks.iter().rev().find_map(|block| match block.stmt {
                    Stmt::While { cond, label: other } if other == label => Some(cond),
                    _ => None,
                });
                heads.is_none_or(|cond| cond.is_some_and(|cond| self.deck.holds(cond) != Some(true)))
            }
            Stmt::Assign { to, .. } => {
                let Expr::Var(number) = self.deck.expr(to) else { return true };
                let row = self.control.var(number);
                row.is_none_or(|row| row.kind != crate::controls::VarKind::AlarmMessage)
            }
            Stmt::Bad(_) => {
                // Letters O may be what is wrong with it.
                let text = block.span.of(self.text).to_ascii_uppercase().replace('O', "0");
                !["M99", "M30", "M2", "M02", "M17", "RET"].iter().any(|end| text.contains(end))
            }
            _ => true,
        }
    }
}
