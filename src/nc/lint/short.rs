//! Blocks with constant length and feed that end before the control has read the next block.

use crate::controls::Address;
use crate::controls::AddressSet;
use crate::msg;
use std::rc::Rc;

use super::super::ast::{Block, Stmt, Word};
use super::context::{Lint, measure};
use super::roles::{
    ABSOLUTE, AUXILIARY, CALL, CURVED, CUTTING, DWELL, EXACT, INCREMENTAL, LINEAR, OTHER_FEED, PER_MINUTE, RAPID,
    RETURN, SPECIAL, SPINDLE, SPINDLE_REST, STOP, SUB,
};
use crate::controls::{Control, Dialect};
use crate::text::{DiagnosticKind, Span};

/// Codes that stop the path, or after which the codes in force are unknown.
const BREAKS: u32 =
    CURVED | RAPID | EXACT | DWELL | CALL | SUB | RETURN | STOP | SPECIAL | SPINDLE | SPINDLE_REST | AUXILIARY;

/// Codes that have to be in force for short blocks.
const NEEDED: u32 = LINEAR | INCREMENTAL | PER_MINUTE | CUTTING;

/// Motion state at a block.
pub(super) struct Short {
    control: &'static Control,
    increments: AddressSet,
    /// Dialect of the control, for the axes that count diameters.
    dialect: Rc<Dialect>,
    /// Codes of [`NEEDED`] in force.
    modes: u32,
    /// Shortest length (mm) that a block needs at the feed in force, and the fastest feed of any axis (mm/min).
    limit: f64,
    fastest: f64,
    /// Number of short blocks in a row, and whether nothing else has moved since the last DO.
    run: u32,
    in_loop: bool,
    /// First block of the present row with its seconds, and the same for the first reported row.
    first: (u32, Span, f64),
    reported: (u32, Span, f64),
    count: u32,
}

impl Short {
    pub(super) fn new(lint: &Lint, increments: AddressSet) -> Short {
        let fastest = lint.control.bench.axes.iter().fold(0.0, |fastest, axis| axis.clamp.max(fastest));
        let none = (0, Span::default(), 0.0);
        let (run, count, in_loop) = (0, 0, false);
        let modes = PER_MINUTE | CUTTING;
        Short {
            control: lint.control,
            increments,
            dialect: Rc::clone(lint.parsed.dialect()),
            modes,
            limit: 0.0,
            fastest,
            run,
            in_loop,
            first: none,
            reported: none,
            count,
        }
    }

    fn value(&self, word: &Word) -> Option<f64> {
        measure(word, self.increments, self.control.limits.increment)
    }

    /// Records a block that only computes or jumps.
    pub(super) fn macro_block(&mut self, stmt: &Stmt) {
        match stmt {
            Stmt::Assign { .. } | Stmt::Assigns { .. } | Stmt::Message(_) | Stmt::IfThen { .. } | Stmt::Empty => {}
            Stmt::While { .. } => {
                self.end_run(false);
                self.in_loop = true;
            }
            Stmt::End { .. } => self.end_run(self.in_loop),
            _ => self.end_run(false),
        }
    }

    /// Ends a row of short blocks. It counts if a loop repeats it, or if it is longer than the control's read-ahead.
    fn end_run(&mut self, repeated: bool) {
        if self.run > u32::from(self.control.timing.preread) || repeated && self.run > 0 {
            if self.count == 0 {
                self.reported = self.first;
            }
            self.count += self.run;
        }
        self.run = 0;
        self.in_loop = false;
    }

    /// Records a block of words, with its index.
    #[inline]
    pub(super) fn block(&mut self, (at, block): (u32, &Block), words: &[Word], bits: u32) {
        self.modes |= bits & NEEDED;
        if bits & (ABSOLUTE | OTHER_FEED | BREAKS) != 0 {
            self.stop(bits);
        }
        let (mut square, mut moves, mut certain) = (0.0, false, self.modes | INCREMENTAL == NEEDED);
        let axes = self.control.axes;
        for word in words {
            if word.letter == Address::F {
                // Millimetres = mm/min * s / 60.
                let feed = self.value(word).map_or(0.0, |feed| feed.min(self.fastest));
                self.limit = feed * self.control.timing.block / 60.0;
            } else if let Some((at, axis)) = axes
                .iter()
                .enumerate()
                .find(|(_, axis)| axis.letter == word.letter || axis.incremental == Some(word.letter))
            {
                moves = true;
                certain &= self.modes & INCREMENTAL != 0 || axis.letter != word.letter;
                let scale = 1.0 / self.dialect.words_per_mm(at);
                match self.value(word) {
                    Some(length) => square += length * length * scale * scale,
                    None => certain = false,
                }
            }
        }
        // Compared as squares, without a square root.
        if certain && square > 0.0 && square < self.limit * self.limit {
            if self.run == 0 {
                self.first = (at, block.span, square.sqrt() / self.limit * self.control.timing.block);
            }
            self.run += 1;
        } else if moves {
            self.end_run(false);
        }
    }

    #[cold]
    fn stop(&mut self, bits: u32) {
        let lost = [
            (ABSOLUTE, INCREMENTAL),
            (OTHER_FEED, PER_MINUTE),
            (EXACT, CUTTING),
            (RAPID | CURVED | SPECIAL | CALL | SUB, LINEAR),
        ];
        for (code, mode) in lost {
            if bits & code != 0 {
                self.modes &= !mode;
            }
        }
        self.end_run(false);
    }

    pub(super) fn report(mut self, lint: &mut Lint) {
        self.end_run(false);
        if self.count > 0 {
            let (block, span, time) = self.reported;
            let (place, _) = lint.written(block, span);
            let (time, needed) = ((time * 1e3, 1), (self.control.timing.block * 1e3, 1));
            if let Some(finding) = lint.warn(place, msg!("lint.short-blocks", time, needed, count = self.count)) {
                finding.kind = DiagnosticKind::ShortBlocks;
            }
        }
    }
}
