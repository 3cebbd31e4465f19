//! Index of a program's blocks by sequence number and by label, for jumps and calls.

use std::collections::BTreeMap;

use super::ast::{Block, Deck, JumpDirection};

/// The numbered blocks of a program.
#[derive(Debug, Default)]
pub(crate) struct SequenceNumbers {
    /// (number, block), sorted.
    rows: Vec<(u32, u32)>,
}

impl SequenceNumbers {
    /// The numbers of `blocks`, whose indices count from `first`.
    pub(crate) fn new(blocks: &[Block], first: u32) -> SequenceNumbers {
        let numbered = (first..).zip(blocks).filter_map(|(at, block)| Some((block.number?, at)));
        let mut rows: Vec<(u32, u32)> = numbered.collect();
        rows.sort_unstable();
        SequenceNumbers { rows }
    }

    /// All numbers with their blocks, sorted.
    pub(super) fn all(&self) -> &[(u32, u32)] {
        &self.rows
    }

    /// A number with its blocks in rising order.
    pub(super) fn of(&self, number: u32) -> &[(u32, u32)] {
        let start = self.rows.partition_point(|row| row.0 < number);
        let end = self.rows.partition_point(|row| row.0 <= number);
        self.rows.get(start..end).unwrap_or_default()
    }

    /// The block with a number: searched from block `from` to the end of the program, then from its start.
    pub(crate) fn find(&self, number: u32, from: u32) -> Option<u32> {
        let first_from = |block: u32| {
            let at = self.rows.partition_point(|&row| row < (number, block));
            self.rows.get(at).filter(|row| row.0 == number).map(|row| row.1)
        };
        first_from(from).or_else(|| first_from(0))
    }

    /// Target of a jump in block `from` to a number.
    pub(crate) fn target(&self, number: u32, from: u32, way: JumpDirection) -> Option<u32> {
        let rows = self.of(number);
        let after = rows.partition_point(|row| row.1 <= from);
        rows.get(way.choice(after, rows.len())?).map(|row| row.1)
    }
}

/// Blocks of each label, rising, by their indices in `blocks`.
pub(crate) fn labels_of<'a>(deck: &'a Deck, blocks: &[Block]) -> BTreeMap<&'a str, Vec<usize>> {
    let mut labels: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (at, block) in blocks.iter().enumerate().filter(|(_, block)| block.label.is_some()) {
        labels.entry(deck.text(block.label)).or_default().push(at);
    }
    labels
}
