//! Cuts behind a change of the unit of F without a new F, on a control that keeps the number of the feed.

use super::super::ast::{Block, Stmt, Word};
use super::context::Lint;
use super::roles::{CALL, CURVED, DWELL, END, LINEAR, OTHER_FEED, PER_MINUTE, RAPID, RETURN, SPECIAL, SUB};
use crate::controls::{Address, Code};
use crate::msg;
use crate::text::Span;

/// Motion in force, as far as F concerns it.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
enum FeedUse {
    /// Not known.
    #[default]
    Unknown,
    /// Rapid traverse: F is stored for the cuts behind it.
    Rapid,
    /// A line or an arc at F.
    Cut,
    /// A thread, whose F is its lead.
    Thread,
}

/// Unit and last F of the present program, followed from block to block.
#[derive(Default)]
pub(super) struct FeedUnit {
    /// Feed is per revolution; `None` where unknown.
    per_revolution: Option<bool>,
    /// The last F, with its block, and whether it was per revolution.
    feed: Option<(u32, Span, bool)>,
    motion: FeedUse,
    /// The program has its warning.
    reported: bool,
}

impl FeedUnit {
    /// Starts a program; a main program starts with the unit after power-on.
    pub(super) fn program(&mut self, lint: &Lint, index: u32) {
        let main = match lint.start {
            Some(number) => lint.programs.number(number) == Some(index),
            None => index == 0,
        };
        let mut startup = lint.parsed.dialect().startup.iter().filter_map(|id| lint.control.code(*id));
        let per_revolution = startup.find_map(|row| unit_of(row.code)).filter(|_| main);
        *self = FeedUnit { per_revolution, ..FeedUnit::default() };
    }

    /// Forgets unit and feed behind a statement that may go elsewhere.
    pub(super) fn statement(&mut self, stmt: Stmt) {
        if !matches!(stmt, Stmt::Empty | Stmt::Assign { .. } | Stmt::Assigns { .. } | Stmt::Message(_)) {
            self.forget();
        }
    }

    fn forget(&mut self) {
        (self.per_revolution, self.feed, self.motion) = (None, None, FeedUse::Unknown);
    }

    /// Follows a block of words and reports the first cut of the program with a feed in the other unit.
    #[inline]
    pub(super) fn block(&mut self, lint: &mut Lint, (at, block): (u32, &Block), words: &[Word], bits: u32) {
        if lint.control.limits.feed_kept {
            self.follow(lint, (at, block), words, bits);
        }
    }

    #[cold]
    fn follow(&mut self, lint: &mut Lint, (at, block): (u32, &Block), words: &[Word], bits: u32) {
        if bits & (CALL | SUB | RETURN | END) != 0 {
            return self.forget();
        }
        let codes = lint.parsed.codes();
        let mut rows = words.iter().filter_map(|word| codes.row_of(word)).map(|row| row.code);
        if bits & (PER_MINUTE | OTHER_FEED) != 0 {
            self.per_revolution = rows.clone().filter_map(unit_of).next_back();
        }
        if bits & (RAPID | LINEAR | CURVED) != 0 {
            let arc = rows.any(|code| matches!(code, Code::ArcCw | Code::ArcCcw));
            self.motion = if arc || bits & LINEAR != 0 {
                FeedUse::Cut
            } else if bits & CURVED != 0 {
                FeedUse::Thread
            } else {
                FeedUse::Rapid
            };
        }
        if bits & (DWELL | SPECIAL) != 0 {
            return;
        }
        let feed = words.iter().find(|word| word.letter == Address::F);
        if let Some(word) = feed.filter(|_| self.motion != FeedUse::Thread) {
            self.feed = self.per_revolution.map(|unit| (at, word.span(block), unit));
        }
        let axis = words.iter().find(|word| lint.control.is_axis(word.letter));
        if let (Some((given, span, before)), Some(now), Some(axis)) = (self.feed, self.per_revolution, axis)
            && self.motion == FeedUse::Cut
            && before != now
            && !self.reported
        {
            self.reported = true;
            let code = |unit: bool| {
                let row = lint.control.codes.iter().find(|row| unit_of(row.code) == Some(unit));
                row.map_or_else(String::new, |row| lint.control.code_name(row.id))
            };
            let (place, word) = lint.written(at, axis.span(block));
            let feed = lint.written(given, span).1;
            lint.warn(place, msg!("lint.feed-unit-changed", word, feed, before = code(before), now = code(now)));
        }
    }
}

/// Whether a code sets the feed per revolution, or per minute.
fn unit_of(code: Code) -> Option<bool> {
    match code {
        Code::FeedPerMinute => Some(false),
        Code::FeedPerRevolution => Some(true),
        _ => None,
    }
}
