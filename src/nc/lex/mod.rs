//! Lexical parts of the language: keywords, names, spelling, and the pieces of a line.

pub(in crate::nc) mod cursor;
pub(in crate::nc) mod keywords;
pub(in crate::nc) mod names;
pub(in crate::nc) mod spelling;
pub(in crate::nc) mod tokens;
