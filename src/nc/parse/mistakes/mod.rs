//! Mistakes that the reader knows: each is reported once with its fix, and the rest is read on.

mod file_fixes;
mod foreign_syntax;
mod quick_fixes;
mod recover;
