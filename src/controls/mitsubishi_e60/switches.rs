//! Points of the E60 that no manual at hand settles.

use super::MEMORY;
use crate::controls::Switch;
use crate::controls::macros::CALL_PARAMETERS;
use crate::controls::switch::switch;
use crate::text::{Citation, Grade};

const DECIMALS: Citation = Citation::new("M700V/M70V programming manual, p.40: parameter #1078", Grade::Sister);

/// The listing of the paper has such points, and does not read for other reasons.
const LISTING: Citation = Citation::new("ribbon dot-printing paper, E60, against MELDAS usage", Grade::Open);

/// What the M700 has, and the E60 is told to lack.
const LATER: Citation = Citation::new("MELDAS usage, unverified: only from the M700 on", Grade::Open);

/// One row per point; the first option is the default.
pub(super) const SWITCHES: &[Switch] = &[
    switch(
        "macro-input-base",
        "First register of the macro inputs: #1032 starts here",
        &["R72", "R172", "R24", "R124", "R6436"],
        Citation::new("MELDAS 64 list and the paper (R74) against the M60 device map", Grade::Open),
    ),
    switch(
        "common-variables",
        "Common variables: 100, 200, 300 or 600 sets",
        &[
            "#100 to #149, #500 to #549",
            "#100 to #199, #500 to #599",
            "#100 to #199, #500 to #699",
            "#100 to #199, #500 to #999",
        ],
        Citation::new("MELDAS option list, unverified: 100 sets are the standard of the E60", Grade::Open),
    ),
    switch(
        "offset-values",
        "A value that a program writes to a tool or work offset",
        &["as written", "increments"],
        MEMORY,
    ),
    switch("decimal-point", "A coordinate without a point (#1078)", &["increments", "millimetres"], DECIMALS),
    switch("argument-point", "A macro argument without a point", &["increments", "as written"], MEMORY),
    switch("point-behind-variable", "A point behind a variable, X#107.", &["alarm", "ignored"], LISTING),
    switch("if-then", "IF [ ] THEN", &["alarm", "read"], LATER),
    switch("modulo", "MOD", &["alarm", "read"], LATER),
    switch("assignments", "Assignments in a block", &["one", "several"], MEMORY),
    switch(
        "round-in-word",
        "ROUND behind an address, X[ROUND[#1]]",
        &["to a whole number", "to the step of the address"],
        Citation::new("MELDAS usage, unverified, tells of whole numbers alone", Grade::Open),
    ),
    switch("startup-distance", "Dimensions after power-on (#1073)", &["G90", "G91"], MEMORY),
    switch("startup-motion", "Motion code after power-on (#1075)", &["G01", "G00"], MEMORY),
    switch("thread-e", "E of a thread, G33 (#8156)", &["threads per inch", "lead"], MEMORY),
    switch("feed-zero", "What F0 does (#1079)", &["alarm", "rapid"], MEMORY),
    switch("spindle-word", "S with decimals", &["truncate", "round"], DECIMALS),
    switch(
        "speed-reached",
        "Cuts and the spindle's speed (SAR)",
        &["do not wait", "wait"],
        Citation::new("MELDAS 50 practice with an inverter: no such signal", Grade::Open),
    ),
    switch("m5-timing", "M05 beside a motion", &["before", "end"], MEMORY),
    switch(
        CALL_PARAMETERS,
        "Macro list: code, type (0 as M98, 1 G65, 2 G66, 3 G66.1), program: #7201=200 #7202=1 #7203=9010 for G200",
        &[""],
        MEMORY,
    ),
    switch("common-at-reset", "#100 and up at reset (#1128)", &["kept", "vacant"], MEMORY),
    switch("locals-of-calls", "Locals without an argument (#1114)", &["vacant", "kept"], MEMORY),
    switch("override-suppression", "#3004 bit 1 switches the cutting override off", &["yes", "no"], MEMORY),
];
