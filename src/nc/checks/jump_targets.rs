//! Index of the possible jump targets of one program: labels, block numbers, and names in blocks that do not parse.

use std::collections::{BTreeMap, BTreeSet};

use crate::controls::Control;
use crate::nc::ast::{Block, Deck, JumpDirection, Stmt};
use crate::nc::block_index::{SequenceNumbers, labels_of};
use crate::nc::dec::Dec;
use crate::nc::unread;

/// Jump targets of one program. Each part is built on first use; a look-up takes logarithmic time.
pub(super) struct JumpTargets<'a> {
    deck: &'a Deck,
    control: &'a Control,
    blocks: &'a [Block],
    /// Text of the program's file.
    text: &'a str,
    numbers: Option<SequenceNumbers>,
    labels: Option<BTreeMap<&'a str, Vec<usize>>>,
    /// Names in blocks that do not parse, in capitals.
    unread: Option<BTreeSet<String>>,
}

impl<'a> JumpTargets<'a> {
    pub(super) fn new(deck: &'a Deck, control: &'a Control, blocks: &'a [Block], text: &'a str) -> JumpTargets<'a> {
        JumpTargets { deck, control, blocks, text, numbers: None, labels: None, unread: None }
    }

    /// The blocks with a number.
    fn numbered(&mut self, number: u32) -> &[(u32, u32)] {
        self.numbers.get_or_insert_with(|| SequenceNumbers::new(self.blocks, 0)).of(number)
    }

    /// Whether a block of the program has this number.
    pub(super) fn has_number(&mut self, number: Dec) -> bool {
        let value = number.to_f64();
        value.fract() == 0.0 && value >= 0.0 && !self.numbered(value as u32).is_empty()
    }

    /// Whether a jump in block `from` reaches a block with this number.
    pub(super) fn number_on_way(&mut self, number: i64, from: usize, way: JumpDirection) -> bool {
        let Ok(number) = u32::try_from(number) else { return false };
        let ends = self.numbered(number);
        ends.first().into_iter().chain(ends.last()).any(|row| way.reaches(from, row.1 as usize))
    }

    /// All labels, each with its blocks.
    pub(super) fn labels(&mut self) -> &BTreeMap<&'a str, Vec<usize>> {
        self.labels.get_or_insert_with(|| labels_of(self.deck, self.blocks))
    }

    /// Whether the program has a label, and whether a jump in block `from` reaches it.
    pub(super) fn label_on_way(&mut self, name: &str, from: usize, way: JumpDirection) -> (bool, bool) {
        let places = self.labels().get(name).map_or(&[][..], Vec::as_slice);
        let reached = places.first().into_iter().chain(places.last()).any(|&to| way.reaches(from, to));
        (!places.is_empty(), reached)
    }

    /// Whether a block that does not parse contains this name, in capitals, outside comments.
    pub(super) fn is_in_unread_block(&mut self, name: &str) -> bool {
        let unread = self.unread.get_or_insert_with(|| {
            let bad = self.blocks.iter().filter(|block| matches!(block.stmt, Stmt::Bad(_)));
            bad.flat_map(|block| unread::names(block.span.of(self.text), self.control)).collect()
        });
        unread.contains(name)
    }
}
