//! The operator's panel, and the list of the actions on it.

mod list;
pub(crate) mod panel;
mod rows;
