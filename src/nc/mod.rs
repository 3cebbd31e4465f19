//! The language in both directions: text to tree ([`parse`]) and tree to text ([`emit`]).
//!
//! Both are total: they return a value and diagnostics, on any input. Only [`parse`] and [`parse_with`] make a [`Parsed`].

pub mod dec;

pub mod ast;

pub mod files;

pub mod build;

mod block_index;
mod checks;
mod codes;
mod emit;
mod fix;
mod lex;
mod lint;
mod lower;
mod parse;
mod parsed;
mod program_names;
mod read;
mod unread;
mod write;

pub mod symbols;

pub use ast::{
    Assignment, BadBlock, Block, Deck, Dimensioning, Expr, ExprId, Extent, Jump, JumpDirection, Op, Program, Stmt,
    TextId, Word, WordValue,
};
pub(crate) use block_index::{SequenceNumbers, labels_of};
pub use codes::{Codes, are_data};
pub use dec::Dec;
pub use emit::{Emitted, Newline, emit, emit_with};
pub use files::{File, Files};
pub use fix::{fix, fix_all};
pub use lex::keywords::IGNORED_STATEMENTS;
pub use lex::tokens::{TokenKind, keywords, tokens};
pub use lint::warnings;
pub use lower::lower;
pub use parse::expression::{ParsedFormula, formula};
pub use parsed::Parsed;
pub use read::{parse, parse_with};
pub use write::is_message;
