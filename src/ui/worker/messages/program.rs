//! Messages about a program in the editor: proposals, places, and the lines that are shown.

use super::findings::Range;
use serde::{Deserialize, Serialize};

/// Greatest number of shown lines of a program.
pub(crate) const SHOWN: u32 = 5000;

/// A place in the editor.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Caret {
    /// The file.
    pub file: u16,
    /// UTF-16 units of its text before the place.
    pub units: u32,
}

/// Completion proposals for the typed prefix.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Proposals {
    /// UTF-16 units before the text that a proposal replaces.
    pub from: u32,
    /// Whether the first of them name a program or a block: these are few, and are shown before anything is typed.
    pub few: bool,
    /// Texts, and the line beside each of them.
    pub rows: Vec<(String, String)>,
}

/// Places of a program.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Places {
    /// Number of all places; greater than the number of rows if the list is cut.
    pub count: u32,
    /// The first places.
    pub rows: Vec<NamedPlace>,
}

/// A place as a row of a list.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct NamedPlace {
    /// Name of a program, block or variable; or file and line.
    pub name: String,
    /// Text of the block or of the line.
    pub text: String,
    /// Whether the row is nested below the place before it, as a block below its program.
    pub below: bool,
    /// The place.
    pub place: Range,
}
