//! A phrase: English text in a row of a table. The catalog of another language has it as a key.

use core::fmt;

use serde::{Serialize, Serializer};

use super::{MessageValue, catalog};

/// English text of a row, shown in the language in use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Phrase {
    /// The English text of the row.
    pub english: &'static str,
}

impl Phrase {
    /// An empty phrase.
    pub const NONE: Phrase = Phrase::new("");

    /// A phrase from its English text.
    pub const fn new(english: &'static str) -> Phrase {
        Phrase { english }
    }

    /// Whether the phrase is empty.
    pub const fn is_empty(self) -> bool {
        self.english.is_empty()
    }

    /// The phrase in the language in use.
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
