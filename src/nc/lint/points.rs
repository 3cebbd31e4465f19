//! Numbers without a decimal point that count increments, in programs not evidently written in increments.

use super::super::ast::{Block, Word, WordValue};
use super::super::dec::Dec;
use super::context::Lint;
use super::roles::{CALL, DWELL, INCH, SPECIAL};
use crate::controls::{Address, AddressSet};
use crate::msg;
use crate::text::Span;
use crate::text::catalog::number_text;

/// Maximum places of one kind in one fix.
const PLACES: usize = 1000;

/// Size (increments of 0.001 mm) from which a number without a point is intended: a forgotten point would make it ten metres, and programs
/// in increments have lengths of a centimetre.
const DELIBERATE: u64 = 10_000;

/// Size (increments) from which a dwell without a point is intended.
const DELIBERATE_DWELL: u64 = 100;

/// Numbers of one kind after one letter, without a decimal point.
struct Pointless {
    kind: u32,
    letter: Address,
    count: usize,
    block: u32,
    words: Vec<(Span, Dec)>,
}

/// Numbers without a decimal point of one program.
pub(super) struct Points {
    /// Addresses that count increments: in dimensions, and in macro arguments.
    increments: [AddressSet; 2],
    rows: Vec<Pointless>,
    /// The program is evidently in increments, or in inches, which are not checked.
    deliberate: bool,
}

impl Points {
    pub(super) fn new(increments: [AddressSet; 2]) -> Points {
        Points { increments, rows: Vec::new(), deliberate: false }
    }

    /// Whether a number of a dimension has no decimal point.
    #[inline]
    pub(super) fn counts(&self, letter: Address, number: Dec) -> bool {
        !number.point && number.mantissa != 0 && self.increments[0].contains(letter)
    }

    /// Records a block; `counts` if a number of a dimension has no decimal point.
    #[inline]
    pub(super) fn block(&mut self, at: u32, block: &Block, words: &[Word], bits: u32, counts: bool) {
        self.deliberate |= bits & INCH != 0;
        if counts && !self.deliberate && bits & SPECIAL == 0 {
            let increments = self.increments[usize::from(bits & CALL != 0)];
            self.deliberate = collect(&mut self.rows, at, block, words, bits & (CALL | DWELL), increments);
        }
    }

    /// Reports the numbers of the program, one warning for each address and kind.
    pub(super) fn report(&self, lint: &mut Lint) {
        self.rows.iter().filter(|_| !self.deliberate).for_each(|row| row.report(lint));
    }
}

/// Records the numbers without a decimal point of a block; returns whether one shows that the program is in increments.
#[cold]
fn collect(
    rows: &mut Vec<Pointless>,
    at: u32,
    block: &Block,
    words: &[Word],
    kind: u32,
    increments: AddressSet,
) -> bool {
    for word in words {
        let WordValue::Number(dec) = word.value else { continue };
        let letter = word.letter;
        let size = dec.mantissa.unsigned_abs();
        if dec.point || size == 0 || !increments.contains(letter) || kind == DWELL && size >= DELIBERATE_DWELL {
            continue;
        }
        if size >= DELIBERATE {
            return true;
        }
        let known = rows.iter().position(|row| row.kind == kind && row.letter == letter);
        if known.is_none() {
            rows.push(Pointless { kind, letter, count: 0, block: at, words: Vec::new() });
        }
        if let Some(row) = known.map_or(rows.len().checked_sub(1), Some).and_then(|at| rows.get_mut(at)) {
            row.count += 1;
            if row.count <= PLACES {
                row.words.push((word.span(block), dec));
            }
        }
    }
    false
}

impl Pointless {
    fn report(&self, lint: &mut Lint) {
        let Some(&(span, dec)) = self.words.first() else { return };
        let step = lint.control.limits.increment;
        let letter = self.letter.to_string();
        let rotary = lint.control.axis(self.letter).is_some_and(|axis| lint.control.axes[axis].rotary);
        let (place, word) = lint.written(self.block, span);
        let (value, count, address) = ((dec.to_f64() * step, 6), self.count as u32, letter.as_str());
        let message = match self.kind {
            DWELL => msg!("lint.no-point-dwell", word, time = value, count),
            CALL => msg!("lint.no-point-argument", word, value, count, address),
            _ => msg!("lint.no-point", word, value, unit = if rotary { "°" } else { "mm" }, count, address),
        };
        lint.warn(place, message);
        let meant = |dec: Dec| format!("{letter}{}", Dec { point: true, ..dec });
        if self.count == self.words.len() {
            lint.fix(msg!("nc.fix.point", word = meant(dec)), &self.words, &meant);
            // Fix to the present meaning: the control's increments are thousandths.
            let present = |dec: Dec| format!("{letter}{}", number_text(dec.to_f64() * step, 9));
            lint.fix(msg!("nc.fix.present", word = present(dec)), &self.words, &present);
        }
    }
}
