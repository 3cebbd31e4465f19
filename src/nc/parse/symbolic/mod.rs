//! Languages with names for programs, labels, codes and addresses.

mod blocks;
mod formula;
mod program_header;
mod words;
