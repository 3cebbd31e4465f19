//! The worker beside the page: messages and both ends of the connection.

pub(super) mod client;
pub(super) mod diagnostics;
pub(super) mod documents;
pub(super) mod editor;
pub(super) mod help;
pub(super) mod messages;
pub(super) mod pictures;
pub(super) mod server;
mod sheet_html;
pub(super) mod shelf;
