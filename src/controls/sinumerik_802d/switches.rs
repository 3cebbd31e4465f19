//! Points of the 802D that no manual at hand settles, and data that change what a program means.

use super::{BLOCKS, MEMORY, SPINDLE};
use crate::controls::Switch;
use crate::controls::switch::switch;
use crate::controls::syntax::{BLOCK_LENGTH, LABEL_LENGTH, NUMBER_JUMPS, ROTARY_AXES};
use crate::text::{Citation, Grade};

const RADII: Citation =
    Citation::new("G22 and G23 belong to the 802S and 802C; the 802D has DIAMOF and DIAMON", Grade::Open);
const M5: Citation = Citation::new(
    "the page on 802D spindle commands, 1(2): the axes first; 808D parameter manual, p.60: before, where the builder leaves it",
    Grade::Manual,
);
const REACHED: Citation = Citation::new("808D parameter manual: MD35500 and MD35150", Grade::Sister);
const ACTIVATION: Citation = Citation::new("no source says it", Grade::Open);
const ANGLE: Citation = Citation::new("alarm 16830 of the 808D, p.245; MD30455 by a secondary page", Grade::Sister);
const KNOB: Citation =
    Citation::new("840D sl basic functions 01/2015, p.1338 and 1666; panels by usage", Grade::Sister);
const BUILDER: Citation = Citation::new(
    "the machine builder's; the page on 802D spindle commands asks for lock and driven tool",
    Grade::Open,
);
const LABELS: Citation = Citation::new("2 to 8 characters by usage of the 802D; 32 on larger controls", Grade::Open);
const ENDS: Citation = Citation::new("808D milling guide, p.79: M2 returns; M30 by usage", Grade::Open);
const LEVELS: Citation =
    Citation::new("808D milling guide, p.79, and 828D: 8; 808D diagnostics 07/2018, p.175: 16", Grade::Sister);
const JUMPS: Citation = Citation::new("alarm 14080 of the 808D, p.184: asks for a label, not a number", Grade::Sister);
const RANGE: Citation = Citation::new("R0 to R249 on 802S and 802C", Grade::Sister);

/// One row per point; the first option is the default.
pub(super) const SWITCHES: &[Switch] = &[
    switch("diameter", "Words of X (MD20100)", &["diameter", "radius"], SPINDLE),
    switch("startup-motion", "Motion after power-on", &["G1", "G0"], MEMORY),
    switch("startup-feed", "Unit of F after power-on", &["G95", "G94"], MEMORY),
    switch("startup-path", "Exact stop or continuous path after power-on", &["G60", "G64"], MEMORY),
    switch("speed-reached", "Cuts and the spindle's speed (MD35500)", &["wait", "do not wait"], REACHED),
    switch("m5-timing", "M5 beside a motion stops the spindle", &["end", "before"], M5),
    switch("lims-in-g97", "LIMS holds G97 too", &["no", "yes"], SPINDLE),
    switch("crossed-limits", "G25 above G26: which one holds", &["upper holds", "lower holds"], ACTIVATION),
    switch("g96-apply-at-activation", "G96 sets the speed at once", &["yes", "no"], ACTIVATION),
    switch("g9x-without-s", "S behind G94 and G95 that end G96", &["last programmed", "hold"], SPINDLE),
    switch(
        "spindle-knob",
        "Spindle override: what the interface takes, or what a panel has",
        &["0 to 200 %", "50 to 120 %"],
        KNOB,
    ),
    switch("spos-out-of-range", "SPOS outside 0 to 359.999 (MD30455)", &["alarm", "modulo"], ANGLE),
    switch(
        "spindle-lock",
        "M code that locks the spindle at its angle; empty: any M code of the builder",
        &[""],
        BUILDER,
    ),
    switch("driven-tool", "M code that starts a driven tool; empty: only another spindle is one", &[""], BUILDER),
    switch("r-parameters", "R parameters (MD28050)", &["R0 to R299", "R0 to R249"], RANGE),
    switch("end-in-subprogram", "M2 and M30 in a subprogram", &["return", "end the program"], ENDS),
    switch("subprogram-levels", "Levels of programs, the main one included", &["8", "16"], LEVELS),
    switch(ROTARY_AXES, "Rotary axes (MD30300, MD30310), for instance Y: DC, ACP and ACN are for them", &[""], BUILDER),
    switch("working-area", "G25 and G26 with axes (SD43400, SD43410)", &["limit", "limit not"], MEMORY),
    switch(
        "reference-point",
        "Reference points (MD34100), where G74 goes: for instance X300 Z500; else 0",
        &[""],
        BUILDER,
    ),
    switch("fixed-point", "Fixed point (MD30600), where G75 goes: for instance X300 Z500; else 0", &[""], BUILDER),
    switch(LABEL_LENGTH, "Characters of a label at most", &["8", "32"], LABELS),
    switch(BLOCK_LENGTH, "Characters of a block: 200, on the 802D sl 512", &["200", "512"], BLOCKS),
    switch(NUMBER_JUMPS, "GOTOF and GOTOB to block numbers", &["no", "yes"], JUMPS),
    switch("codes-g22-g23", "G22 and G23", &["alarm", "radius and diameter"], RADII),
];
