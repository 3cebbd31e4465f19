//! The language in both directions: text to tree ([`parse`]) and tree to text ([`emit`]).
//!
//! Both are total: they return a value and diagnostics, on any input. Only [`parse`] can make a [`Parsed`].

pub mod dec;

pub mod ast;

pub mod files;

pub mod build;

mod parsed;

mod parse;

pub use ast::{Block, Deck, Expr, ExprId, Op, Program, Stmt, Word, WordValue};
pub use dec::Dec;
pub use files::{File, Files};
pub use parse::parse;
pub use parsed::Parsed;
