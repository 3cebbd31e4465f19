//! Checks of whole programs in a language with names: labels, jumps to them, messages.

use std::collections::BTreeMap;

use super::programs::Check;
use crate::controls::Alarm;
use crate::msg;
use crate::nc::ast::{Block, Expr, JumpDirection, Stmt, TextId};
use crate::nc::lex::spelling::meant;
use crate::nc::parse::reader::FINDINGS;
use crate::text::{Diagnostic, Place, Span};

impl<'a> Check<'a> {
    /// Labels, the jumps to them, and messages.
    pub(in crate::nc) fn named(&mut self) {
        let deck = self.deck;
        let blocks = deck.blocks_of(self.program);
        // The blocks of each label.
        let mut labels: BTreeMap<&'a str, Vec<usize>> = BTreeMap::new();
        for (at, block) in blocks.iter().enumerate().filter(|(_, block)| block.label.is_some()) {
            labels.entry(deck.text(block.label)).or_default().push(at);
        }
        if self.control.raises(Alarm::LabelTwice) {
            for (name, places) in &labels {
                for at in places.iter().skip(1) {
                    let span = self.name_span(&blocks[*at], name);
                    self.report(Alarm::LabelTwice, span, msg!("nc.label-twice", *name));
                }
            }
        }
        for (at, block) in blocks.iter().enumerate() {
            if !matches!(block.stmt, Stmt::If { .. } | Stmt::Ifs { .. } | Stmt::Goto { .. }) {
                continue;
            }
            for (_, target, way) in deck.jumps_of(block.stmt) {
                match deck.expr(target) {
                    Expr::Label(label) => self.label(&labels, (at, block), label, way),
                    Expr::Number(number) => self.block_number((at, block), number.mantissa, way),
                    _ => {}
                }
            }
        }
        self.calls(blocks);
        if self.control.raises(Alarm::MessageBlocks) {
            self.messages(blocks);
        }
    }

    /// A jump to a label, which has to lie on its way.
    fn label(
        &mut self,
        labels: &BTreeMap<&str, Vec<usize>>,
        (at, block): (usize, &Block),
        label: TextId,
        way: JumpDirection,
    ) {
        let name = self.deck.text(Some(label));
        let places = labels.get(name).map_or(&[][..], Vec::as_slice);
        if places.iter().any(|&to| way.reaches(at, to)) || self.found.len() > 2 * FINDINGS {
            return;
        }
        let span = self.jump_span(block, name);
        let blocks = self.deck.blocks_of(self.program);
        let unread = |row: &Block| {
            matches!(row.stmt, Stmt::Bad(_)) && row.span.of(self.text).to_ascii_uppercase().contains(name)
        };
        if places.is_empty() && blocks.iter().any(unread) {
            // Its block was reported.
            return;
        }
        if places.is_empty() {
            return self.report(Alarm::NoSequence, span, msg!("nc.no-such-label", name));
        }
        let (word, other) = if way == JumpDirection::Forward { ("GOTOF", "GOTOB") } else { ("GOTOB", "GOTOF") };
        let place = |span: Span| Place { file: self.program.file, span };
        let number = self.control.alarm_shown(Alarm::NoSequence);
        let finding = Diagnostic::error(msg!("nc.label-other-way", name, word, other)).at(place(span)).alarm(number);
        let jump = block.span.of(self.text).get(..(span.start - block.span.start) as usize).unwrap_or("");
        let edit = jump.to_ascii_uppercase().rfind(word).map(|at| {
            let start = block.span.start + at as u32;
            vec![(place(Span::new(start, start + word.len() as u32)), other.to_owned())]
        });
        self.found.push(match edit {
            Some(edit) => finding.fix(msg!("nc.fix.write", other), edit),
            None => finding,
        });
    }

    /// Calls of programs that are not here, where a code of nearly the same name is.
    fn calls(&mut self, blocks: &[Block]) {
        for block in blocks {
            let Stmt::Call { name, .. } = block.stmt else { continue };
            let name = self.deck.text(Some(name));
            let codes = self.control.syntax.names().map_or(&[][..], |names| names.codes);
            if name.len() < 3 || self.deck.program_named(name).is_some() || self.found.len() > FINDINGS {
                continue;
            }
            if let Some(code) = meant(name, codes.iter().copied()).and_then(|at| codes.get(at)) {
                let place = Place { file: self.program.file, span: self.name_span(block, name) };
                let finding = Diagnostic::warning(msg!("nc.call-or-code", name, *code)).at(place);
                self.found.push(finding.fix(msg!("nc.fix.write", *code), vec![(place, (*code).to_owned())]));
            }
        }
    }

    /// A jump to a block number, where there are such.
    fn block_number(&mut self, (at, block): (usize, &Block), number: i64, way: JumpDirection) {
        let blocks = self.deck.blocks_of(self.program);
        let found = |(to, row): (usize, &Block)| row.number.map(i64::from) == Some(number) && way.reaches(at, to);
        if !blocks.iter().enumerate().any(found) && self.found.len() <= 2 * FINDINGS {
            self.report(Alarm::NoSequence, block.span, msg!("nc.no-such-sequence", format!("N{number}")));
        }
    }

    /// Two messages with nothing between them that is done.
    fn messages(&mut self, blocks: &[Block]) {
        let mut message = false;
        for block in blocks {
            match block.stmt {
                Stmt::Empty => {}
                Stmt::Message(_) if message && block.label.is_none() => {
                    self.report(Alarm::MessageBlocks, block.span, msg!("nc.message-blocks"));
                }
                stmt => message = matches!(stmt, Stmt::Message(_)),
            }
        }
    }

    /// Where a label stands in front of its block.
    fn name_span(&self, block: &Block, name: &str) -> Span {
        let text = block.span.of(self.text).to_ascii_uppercase();
        let at = text.as_bytes().windows(name.len().max(1)).position(|w| w == name.as_bytes()).unwrap_or(0) as u32;
        Span::new(block.span.start + at, (block.span.start + at + name.len() as u32).min(block.span.end))
    }

    /// Where a label stands behind a jump.
    fn jump_span(&self, block: &Block, name: &str) -> Span {
        let text = block.span.of(self.text).to_ascii_uppercase();
        let mut from = 0;
        let jump = |rest: &str| rest.as_bytes().windows(4).position(|word| word == b"GOTO");
        while let Some(jump) = text.get(from..).and_then(jump) {
            let behind = text.get(from + jump + 5..).unwrap_or("");
            let gap = behind.len() - behind.trim_start().len();
            let at = from + jump + 5 + gap;
            let rest = text.get(at..).unwrap_or("");
            let next = rest.get(name.len()..).and_then(|rest| rest.bytes().next());
            if rest.starts_with(name) && !next.is_some_and(|b| b.is_ascii_alphanumeric() || b == b'_') {
                return Span::new(block.span.start + at as u32, block.span.start + (at + name.len()) as u32);
            }
            from += jump + 4;
        }
        block.span
    }
}
