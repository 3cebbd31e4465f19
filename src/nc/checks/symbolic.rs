//! Checks of whole programs in a language with names: labels, jumps to them, messages.

use super::context::Check;
use crate::controls::{Address, Alarm};
use crate::msg;
use crate::nc::ast::{Block, Expr, Jump, JumpDirection, Stmt, TextId};
use crate::nc::lex::spelling::zero_as_letter;
use crate::nc::parsed::FINDINGS;
use crate::text::{Diagnostic, DiagnosticKind, Message, Place, Span};

impl Check<'_> {
    /// Checks labels, jumps to labels, calls and messages.
    pub(super) fn symbolic(&mut self) {
        if self.control.raises(Alarm::LabelTwice) {
            self.labels_twice();
        }
        for (at, block) in self.blocks.iter().enumerate() {
            if !matches!(block.stmt, Stmt::If { .. } | Stmt::Ifs { .. } | Stmt::Goto { .. }) {
                continue;
            }
            for jump in self.deck.jumps_of(block.stmt) {
                match self.deck.expr(jump.target) {
                    Expr::Label(label) => self.label((at, block), jump, label),
                    Expr::Number(number) => self.block_number((at, block), number.mantissa, jump.way),
                    _ => {}
                }
            }
        }
        self.calls();
        if self.control.raises(Alarm::MessageBlocks) {
            self.messages();
        }
    }

    /// Reports an alarm that a run raises too, at the block.
    fn refuse(&mut self, alarm: Alarm, span: Span, message: Message) {
        self.report(alarm, span, message);
        if let Some(finding) = self.found.last_mut() {
            finding.kind = DiagnosticKind::RefusedBlock;
        }
    }

    /// Reports labels in front of several blocks.
    fn labels_twice(&mut self) {
        let labels = self.targets.labels().iter();
        let again: Vec<(&str, usize)> =
            labels.flat_map(|(name, at)| at.iter().skip(1).map(|at| (*name, *at))).collect();
        for (name, at) in again {
            let span = self.blocks[at].label.map_or(self.blocks[at].span, |label| self.places.text(label));
            self.refuse(Alarm::LabelTwice, span, msg!("nc.label-twice", label = name));
        }
    }

    /// Checks a jump to a label, which has to be in the jump's direction.
    fn label(&mut self, (at, block): (usize, &Block), jump: Jump, label: TextId) {
        let name = self.deck.text(Some(label));
        let (exists, reached) = self.targets.label_on_way(name, at, jump.way);
        // The error of a block that does not parse is already reported, and the label may be in it.
        if reached || self.is_full() || !exists && self.targets.is_in_unread_block(name) {
            return;
        }
        let span = self.expr_span(block, jump.target);
        if !exists {
            return self.report(Alarm::NoSequence, span, msg!("nc.no-such-label", label = name));
        }
        let (word, other) = jump.way.keywords();
        let place = |span: Span| Place { file: self.program.file, span };
        let number = self.control.alarm_shown(Alarm::NoSequence);
        let message = msg!("nc.label-other-way", label = name, keyword = word, other);
        let edit = vec![(place(jump.keyword.span(block)), other.to_owned())];
        let finding = Diagnostic::error(message).at(place(span)).alarm(number);
        self.found.push(finding.fix(msg!("nc.fix.write", text = other), edit));
    }

    /// Reports calls of missing programs whose name is an axis with the letter O in place of the digit 0.
    fn calls(&mut self) {
        for block in self.blocks {
            let Stmt::Call { name: id, .. } = block.stmt else { continue };
            let name = self.deck.text(Some(id));
            if self.known.name(name).is_some() || self.found.len() > FINDINGS {
                continue;
            }
            let axis = name.bytes().next().and_then(Address::of).is_some_and(|it| self.control.axis(it).is_some());
            if axis && zero_as_letter(name) {
                let Span { start, end } = self.places.text(id);
                let place = Place { file: self.program.file, span: Span::new(start + 1, end) };
                let digits = name.get(1..).unwrap_or("").replace('O', "0");
                let finding = Diagnostic::warning(msg!("nc.letter-o")).at(place);
                self.found.push(finding.fix(msg!("nc.fix.write", text = digits.as_str()), vec![(place, digits)]));
            }
        }
    }

    /// Checks a jump to a block number, on controls with such jumps.
    fn block_number(&mut self, (at, block): (usize, &Block), number: i64, way: JumpDirection) {
        if !self.is_full() && !self.targets.number_on_way(number, at, way) {
            self.report(Alarm::NoSequence, block.span, msg!("nc.no-such-sequence", block = format!("N{number}")));
        }
    }

    /// Reports two messages without an executable block between them.
    fn messages(&mut self) {
        let mut message = false;
        for block in self.blocks {
            match block.stmt {
                Stmt::Empty => {}
                Stmt::Message(_) if message && block.label.is_none() => {
                    self.refuse(Alarm::MessageBlocks, block.span, msg!("nc.message-blocks"));
                }
                stmt => message = matches!(stmt, Stmt::Message(_)),
            }
        }
    }
}
