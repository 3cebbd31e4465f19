//! Findings: about a project file, about programs by parser, warnings and run, silenced, and as text and JSON.

pub(super) mod project_file;

pub mod render;

pub mod file_findings;

pub mod silence;

pub mod check;
