//! FANUC 0i-TF, lathe, G code system A: rows only. Its manuals are not at hand; alarms are those of its sister, the 30i.

use super::base::fanuc;
use super::base::fanuc::MEMORY;
use super::base::fanuc::series_0i_f;
use super::code::g_codes;
use super::interface::PlcLanguage;
use super::{AxisDef, Control, SpindleRules};
use crate::controls::Address;

/// The control.
pub static CONTROL: Control = Control {
    id: "fanuc-0i-tf",
    name: "FANUC 0i-TF",
    syntax: series_0i_f::SYNTAX,
    macros: series_0i_f::MACROS,
    axes: &[
        AxisDef { letter: Address::X, rotary: false, incremental: Some(Address::U), diameter: true, cite: MEMORY },
        AxisDef { letter: Address::Z, rotary: false, incremental: Some(Address::W), diameter: false, cite: MEMORY },
        AxisDef { letter: Address::Y, rotary: false, incremental: Some(Address::V), diameter: false, cite: MEMORY },
        AxisDef { letter: Address::C, rotary: true, incremental: Some(Address::H), diameter: false, cite: MEMORY },
    ],
    startup: &g_codes([0, 18, 99, 21, 40, 54, 67, 80, 97]),
    limits: series_0i_f::LIMITS,
    timing: fanuc::TIMING,
    feed_knob: fanuc::FEED_KNOB,
    codes: fanuc::LATHE_CODES,
    vars: fanuc::LATHE_VARS,
    params: fanuc::LATHE_PARAMS,
    alarms: fanuc::LATHE_ALARMS,
    interface: fanuc::SIGNALS,
    plc: PlcLanguage::Pmc,
    switches: series_0i_f::LATHE_SWITCHES,
    spindle: SpindleRules { signed_output: true, ..fanuc::SPINDLE },
    analog_output: fanuc::ANALOG_OUTPUT,
    scaling: Some(fanuc::SCALING),
    zero_return: None,
    bench: fanuc::BENCH,
    drives: series_0i_f::DRIVES,
};
