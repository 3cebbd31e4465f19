//! A phrase: English text that stands in a row of a table. The catalog of another language has it as a key.

use core::fmt;

use serde::{Serialize, Serializer};

use super::{MessageValue, catalog};

/// English text of a row; shown in the language that is spoken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Phrase {
    /// As the row has it.
    pub english: &'static str,
}

impl Phrase {
    /// A phrase without words.
    pub const NONE: Phrase = Phrase::new("");

    /// The phrase that a row states.
    pub const fn new(english: &'static str) -> Phrase {
        Phrase { english }
    }

    /// Whether the row says nothing.
    pub const fn is_empty(self) -> bool {
        self.english.is_empty()
    }

    /// In the language that is spoken.
    pub fn words(self) -> &'static str {
        catalog::words(self.english)
    }
}

impl fmt::Display for Phrase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.words())
    }
}

impl Serialize for Phrase {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.words())
    }
}

impl From<Phrase> for MessageValue {
    fn from(phrase: Phrase) -> MessageValue {
        MessageValue::Label(phrase.english)
    }
}
