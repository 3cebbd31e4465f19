//! Languages with names for programs, labels, codes and addresses.

pub(in crate::nc) mod blocks;
pub(in crate::nc) mod formula;
pub(in crate::nc) mod program_header;
pub(in crate::nc) mod words;
