//! An entry of the form that a remedy, a candidate or a row of a sheet proposes.

/// An entry of a field, as it would be typed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FieldEntry {
    /// Id of the field.
    pub field: &'static str,
    /// Text to be typed.
    pub text: String,
}

impl FieldEntry {
    /// The entry of a text in the field with this id.
    pub fn new(field: &'static str, text: impl Into<String>) -> FieldEntry {
        FieldEntry { field, text: text.into() }
    }
}

impl<T: Into<String>> From<(&'static str, T)> for FieldEntry {
    fn from((field, text): (&'static str, T)) -> FieldEntry {
        FieldEntry::new(field, text)
    }
}
