//! What can be said only when a program is read to its end: loops, jump targets, its last block.

use super::super::ast::{Block, Deck, Expr, Program, Stmt, WordValue};
use super::super::files::Files;
use super::FINDINGS;
use crate::controls::{Alarm, Code, Control};
use crate::msg;
use crate::order;
use crate::text::{Diagnostic, Message, Place, Span};

/// Checks every program.
pub(super) fn programs(deck: &Deck, control: &Control, files: &Files, found: &mut Vec<Diagnostic>) {
    let again = again(&deck.programs);
    for (program, again) in deck.programs.iter().zip(again) {
        if found.len() > 2 * FINDINGS {
            return;
        }
        let text = files.get(program.file).map_or("", |file| file.text.as_str());
        let mut check = Check { deck, control, program, text, found };
        check.loops();
        check.targets();
        check.end();
        if again {
            let place = Place { file: program.file, span: program.span };
            let message = msg!("nc.program-twice", format!("O{}", program.number));
            check.found.push(Diagnostic::warning(message).at(place));
        }
    }
}

/// Of each program, whether its number was an earlier one's already.
fn again(programs: &[Program]) -> Vec<bool> {
    let mut by_number: Vec<usize> = (0..programs.len()).filter(|&at| programs[at].number != 0).collect();
    order::by_key(&mut by_number, |&at| programs[at].number.into());
    let mut again = vec![false; programs.len()];
    for pair in by_number.windows(2) {
        again[pair[1]] = programs[pair[0]].number == programs[pair[1]].number;
    }
    again
}

struct Check<'a> {
    deck: &'a Deck,
    control: &'a Control,
    program: &'a Program,
    text: &'a str,
    found: &'a mut Vec<Diagnostic>,
}

impl Check<'_> {
    fn report(&mut self, alarm: Alarm, span: Span, message: Message) {
        let place = Place { file: self.program.file, span };
        let finding = Diagnostic::error(message).at(place).alarm(self.control.alarm_number(alarm));
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
        // A loop head or end that does not read was reported; its partner is not to blame.
        let unread = |b: &Block| matches!(b.stmt, Stmt::Bad(_)) && self.names_loop(b);
        if blocks.iter().any(unread) {
            return;
        }
        let deepest = self.control.syntax.do_depth as usize;
        let mut open: Vec<(u16, &Block)> = Vec::new();
        for block in blocks {
            match block.stmt {
                Stmt::While { label, .. } => {
                    let span = self.keyword_span(block, "DO");
                    if open.len() == deepest {
                        return self.report(Alarm::DoNesting, span, msg!("nc.do-nesting", deepest as u32));
                    }
                    if open.iter().any(|(other, _)| *other == label) {
                        self.report(Alarm::DoPair, span, msg!("nc.do-within-itself", u32::from(label)));
                    }
                    open.push((label, block));
                }
                Stmt::End { label } => match open.iter().rposition(|(other, _)| *other == label) {
                    Some(at) if at + 1 == open.len() => {
                        open.pop();
                    }
                    Some(at) => {
                        let inner = open.last().map_or(0, |(label, _)| u32::from(*label));
                        let span = self.keyword_span(block, "END");
                        self.report(Alarm::DoPair, span, msg!("nc.do-crossing", u32::from(label), inner));
                        open.truncate(at);
                    }
                    None if self.found.len() > 2 * FINDINGS => return,
                    None => {
                        let span = self.keyword_span(block, "END");
                        self.report(Alarm::DoPair, span, msg!("nc.end-without-do", u32::from(label)));
                    }
                },
                _ => {}
            }
        }
        for (label, block) in open {
            let span = self.keyword_span(block, "DO");
            self.report(Alarm::DoPair, span, msg!("nc.do-without-end", u32::from(label)));
        }
    }

    fn names_loop(&self, block: &Block) -> bool {
        let text = block.span.of(self.text).to_ascii_uppercase();
        ["DO", "END", "WHILE"].iter().any(|word| text.contains(word))
    }

    /// Jumps to a constant number that is not in the program.
    fn targets(&mut self) {
        let deck = self.deck;
        let blocks = deck.blocks_of(self.program);
        let mut numbers: Option<Vec<u32>> = None;
        for block in blocks {
            let (Stmt::If { target, .. } | Stmt::Goto(target)) = block.stmt else { continue };
            let Expr::Number(target) = deck.expr(target) else { continue };
            let numbers = numbers.get_or_insert_with(|| {
                let mut all: Vec<u32> = blocks.iter().filter_map(|block| block.number).collect();
                order::by_key(&mut all, |&number| number.into());
                all
            });
            let value = target.to_f64();
            let there = value.fract() == 0.0 && numbers.binary_search(&(value as u32)).is_ok() && value >= 0.0;
            if !there && self.found.len() <= 2 * FINDINGS {
                let span = self.keyword_span(block, "GOTO");
                let span = Span::new((span.start + 4).min(span.end), span.end);
                let lead = span.of(self.text).len() - span.of(self.text).trim_start().len();
                let span = Span::new(span.start + lead as u32, span.end);
                self.report(Alarm::NoSequence, span, msg!("nc.no-such-sequence", format!("N{target}")));
            }
        }
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
        let newline = if self.text.contains("\r\n") { "\r\n" } else { "\n" };
        let tail = behind.get(..line).unwrap_or("");
        let at = span.end + tail.strip_suffix('\r').unwrap_or(tail).len() as u32;
        let place = Place { file: self.program.file, span };
        let insert = Place { file: self.program.file, span: Span::at(at) };
        let number = self.control.alarm_number(Alarm::NoProgramEnd);
        let mut finding = Diagnostic::error(msg!("nc.no-program-end")).at(place).alarm(number);
        // The builder's and the user's standard programs are called: there the return is the likelier end.
        let called = self.program.number >= 8000;
        let ends = if called { [Code::SubEnd, Code::EndRewind] } else { [Code::EndRewind, Code::SubEnd] };
        for end in ends {
            let Some(row) = self.control.codes.iter().find(|row| row.code == end) else { continue };
            let code = format!("{}{}", row.letter as char, row.number / 10);
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
                WordValue::Number(number) if word.letter == b'M' && number.scale == 0 => {
                    let tenths = u16::try_from(number.mantissa.saturating_mul(10)).unwrap_or(u16::MAX);
                    let row = self.control.code(b'M', tenths);
                    row.is_some_and(|row| matches!(row.code, Code::End | Code::EndRewind | Code::SubEnd))
                }
                _ => false,
            }),
            Stmt::Goto(_) => false,
            // The end of a loop without a condition is never passed.
            Stmt::End { label } => {
                let heads = blocks.iter().rev().find_map(|block| match block.stmt {
                    Stmt::While { cond, label: other } if other == label => Some(cond),
                    _ => None,
                });
                !matches!(heads, Some(None))
            }
            Stmt::Assign { to, .. } => {
                let Expr::Var(number) = self.deck.expr(to) else { return true };
                let row = self.control.var(number);
                row.is_none_or(|row| row.kind != crate::controls::VarKind::AlarmMessage)
            }
            Stmt::Bad(_) => {
                let text = block.span.of(self.text).to_ascii_uppercase();
                !["M99", "M30", "M2", "M02"].iter().any(|end| text.contains(end))
            }
            _ => true,
        }
    }
}
