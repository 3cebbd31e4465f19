//! [`Variant`]: other settings of a project's machine, kept under a name.

use crate::controls::{Control, Switches};
use crate::machines::form::Values;

/// Variants of a project at most.
pub const MAX_VARIANTS: usize = 12;

/// Characters of the name of a variant at most.
pub const MAX_VARIANT_NAME: usize = 40;

/// Control, entries of the form and settings of open points that a project keeps under a name, to compare them and to take them again.
#[derive(Debug, Clone)]
pub struct Variant {
    /// Name, unique in its project; see [`variant_name`].
    pub name: String,
    /// The control.
    pub control: &'static Control,
    /// Values of the form by field id; a missing field has its default.
    pub values: Values,
    /// Settings of the control's open points.
    pub switches: Switches,
}

impl PartialEq for Variant {
    fn eq(&self, other: &Variant) -> bool {
        let same_form = self.values == other.values && self.switches == other.switches;
        self.name == other.name && self.control.id == other.control.id && same_form
    }
}

/// The name of a variant in a text: one line without blanks at its ends, of [`MAX_VARIANT_NAME`] characters at most. `None` where nothing is
/// left.
pub fn variant_name(text: &str) -> Option<String> {
    let line: String = text.trim().chars().filter(|c| !c.is_control()).take(MAX_VARIANT_NAME).collect();
    let name = line.trim();
    (!name.is_empty()).then(|| name.to_owned())
}
