//! Every machine: forms at their ends, verdicts and remedies, drawings, report, links, interruptions, written programs.

pub(super) mod drawn;
mod examples;
mod files_drawn;
mod links;
mod look;
mod parts;
mod plots;
mod remedy;
mod repairs;
mod report;
pub(super) mod restart;
mod scenes;
mod sensitivity;
mod standstill;
mod sweep;
mod verdicts;
mod written;
