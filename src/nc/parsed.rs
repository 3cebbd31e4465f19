//! A read program: files, tree and findings together; only the parser makes one.

use std::rc::Rc;

use super::ast::{Block, Deck};
use super::codes::Codes;
use super::files::Files;
use crate::controls::{Control, Dialect, Switches};
use crate::text::{Diagnostic, Place, Severity};

/// Text that a control has read. The interpreter takes nothing else.
#[derive(Debug, Clone)]
pub struct Parsed {
    files: Files,
    deck: Deck,
    diagnostics: Vec<Diagnostic>,
    control: &'static Control,
    switches: Switches,
    dialect: Rc<Dialect>,
    codes: Codes,
}

impl Parsed {
    pub(super) fn new(
        files: Files,
        deck: Deck,
        diagnostics: Vec<Diagnostic>,
        control: &'static Control,
        switches: Switches,
        dialect: Rc<Dialect>,
        codes: Codes,
    ) -> Parsed {
        Parsed { files, deck, diagnostics, control, switches, dialect, codes }
    }

    /// The text.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// The tree. Its places point into [`files`](Parsed::files).
    pub fn deck(&self) -> &Deck {
        &self.deck
    }

    /// What the control would say, and remarks, in the order of the text.
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

    /// The place of a block of a program, both by index.
    pub fn place(&self, program: usize, block: &Block) -> Place {
        let file = self.deck.programs.get(program).map_or_else(Default::default, |p| p.file);
        Place { file, span: block.span }
    }
}
