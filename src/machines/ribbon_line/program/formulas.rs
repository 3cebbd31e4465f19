//! Expressions that the programs of the ribbon line share: speeds, feeds, travels.

use crate::machines::ribbon_line::params::OverrideForm;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{
    FEED_PER_TURN, HEADS, PITCH, PRESS_ROLLER, PRINT_ROLLER, REDUCTION, SPEED, STROKE, VECTOR_FEED,
};
use crate::nc::build::{Condition, Formula, real, v};

/// π as the program has it: 3.141592654, or 3.14.
///
/// The vector feed takes π almost squared: with eight decimals it would come out 2.3e-9 low, with nine it is right to
/// 3e-10. Where the control takes fewer digits, π is cut to them.
pub(super) fn pi(line: &RibbonLine) -> Formula {
    let decimals = line.dialect.reading.digits.saturating_sub(1).min(9);
    real(line.params.program_pi(), decimals as u8)
}

/// Actual spindle speed, equation (1). `input` holds the PLC's word.
pub(super) fn actual_speed(line: &RibbonLine, input: u32) -> Formula {
    match line.params.override_form {
        OverrideForm::Percent => v(SPEED) * v(input) / 100,
        OverrideForm::FinalSpeed => v(input),
    }
}

/// Ribbon per revolution of the unwinder's motor, equation (2).
pub(super) fn per_turn(line: &RibbonLine) -> Formula {
    pi(line) * v(PRESS_ROLLER) / v(REDUCTION)
}

/// Travel of the print roller per pitch: one head further.
pub(super) fn print_stroke(line: &RibbonLine) -> Formula {
    if line.degrees() { real(360.0, 0) / v(HEADS) } else { pi(line) * v(PRINT_ROLLER) / v(HEADS) }
}

/// Vector feed from the speed of the ribbon, equation (4): the block N30 that the paper leaves out.
pub(super) fn vector_feed(speed: Formula) -> Formula {
    speed * (v(PITCH) * v(PITCH) + v(STROKE) * v(STROKE)).sqrt() / v(PITCH)
}

/// Variable of the F that moves the axes.
pub(super) fn feed(line: &RibbonLine) -> u32 {
    if line.feeds_per_revolution() { FEED_PER_TURN } else { VECTOR_FEED }
}

/// Least F (mm/min): the control reads a smaller one as F0.
pub(super) fn least_feed() -> Formula {
    real(0.001, 3)
}

/// The vector feed moves the axes.
pub(super) fn feed_moves() -> Condition {
    v(VECTOR_FEED).ge(least_feed())
}

/// The vector feed is zero: the override is 0.
pub(super) fn feed_is_zero() -> Condition {
    v(VECTOR_FEED).lt(least_feed())
}

/// 0 while no watched entry differs from its copy.
pub(super) fn changed(watched: &[(u32, u32)]) -> Formula {
    let mut sum: Option<Formula> = None;
    for (entry, copy) in watched {
        let difference = (v(*entry) - v(*copy)).abs();
        sum = Some(match sum {
            Some(sum) => sum + difference,
            None => difference,
        });
    }
    sum.unwrap_or(0.into())
}
