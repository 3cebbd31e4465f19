//! `Switch`: a point that the manuals leave open, its possible settings, its default, and the evidence for the default.

use super::options::{SwitchKind, SwitchOption};
use super::table::{Key, text_key};
use crate::text::catalog::words;
use crate::text::{Citation, with_aside};

/// A point of a control that is not certain; the user may set it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Switch {
    /// The point, with the options on this control, the default first, or with the default of a text.
    pub kind: SwitchKind,
    /// Catalog id of its label.
    pub label: &'static str,
    /// Number of the control's own parameter for the point, for instance `1006#3`; empty if unknown.
    pub parameter: &'static str,
    /// Source and grade of the default.
    pub cite: Citation,
}

/// Largest number of characters of a free text.
const TEXT: usize = 500;

/// A row of a switch.
pub const fn switch(kind: SwitchKind, cite: Citation) -> Switch {
    Switch { kind, label: kind.label(), parameter: "", cite }
}

impl Switch {
    /// The switch, with the number of the control's own parameter.
    pub const fn parameter(mut self, number: &'static str) -> Switch {
        self.parameter = number;
        self
    }

    /// The switch, with another label (catalog id).
    pub const fn label(mut self, label: &'static str) -> Switch {
        self.label = label;
        self
    }

    /// Id in projects and on the command line, for instance `macro-input-base`.
    pub fn id(&self) -> &'static str {
        self.kind.id()
    }

    /// The label, with the control's own parameter.
    pub fn text(&self) -> String {
        let label = words(self.label);
        if self.parameter.is_empty() { label.to_owned() } else { with_aside(label, words(self.parameter)) }
    }

    /// Options by id and catalog id of their label, the default first; empty for free text.
    pub fn options(&self) -> Vec<SwitchOption> {
        self.kind.options()
    }

    /// The default: id of an option, or a text.
    pub fn default(&self) -> &'static str {
        self.kind.default()
    }

    /// Whether the setting is free text.
    pub fn is_text(&self) -> bool {
        self.kind.is_text()
    }

    /// Whether the switch accepts a setting: the id of an option, or a text of printable ASCII.
    pub fn takes(&self, setting: &str) -> bool {
        if self.is_text() {
            return setting.len() <= TEXT && setting.bytes().all(|b| b.is_ascii_graphic() || b == b' ');
        }
        self.options().iter().any(|option| option.id == setting)
    }
}

/// Settings of switches that differ from the default: pairs of switch id and option id or text.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Switches(pub Vec<(String, String)>);

impl Switches {
    /// Present setting of a switch, or its default.
    pub fn setting<'a>(&'a self, row: &Switch) -> &'a str {
        let set = self.0.iter().find(|(id, _)| id == row.id()).map(|(_, setting)| setting.as_str());
        set.filter(|setting| row.takes(setting)).unwrap_or(row.default())
    }

    /// Sets a switch. Setting the default removes the entry.
    pub fn set(&mut self, row: &Switch, setting: &str) {
        self.0.retain(|(id, _)| id != row.id());
        if setting != row.default() {
            self.0.push((row.id().to_owned(), setting.to_owned()));
        }
    }
}

impl Switch {
    /// Whether the table is sorted, for binary search.
    pub const SORTED: bool = false;

    /// Key for replacing a family's row by the control's own row of the same id.
    pub const fn key(&self) -> Key {
        text_key(self.kind.id().as_bytes())
    }

    /// The key of an entry in a row list, by switch id.
    pub const fn listed_key(word: &[u8]) -> Key {
        text_key(word)
    }
}
