//! Characters allowed in comments of a control, and their size in bytes.

use core::ops::RangeInclusive;

use super::options::CommentCharacters;

/// Characters of GBK for comments: ideographs, punctuation, wide letters, technical signs. The rest of GBK is left out.
const GBK: [RangeInclusive<char>; 18] = [
    '\u{b0}'..='\u{b1}',
    '\u{b7}'..='\u{b7}',
    '\u{d7}'..='\u{d7}',
    '\u{f7}'..='\u{f7}',
    '\u{391}'..='\u{3a1}',
    '\u{3a3}'..='\u{3a9}',
    '\u{3b1}'..='\u{3c1}',
    '\u{3c3}'..='\u{3c9}',
    '\u{2014}'..='\u{2014}',
    '\u{2018}'..='\u{2019}',
    '\u{201c}'..='\u{201d}',
    '\u{2026}'..='\u{2026}',
    '\u{2103}'..='\u{2103}',
    '\u{2264}'..='\u{2265}',
    '\u{3000}'..='\u{3002}',
    '\u{3008}'..='\u{3011}',
    '\u{4e00}'..='\u{9fa5}',
    '\u{ff01}'..='\u{ff5e}',
];

impl CommentCharacters {
    /// Whether comments may contain this character.
    pub fn has(self, c: char) -> bool {
        c.is_ascii()
            || match self {
                CommentCharacters::Ascii => false,
                CommentCharacters::Gbk => GBK.iter().any(|range| range.contains(&c)),
                CommentCharacters::Utf8 => !c.is_control(),
            }
    }

    /// Bytes of a character.
    pub fn width(self, c: char) -> usize {
        match self {
            CommentCharacters::Gbk if !c.is_ascii() => 2,
            _ => c.len_utf8(),
        }
    }

    /// Bytes of a text.
    pub fn length(self, text: &str) -> usize {
        if text.is_ascii() { text.len() } else { text.chars().map(|c| self.width(c)).sum() }
    }
}
