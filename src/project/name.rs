//! Names of projects, and entries of the title block.

/// Characters of a name or an entry at most.
pub const NAME_LENGTH: usize = 120;

/// A name as typed or read from a file, without control characters and within `NAME_LENGTH`.
pub fn clean_name(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(NAME_LENGTH).collect()
}
