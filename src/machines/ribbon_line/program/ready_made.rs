//! The ready-made programs: O9100 with guards and the paper's equations, O9101 with a loop that follows knob and entries.

use super::alarms;
use super::blocks::{
    about, codes, end, header, modes, move_block, opening, override_off, preset, presets, pull_words, spindle_word,
    start_spindle, to_head, wait_for_knob,
};
use super::entries::{entries, is_length};
use super::formulas::{actual_speed, changed, feed_is_zero, feed_moves, per_turn, print_stroke, vector_feed};
use super::limits::{clamp_guards, limit_alarms, limit_guards};
use super::numbers::{COMPUTE, RUN};
use super::phase;
use super::product_length::{compute_again, last_pitch, length_alarms, pitches_left};
use crate::controls::Code;
use crate::machines::program::writing::{self, alarm_block};
use crate::machines::ribbon_line::axes::PerAxis;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{
    ACTUAL_SPEED, BLOCK_PITCHES, BLOCK_SIZE, BLOCK_STROKE, COUNT, FEED_LIMIT, FEED_PER_TURN, HEADS, HEADS_COPY, KNOB,
    LEFT, LENGTH, LINE_SPEED, PITCH, PITCH_COPY, PRESS_ROLLER, PRESS_ROLLER_COPY, PRINT_ROLLER, PRINT_ROLLER_COPY,
    PRINT_TRAVEL, PULL_LENGTH, REDUCTION, REDUCTION_COPY, REMAINDER, RIBBON_PER_TURN, RUNNING_SPEED, SPEED,
    SPEED_CLAMP, SPEED_COPY, STROKE, VECTOR_FEED,
};
use crate::nc::build::{Builder, s, v};

/// Entries that change the motion of a running line, each with the variable of its copy.
pub(super) const WATCHED: [(u32, u32); 6] = [
    (SPEED, SPEED_COPY),
    (REDUCTION, REDUCTION_COPY),
    (PRESS_ROLLER, PRESS_ROLLER_COPY),
    (PITCH, PITCH_COPY),
    (HEADS, HEADS_COPY),
    (PRINT_ROLLER, PRINT_ROLLER_COPY),
];

/// O9100, ready-made: guards, copies of the watched entries, and the paper's equations; first those that the override does not change.
pub(super) fn compute(b: &mut Builder, line: &RibbonLine) {
    b.program(COMPUTE, "RIBBON LINE - COMPUTE");
    writing::guards(b, &entries(line));
    // Entries are copied before use, so that an entry changed later differs from its copy and is computed again.
    for (at, (watched, copy)) in (20..).zip(WATCHED) {
        b.n(at).assign(copy, v(watched));
    }
    b.n(30).assign(STROKE, print_stroke(line)).note(&about(line, "PER PITCH"));
    b.n(31).assign(PULL_LENGTH, pull_words(line, v(PITCH) * v(BLOCK_PITCHES))).note(if line.x_counts_diameters() {
        "X PER BLOCK, DIAMETER"
    } else {
        "X PER BLOCK"
    });
    b.n(32).assign(BLOCK_STROKE, v(STROKE) * v(BLOCK_PITCHES)).note(&about(line, "PER BLOCK"));
    b.n(33).assign(RIBBON_PER_TURN, per_turn(line)).note("RIBBON PER REVOLUTION");
    b.n(34).assign(FEED_PER_TURN, vector_feed(v(RIBBON_PER_TURN))).note("FEED PER REVOLUTION");
    speed_and_feed(b, line, 40);
    limit_guards(b, line, 46);
    b.n(47).words(codes(line, [Code::SubEnd]));
    writing::alarms(b, line.control, &entries(line));
    limit_alarms(b, line);
    // The header is after the program end: it is only for readers, and costs a running line no time.
    header(b, line);
}

/// Everything that depends on the override, in six blocks from number `n` on; [`FEED_PER_TURN`] and [`RIBBON_PER_TURN`]
/// do not.
pub(super) fn speed_and_feed(b: &mut Builder, line: &RibbonLine, n: u32) {
    b.n(n).assign(KNOB, v(line.override_variable())).note("OVERRIDE");
    b.n(n + 1).assign(ACTUAL_SPEED, actual_speed(line, KNOB)).note("ACTUAL SPEED R/MIN");
    b.n(n + 2).if_goto(v(ACTUAL_SPEED).le(v(SPEED_CLAMP)), n + 4);
    b.n(n + 3).assign(ACTUAL_SPEED, v(SPEED_CLAMP)).note("CLAMP AS THE CONTROL DOES");
    b.n(n + 4).assign(LINE_SPEED, v(RIBBON_PER_TURN) * v(ACTUAL_SPEED)).note("LINE SPEED MM/MIN");
    b.n(n + 5).assign(VECTOR_FEED, v(FEED_PER_TURN) * v(ACTUAL_SPEED)).note("VECTOR FEED");
}

/// O9101, ready-made.
pub(super) fn run(b: &mut Builder, line: &RibbonLine) {
    b.program(RUN, "RIBBON LINE - RUN");
    header(b, line);
    override_off(b, line, 1);
    if !line.feeds_per_revolution() {
        writing::count_seconds(b, line.control);
    }
    if !is_length(line) {
        b.n(2).assign(LEFT, v(COUNT)).note("PITCHES LEFT");
    }
    phase::check(b, line, 3);
    opening(b, line);
    b.n(4).assign(BLOCK_PITCHES, v(BLOCK_SIZE)).note("PITCHES OF A BLOCK");
    b.n(5).call(COMPUTE, None);
    // A final speed is read by the running line (N15), after S.
    if !line.params.reads_final_speed() {
        // A start under override 0 has its wait for the unwinder when the override rises (N20 in the running line).
        b.while_do(feed_is_zero(), 1);
        wait_for_knob(b, line);
        b.call(COMPUTE, None);
        b.end_do(1);
    }
    if is_length(line) {
        pitches_left(b, line, v(LENGTH));
        b.if_goto(v(LEFT).lt(1), alarm_block(alarms::SHORT_LENGTH));
    }
    let next = if presets(line) { 6 } else { 7 };
    to_head(b, line, next);
    preset(b, line, 6, 7);
    let speed = spindle_word(line);
    b.n(7).assign(RUNNING_SPEED, v(speed)).note("SPEED THAT RUNS");
    start_spindle(b, line, 8, 9);
    b.n(10).words(modes(line));
    b.n(11).while_do(v(LEFT).gt(0), 1);
    b.n(12).assign(BLOCK_PITCHES, v(BLOCK_SIZE));
    b.n(13).if_goto(v(LEFT).ge(v(BLOCK_PITCHES)), 15);
    b.n(14).assign(BLOCK_PITCHES, v(LEFT)).note("LAST BLOCK IS SHORTER");
    compute_again(b.n(15), line);
    b.n(16).if_goto(v(speed).eq(v(RUNNING_SPEED)), 19);
    b.n(17).assign(RUNNING_SPEED, v(speed));
    b.n(18).words([s(v(speed))]);
    b.n(19).if_goto(feed_moves(), 30).note("F BELOW IS F0");
    wait_for_override(b, line);
    b.n(30).while_do(v(LEFT).ge(v(BLOCK_PITCHES)), 2);
    // One block watches the knob and three entries, another one the other entries, so that a pass has seven macro blocks. Each block fits a
    // screen, this one without its number.
    let (first, second) = WATCHED.split_at(3);
    let with_knob: Vec<_> = core::iter::once((line.override_variable(), KNOB)).chain(first.iter().copied()).collect();
    if line.params.knob_is_locked() {
        // S changes with the typed override.
        b.if_goto(changed(&with_knob).gt(0), 15);
    } else {
        b.if_goto(changed(&with_knob).le(0), 41);
        b.n(32).if_goto(changed(first).gt(0), 15);
        speed_and_feed(b, line, 33);
        if !line.feeds_per_revolution() {
            b.n(39).if_goto(v(VECTOR_FEED).gt(v(FEED_LIMIT)), 15).note("TOO FAST: ALARM");
        }
        clamp_guards(b, line, PerAxis { pull: 15, print: 15 });
        b.n(40).if_goto(feed_is_zero(), 15).note("OVERRIDE 0");
    }
    b.n(41).if_goto(changed(second).gt(0), 15);
    b.n(42)
        .assign(PRINT_TRAVEL, ((v(REMAINDER) + v(BLOCK_STROKE)) * 1000).round() / 1000)
        .note(&about(line, "OF THIS BLOCK"));
    b.n(43).assign(REMAINDER, v(REMAINDER) + v(BLOCK_STROKE) - v(PRINT_TRAVEL)).note(&about(line, "LEFT OVER"));
    b.n(44).words(move_block(line, v(PULL_LENGTH)));
    b.n(45).assign(LEFT, v(LEFT) - v(BLOCK_PITCHES));
    b.n(46).end_do(2);
    b.n(47).end_do(1);
    last_pitch(b, line);
    end(b, line);
    length_alarms(b, line);
}

/// N20 to N29: at override 0 the line waits; then it waits for the unwinder as at a start, because X would otherwise
/// pull before ribbon is unwound.
pub(super) fn wait_for_override(b: &mut Builder, line: &RibbonLine) {
    wait_for_knob(b.n(20), line);
    speed_and_feed(b, line, 21);
    b.n(27).if_goto(feed_is_zero(), 20);
    start_spindle(b, line, 28, 29);
    b.goto(15);
}
