//! Text and what is said about it: places, lines, messages, diagnostics, citations.

pub mod span;

pub mod lines;

pub mod number;

pub mod message;

pub mod catalog;

pub mod citation;

pub mod diagnostic;

pub use citation::{Citation, Grade};
pub use diagnostic::{Diagnostic, DiagnosticKind, Fix, Severity};
pub use lines::{LineIndex, Position};
pub use message::{Message, Value};
pub use span::{FileId, Place, Span};
