//! Sentences about time, axes, spindle, panel.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[
    (
        "motion.axis-clamp",
        "Axis {0} may run at most {1} per minute: the control slows the whole block from F{2} to F{3}, and with it the ratio to the spindle.",
    ),
    ("motion.emergency-stop", "Emergency stop. Reset, then cycle start, to begin again."),
    ("motion.missing-axis", "The machine has no axis {0}; the simulation moves it without acceleration and clamp."),
    (
        "motion.no-feed",
        "The program waits for ever: the feed is 0. Raise the feed override, or let the spindle turn where F counts per revolution.",
    ),
    ("motion.no-fin", "The program waits for ever: the PLC does not answer this code with FIN."),
    ("motion.nothing-to-set", "“{0}” is no variable and no input that can be set; it was left out."),
    ("motion.out-of-blocks", "Stopped after {0} blocks, the budget of this run: the program may never end by itself."),
    (
        "motion.out-of-seconds",
        "Stopped after {0} s of machine time, the budget of this run: the program has not ended by then, and may never.",
    ),
    (
        "motion.spindle-clamp",
        "The spindle is told {0} r/min and clamped to {1} r/min; what the program computes from S is not clamped with it.",
    ),
    (
        "motion.spindle-stands",
        "The spindle stands still: a feed per revolution waits until it turns. Command S and M03 or M04 before this block.",
    ),
    (
        "motion.starved",
        "The axes stop between blocks: this block takes longer to read ({0} ms, and {1} ms for each macro block before it) than the one before takes to execute. More travel per block, or fewer macro blocks, mends it.",
    ),
];
