//! The listing that calculates before its loop and again when knob or entries change.

use super::blocks::{about, codes, header, modes, move_block, pull_words, spindle_word, start_spindle, wait_for_knob};
use super::formulas::{actual_speed, changed, feed_moves, per_turn, print_stroke, vector_feed};
use super::limits::{limit_alarms, limit_guards};
use super::listing::run_listing;
use super::numbers::COMPUTE;
use super::product_length::compute_again;
use crate::controls::Code;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{
    ACTUAL_SPEED, FEED_PER_TURN, HEADS, HEADS_COPY, KNOB, LEFT, LINE_SPEED, PITCH, PITCH_COPY, PRINT_TRAVEL,
    PULL_LENGTH, REMAINDER, RUNNING_SPEED, SPEED, SPEED_CLAMP, SPEED_COPY, STROKE, VECTOR_FEED,
};
use crate::nc::build::{Builder, v};

/// Entries that the precomputed listing watches in the running line, each with the variable of its copy; the others act at the next start.
pub(super) const WATCHED_ONCE: [(u32, u32); 3] = [(SPEED, SPEED_COPY), (PITCH, PITCH_COPY), (HEADS, HEADS_COPY)];

/// O9100 of the listing that calculates before the loop: the same numbers without the motion, and copies of the watched entries.
pub(super) fn compute(b: &mut Builder, line: &RibbonLine) {
    b.program(COMPUTE, "RIBBON LINE - AS PUBLISHED, ONCE");
    b.n(1).assign(KNOB, v(line.override_variable())).note("OVERRIDE");
    for (at, (watched, copy)) in (2..).zip(WATCHED_ONCE) {
        b.n(at).assign(copy, v(watched));
    }
    b.n(5).assign(ACTUAL_SPEED, actual_speed(line, KNOB)).note("ACTUAL SPEED R/MIN");
    b.n(6).if_goto(v(ACTUAL_SPEED).le(v(SPEED_CLAMP)), 10);
    b.n(7).assign(ACTUAL_SPEED, v(SPEED_CLAMP)).note("CLAMP AS THE CONTROL DOES");
    b.n(10).assign(LINE_SPEED, per_turn(line) * v(ACTUAL_SPEED)).note("LINE SPEED MM/MIN");
    b.n(20).assign(STROKE, print_stroke(line)).note(&about(line, "PER PITCH"));
    b.n(30).assign(VECTOR_FEED, vector_feed(v(LINE_SPEED))).note("VECTOR FEED");
    b.n(31).assign(PULL_LENGTH, pull_words(line, v(PITCH))).note("PULL PER PITCH");
    if line.feeds_per_revolution() {
        b.n(32).assign(FEED_PER_TURN, vector_feed(per_turn(line))).note("FEED PER TURN");
    }
    limit_guards(b, line, 41);
    b.n(42).words(codes(line, [Code::SubEnd]));
    limit_alarms(b, line);
    header(b, line);
}

/// The main program of the listing that calculates before the loop: a pass is a look at the knob and the block N200.
pub(super) fn run(b: &mut Builder, line: &RibbonLine) {
    run_listing(b, line, 26, |b| {
        b.n(26).words(modes(line));
        b.n(30).while_do(v(LEFT).gt(0), 1);
        compute_again(b.n(31), line);
        b.n(32).if_goto(feed_moves(), 35).note("F BELOW IS F0");
        wait_for_knob(b.n(33), line);
        b.n(34).assign(RUNNING_SPEED, 0).note("SPINDLE STANDS");
        b.goto(31);
        let speed = spindle_word(line);
        b.n(35).if_goto(v(RUNNING_SPEED).eq(v(speed)), 190);
        start_spindle(b, line, 100, 110);
        b.n(120).assign(RUNNING_SPEED, v(speed)).note("SPEED THAT RUNS");
        b.n(190).while_do(v(LEFT).gt(0), 2);
        let watched: Vec<_> = core::iter::once((line.override_variable(), KNOB)).chain(WATCHED_ONCE).collect();
        // Without its number the block fits on a screen.
        b.if_goto(changed(&watched).gt(0), 31);
        b.n(192)
            .assign(PRINT_TRAVEL, ((v(REMAINDER) + v(STROKE)) * 1000).round() / 1000)
            .note(&about(line, "OF THIS PITCH"));
        b.n(193).assign(REMAINDER, v(REMAINDER) + v(STROKE) - v(PRINT_TRAVEL)).note(&about(line, "LEFT OVER"));
        b.n(200).words(move_block(line, v(PULL_LENGTH)));
        b.n(201).assign(LEFT, v(LEFT) - 1);
        b.n(202).end_do(2);
        b.n(203).end_do(1);
    });
}
