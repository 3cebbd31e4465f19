//! A parsed program: files, tree and findings; only the parser makes one.

use std::rc::Rc;

use super::ast::{Block, Deck, ExprId, TextId};
use super::codes::Codes;
use super::files::Files;
use crate::controls::{Control, Dialect, Switches};
use crate::text::{Diagnostic, Place, Span};

/// Maximum findings of a program; a file of garbage has millions.
pub(in crate::nc) const FINDINGS: usize = 1000;

/// Place of an expression in its file, blanks around it included.
#[derive(Debug, Clone, Copy)]
pub(in crate::nc) struct ExprSpan {
    /// First byte.
    pub(in crate::nc) start: u32,
    /// Number of bytes.
    pub(in crate::nc) len: u16,
}

impl ExprSpan {
    /// Span of the expression in the text of its file, without blanks around it.
    pub(in crate::nc) fn trimmed(self, file: &str) -> Option<Span> {
        let text = file.get(self.start as usize..self.start as usize + usize::from(self.len))?;
        let start = self.start + (text.len() - text.trim_ascii_start().len()) as u32;
        Some(Span::new(start, start + text.trim_ascii().len() as u32))
    }
}

/// Places of the parts of a deck in their files.
#[derive(Debug, Clone, Default)]
pub(in crate::nc) struct PartPlaces {
    /// Places of [`Deck::exprs`].
    pub(in crate::nc) exprs: Vec<ExprSpan>,
    /// Places of [`Deck::texts`], without brackets and quotes; empty for the name of a file.
    pub(in crate::nc) texts: Vec<Span>,
}

impl PartPlaces {
    /// Span of a text.
    pub(in crate::nc) fn text(&self, id: TextId) -> Span {
        self.texts.get(id.index()).copied().unwrap_or_default()
    }
}

/// Programs parsed for a control; the only input of the interpreter.
#[derive(Debug, Clone)]
pub struct Parsed {
    pub(in crate::nc) files: Files,
    pub(in crate::nc) deck: Deck,
    pub(in crate::nc) diagnostics: Vec<Diagnostic>,
    pub(in crate::nc) control: &'static Control,
    pub(in crate::nc) switches: Switches,
    pub(in crate::nc) dialect: Rc<Dialect>,
    pub(in crate::nc) codes: Codes,
    pub(in crate::nc) places: PartPlaces,
}

impl Parsed {
    /// The program files.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// The tree. Its places refer to [`files`](Parsed::files).
    pub fn deck(&self) -> &Deck {
        &self.deck
    }

    /// Alarms of the control and warnings, in text order.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// The control.
    pub fn control(&self) -> &'static Control {
        self.control
    }

    /// Switch settings of the control.
    pub fn switches(&self) -> &Switches {
        &self.switches
    }

    /// The control's dialect under these settings.
    pub fn dialect(&self) -> &Rc<Dialect> {
        &self.dialect
    }

    /// Codes of the control under these settings, including codes bound to programs by parameters.
    pub fn codes(&self) -> &Codes {
        &self.codes
    }

    /// Whether the control would refuse or misread a part of the program.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.is_error())
    }

    /// The text of a place.
    pub fn text(&self, place: Place) -> &str {
        self.files.get(place.file).map_or("", |file| place.span.of(&file.text))
    }

    /// Span of an expression in the block at a place; `None` if the expression is not part of that block.
    pub fn expr_span(&self, block: Place, expr: ExprId) -> Option<Span> {
        let raw = self.places.exprs.get(expr.0 as usize)?;
        let span = raw.trimmed(&self.files.get(block.file)?.text)?;
        (block.span.start <= span.start && span.end <= block.span.end).then_some(span)
    }

    /// Span of a comment, message, label or name in its file, without brackets and quotes.
    pub fn text_span(&self, text: TextId) -> Span {
        self.places.text(text)
    }

    /// Place of a block, in the program with this index.
    pub fn place(&self, program: usize, block: &Block) -> Place {
        let file = self.deck.programs.get(program).map_or_else(Default::default, |p| p.file);
        Place { file, span: block.span }
    }
}
