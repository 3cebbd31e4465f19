//! Findings: about a project file, about programs by parser, warnings and run, silenced, and as text and JSON.

pub mod check;
pub mod file_findings;
pub(super) mod project_file;
pub mod render;
pub mod silence;
