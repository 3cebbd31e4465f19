//! Constant surface speed: cuts to the turning centre without a speed limit, and offsets that move work zero off the centre.

use super::super::ast::{Stmt, Word};
use super::context::Lint;
use super::facts::Facts;
use super::position::{PositionReader, UNKNOWN, keeps_positions};
use super::roles::{CURVED, INCREMENTAL, LINEAR, RAPID, Roles};
use crate::controls::{Address, AxisDef, Code, CodeDef, Group};
use crate::msg;
use crate::text::{Severity, Span};

/// Diameter (mm) below which a cut counts as one to the centre: at 100 m/min it needs 16 000 r/min.
const CENTRE: f64 = 2.0;

/// State of the check in one program. Diameters in mm, as words count; `None` where unknown.
struct Course {
    /// Constant surface speed is on.
    surface: bool,
    cuts: bool,
    at: Option<f64>,
    /// Offset of X, and its last word with the index of its block.
    shift: Option<f64>,
    shifted: Option<(u32, Span)>,
}

/// Size of an offset from the centre, the lesser one first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum OffsetSize {
    /// A remark.
    Small,
    /// A warning.
    Large,
}

/// Reports the first cut to the centre and the first offset across the spindle of every program with constant surface speed.
pub(super) fn surface_speed(lint: &mut Lint, roles: &Roles, facts: &Facts) {
    let axes = lint.control.axes.iter();
    let Some((k, cross)) = axes.enumerate().find(|(_, axis)| axis.diameter || axis.letter == Address::X) else {
        return;
    };
    // A called program that is missing here, or a block that does not parse, may limit the speed.
    let limited = !facts.missed.is_empty() || facts.any_called || !facts.bad.is_empty() || limits(lint);
    let words = lint.parsed.dialect().words_per_mm(k);
    for program in 0..lint.deck.programs.len() {
        Check { lint, roles, cross, words, limited }.program(program);
    }
}

/// Whether a program here limits the speed: LIMS, an upper spindle limit, G50 S or G92 S.
fn limits(lint: &Lint) -> bool {
    let deck = lint.deck;
    deck.blocks.iter().filter(|block| matches!(block.stmt, Stmt::Words { .. })).any(|block| {
        let words = deck.words_of(block);
        let names = |letter| words.iter().any(|word| word.letter == letter);
        let limit = |row: &CodeDef| matches!(row.code, Code::SetCoordinates | Code::UpperLimits);
        names(Address::Lims) || names(Address::S) && rows(lint, words).any(limit)
    })
}

/// The rows of the codes of a block.
fn rows<'a>(lint: &Lint<'a>, words: &'a [Word]) -> impl Iterator<Item = &'static CodeDef> + use<'a> {
    let codes = lint.parsed.codes();
    words.iter().filter_map(|word| codes.row_of(word))
}

/// The check of one program.
struct Check<'l, 'a, 'r> {
    lint: &'l mut Lint<'a>,
    roles: &'r Roles<'r>,
    cross: &'static AxisDef,
    /// Units of axis words per millimetre of slide travel.
    words: f64,
    /// The speed is limited, or may be.
    limited: bool,
}

impl Check<'_, '_, '_> {
    fn program(mut self, program: usize) {
        let deck = self.lint.deck;
        let Some(program) = deck.programs.get(program) else { return };
        let mut course = Course { surface: false, cuts: false, at: None, shift: Some(0.0), shifted: None };
        let mut reported = None;
        let reader = PositionReader::new(self.lint);
        for (index, block) in (program.first..).zip(deck.blocks_of(program)) {
            if !matches!(block.stmt, Stmt::Words { .. }) {
                if !keeps_positions(block.stmt) {
                    course.at = None;
                }
                continue;
            }
            let words = deck.words_of(block);
            let bits = self.roles.block(words);
            self.codes(&mut course, words);
            let across =
                words.iter().find(|word| word.letter == self.cross.letter).map(|word| (word, reader.position(word)));
            self.offset(&mut course, words, across.map(|(word, value)| ((index, word.span(block)), value)));
            reported = reported.max(self.tell_offset(&course, reported));
            course.cuts = (course.cuts || bits & (LINEAR | CURVED) != 0) && bits & RAPID == 0;
            if bits & INCREMENTAL != 0 || bits & UNKNOWN & !CURVED != 0 {
                course.at = None;
                continue;
            }
            let Some((word, to)) = across else {
                if words.iter().any(|word| self.cross.incremental == Some(word.letter)) {
                    course.at = None;
                }
                continue;
            };
            let reaches = to.is_some_and(|to| to.abs() <= CENTRE || course.at.is_some_and(|from| from * to < 0.0));
            if course.surface && course.cuts && reaches && !self.limited {
                self.tell_centre(index, word.span(block));
                self.limited = true;
            }
            course.at = to;
        }
    }

    /// Applies codes that switch constant surface speed on and off.
    fn codes(&self, course: &mut Course, words: &[Word]) {
        let feed_ends = self.lint.parsed.dialect().spindle().feed_ends_surface;
        for row in rows(self.lint, words) {
            match row.code {
                Code::SurfaceSpeed => course.surface = true,
                Code::SurfaceSpeedOff => course.surface = false,
                _ if feed_ends && row.group == Group::FeedUnit => course.surface = false,
                _ => {}
            }
        }
    }

    /// Applies the offset of a block.
    fn offset(&self, course: &mut Course, words: &[Word], across: Option<((u32, Span), Option<f64>)>) {
        let code = rows(self.lint, words)
            .map(|row| row.code)
            .find(|code| matches!(code, Code::Offset | Code::OffsetMore | Code::LocalCoordinates));
        let value = across.map_or(Some(0.0), |(_, value)| value);
        match code {
            Some(Code::Offset) => course.shift = value,
            Some(Code::LocalCoordinates) if across.is_some() => course.shift = value,
            Some(Code::OffsetMore) => course.shift = course.shift.zip(value).map(|(shift, more)| shift + more),
            _ => return,
        }
        if let Some((place, _)) = across {
            course.shifted = Some(place);
        }
    }

    /// Reports work zero off the centre, as a remark if the offset is small: the first of each size. Returns the size of the reported
    /// offset; `reported` is the largest size reported so far.
    fn tell_offset(&mut self, course: &Course, reported: Option<OffsetSize>) -> Option<OffsetSize> {
        let offset = course.shift?.abs() / self.words;
        let (index, span) = course.shifted.filter(|_| course.surface && offset > 1e-9)?;
        let small = offset <= self.lint.parsed.dialect().spindle().small_offset + 1e-9;
        let size = Some(if small { OffsetSize::Small } else { OffsetSize::Large });
        if size <= reported {
            return None;
        }
        let (place, word) = self.lint.written(index, span);
        let error = (2.0 * offset, 4);
        let message =
            if small { msg!("lint.small-offset", word, error) } else { msg!("lint.offset-off-centre", word, error) };
        let finding = self.lint.warn(place, message);
        if let Some(finding) = finding.filter(|_| small) {
            finding.severity = Severity::Info;
        }
        size
    }

    fn tell_centre(&mut self, index: u32, span: Span) {
        let control = self.lint.control;
        let has_word =
            control.syntax.names().is_some_and(|names| names.addresses.iter().any(|row| row.1 == Address::Lims));
        let code = control.codes.iter().find(|row| row.code == Code::SetCoordinates);
        let limit_word = match code {
            Some(row) if !has_word => format!("{} S", control.code_name(row.id)),
            _ => "LIMS=".to_owned(),
        };
        let (place, word) = self.lint.written(index, span);
        self.lint.warn(place, msg!("lint.centre-unlimited", word, limit_word));
    }
}
