//! Advice on mistakes: known patterns, with their fixes.

pub(super) mod programs;

mod file_fixes;
mod foreign_syntax;
mod jump_targets;
mod loops;
mod quick_fixes;
mod recover;
mod symbolic;
