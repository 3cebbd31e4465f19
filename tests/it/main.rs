//! The native tests, one binary: a test states a feature, and its failure tells the developer what to do.
#![allow(clippy::unwrap_used, clippy::string_slice, reason = "a test stops at a fault")]

mod changes;
mod cli;
mod cli_language;
mod command;
mod comments;
mod completion;
mod control_differences;
mod controls;
mod diagnostic_text;
mod edges;
mod figures;
mod generated;
mod help;
mod language;
mod lsp;
mod machines;
mod meaning;
mod numbers;
mod operator_actions;
mod package;
mod papers;
mod parts;
mod physics;
mod programs;
mod rows;
mod sarif;
mod saved;
mod sizing;
mod stepping;
mod symbols;
mod tidy;
mod units;
mod variants;
mod warnings;
mod writing;
