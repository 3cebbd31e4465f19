//! Languages in which programs, labels, codes and addresses have names.

pub(in crate::nc) mod blocks;
pub(in crate::nc) mod program_header;
pub(in crate::nc) mod words;
