//! KND K2000T: rows only. Its manuals are not public: rows without a better source follow FANUC 0i-T, whose codes the control shares.

mod alarms;
mod rows;
mod sources;

use super::base::drives::{ANALOG_SPINDLE, PULSE};
use super::base::fanuc;
use super::base::fanuc::MEMORY;
use super::code::g_codes;
use super::interface::PlcLanguage;
use super::macros::{CallKind, CodeCalls};
use super::schema::table::joined;
use super::syntax::Function;
use super::{AxisDef, Control, DriveSystem, Macros, SpindleRules, Syntax};
use crate::controls::Address;
use sources::{PAPER, RETURN};

/// The control.
pub static CONTROL: Control = Control {
    id: "knd-k2000t",
    name: "KND K2000T",
    syntax: Syntax {
        functions: joined![(&str, Function): &fanuc::FUNCTIONS, &fanuc::SHORT_FUNCTIONS],
        ..fanuc::SYNTAX
    },
    macros: Macros {
        code_calls: &[CodeCalls::Each {
            kind: CallKind::Macro,
            negative: None,
            letter: Address::G,
            first: 4120,
            count: 20,
            program: 9120,
        }],
        code_calls_alone: true,
        ..fanuc::MACROS
    },
    axes: &[
        AxisDef { letter: Address::X, rotary: false, incremental: Some(Address::U), diameter: true, cite: PAPER },
        AxisDef { letter: Address::Z, rotary: false, incremental: Some(Address::W), diameter: false, cite: PAPER },
        AxisDef { letter: Address::Y, rotary: false, incremental: Some(Address::V), diameter: false, cite: MEMORY },
        AxisDef { letter: Address::C, rotary: true, incremental: Some(Address::H), diameter: false, cite: MEMORY },
    ],
    startup: &g_codes([0, 18, 98, 21, 40, 54, 67, 80, 97]),
    limits: fanuc::LIMITS,
    timing: fanuc::TIMING,
    feed_knob: fanuc::FEED_KNOB,
    codes: rows::CODES,
    vars: rows::VARS,
    alarms: alarms::ALARMS,
    params: rows::PARAMS,
    interface: rows::SIGNALS,
    plc: PlcLanguage::Pmc,
    switches: rows::SWITCHES,
    spindle: SpindleRules { signed_output: true, ..fanuc::SPINDLE },
    analog_output: fanuc::ANALOG_OUTPUT,
    scaling: Some(fanuc::SCALING),
    zero_return: Some(RETURN),
    bench: fanuc::BENCH,
    drives: joined![DriveSystem: &PULSE, ANALOG_SPINDLE],
};
