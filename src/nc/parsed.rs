//! A read program: files, tree and findings together; only the parser makes one.

use std::rc::Rc;

use super::ast::{Block, Deck, ExprId};
use super::codes::Codes;
use super::files::Files;
use crate::controls::{Control, Dialect, Switches};
use crate::text::{Diagnostic, Place, Severity, Span};

/// Place of an expression in its file, with the blanks around it.
#[derive(Debug, Clone, Copy)]
pub(in crate::nc) struct ExprSpan {
    /// First byte.
    pub(in crate::nc) start: u32,
    /// Number of bytes.
    pub(in crate::nc) len: u16,
}

impl ExprSpan {
    /// The bytes of the expression in the text of its file, without the blanks around it.
    pub(in crate::nc) fn trimmed(self, file: &str) -> Option<Span> {
        let text = file.get(self.start as usize..self.start as usize + usize::from(self.len))?;
        let start = self.start + (text.len() - text.trim_ascii_start().len()) as u32;
        Some(Span::new(start, start + text.trim_ascii().len() as u32))
    }
}

/// Programs that a control has read; the only input of the interpreter.
#[derive(Debug, Clone)]
pub struct Parsed {
    pub(in crate::nc) files: Files,
    pub(in crate::nc) deck: Deck,
    pub(in crate::nc) diagnostics: Vec<Diagnostic>,
    pub(in crate::nc) control: &'static Control,
    pub(in crate::nc) switches: Switches,
    pub(in crate::nc) dialect: Rc<Dialect>,
    pub(in crate::nc) codes: Codes,
    pub(in crate::nc) expr_spans: Vec<ExprSpan>,
}

impl Parsed {
    /// The text.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// The tree. Its places point into [`files`](Parsed::files).
    pub fn deck(&self) -> &Deck {
        &self.deck
    }

    /// Alarms of the control and remarks, in the order of the text.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// The control that read it.
    pub fn control(&self) -> &'static Control {
        self.control
    }

    /// The settings of the control when it read.
    pub fn switches(&self) -> &Switches {
        &self.switches
    }

    /// The control as it was set when it read.
    pub fn dialect(&self) -> &Rc<Dialect> {
        &self.dialect
    }

    /// The codes of the control as its switches have them, with those that call programs by parameter.
    pub fn codes(&self) -> &Codes {
        &self.codes
    }

    /// Whether the control would refuse or misread any of it.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }

    /// The text of a place.
    pub fn text(&self, place: Place) -> &str {
        self.files.get(place.file).map_or("", |file| place.span.of(&file.text))
    }

    /// The bytes of an expression in the block at a place; `None` where the expression is not part of that block.
    pub fn expr_span(&self, block: Place, expr: ExprId) -> Option<Span> {
        let raw = self.expr_spans.get(expr.0 as usize)?;
        let span = raw.trimmed(&self.files.get(block.file)?.text)?;
        (block.span.start <= span.start && span.end <= block.span.end).then_some(span)
    }

    /// The place of a block of a program, both by index.
    pub fn place(&self, program: usize, block: &Block) -> Place {
        let file = self.deck.programs.get(program).map_or_else(Default::default, |p| p.file);
        Place { file, span: block.span }
    }
}
