//! Text to tree.

use super::ast::Deck;
use super::files::Files;
use super::parsed::Parsed;
use crate::controls::Control;

/// Reads files as a control would. Total.
pub fn parse(files: &Files, control: &'static Control) -> Parsed {
    Parsed::new(files.clone(), Deck::default(), Vec::new(), control)
}
