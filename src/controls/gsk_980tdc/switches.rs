//! Points of the 980TDc that no manual at hand settles, and parameters that change what a program means.

use super::{MACRO, MEMORY, PARAMETERS, STATEMENT};
use crate::controls::Switch;
use crate::controls::macros::CALL_PARAMETERS;
use crate::controls::switch::switch;
use crate::text::{Citation, Grade};

const LADDER: Citation = Citation::new("GSK980MDi manual, ladder 3.1", Grade::Sister);
const PLC_DATA: Citation = Citation::new("GSK980TDi PLC data list, K16.5 and K17.3", Grade::Sister);
const ESCD: Citation =
    Citation::new("GSK980TDc manual, 2.2.2: kept; parameter GSK980MDi manual 2022, p.374", Grade::Sister);
const CALLS: Citation = Citation::new("GSK980TDi manual, 3.32; M codes: notes on new functions", Grade::Sister);
const ALARMS: Citation =
    Citation::new("GSK980TDi manual, 3.28: 5900 + n; an older list has 500 + n for H99", Grade::Sister);
/// All samples of the manuals leave the point out.
const SAMPLES: Citation =
    Citation::new("samples of the 980TDi manual: G00 X100 Z50 is 100 mm and 50 mm", Grade::Inferred);

/// One row per point; the first option is the default.
pub(super) const SWITCHES: &[Switch] = &[
    switch("decimal-point", "A coordinate without a point", &["millimetres", "increments"], SAMPLES),
    switch("argument-point", "A macro argument without a point", &["as written", "increments"], MACRO),
    switch("point-behind-variable", "A point behind a variable, X#107.", &["alarm", "ignored"], MEMORY),
    switch("assignments", "Assignments in a block", &["one", "several"], MEMORY),
    switch("word-formula", "A formula behind an address, X#100+10", &["as it is", "in brackets"], MEMORY),
    switch(
        "round-in-word",
        "ROUND behind an address, X[ROUND[#1]]",
        &["to a whole number", "to the step of the address"],
        Citation::new("GSK980TDi manual, 3.29, tells of statements, IF and WHILE alone", Grade::Open),
    ),
    switch("diameter", "Words of X (No.001#2)", &["diameter", "radius"], PARAMETERS),
    switch("m-codes", "A second M code in a block", &["alarm", "the last acts"], MEMORY),
    switch("startup-feed", "Unit of F after power-on (No.182#0)", &["G98", "G99"], PARAMETERS),
    switch(
        "angle-range",
        "Results of ATAN and ASIN (No.180#7)",
        &["ATAN 0 to 360, ASIN -90 to 90", "ATAN -180 to 180, ASIN 90 to 270"],
        STATEMENT,
    ),
    switch(
        "speed-limit-sets-zero",
        "What G50 S makes of the present position",
        &["reference point", "work zero", "nothing"],
        Citation::new(
            "GSK980TDc manual, 2.2.3: the program reference point; on the TDi it sets nothing",
            Grade::Manual,
        ),
    ),
    switch("speed-reached", "Cuts and the spindle's speed (No.175#6)", &["do not wait", "wait"], PARAMETERS),
    switch("override-order", "Spindle override", &["before the limits", "behind the limits"], MEMORY),
    switch("m5-timing", "M05 beside a motion (PLC K16.5)", &["end", "before"], PLC_DATA),
    switch("volts-at-stop", "The analog output at M05 (PLC K17.3)", &["kept", "off"], PLC_DATA),
    switch("volts-at-emergency-stop", "The analog output at emergency stop (No.173#0)", &["kept", "off"], ESCD),
    switch(
        "m03-m04",
        "M04 while a machine's PLC puts out M03, or M03 while M04 (A0.3)",
        &["alarm", "turns back"],
        LADDER,
    ),
    switch("spindle-at-reset", "The spindle at reset (K10.1 RSJG)", &["stops", "turns"], LADDER),
    switch("spindle-at-end", "The spindle at M30 (K10 MTSS of the milling control)", &["turns", "stops"], LADDER),
    switch("spindle-word", "S with decimals", &["round", "truncate"], MEMORY),
    switch("user-alarm-base", "Number of a user alarm (#3000 = n, H99 P n): this and n", &["5900", "500"], ALARMS),
    switch(
        CALL_PARAMETERS,
        "No.086 to No.091: codes that call programs, for instance 86=3 87=100 88=2000 for G100 to G102",
        &[""],
        CALLS,
    ),
    switch("common-at-reset", "#100 to #199 at reset", &["kept", "vacant"], MEMORY),
    switch("locals-of-calls", "Locals without an argument", &["vacant", "kept"], MACRO),
];
