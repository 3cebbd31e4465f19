//! Points that the manuals leave open: a default, the other possibility, and the evidence.

use crate::text::Citation;

/// A point of a control that is not known for certain; the user may set it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Switch {
    /// Id in projects, for instance `macro-input-base`.
    pub id: &'static str,
    /// What it decides.
    pub text: &'static str,
    /// Possible settings; the first is the default. With a single one the setting is free text, and this is its default.
    pub options: &'static [&'static str],
    /// Source and grade of the default.
    pub cite: Citation,
}

/// Ids of the switches that name the common variables that are fitted, for instance `#100 to #149, #500 to #549`.
pub(in crate::controls) const FITTED: [&str; 2] = ["common-variables", "r-parameters"];

/// Characters of a free text.
const TEXT: usize = 500;

impl Switch {
    /// Whether a setting is free text.
    pub fn is_text(&self) -> bool {
        self.options.len() == 1
    }

    /// Whether this can be its setting.
    pub fn takes(&self, setting: &str) -> bool {
        let text = || setting.len() <= TEXT && setting.bytes().all(|b| b.is_ascii_graphic() || b == b' ');
        self.options.contains(&setting) || self.is_text() && text()
    }
}

/// Settings of switches that differ from the default, by id.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Switches(pub Vec<(String, String)>);

impl Switches {
    /// The setting of a switch: what was chosen, or its default.
    pub fn get<'a>(&'a self, switches: &'a [Switch], id: &str) -> Option<&'a str> {
        let row = switches.iter().find(|row| row.id == id)?;
        let set = self.0.iter().find(|(key, _)| key == id).map(|(_, value)| value.as_str());
        set.filter(|value| row.takes(value)).or(row.options.first().copied())
    }
}

/// A row of a switch; the first option is the default.
pub(in crate::controls) const fn switch(
    id: &'static str,
    text: &'static str,
    options: &'static [&'static str],
    cite: Citation,
) -> Switch {
    Switch { id, text, options, cite }
}
