//! The operator's variables of the ribbon line: those that a program checks, and those that the page lists.

use crate::machines::machine::MachineVariable;
use crate::machines::program::writing::OperatorVariable;
use crate::machines::ribbon_line::params::Variant;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::variables::{
    ACTUAL_SPEED, BLOCK_PITCHES, BLOCK_SIZE, COUNT, FEED_LIMIT, FEED_PER_TURN, HEADS, LEFT, LENGTH, LINE_SPEED, PITCH,
    PRESS_ROLLER, PRINT_ROLLER, REDUCTION, REMAINDER, RIBBON_PER_TURN, SPEED, SPEED_CLAMP, STROKE, VECTOR_FEED,
};

/// The operator's variables.
pub(super) const ENTRIES: [OperatorVariable; 10] = [
    OperatorVariable::whole(SPEED),
    OperatorVariable::any(REDUCTION),
    OperatorVariable::any(PRESS_ROLLER),
    OperatorVariable::any(PITCH),
    OperatorVariable::whole(HEADS),
    OperatorVariable::any(PRINT_ROLLER),
    OperatorVariable::any(SPEED_CLAMP),
    OperatorVariable::any(FEED_LIMIT),
    OperatorVariable::whole(COUNT),
    OperatorVariable::whole(BLOCK_SIZE),
];

/// Whether a product is given by its length, independent of the pitch.
pub(super) fn is_length(line: &RibbonLine) -> bool {
    line.params.is_length(line.control)
}

/// The operator's variables on this control.
pub(super) fn entries(line: &RibbonLine) -> Vec<OperatorVariable> {
    let typed = line.override_macro_input().is_none().then_some(OperatorVariable::any(line.override_variable()));
    let product = |entry: OperatorVariable| match entry.number {
        COUNT if is_length(line) => OperatorVariable::any(LENGTH),
        _ => entry,
    };
    ENTRIES.into_iter().map(product).chain(typed).collect()
}

/// Variables that the operator reads and sets.
pub(in crate::machines::ribbon_line) fn variables(line: &RibbonLine) -> Vec<MachineVariable> {
    let variable = MachineVariable::new;
    let per_turn = line.feeds_per_revolution();
    let mut all = vec![
        variable(SPEED, "ribbon.spindle-speed", "r/min"),
        variable(REDUCTION, "ribbon.reduction-ratio", ": 1"),
        variable(PRESS_ROLLER, "ribbon.press-roller-diameter", "mm"),
        variable(PITCH, "ribbon.pitch", "mm"),
        variable(HEADS, "ribbon.heads", ""),
        variable(PRINT_ROLLER, "ribbon.print-roller-diameter", "mm"),
        variable(SPEED_CLAMP, "ribbon.speed-clamp", "r/min"),
        variable(FEED_LIMIT, "ribbon.feed-limit", if per_turn { "mm/rev" } else { "mm/min" }),
        if is_length(line) {
            variable(LENGTH, "ribbon.product-length", "mm")
        } else {
            variable(COUNT, "ribbon.pitch-count", "")
        },
        variable(BLOCK_SIZE, "ribbon.pitches-per-block", ""),
        variable(line.override_variable(), "ribbon.variable.input", ""),
        variable(ACTUAL_SPEED, "ribbon.readout.actual-speed", "r/min"),
        variable(LINE_SPEED, "ribbon.readout.line-speed", "mm/min"),
        variable(STROKE, "ribbon.readout.y-stroke", ""),
        variable(VECTOR_FEED, "ribbon.readout.vector-feed", "mm/min"),
    ];
    let ready_made = line.params.variant == Variant::ReadyMade;
    if per_turn || ready_made {
        all.push(variable(FEED_PER_TURN, "ribbon.readout.feed-per-revolution", "mm/rev"));
    }
    if ready_made {
        all.push(variable(RIBBON_PER_TURN, "ribbon.readout.k", "mm/rev"));
    }
    all.extend([
        variable(REMAINDER, "ribbon.variable.remainder", ""),
        variable(LEFT, "ribbon.variable.left", ""),
        variable(BLOCK_PITCHES, "ribbon.variable.block", ""),
    ]);
    all
}
