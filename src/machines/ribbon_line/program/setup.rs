//! O9102: the values of the project, once.

use super::blocks::header;
use super::entries::is_length;
use super::numbers::SETUP;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{
    BLOCK_SIZE, COUNT, FEED_LIMIT, HEADS, LENGTH, PITCH, PRESS_ROLLER, PRINT_ROLLER, REDUCTION, SPEED, SPEED_CLAMP,
};
use crate::nc::build::{Builder, m, real};

/// O9102: the values of the project, once.
pub(super) fn write(b: &mut Builder, line: &RibbonLine) {
    b.program(SETUP, "RIBBON LINE - SET VALUES ONCE");
    header(b, line);
    let p = &line.params;
    let values = [
        (SPEED, p.spindle_speed, 0, "SPINDLE SPEED S"),
        (REDUCTION, p.reduction_ratio, 6, "REDUCTION RATIO"),
        (PRESS_ROLLER, p.press_roller_diameter, 4, "PRESS ROLLER DIAMETER"),
        (PITCH, p.pitch, 3, "PITCH"),
        (HEADS, p.heads, 0, "PRINT HEADS"),
        (PRINT_ROLLER, p.print_roller_diameter, 4, "PRINT ROLLER DIAMETER"),
        (SPEED_CLAMP, p.top_speed(), 3, "SPEED CLAMP"),
        (FEED_LIMIT, line.feed_max(), 3, "FEED LIMIT"),
        if is_length(line) {
            (LENGTH, p.product_length, 3, "LENGTH OF A PRODUCT")
        } else {
            (COUNT, p.count(), 0, "PITCHES OF A PRODUCT")
        },
        (BLOCK_SIZE, p.block_pitches(), 0, "PITCHES PER BLOCK"),
    ];
    for (at, (number, value, decimals, text)) in (1..).zip(values) {
        b.n(at).assign(number, real(value, decimals)).note(text);
    }
    if line.override_macro_input().is_none() {
        b.n(11).assign(line.override_variable(), real(p.override_stepped(), 0)).note("OVERRIDE PERCENT");
    }
    b.n(20).words([m(30)]);
}
