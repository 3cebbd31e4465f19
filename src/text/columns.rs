//! How wide a text is, counted in letters.

/// Columns that a text takes: a Chinese character and a full-width mark are as wide as two letters. What lays out labels needs no more than that,
/// and the tables of Unicode would make the page larger.
pub fn columns(text: &str) -> usize {
    text.chars().map(|c| if ('\u{2e80}'..='\u{ffef}').contains(&c) { 2 } else { 1 }).sum()
}
