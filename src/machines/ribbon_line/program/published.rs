//! The listing as published: one call of O9100 per pitch.

use super::blocks::{about, codes, header, modes, move_block, pull_words, spindle_word, start_spindle, wait_for_knob};
use super::formulas::{actual_speed, feed_is_zero, per_turn, print_stroke, vector_feed};
use super::limits::{feed_alarm, feed_guard};
use super::listing::run_listing;
use super::numbers::COMPUTE;
use crate::controls::Code;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{
    ACTUAL_SPEED, FEED_PER_TURN, LEFT, LINE_SPEED, PITCH, PRINT_TRAVEL, REMAINDER, RUNNING_SPEED, SPEED_CLAMP, STROKE,
    VECTOR_FEED,
};
use crate::nc::build::{Builder, v};

/// O9100 as published: its numbers N5, N10, N20, N30, N100 and N200 with the corrections between them.
pub(super) fn compute(b: &mut Builder, line: &RibbonLine) {
    b.program(COMPUTE, "RIBBON LINE - AS PUBLISHED");
    b.n(5).assign(ACTUAL_SPEED, actual_speed(line, line.override_variable())).note("ACTUAL SPEED R/MIN");
    b.n(6).if_goto(v(ACTUAL_SPEED).le(v(SPEED_CLAMP)), 10);
    b.n(7).assign(ACTUAL_SPEED, v(SPEED_CLAMP)).note("CLAMP AS THE CONTROL DOES");
    b.n(10).assign(LINE_SPEED, per_turn(line) * v(ACTUAL_SPEED)).note("LINE SPEED MM/MIN");
    b.n(20).assign(STROKE, print_stroke(line)).note(&about(line, "PER PITCH"));
    b.n(30).assign(VECTOR_FEED, vector_feed(v(LINE_SPEED))).note("VECTOR FEED");
    b.n(31)
        .assign(PRINT_TRAVEL, ((v(REMAINDER) + v(STROKE)) * 1000).round() / 1000)
        .note(&about(line, "OF THIS PITCH"));
    b.n(40).if_goto(feed_is_zero(), 210).note("F BELOW IS F0");
    if line.feeds_per_revolution() {
        b.assign(FEED_PER_TURN, vector_feed(per_turn(line))).note("FEED PER REVOLUTION");
    }
    feed_guard(b, line, 41);
    let speed = spindle_word(line);
    b.n(90).if_goto(v(RUNNING_SPEED).eq(v(speed)), 200);
    start_spindle(b, line, 100, 110);
    b.n(120).assign(RUNNING_SPEED, v(speed)).note("SPEED THAT RUNS");
    let pull = pull_words(line, v(PITCH));
    b.n(200).words(modes(line).into_iter().chain(move_block(line, pull)));
    b.n(201).assign(REMAINDER, v(REMAINDER) + v(STROKE) - v(PRINT_TRAVEL)).note(&about(line, "LEFT OVER"));
    b.n(202).assign(LEFT, v(LEFT) - 1);
    b.n(203).words(codes(line, [Code::SubEnd]));
    wait_for_knob(b.n(210), line);
    b.n(211).assign(RUNNING_SPEED, 0).note("SPINDLE STANDS");
    b.n(212).words(codes(line, [Code::SubEnd]));
    feed_alarm(b, line);
    header(b, line);
}

/// The main program of the published listing: one call of O9100 per pitch.
pub(super) fn run(b: &mut Builder, line: &RibbonLine) {
    run_listing(b, line, 30, |b| {
        b.n(30).while_do(v(LEFT).gt(0), 1);
        b.n(31).call(COMPUTE, None);
        b.n(32).end_do(1);
    });
}
