//! Requests of a shell, checked against the control: checks and runs of a project or of bare programs.

pub mod check_request;
pub mod run_request;
