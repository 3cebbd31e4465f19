//! Text and findings about it: places, lines, messages, diagnostics, citations.

pub mod span;

mod byte_order_mark;

pub mod utf16;

pub mod lines;

pub mod escape;

pub mod number;

pub mod units;

pub mod quantity;

pub mod message;

pub mod catalog;

pub mod phrase;

pub mod list;

pub mod columns;

pub mod citation;

mod with_all;

pub mod diagnostic;

pub use byte_order_mark::{BYTE_ORDER_MARK, without_byte_order_mark};
pub use citation::{Citation, Grade, Provenance};
pub use columns::columns;
pub use diagnostic::{Diagnostic, DiagnosticKind, Fix, Severity};
pub use lines::{LineIndex, Position};
pub use list::{clauses, detailed, either, headed, listed, ranged, sentences, with_aside};
pub use message::{Message, MessageValue};
pub use phrase::Phrase;
pub use span::{FileId, Place, Span};
pub(crate) use with_all::with_all;
