//! Feeds: F0, cuts without any F, and feeds of an unlikely size for their unit.

use super::super::ast::{Block, Word};
use super::super::dec::Dec;
use super::context::Lint;
use super::facts::Facts;
use super::roles::{CALL, CURVED, DWELL, INCH, LINEAR, OTHER_FEED, PER_MINUTE, RAPID, Roles, SPECIAL};
use crate::controls::{Address, AddressSet, Alarm, Code, ParamRole};
use crate::msg;
use crate::text::Span;

/// Maximum feeds in one fix.
const PLACES: usize = 1000;

/// Feed per minute (mm/min) below which a feed per revolution is assumed, because cuts this slow do not occur.
const SLOWEST: f64 = 2.0;

/// Feed per revolution (mm) above which a feed per minute is assumed.
const COARSEST: f64 = 20.0;

/// Feeds of all programs.
#[derive(Default)]
pub(super) struct Feeds {
    /// A block has an F word, or does not parse and may have one.
    any: bool,
    /// The first code of a cutting motion, with its block.
    first_cut: Option<(u32, Span)>,
    /// A code sets the unit of F, or a block that does not parse may do so.
    has_unit: bool,
    /// Feeds of straight lines.
    lines: Vec<(u32, Span, Dec)>,
    /// The present program moves along straight lines.
    linear: bool,
    /// F0 of the present program is reported.
    has_zero: bool,
}

impl Feeds {
    /// Starts a program.
    pub(super) fn program(&mut self) {
        (self.linear, self.has_zero) = (false, false);
    }

    /// Records a block that does not parse; `unit` if it may set the unit of F.
    pub(super) fn bad_block(&mut self, unit: bool) {
        self.any = true;
        self.has_unit |= unit;
    }

    /// Records a block of words, with its addresses and its F number.
    #[inline]
    pub(super) fn block(
        &mut self,
        lint: &mut Lint,
        roles: &Roles,
        (at, block): (u32, &Block),
        (words, bits): (&[Word], u32),
        (letters, feed): (AddressSet, Option<(&Word, Dec)>),
    ) {
        self.any |= letters.contains(Address::F);
        if self.first_cut.is_none() && bits & LINEAR != 0 && bits & CALL == 0 {
            let moves = |word: &Word| lint.control.is_axis(word.letter);
            let is_code = |word: &&Word| matches!(word.letter, Address::G | Address::Name);
            let code = words.iter().filter(is_code).find(|word| roles.word(word) & LINEAR != 0);
            self.first_cut = code.filter(|_| words.iter().any(moves)).map(|word| (at, word.span(block)));
        }
        self.has_unit |= bits & (PER_MINUTE | OTHER_FEED | INCH) != 0;
        if bits & (RAPID | LINEAR | CURVED) != 0 {
            self.linear = bits & LINEAR != 0;
        }
        let Some((word, number)) = feed.filter(|_| bits & (CALL | DWELL) == 0) else { return };
        if self.linear && bits & SPECIAL == 0 && self.lines.len() < PLACES {
            self.lines.push((at, word.span(block), number));
        }
        if number.mantissa == 0 && !self.has_zero {
            self.has_zero = true;
            tell_zero(lint, at, word.span(block));
        }
    }

    /// Reports the findings from all programs together.
    pub(super) fn report(&self, lint: &mut Lint, facts: &Facts) {
        self.tell_unit(lint);
        // A called program that is missing here, or a caller, may set a feed.
        let silent = self.any || !facts.missed.is_empty() || facts.any_called;
        if let Some((at, span)) = self.first_cut.filter(|_| !silent && facts.programs.iter().any(|part| part.ends)) {
            let alarm = lint.control.alarm_number(Alarm::NoFeed).unwrap_or("");
            let (place, code) = lint.written(at, span);
            lint.warn(place, msg!("lint.no-feed", code, alarm));
        }
    }

    /// Reports feeds of an unlikely size, if no code sets the unit of F and the unit after power-on is in force.
    fn tell_unit(&self, lint: &mut Lint) {
        let mut startup = lint.parsed.dialect().startup.iter().filter_map(|id| lint.control.code(*id));
        let revolution = startup.any(|row| row.code == Code::FeedPerRevolution);
        let other = if revolution { Code::FeedPerMinute } else { Code::FeedPerRevolution };
        let strange = |dec: &Dec| {
            let feed = dec.to_f64();
            if revolution { feed > COARSEST } else { feed > 0.0 && feed < SLOWEST }
        };
        // One feed of a usual size shows that the unit is intended.
        if self.has_unit || self.lines.iter().any(|(_, _, dec)| !strange(dec)) {
            return;
        }
        let row = lint.control.codes.iter().find(|row| row.code == other);
        if let (Some(&(at, span, dec)), Some(row)) = (self.lines.first(), row) {
            let code = lint.control.code_name(row.id);
            let (place, word) = lint.written(at, span);
            let (feed, count) = ((dec.to_f64(), 6), self.lines.len() as u32);
            let message = if revolution {
                msg!("lint.feed-per-revolution", word, feed, code = code.as_str(), count)
            } else {
                msg!("lint.feed-per-minute", word, feed, code = code.as_str(), count)
            };
            lint.warn(place, message);
            lint.fix(msg!("nc.fix.unit", code = code.as_str()), &[(span, dec)], &|dec| format!("{code} F{dec}"));
        }
    }
}

/// Reports F0, which stops the axes, moves them in rapid traverse, or is a feed of a parameter.
#[cold]
fn tell_zero(lint: &mut Lint, at: u32, span: Span) {
    let parameter = lint.control.param(ParamRole::FeedOneDigit).map_or("", |row| row.number);
    let message = match parameter {
        "" => msg!("lint.feed-zero"),
        _ if lint.parsed.dialect().running.feed_zero_rapid => msg!("lint.feed-zero-rapid", parameter),
        _ => msg!("lint.feed-zero-digit", parameter),
    };
    let (place, _) = lint.written(at, span);
    lint.warn(place, message);
}
