//! Programs with errors: a block that does not parse may set, call or jump to everything it names.

use super::super::ast::Block;
use super::super::unread;
use super::context::Lint;
use super::facts::Facts;
use crate::controls::Code;
use crate::text::Place;

impl Facts {
    /// Marks programs with errors.
    pub(super) fn errors(&mut self, lint: &Lint) {
        let deck = lint.deck;
        let start = |index: usize| {
            let program = &deck.programs[index];
            let first = deck.blocks_of(program).first().map_or(u32::MAX, |block| block.span.start);
            // A program that begins with its first block has no span of its own.
            let head = if program.span.start < program.span.end { program.span.start } else { first };
            (program.file, head.min(first))
        };
        let starts: Vec<_> = (0..deck.programs.len()).map(start).collect();
        let errors = lint.parsed.diagnostics().iter().filter(|finding| finding.is_error());
        for Place { file, span } in errors.filter_map(|finding| finding.place) {
            let after = starts.partition_point(|start| *start <= (file, span.start));
            if let Some(part) = self.programs.get_mut(after.saturating_sub(1)) {
                part.faulty = true;
            }
        }
    }

    /// Records a block that does not parse; returns whether it may set the unit of F.
    pub(super) fn bad_block(&mut self, lint: &Lint, (program, at): (u32, u32), block: &Block) -> bool {
        let text = lint.parsed.text(lint.place(at, block.span));
        let ids = unread::codes(text, lint.control);
        let codes = lint.parsed.codes();
        let any = |wanted: &[Code]| ids.iter().filter_map(|id| codes.row(*id)).any(|row| wanted.contains(&row.code));
        self.bad.push((program, at));
        self.any_called |= lint.control.syntax.names().is_some() || !codes.calls().is_empty();
        self.any_called |= any(&[Code::MacroCall, Code::MacroModal, Code::MacroModalBlock, Code::SubCall]);
        self.any_entry |= any(&[Code::SubCall, Code::SubEnd]);
        if let Some(part) = self.programs.get_mut(program as usize) {
            part.ends |= any(&[Code::End, Code::EndRewind]);
        }
        unread::has_g_word(text, lint.control)
    }
}

/// Numbers of the variables named in a block, and whether it names one by a formula.
pub(super) fn variables(text: &str, letter: char) -> (Vec<u32>, bool) {
    let (mut numbers, mut any) = (Vec::new(), false);
    let mut bytes = text.bytes().peekable();
    while let Some(byte) = bytes.next() {
        if byte.to_ascii_uppercase() != letter as u8 {
            continue;
        }
        let mut number: Option<u32> = None;
        while let Some(&next) = bytes.peek() {
            match next {
                b' ' => {}
                b'0'..=b'9' => {
                    number = Some(number.unwrap_or(0).saturating_mul(10).saturating_add(u32::from(next - b'0')));
                }
                b'#' | b'[' | b'(' => {
                    any |= number.is_none();
                    break;
                }
                _ => break,
            }
            bytes.next();
        }
        numbers.extend(number);
    }
    (numbers, any)
}
