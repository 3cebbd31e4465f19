//! Blocks that the programs of the ribbon line share: codes, travels, waits, spindle, the end.

use super::formulas::feed;
use super::phase;
use crate::controls::{Address, Code, VarKind};
use crate::machines::program::writing;
use crate::machines::ribbon_line::params::{Endless, PathMode, Wait};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{ACTUAL_SPEED, LEFT, PITCH, PRINT_TRAVEL, REMAINDER, SPEED, STROKE};
use crate::nc::build::{Builder, Formula, NewWord, f, g, m, real, s, v, word, x};

pub(super) fn header(b: &mut Builder, line: &RibbonLine) {
    writing::write_header::<RibbonLine>(b, &line.form, line.control);
}

/// The control's own codes for these functions, without those that it lacks.
pub(super) fn codes(line: &RibbonLine, wanted: impl IntoIterator<Item = Code>) -> Vec<NewWord> {
    writing::codes(line.control, wanted)
}

/// A word that moves an axis by `by`: with the incremental address, or with the axis address under G91.
pub(super) fn travel(line: &RibbonLine, axis: usize, by: Formula) -> NewWord {
    let row = line.control.axes.get(axis);
    let own = row.map_or(Address::X, |row| row.letter);
    let incremental = row.and_then(|row| row.incremental).filter(|_| !line.control.can(Code::Incremental));
    word(incremental.unwrap_or(own), by)
}

/// A comment that begins with the name of the print roller's axis.
pub(super) fn about(line: &RibbonLine, what: &str) -> String {
    format!("{} {what}", line.params.print_axis.address())
}

/// Words of the pull axis for a length of ribbon in mm.
pub(super) fn pull_words(line: &RibbonLine, ribbon: Formula) -> Formula {
    if line.x_counts_diameters() { ribbon * 2 } else { ribbon }
}

/// The block that pulls and prints. An exact stop that acts in one block alone is written in each.
pub(super) fn move_block(line: &RibbonLine, pull: Formula) -> Vec<NewWord> {
    let once = line.params.path_mode == PathMode::ExactStop && !line.control.can(Code::ExactStop);
    let mut words = codes(line, once.then_some(Code::ExactStopOnce));
    words.extend([
        g(1),
        travel(line, line.pull(), pull),
        travel(line, line.print(), v(PRINT_TRAVEL)),
        f(v(feed(line))),
    ]);
    words
}

/// Unit of F.
pub(super) fn feed_unit(line: &RibbonLine) -> Code {
    if line.feeds_per_revolution() { Code::FeedPerRevolution } else { Code::FeedPerMinute }
}

/// A short dwell before the program reads the override knob again.
pub(super) fn wait_for_knob(b: &mut Builder, line: &RibbonLine) {
    writing::wait(b, line.control, feed_unit(line), real(0.1, 3), "OVERRIDE 0: WAIT");
}

/// Incremental dimensions, unit of F, and how blocks join.
pub(super) fn modes(line: &RibbonLine) -> Vec<NewWord> {
    let path = if line.params.path_mode == PathMode::ExactStop { Code::ExactStop } else { Code::Cutting };
    codes(line, [Code::Incremental, feed_unit(line), path])
}

/// Millimetres, and S in r/min, whatever the program before has left in force.
pub(super) fn opening(b: &mut Builder, line: &RibbonLine) {
    b.words(codes(line, [Code::Metric, Code::SurfaceSpeedOff]));
}

/// Turns the feed override off, if the control has a variable for it.
pub(super) fn override_off(b: &mut Builder, line: &RibbonLine, number: u32) {
    if overrides_can_be_off(line) {
        b.n(number).assign(3004, 2).note("FEED OVERRIDE OFF");
    }
}

/// Whether the program can switch the feed override off.
pub(super) fn overrides_can_be_off(line: &RibbonLine) -> bool {
    line.control.var(3004).is_some_and(|row| row.kind == VarKind::SuppressOverride)
}

/// Whether the program shifts the coordinates back at each start.
pub(super) fn presets(line: &RibbonLine) -> bool {
    line.params.endless == Endless::Shift
}

/// Brings a head to the ribbon before the product begins.
pub(super) fn to_head(b: &mut Builder, line: &RibbonLine, next: u32) {
    phase::to_head(b, line, next, |by| travel(line, line.print(), by));
}

/// Shifts the coordinates back, because they otherwise only grow, and goes on at block `next`. X begins anew at zero, the print roller at its
/// distance from the head.
///
/// A control that reads its positions shifts only where the product would end in the second half of its range: a coordinate has whole
/// increments, and what a shift loses of the head's place adds up over the products of a shift.
pub(super) fn preset(b: &mut Builder, line: &RibbonLine, number: u32, next: u32) {
    if !presets(line) {
        return;
    }
    let shift = |print: Formula| {
        let mut words = codes(line, [Code::SetCoordinates]);
        words.extend([x(real(0.0, 0)), word(line.params.print_axis.address(), print)]);
        words
    };
    let Some(position) = writing::work_position(line.control) else {
        b.n(number).words(shift(real(0.0, 0)));
        return;
    };
    let of = |axis: usize| v(position + axis as u32).abs();
    let product = v(LEFT) * (pull_words(line, v(PITCH)) + v(STROKE));
    let half = (0.5 * line.control.limits.coordinate_max).floor();
    b.n(number).if_goto((of(line.pull()) + of(line.print()) + product).lt(real(half, 0)), next);
    b.words(shift(-v(REMAINDER)));
}

/// Variable of S: the programmed speed, which the control multiplies by the knob; where the PLC locks the knob, the speed that the typed
/// override leaves.
pub(super) fn spindle_word(line: &RibbonLine) -> u32 {
    if line.params.knob_is_locked() { ACTUAL_SPEED } else { SPEED }
}

/// S and M3, and the wait until the unwinder runs.
pub(super) fn start_spindle(b: &mut Builder, line: &RibbonLine, start: u32, wait: u32) {
    b.n(start).words([s(v(spindle_word(line))), m(3)]);
    match line.params.wait {
        Wait::Dwell if line.params.dwell > 0.0 => {
            let (seconds, note) = (real(line.params.dwell, 3), "SPINDLE GETS ITS SPEED");
            writing::wait(b.n(wait), line.control, feed_unit(line), seconds, note);
        }
        Wait::Dwell => {}
        Wait::Fin => {
            b.note("PLC ANSWERS AT SPEED");
        }
    }
}

/// Spindle off, absolute dimensions, program end, and the alarm of a broken-off product. `#3004` is cleared by the reset of M30: written
/// here it would act before the last moves are done.
pub(super) fn end(b: &mut Builder, line: &RibbonLine) {
    // Where the volts stay, a key would turn the unwinder at the speed of the program; not every maker says whether they do.
    b.n(50).words([m(5), s(0)]).note("NO VOLTAGE FOR THE KEYS");
    phase::end(b, line);
    let absolute = codes(line, [Code::Absolute]);
    if !absolute.is_empty() {
        b.n(51).words(absolute);
    }
    b.n(52).words([m(30)]);
    phase::alarm(b, line);
}
