//! The main program that both listings of the paper share; each has passes of its own.

use super::alarms;
use super::blocks::{about, end, header, opening, override_off, preset, presets, to_head};
use super::entries::{entries, is_length};
use super::formulas::print_stroke;
use super::numbers::RUN;
use super::phase;
use super::product_length::{last_pitch, length_alarms, pitches_left};
use crate::machines::program::writing::{self, alarm_block};
use crate::machines::ribbon_line::params::Variant;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{COUNT, LEFT, LENGTH, PITCH, PITCH_COPY, RUNNING_SPEED, SPEED, STROKE};
use crate::nc::build::{Builder, m, s, v};

/// The main program of a listing: the blocks before its passes, the passes (from a block on), the last pitch and the alarms.
pub(super) fn run_listing(b: &mut Builder, line: &RibbonLine, passes_at: u32, passes: impl FnOnce(&mut Builder)) {
    b.program(RUN, "RIBBON LINE - RUN");
    header(b, line);
    writing::guards(b, &entries(line));
    phase::check(b, line, 19);
    override_off(b, line, 20);
    if !line.feeds_per_revolution() {
        writing::count_seconds(b, line.control);
    }
    opening(b, line);
    b.n(21);
    product(b, line);
    b.n(22).assign(STROKE, print_stroke(line)).note(&about(line, "PER PITCH"));
    b.n(23).assign(RUNNING_SPEED, 0).note("SPINDLE DOES NOT RUN YET");
    let start = if line.params.reads_final_speed() { 25 } else { passes_at };
    to_head(b, line, if presets(line) { 24 } else { start });
    preset(b, line, 24, start);
    if line.params.reads_final_speed() {
        // The register is 0 until the control puts out an S.
        b.n(25).words([s(v(SPEED)), m(3)]).note("S IS READ BACK");
    }
    passes(b);
    last_pitch(b, line);
    end(b, line);
    length_alarms(b, line);
    writing::alarms(b, line.control, &entries(line));
    b.words([m(30)]);
}

/// Pitches of the product, from its count or its length, and the alarm of a length below a pitch.
pub(super) fn product(b: &mut Builder, line: &RibbonLine) {
    if is_length(line) {
        pitches_left(b, line, v(LENGTH));
        b.if_goto(v(LEFT).lt(1), alarm_block(alarms::SHORT_LENGTH));
        if line.params.variant == Variant::Precomputed {
            b.assign(PITCH_COPY, v(PITCH));
        }
    } else {
        b.assign(LEFT, v(COUNT)).note("PITCHES LEFT");
    }
}
