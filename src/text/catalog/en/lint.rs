//! Sentences of the warnings that a senior programmer would give.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[
    (
        "lint.auxiliary-in-loop",
        "{0} stands in every pass of a loop that cuts: each time the control waits for the PLC, and the axes stop. Put it before the loop, or jump over it.",
    ),
    (
        "lint.equal-decimals",
        "{0} compares every digit, and the value can have decimals: what should be equal may differ in the last one.",
    ),
    (
        "lint.feed-per-minute",
        "{0} is {1} mm a minute: no program here says {2}, and the control starts with feed per minute ({3}× here). Write {2} before it, or set how this control starts.",
    ),
    (
        "lint.feed-per-revolution",
        "{0} is {1} mm a revolution: no program here says {2}, and this control is set to start with feed per revolution ({3}× here). Write {2} before it, or set how this control starts.",
    ),
    ("lint.feed-zero", "F0 is no feed: a cutting motion stops with an alarm. Jump over the motion, or wait by G04."),
    (
        "lint.feed-zero-digit",
        "F0 is no feed: a cutting motion stops with an alarm, or runs in rapid traverse where {1} is 1. Jump over the motion, or wait by G04.",
    ),
    ("lint.feed-zero-rapid", "F0 is rapid traverse here ({1}). Jump over the motion, or wait by G04."),
    ("lint.fix.point", "Add the point: {0}"),
    ("lint.fix.present", "Write what it is now: {0}"),
    ("lint.fix.unit", "Write {0} in front of it"),
    ("lint.hint-argument", "No call here passes the argument {1}."),
    ("lint.hint-difference", "Test it before: IF[ABS[{0}] LT 0.0001]GOTO …"),
    ("lint.hint-divisor", "Test it before: IF[{0} LE 0]GOTO …"),
    ("lint.hint-equal", "Compare by GE, GT, LE or LT, or within a tolerance: ABS[a-b] LT 0.0001."),
    ("lint.hint-unset-local", "Assign {0} before; what the operator sets is a common variable."),
    ("lint.hint-vacant", "Test it before: IF[{1} EQ #0]GOTO …"),
    (
        "lint.kept-as-scratch",
        "{0} is no free variable ({1}): what is calculated into it stays, and acts on the next part. Take a common variable.",
    ),
    (
        "lint.main-returns",
        "A main program that ends in {0} starts again for ever. End it with {1}; {0} is for subprograms.",
    ),
    (
        "lint.no-point",
        "{0} is {1} {2}: without its point a number counts increments ({3}× behind {4} in this program).",
    ),
    (
        "lint.no-point-argument",
        "{0} passes {1} to the macro: without its point a number counts increments ({3}× behind {4} in this program).",
    ),
    ("lint.no-point-dwell", "{0} waits {1} s: without its point a number counts increments ({3}× in this program)."),
    (
        "lint.short-blocks",
        "This block is over in {1} ms, but the control needs {2} ms to read the next one ({3}× in this program): the axes stop in between. More travel per block or a lower F mends it.",
    ),
    (
        "lint.spindle-in-loop",
        "{0} stands in every pass of a loop: each time the control waits for the PLC, and the axes stop. Put it before the loop, or jump over it while nothing has changed.",
    ),
    (
        "lint.suppression-stays",
        "{0} is never set back to 0, and no M02 or M30 here resets it: it stays so for whatever runs next.",
    ),
    (
        "lint.unreachable",
        "Nothing leads here: this block and what follows it ({1} in a row) never run. Jump here, or delete them.",
    ),
    (
        "lint.unset-common",
        "To be set on the screen before the start, as no program here does: {1}. What is not set is vacant, and counts as 0 in formulas.",
    ),
    ("lint.unset-local", "Nothing sets {0}: it is vacant when it is read."),
    ("lint.vacant-word", "{0} is left out while {1} is vacant: the axis does not move."),
    ("lint.zero-divisor", "{0} can be 0, and nothing compares it before: dividing by it would stop with {1}."),
];
