//! The hand of the operator: the panel, and the list of the actions on it.

mod list;
pub(crate) mod panel;
mod rows;
