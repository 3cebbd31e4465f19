//! The debugger: a stepped run beside the main run, its breakpoints and watches, and its commands as lines of text.

pub mod breakpoints;
pub mod console;
pub mod session;
pub mod stepping;
