//! Checks of F and of the axes against their limits, and the alarms of these checks.

use super::alarms;
use super::blocks::codes;
use super::formulas::feed;
use crate::controls::Code;
use crate::machines::program::writing::{self, alarm_block};
use crate::machines::ribbon_line::axes::{LineAxis, PerAxis};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{FEED_LIMIT, LINE_SPEED, PITCH, STROKE};
use crate::nc::build::{Builder, real, v};

/// Jumps to the alarm of an F above the limit.
pub(super) fn feed_guard(b: &mut Builder, line: &RibbonLine, number: u32) {
    b.n(number).if_goto(v(feed(line)).gt(v(FEED_LIMIT)), alarm_block(alarms::FEED));
}

/// Jumps to the block of an axis, the pull axis or the print roller, that is above the clamp of its feed: the
/// control would slow both axes, but not the unwinder.
pub(super) fn clamp_guards(b: &mut Builder, line: &RibbonLine, blocks: PerAxis<u32>) {
    let clamps = line.params.axes.map(|axis| real(axis.clamp, 3));
    b.if_goto(v(LINE_SPEED).gt(clamps.pull), blocks.pull);
    b.if_goto((v(LINE_SPEED) * v(STROKE)).gt(v(PITCH) * clamps.print), blocks.print);
}

/// Jumps to the alarms of an F or an axis above its limit.
pub(super) fn limit_guards(b: &mut Builder, line: &RibbonLine, number: u32) {
    feed_guard(b, line, number);
    clamp_guards(b, line, alarms::CLAMPS.map(|number| alarm_block(*number)));
}

/// The alarm of an F above the limit.
pub(super) fn feed_alarm(b: &mut Builder, line: &RibbonLine) {
    let feed = line.control.variable(feed(line));
    let limit = line.control.variable(FEED_LIMIT);
    writing::alarm(b, line.control, alarms::FEED, &format!("FEED {feed} ABOVE LIMIT {limit}"));
    if writing::has_alarms(line.control) {
        b.words(codes(line, [Code::SubEnd]));
    }
}

/// The alarms of an axis above its clamp.
pub(super) fn clamp_alarms(b: &mut Builder, line: &RibbonLine) {
    for axis in LineAxis::BOTH {
        let (letter, clamp) = (line.letter(axis), line.params.axes[axis].clamp);
        writing::alarm(b, line.control, alarms::CLAMPS[axis], &format!("{letter} FEED ABOVE CLAMP {clamp}"));
        if writing::has_alarms(line.control) {
            b.words(codes(line, [Code::SubEnd]));
        }
    }
}

/// The alarms of [`limit_guards`].
pub(super) fn limit_alarms(b: &mut Builder, line: &RibbonLine) {
    feed_alarm(b, line);
    clamp_alarms(b, line);
}
