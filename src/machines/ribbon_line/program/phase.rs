//! Phase of the print heads at the start of a product: a head is brought to the ribbon, also after a product that was broken off.
//!
//! If the control reads positions, the program turns the print roller on to its next head, with the ribbon at rest: no head meets the
//! ribbon on the way. If it does not, a variable marks a product that was broken off, and an alarm sends the operator to the roller.

use super::alarms;
use crate::controls::Code;
use crate::machines::program::writing;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{PHASE, PRINT_TRAVEL, REMAINDER, STROKE};
use crate::nc::build::{Builder, Formula, NewWord, g, real, v};

/// Phase error (in heads) up to which the first block corrects it; with a greater one the roller is turned first.
const SMALL: f64 = 0.002;

/// Added to the phase error (in heads) before it is rounded: every error above [`SMALL`] then rounds up, and none below 0 does.
const ROUNDS_UP: f64 = 0.5 - SMALL;

/// Variable of the print roller's position, if the control has one.
pub(in crate::machines::ribbon_line) fn position_variable(line: &RibbonLine) -> Option<u32> {
    Some(writing::work_position(line.control)? + line.print() as u32)
}

/// Jumps to the alarm if the product before was broken off. The check is block `number`.
pub(super) fn check(b: &mut Builder, line: &RibbonLine, number: u32) {
    if !line.reads_positions() {
        b.n(number).if_goto(v(PHASE).gt(0), writing::alarm_block(alarms::BROKEN_OFF));
    }
}

/// Brings a head to the ribbon and goes on at block `next`: [`STROKE`] has the stroke of a pitch, one head. `turn` is the word of the roller's
/// travel. A product begins here.
///
/// With the position y in heads and its distance `e = y - ROUND(y)` from the nearest head, the way on to the next head is
/// `ROUND(e + 0.498) - e`: 1 - e if the ribbon is past a head, -e if it is before one. The roller never turns backwards.
pub(super) fn to_head(b: &mut Builder, line: &RibbonLine, next: u32, turn: impl FnOnce(Formula) -> NewWord) {
    let axis = line.params.print_axis.address();
    let Some(position) = position_variable(line) else {
        b.assign(REMAINDER, 0).note(&format!("REMAINDER OF {axis}"));
        b.assign(PHASE, 1).note("A PRODUCT BEGINS");
        return;
    };
    b.assign(PHASE, v(position) / v(STROKE)).note("HEADS FROM ZERO");
    b.assign(PHASE, v(PHASE) - v(PHASE).round()).note("FROM THE NEAREST");
    b.assign(REMAINDER, -(v(PHASE) * v(STROKE))).note(&format!("REMAINDER OF {axis}"));
    b.if_goto(v(PHASE).abs().le(real(SMALL, 3)), next);
    b.assign(PHASE, (v(PHASE) + real(ROUNDS_UP, 3)).round() - v(PHASE)).note("TO THE NEXT HEAD");
    b.assign(PRINT_TRAVEL, (v(PHASE) * v(STROKE) * 1000).round() / 1000);
    b.assign(REMAINDER, v(PHASE) * v(STROKE) - v(PRINT_TRAVEL)).note(&format!("REMAINDER OF {axis}"));
    let mut words = writing::codes(line.control, [Code::Incremental]);
    words.extend([g(0), turn(v(PRINT_TRAVEL))]);
    b.words(words).note("A HEAD TO THE RIBBON");
}

/// Marks the product as complete: after M5, when all blocks are done.
pub(super) fn end(b: &mut Builder, line: &RibbonLine) {
    if line.reads_positions() {
        return;
    }
    let waits = writing::codes(line.control, [Code::StopReading]);
    if !waits.is_empty() {
        b.words(waits);
    }
    b.assign(PHASE, 0).note("THE PRODUCT IS WHOLE");
}

/// Writes the alarm after the end of the program. Only a reset ends the alarm: after an M0, cycle start would move a
/// jogged roller back.
pub(super) fn alarm(b: &mut Builder, line: &RibbonLine) {
    if line.reads_positions() {
        return;
    }
    let (axis, variable) = (line.params.print_axis.address(), line.control.variable(PHASE));
    writing::alarm(b, line.control, alarms::BROKEN_OFF, &format!("RESET, TURN {axis} TO A HEAD BY HAND, {variable}=0"));
}
