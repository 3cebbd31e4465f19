//! SINUMERIK 808D, turning: rows only. Single pages of its own manuals are known; the rows of the language are from its sisters.

mod rows;
mod sources;

use super::base::sinumerik;
use super::base::sinumerik::MEMORY;
use super::code::g_codes;
use super::interface::PlcLanguage;
use super::syntax::Names;
use super::{Address, AxisDef, Control, Limits, Syntax};
use sources::RANGES;

/// Names of the family, with definitions of variables: 808D turning 01/2017, p.126. Control structures, SPOSA and WAITS are in its alarms:
/// 808D diagnostics 07/2018, pp.167-168 and p.311. FOR is not named there, and neither denied.
const NAMES: Names = Names {
    local_data: true,
    foreign: &["CALL", "CASE", "COUPON", "DEF", "EGON", "EXTERN", "GOTOC", "PCALL", "PROC", "SETAL"],
    left_out: &["ELSE", "ENDIF", "ENDLOOP", "ENDWHILE", "LOOP", "SPOSA", "WAITS", "WHILE"],
    unsimulated: &["ENDFOR", "EXTCALL", "FGROUP", "FOR", "MCALL", "REPEAT", "REPEATB", "TRAILON", "UNTIL"],
    ..sinumerik::NAMES
};

/// The control.
pub static CONTROL: Control = Control {
    id: "sinumerik-808d",
    name: "SINUMERIK 808D",
    syntax: Syntax { names: Some(NAMES), ..sinumerik::SYNTAX },
    macros: sinumerik::MACROS,
    axes: &[
        AxisDef { letter: Address::X, rotary: false, incremental: None, diameter: true, cite: MEMORY },
        AxisDef { letter: Address::Y, rotary: false, incremental: None, diameter: false, cite: MEMORY },
        AxisDef { letter: Address::Z, rotary: false, incremental: None, diameter: false, cite: MEMORY },
    ],
    startup: &g_codes([1, 18, 40, 60, 71, 90, 95, 500]),
    limits: Limits { feed_max: 999_999.999, revolution_feed_max: 999_999.999, cite: RANGES, ..sinumerik::LIMITS },
    spindle: sinumerik::SPINDLE,
    timing: sinumerik::TIMING,
    feed_knob: sinumerik::FEED_KNOB,
    codes: rows::CODES,
    vars: sinumerik::VARS,
    alarms: rows::ALARMS,
    params: rows::PARAMS,
    interface: sinumerik::SIGNALS,
    plc: PlcLanguage::Step7,
    switches: rows::SWITCHES,
    analog_output: sinumerik::ANALOG_OUTPUT,
    scaling: Some(sinumerik::SCALING),
    zero_return: None,
    bench: sinumerik::BENCH,
    drives: sinumerik::DRIVES,
};
