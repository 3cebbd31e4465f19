//! What the programs of all machines share: header with the settings, checks of the operator's variables, alarms, comments.

pub mod comments;
pub mod header;
pub mod settings;
pub mod writing;
