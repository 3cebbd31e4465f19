//! The native tests, one binary: a test states a feature, and says in its failure what to do.
#![allow(clippy::unwrap_used, clippy::string_slice)]

mod cli;
mod control_differences;
mod controls;
mod diagnostic_text;
mod edges;
mod figures;
mod generated;
mod language;
mod machines;
mod meaning;
mod numbers;
mod papers;
mod parts;
mod physics;
mod programs;
mod rows;
mod sarif;
mod saved;
mod sizing;
mod stepping;
mod tidy;
mod variants;
mod warnings;
mod writing;
