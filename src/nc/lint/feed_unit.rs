//! Cuts behind a change of the unit of F without a new F: by a feed in the other unit where the control keeps its number, else without feed.

use super::super::ast::{Block, Stmt, Word};
use super::context::Lint;
use super::roles::{CALL, CURVED, DWELL, END, LINEAR, OTHER_FEED, PER_MINUTE, RAPID, RETURN, SPECIAL, SUB};
use crate::controls::{Address, Alarm, Code, CodeDef, CodeId, Group};
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
    /// The code that set the unit; none where it is the one after power-on.
    set_by: Option<CodeId>,
    /// The last F, with its block, and whether it was per revolution.
    feed: Option<(u32, Span, bool)>,
    /// The last F, lost by a change of its unit on a control that does not keep it.
    lost: Option<(u32, Span, bool)>,
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
        *self = FeedUnit { reported: self.reported, ..FeedUnit::default() };
    }

    /// Sets the unit of F, `None` where unknown. A known change loses F on a control that does not keep it.
    fn set_unit(&mut self, now: Option<bool>, kept: bool) {
        if now != self.per_revolution && !kept {
            let known = now.is_some() && self.per_revolution.is_some();
            self.lost = self.feed.or(self.lost).filter(|_| known);
            self.feed = None;
        }
        self.per_revolution = now;
    }

    /// Follows a block of words and reports the first cut of the program with a feed in the other unit, or with a lost one.
    #[inline]
    pub(super) fn block(&mut self, lint: &mut Lint, (at, block): (u32, &Block), words: &[Word], bits: u32) {
        if bits & (CALL | SUB | RETURN | END) != 0 {
            return self.forget();
        }
        if bits & (PER_MINUTE | OTHER_FEED) != 0 {
            self.units(lint, block, words);
        }
        if bits & (RAPID | LINEAR | CURVED) != 0 {
            let mut rows = words.iter().filter_map(|word| lint.parsed.codes().row_of(word));
            let arc = rows.any(|row| matches!(row.code, Code::ArcCw | Code::ArcCcw));
            self.motion = if arc || bits & LINEAR != 0 {
                FeedUse::Cut
            } else if bits & CURVED != 0 {
                FeedUse::Thread
            } else {
                FeedUse::Rapid
            };
        }
        if bits & DWELL != 0 {
            return;
        }
        let feed = words.iter().find(|word| word.letter == Address::F);
        if let Some(word) = feed.filter(|_| self.motion != FeedUse::Thread) {
            self.feed = self.per_revolution.map(|unit| (at, word.span(block), unit)).filter(|_| bits & SPECIAL == 0);
            self.lost = None;
        }
        if self.motion == FeedUse::Cut && bits & SPECIAL == 0 && !self.reported {
            self.cut(lint, (at, block), words);
        }
    }

    /// Follows the codes of the unit of F. One that a block skip may leave out makes the unit unknown.
    #[cold]
    fn units(&mut self, lint: &Lint, block: &Block, words: &[Word]) {
        let rows = words.iter().filter_map(|word| lint.parsed.codes().row_of(word));
        let skips = block.skip > 0 || words.iter().any(|word| word.letter == Address::Skip);
        let present = self.per_revolution;
        let changed = rows.filter_map(|row| Some((row.id, unit_after(row, present)?))).next_back().filter(|_| !skips);
        let now = changed.map(|row| row.1);
        if now != present {
            self.set_by = changed.map(|row| row.0);
        }
        self.set_unit(now, lint.control.limits.feed_kept);
    }

    /// Reports a cut with a feed in another unit than the one in force, or with a lost one.
    fn cut(&mut self, lint: &mut Lint, (at, block): (u32, &Block), words: &[Word]) {
        let Some(now) = self.per_revolution else { return };
        let kept = self.feed.filter(|feed| feed.2 != now);
        let Some((given, span, before)) = kept.or(self.lost) else { return };
        let Some(axis) = words.iter().find(|word| lint.control.is_axis(word.letter)) else { return };
        self.reported = true;
        let code = |unit: bool| {
            let row = lint.control.codes.iter().find(|row| unit_of(row.code) == Some(unit));
            row.map_or_else(String::new, |row| lint.control.code_name(row.id))
        };
        let now = self.set_by.map_or_else(|| code(now), |id| lint.control.code_name(id));
        let before = code(before);
        let (place, word) = lint.written(at, axis.span(block));
        let feed = lint.written(given, span).1;
        let message = match kept {
            Some(_) => msg!("lint.feed-unit-changed", word, feed, before, now),
            None => {
                let alarm = lint.control.alarm_number(Alarm::NoFeed).unwrap_or("");
                msg!("lint.feed-lost", word, feed, now, alarm)
            }
        };
        lint.warn(place, message);
    }
}

/// Unit of the feed behind a code: per revolution or per minute. Where the codes of the surface speed belong to its group, G96 makes it per
/// revolution, and G97 leaves it as it is.
fn unit_after(row: &CodeDef, present: Option<bool>) -> Option<bool> {
    match row.code {
        Code::SurfaceSpeed if row.group == Group::FeedUnit => Some(true),
        Code::SurfaceSpeedOff if row.group == Group::FeedUnit => present,
        code => unit_of(code),
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
