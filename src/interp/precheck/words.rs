//! Pre-check of blocks of words: values out of range, calls and functions with constant words.

use std::mem;

use super::super::context::BlockContext;
use super::super::state::RunState;
use super::check::Precheck;
use super::clean::{Clean, is_code};
use crate::controls::{Address, Alarm};
use crate::nc::{Block, Dec, Word, WordValue};
use crate::text::{Diagnostic, DiagnosticKind, Place};

/// Alarms of executing a block of words that do not depend on the run.
const ALWAYS: &[Alarm] = &[
    Alarm::RepeatRange,
    Alarm::NoCallProgram,
    Alarm::OwnCall,
    Alarm::SpindleAngle,
    Alarm::SurfaceRange,
    // `G65 H` functions.
    Alarm::DivisionByZero,
    Alarm::Calculation,
    Alarm::SquareRoot,
    Alarm::Tangent,
    Alarm::Overflow,
    Alarm::NotWhole,
    Alarm::ReadOnly,
    Alarm::VacantWritten,
];
/// Further such alarms of a block with a constant P.
const WITH_CONSTANT_P: &[Alarm] = &[Alarm::JumpNumber];
/// Further such alarms of a block with a sequence number in H. P of a return is a block number of the calling program.
const WITH_SEQUENCE_IN_H: &[Alarm] = &[Alarm::NoSequence];

impl Precheck<'_> {
    /// Checks the words of a block.
    pub(super) fn block_words(&mut self, at: u32, block: &Block, words: &[Word]) {
        // Cached block: its codes are already in force, and its numbers are in ranges without findings.
        if self.clean.len() == words.len() && self.clean.iter().zip(words).all(|(clean, word)| clean.holds(word)) {
            return;
        }
        let before = mem::take(&mut self.clean);
        let (mut all, mut codes, mut results) = (true, true, true);
        for word in words.iter().filter(|word| !self.is_known(word)) {
            all = false;
            codes &= !is_code(word);
            results &= word.letter == Address::P;
        }
        // A calculated code may change the meaning of the other words.
        if !codes {
            return;
        }
        let constant: Vec<Word>;
        let known = if all {
            words
        } else {
            constant = words.iter().filter(|word| self.is_known(word)).copied().collect();
            &constant
        };
        self.heard.take();
        let read = self.state.read_words(&mut self.cx, block, known);
        let heard = self.heard.take();
        let quiet = heard.is_empty();
        if all && read.is_ok() && !quiet {
            self.remarked(block, words, heard);
        }
        match read {
            Ok(None) => {}
            Ok(Some(calls)) => {
                if all && words.iter().any(|word| word.letter == Address::Q) {
                    self.contour(at, block, words);
                }
                // P of a function is its result variable.
                let function = !all && results && calls && self.state.is_function(&self.cx, words);
                let spindle = || words.iter().any(|word| matches!(word.letter, Address::S | Address::Spos));
                if function || all && (calls || spindle()) {
                    self.executed(at, block, words, all);
                } else if all && quiet {
                    self.note_clean(words, before);
                }
            }
            Err(_) => self.faulty_words(block, known),
        }
    }

    /// Alarms of executing a block of constant words; `all` where P is constant too.
    fn executed(&mut self, at: u32, block: &Block, words: &[Word], all: bool) {
        let sequence = all && words.iter().any(|word| word.letter == Address::H);
        let with_p = if all { WITH_CONSTANT_P } else { &[] };
        let with_h = if sequence { WITH_SEQUENCE_IN_H } else { &[] };
        let alarms = [ALWAYS, with_p, with_h].concat();
        let finding = self.always(block, &alarms, &mut |state, cx| state.execute_words(cx, at, block, words));
        self.note(finding);
    }

    /// Alarms of words that cannot be read: of all words together, and of each word with the codes of the block.
    fn faulty_words(&mut self, block: &Block, known: &[Word]) {
        let mut together = |state: &mut RunState, cx: &mut BlockContext| state.read_words(cx, block, known).map(|_| ());
        let finding = self.always(block, &[Alarm::ArgumentSets, Alarm::Auxiliaries], &mut together);
        self.note(finding);
        for (at, word) in known.iter().enumerate() {
            let alone = known.iter().enumerate().filter(|row| row.0 == at || is_code(row.1));
            let alone: Vec<Word> = alone.map(|row| *row.1).collect();
            let span = word.span(block);
            let finding = self.always(block, &[], &mut |state, cx| state.read_words(cx, block, &alone).map(|_| ()));
            let inside = |place: Place| span.start <= place.span.start && place.span.end <= span.end;
            self.note(finding.filter(|finding| finding.place.is_some_and(inside)));
        }
    }

    /// Caches a block without findings; `before` is the preceding cache.
    fn note_clean(&mut self, words: &[Word], before: Vec<Clean>) {
        self.clean = before;
        if self.clean.len() != words.len() || !self.clean.iter().zip(words).all(|(clean, word)| clean.is_like(word)) {
            self.clean.clear();
        }
        for (at, word) in words.iter().enumerate() {
            let WordValue::Number(Dec { mantissa, .. }) = word.value else { return self.clean.clear() };
            match self.clean.get_mut(at) {
                Some(clean) => (clean.least, clean.most) = (clean.least.min(mantissa), clean.most.max(mantissa)),
                None => {
                    let ranges = matches!(word.letter, Address::F | Address::I | Address::J | Address::K)
                        || self.cx.shared.index.axis(word.letter).is_some();
                    self.clean.push(Clean { word: *word, least: mantissa, most: mantissa, ranges });
                }
            }
        }
    }

    /// Warns about the contour skipped by a cycle that is not simulated.
    fn contour(&mut self, at: u32, block: &Block, words: &[Word]) {
        // Other outcomes depend on the state.
        let outcome = self.state.clone().execute_words(&mut self.cx, at, block, words);
        self.report(block, outcome, &[Alarm::NoContour]);
        self.found.extend(self.heard.take().into_iter().filter(|remark| remark.kind == DiagnosticKind::Contour));
    }

    /// Warnings common to all modal states.
    fn remarked(&mut self, block: &Block, words: &[Word], mut heard: Vec<Diagnostic>) {
        for modal in &self.modals {
            let mut state = self.state.clone();
            state.modal.clone_from(modal);
            if state.read_words(&mut self.cx, block, words).is_err() {
                return;
            }
            let others = self.heard.take();
            heard.retain(|remark| others.contains(remark));
        }
        self.found.append(&mut heard);
    }
}
