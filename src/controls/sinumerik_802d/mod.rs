//! SINUMERIK 802D, turning: rows only. Rows without a page of the 802D are from its successor 808D or from the 840D, and cite them.

mod rows;
mod sources;

use super::base::drives::FIELD_BUS;
use super::base::sinumerik;
use super::base::sinumerik::MEMORY;
use super::code::g_codes;
use super::interface::PlcLanguage;
use super::schema::table::joined;
use super::{AxisDef, Control, DriveSystem, Limits, SpindleRules, Syntax};
use crate::controls::Address;
use sources::{BLOCKS, RANGES, SPINDLE};

/// The control.
pub static CONTROL: Control = Control {
    id: "sinumerik-802d",
    name: "SINUMERIK 802D",
    syntax: Syntax { cite: BLOCKS, ..sinumerik::SYNTAX },
    macros: sinumerik::MACROS,
    axes: &[
        AxisDef { letter: Address::X, rotary: false, incremental: None, diameter: true, cite: SPINDLE },
        AxisDef { letter: Address::Y, rotary: false, incremental: None, diameter: false, cite: MEMORY },
        AxisDef { letter: Address::Z, rotary: false, incremental: None, diameter: false, cite: SPINDLE },
    ],
    startup: &g_codes([1, 18, 40, 60, 71, 90, 95, 500]),
    limits: Limits { cite: RANGES, ..sinumerik::LIMITS },
    spindle: SpindleRules { cite: SPINDLE, ..sinumerik::SPINDLE },
    timing: sinumerik::TIMING,
    feed_knob: sinumerik::FEED_KNOB,
    codes: rows::CODES,
    vars: sinumerik::VARS,
    alarms: sinumerik::ALARMS,
    params: rows::PARAMS,
    interface: sinumerik::SIGNALS,
    plc: PlcLanguage::Step7,
    switches: rows::SWITCHES,
    analog_output: sinumerik::ANALOG_OUTPUT,
    scaling: Some(sinumerik::SCALING),
    zero_return: None,
    bench: sinumerik::BENCH,
    drives: joined![DriveSystem: sinumerik::DRIVES, &FIELD_BUS],
};
