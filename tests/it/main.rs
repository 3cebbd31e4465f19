//! The native tests, one binary: a test states a feature, and says in its failure what to do.
#![allow(clippy::unwrap_used, clippy::string_slice)]

mod cli;
mod controls;
mod differences;
mod figures;
mod generated;
mod language;
mod machines;
mod numbers;
mod physics;
mod programs;
mod rows;
mod saved;
mod stepping;
mod tidy;
mod told;
mod warnings;
mod writing;
