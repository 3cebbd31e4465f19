//! Errors of whole programs, found after all files are read: jump targets, loops, calls, the last block.

pub(in crate::nc) mod programs;

mod context;
mod jump_targets;
mod loops;
mod symbolic;
