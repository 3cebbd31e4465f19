//! Checks of whole programs in a language with names: labels, jumps to them, messages.

use super::programs::Check;
use crate::controls::Alarm;
use crate::msg;
use crate::nc::ast::{Block, Expr, ExprId, JumpDirection, Stmt, TextId};
use crate::nc::lex::spelling::meant;
use crate::nc::parse::reader::FINDINGS;
use crate::text::{Diagnostic, Place, Span};

impl Check<'_> {
    /// Checks labels, jumps to labels, calls and messages.
    pub(super) fn named(&mut self) {
        if self.control.raises(Alarm::LabelTwice) {
            self.labels_twice();
        }
        for (at, block) in self.blocks.iter().enumerate() {
            if !matches!(block.stmt, Stmt::If { .. } | Stmt::Ifs { .. } | Stmt::Goto { .. }) {
                continue;
            }
            for (_, target, way) in self.deck.jumps_of(block.stmt) {
                match self.deck.expr(target) {
                    Expr::Label(label) => self.label((at, block), (target, label), way),
                    Expr::Number(number) => self.block_number((at, block), number.mantissa, way),
                    _ => {}
                }
            }
        }
        self.calls();
        if self.control.raises(Alarm::MessageBlocks) {
            self.messages();
        }
    }

    /// Reports labels in front of several blocks.
    fn labels_twice(&mut self) {
        let labels = self.targets.labels().iter();
        let again: Vec<(&str, usize)> =
            labels.flat_map(|(name, at)| at.iter().skip(1).map(|at| (*name, *at))).collect();
        for (name, at) in again {
            let span = self.name_span(&self.blocks[at], name);
            self.report(Alarm::LabelTwice, span, msg!("nc.label-twice", label = name));
        }
    }

    /// Checks a jump to a label, which has to be in the jump's direction.
    fn label(&mut self, (at, block): (usize, &Block), (target, label): (ExprId, TextId), way: JumpDirection) {
        let name = self.deck.text(Some(label));
        let (exists, reached) = self.targets.label_on_way(name, at, way);
        // The error of a block that does not parse is already reported, and the label may be in it.
        if reached || self.found.len() > 2 * FINDINGS || !exists && self.targets.is_in_unread_block(name) {
            return;
        }
        let span = self.expr_span(block, target);
        if !exists {
            return self.report(Alarm::NoSequence, span, msg!("nc.no-such-label", label = name));
        }
        let (word, other) = if way == JumpDirection::Forward { ("GOTOF", "GOTOB") } else { ("GOTOB", "GOTOF") };
        let place = |span: Span| Place { file: self.program.file, span };
        let number = self.control.alarm_shown(Alarm::NoSequence);
        let finding = Diagnostic::error(msg!("nc.label-other-way", label = name, keyword = word, other))
            .at(place(span))
            .alarm(number);
        let jump = block.span.of(self.text).get(..(span.start - block.span.start) as usize).unwrap_or("");
        let edit = jump.to_ascii_uppercase().rfind(word).map(|at| {
            let start = block.span.start + at as u32;
            vec![(place(Span::new(start, start + word.len() as u32)), other.to_owned())]
        });
        self.found.push(match edit {
            Some(edit) => finding.fix(msg!("nc.fix.write", text = other), edit),
            None => finding,
        });
    }

    /// Reports calls of missing programs with a name close to a code.
    fn calls(&mut self) {
        for block in self.blocks {
            let Stmt::Call { name, .. } = block.stmt else { continue };
            let name = self.deck.text(Some(name));
            let codes = self.control.syntax.names().map_or(&[][..], |names| names.codes);
            if name.len() < 3 || self.known.name(name).is_some() || self.found.len() > FINDINGS {
                continue;
            }
            if let Some(code) = meant(name, codes.iter().copied()).and_then(|at| codes.get(at)) {
                let place = Place { file: self.program.file, span: self.name_span(block, name) };
                let finding = Diagnostic::warning(msg!("nc.call-or-code", program = name, code = *code)).at(place);
                self.found.push(finding.fix(msg!("nc.fix.write", text = *code), vec![(place, (*code).to_owned())]));
            }
        }
    }

    /// Checks a jump to a block number, on controls with such jumps.
    fn block_number(&mut self, (at, block): (usize, &Block), number: i64, way: JumpDirection) {
        if self.found.len() <= 2 * FINDINGS && !self.targets.number_on_way(number, at, way) {
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
                    self.report(Alarm::MessageBlocks, block.span, msg!("nc.message-blocks"));
                }
                stmt => message = matches!(stmt, Stmt::Message(_)),
            }
        }
    }

    /// Span of a name at the start of its block: a label or a called program.
    fn name_span(&self, block: &Block, name: &str) -> Span {
        let text = block.span.of(self.text).to_ascii_uppercase();
        let at = text.as_bytes().windows(name.len().max(1)).position(|w| w == name.as_bytes()).unwrap_or(0) as u32;
        Span::new(block.span.start + at, (block.span.start + at + name.len() as u32).min(block.span.end))
    }
}
