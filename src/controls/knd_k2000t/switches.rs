//! Points of the K2000T that no manual at hand settles, and parameters that change what a program means.

use super::{MEMORY, PAPER};
use crate::controls::Switch;
use crate::controls::macros::CALL_PARAMETERS;
use crate::controls::switch::switch;
use crate::text::{Citation, Grade};

/// The samples show what is meant; the parameter's number is FANUC's.
const SAMPLE: Citation = Citation::new("sample of the polygon turning paper; parameter by FANUC 0i-T", Grade::Inferred);

/// One row per point; the first option is the default.
pub(super) const SWITCHES: &[Switch] = &[
    switch("decimal-point", "A coordinate without a point (3401#0)", &["millimetres", "increments"], SAMPLE),
    switch("argument-point", "A macro argument without a point", &["as written", "increments"], SAMPLE),
    switch("point-behind-variable", "A point behind a variable, X#107.", &["alarm", "ignored"], MEMORY),
    switch("assignments", "Assignments in a block", &["one", "several"], MEMORY),
    switch("word-formula", "A formula behind an address, X#100+10", &["as it is", "in brackets"], MEMORY),
    switch(
        "round-in-word",
        "ROUND behind an address, X[ROUND[#1]]",
        &["to the step of the address", "to a whole number"],
        Citation::new("custom macro B of FANUC, by secondary sources", Grade::Inferred),
    ),
    switch(
        "number-digits",
        "Digits of a number",
        &["12", "8"],
        Citation::new("8 on older FANUC controls by a forum, 12 on newer ones from memory", Grade::Open),
    ),
    switch("diameter", "Words of X (1006#3)", &["diameter", "radius"], SAMPLE),
    switch(
        "m-codes",
        "More than one M code in a block (3404#7)",
        &["the last acts", "the last 3 act", "alarm"],
        MEMORY,
    ),
    switch("startup-motion", "Motion code after power-on (3402#0)", &["G00", "G01"], MEMORY),
    switch("startup-feed", "Unit of F after power-on (3402#4)", &["G98", "G99"], SAMPLE),
    switch(
        "angle-range",
        "Results of ATAN and ASIN (6004#0)",
        &["ATAN 0 to 360, ASIN 270 to 90", "ATAN -180 to 180, ASIN -90 to 90"],
        MEMORY,
    ),
    switch("speed-reached", "Cuts and the spindle's speed (3708#0)", &["do not wait", "wait"], MEMORY),
    switch("override-order", "Spindle override", &["before the limits", "behind the limits"], MEMORY),
    switch("m5-timing", "M05 beside a motion", &["before", "end"], MEMORY),
    switch("spindle-at-reset", "The spindle at reset", &["stops", "turns"], MEMORY),
    switch(CALL_PARAMETERS, "4120 to 4139: G codes that call O9120 to O9139", &["4120=512 4121=502"], PAPER),
    switch("pmc-override", "Feed override and axes that the PMC turns", &["acts not", "acts"], MEMORY),
    switch("common-at-reset", "#100 to #199 at reset (6001#6)", &["vacant", "kept"], MEMORY),
    switch("locals-of-calls", "Locals without an argument", &["vacant", "kept"], MEMORY),
    switch("override-suppression", "#3004 bit 1 switches the cutting override off", &["yes", "no"], MEMORY),
];
