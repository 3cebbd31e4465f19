//! A product that is given by its length: pitches left, a shorter last pitch, alarms.

use super::alarms;
use super::blocks::{about, move_block, pull_words};
use super::entries::is_length;
use super::numbers::COMPUTE;
use crate::machines::program::writing::{self, alarm_block};
use crate::machines::ribbon_line::derive::{PITCH_TOLERANCE, SHORTEST};
use crate::machines::ribbon_line::params::Rest;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{
    LAST, LEFT, LENGTH, LENGTH_LEFT, PITCH, PITCH_COPY, PRINT_TRAVEL, REMAINDER, STROKE,
};
use crate::nc::build::{Builder, Formula, m, real, v};

/// Writes the pitches left of a length by the rule for its remainder, and the length of a shorter last pitch.
pub(super) fn pitches_left(b: &mut Builder, line: &RibbonLine, length: Formula) {
    let pitches = || length.clone() / v(PITCH);
    let whole = match line.params.rest {
        Rest::Shorten => (pitches() + real(PITCH_TOLERANCE, 4)).fix(),
        Rest::Round | Rest::Alarm => pitches().round(),
    };
    b.assign(LEFT, whole).note("PITCHES LEFT");
    match line.params.rest {
        Rest::Shorten => b.assign(LAST, length.clone() - v(LEFT) * v(PITCH)).note("LAST PITCH"),
        Rest::Round | Rest::Alarm => b.assign(LAST, 0).note("NO SHORTER PITCH"),
    };
    if line.params.rest == Rest::Alarm {
        b.if_goto((length - v(LEFT) * v(PITCH)).abs().gt(real(0.001, 3)), alarm_block(alarms::PART_OF_A_PITCH));
    }
}

/// Calls O9100 again. The length left is taken with the copy of the old pitch first, so that it stays when the pitch changes.
pub(super) fn compute_again(b: &mut Builder, line: &RibbonLine) {
    if is_length(line) {
        b.assign(LENGTH_LEFT, v(LEFT) * v(PITCH_COPY) + v(LAST)).note("LENGTH LEFT");
        b.call(COMPUTE, None);
        pitches_left(b, line, v(LENGTH_LEFT));
    } else {
        b.call(COMPUTE, None);
    }
}

/// The block of the shorter last pitch: both axes in the same ratio as before.
pub(super) fn last_pitch(b: &mut Builder, line: &RibbonLine) {
    if !is_length(line) || line.params.rest != Rest::Shorten {
        return;
    }
    b.if_goto(v(LAST).le(real(SHORTEST, 4)), 50);
    b.assign(PRINT_TRAVEL, ((v(REMAINDER) + v(STROKE) * v(LAST) / v(PITCH)) * 1000).round() / 1000)
        .note(&about(line, "OF THE LAST PITCH"));
    b.words(move_block(line, pull_words(line, v(LAST))));
}

/// Writes the alarms about the length after the end of the program.
pub(super) fn length_alarms(b: &mut Builder, line: &RibbonLine) {
    if !is_length(line) {
        return;
    }
    let length = line.control.variable(LENGTH);
    writing::alarm(b, line.control, alarms::SHORT_LENGTH, &format!("LENGTH {length} IS BELOW A PITCH"));
    if line.params.rest == Rest::Alarm {
        writing::alarm(b, line.control, alarms::PART_OF_A_PITCH, &format!("{length} IS NO WHOLE PITCHES"));
    }
    if writing::has_alarms(line.control) {
        b.words([m(30)]);
    }
}
