//! Conversion between byte offsets and positions of the protocol, which count lines and UTF-16 units from 0.
//!
//! A CR alone ends a line there, as LF and CR LF do.

use lsp_types::{Position, Range};
use macroline::text::{LineIndex, Span, utf16};

/// A text with the starts of its lines.
pub(super) struct Lines<'t> {
    text: &'t str,
    index: LineIndex,
}

impl<'t> Lines<'t> {
    /// Reads a text once.
    pub(super) fn new(text: &'t str) -> Lines<'t> {
        Lines { text, index: LineIndex::of_editor(text) }
    }

    /// The position of a byte.
    pub(super) fn position(&self, byte: u32) -> Position {
        let line = self.index.line_of(byte);
        let within = byte.saturating_sub(self.index.start(line));
        Position::new(line - 1, utf16::units(self.index.line(self.text, line), within))
    }

    /// The range of bytes.
    pub(super) fn range(&self, span: Span) -> Range {
        Range::new(self.position(span.start), self.position(span.end))
    }

    /// Byte offset of a position; limited to the end of its line, and of the text.
    pub(super) fn byte(&self, position: Position) -> u32 {
        if position.line >= self.index.count() {
            return self.text.len() as u32;
        }
        let line = position.line + 1;
        self.index.start(line) + utf16::byte(self.index.line(self.text, line), position.character)
    }

    /// The bytes of a range.
    pub(super) fn span(&self, range: Range) -> Span {
        let (start, end) = (self.byte(range.start), self.byte(range.end));
        Span::new(start.min(end), end.max(start))
    }
}
