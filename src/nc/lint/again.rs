//! Words and codes of a block that another one of the same block overrides.

use super::super::ast::{Block, Word};
use super::context::Lint;
use crate::controls::{Address, AddressSet, Code, CodeDef, Group};
use crate::msg;
use crate::text::Fix;

/// Maximum words reported.
pub(super) const REPORTED_WORDS: usize = 20;

/// Words of a block that may override each other.
#[derive(Clone, Copy)]
pub(super) struct Rivals {
    /// Addresses whose values overwrite each other in a block.
    addresses: AddressSet,
    /// Addresses of incremental words beside an absolute one of the same axis: U for X.
    incremental: AddressSet,
    /// Whether the later of two codes of one group counts, without an alarm.
    codes: bool,
}

impl Rivals {
    /// The rivals on a control. The reader reports those that are an alarm.
    pub(super) fn new(lint: &Lint) -> Rivals {
        let control = lint.control;
        if control.syntax.names().is_some() {
            return Rivals { addresses: AddressSet::EMPTY, incremental: AddressSet::EMPTY, codes: false };
        }
        let addresses = if control.syntax.address_twice {
            AddressSet::EMPTY
        } else {
            control.axis_letters().chain([Address::F, Address::S, Address::T]).collect()
        };
        Rivals {
            addresses,
            incremental: control.axes.iter().filter_map(|axis| axis.incremental).collect(),
            codes: true,
        }
    }

    /// Whether the values of an address overwrite each other in a block.
    #[inline]
    pub(super) fn overwrites(self, letter: Address) -> bool {
        self.addresses.contains(letter)
    }

    /// Whether a block with these letters, and with this number of codes, has to be checked.
    #[inline]
    pub(super) fn may_meet(self, letters: AddressSet, codes: u32) -> bool {
        self.codes && codes > 1 || !letters.and(self.incremental).is_empty()
    }
}

impl Lint<'_> {
    /// Whether a further word may be reported. A block with a `/` in its middle may repeat a word on purpose.
    fn reports_again(&self, words: &[Word]) -> bool {
        self.again < REPORTED_WORDS && words.iter().all(|word| word.letter != Address::Skip)
    }

    /// Reports the second word of an address in a block.
    #[cold]
    pub(super) fn word_again(&mut self, at: u32, block: &Block, words: &[Word], rivals: Rivals) {
        if !self.reports_again(words) {
            return;
        }
        for (index, word) in words.iter().enumerate() {
            let earlier = words.iter().take(index).rfind(|other| other.letter == word.letter);
            if let Some(earlier) = earlier.filter(|_| rivals.overwrites(word.letter)) {
                self.again += 1;
                let earlier = self.parsed.text(self.place(at, earlier.span(block)));
                let (place, word) = self.written(at, word.span(block));
                self.warn(place, msg!("lint.word-again", word, earlier));
            }
        }
    }

    /// Reports an absolute and an incremental word of one axis, two codes of one group, and a fixed cycle beside a code of motion.
    #[cold]
    pub(super) fn rivals(&mut self, at: u32, block: &Block, words: &[Word]) {
        if !self.reports_again(words) {
            return;
        }
        let control = self.control;
        for axis in control.axes {
            let with = |letter| words.iter().rposition(|word| word.letter == letter);
            let (Some(absolute), Some(relative)) = (with(axis.letter), axis.incremental.and_then(with)) else {
                continue;
            };
            let relative_counts = relative > absolute && !control.syntax.absolute_holds;
            let (lost, kept) = if relative_counts { (absolute, relative) } else { (relative, absolute) };
            let (Some(lost), Some(kept)) = (words.get(lost), words.get(kept)) else { continue };
            let kept = self.written(at, kept.span(block)).1;
            let (place, word) = self.written(at, lost.span(block));
            self.again += 1;
            self.warn(place, msg!("lint.axis-again", word, kept, axis = axis.letter.to_string()));
        }
        let rows = words.iter().filter(|word| word.letter == Address::G).filter_map(|word| {
            let row = self.parsed.codes().row_of(word)?;
            self.parsed.codes().call_of(word).is_none().then_some((word, row))
        });
        let rows: Vec<(&Word, &CodeDef)> = rows.collect();
        for (index, &(word, row)) in rows.iter().enumerate() {
            let same = |other: &&(&Word, &CodeDef)| other.1.group == row.group && other.1.id != row.id;
            if let Some(&(earlier, _)) = rows.iter().take(index).rfind(same).filter(|_| is_modal(row.group)) {
                self.again += 1;
                let earlier = self.written(at, earlier.span(block)).1;
                let (place, code) = self.written(at, word.span(block));
                self.warn(place, msg!("lint.code-again", code, earlier));
            }
        }
        // `G00 G81` runs the cycle: the later code counts.
        let cycle = rows.iter().position(|row| row.1.group == Group::Cycle && row.1.code != Code::Cancel);
        let behind = cycle.and_then(|at| rows.get(at..)).unwrap_or_default();
        let motion = behind.iter().find(|row| row.1.group == Group::Motion);
        if let (Some(&(cycle, _)), Some(&(motion, _))) = (behind.first(), motion) {
            self.again += 1;
            let cycle = self.written(at, cycle.span(block)).1;
            let (place, code) = self.written(at, motion.span(block));
            let title = msg!("nc.fix.drop", text = code);
            if let Some(finding) = self.warn(place, msg!("lint.cycle-ended", code, cycle)) {
                finding.fixes.push(Fix { title, edits: vec![(place, String::new())] });
            }
        }
    }
}

/// Whether a code of the group stays in force until another one of it.
fn is_modal(group: Group) -> bool {
    !matches!(group, Group::OneShot | Group::MacroModal | Group::Spindle | Group::Flow | Group::Other)
}
