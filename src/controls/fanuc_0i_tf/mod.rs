//! FANUC 0i-TF, lathe, G code system A: rows only. Its manuals are not at hand; alarms are those of its sister, the 30i.

mod rows;

use super::base::fanuc;
use super::base::fanuc::MEMORY;
use super::code::g_codes;
use super::macros::{CallKind, CodeCalls};
use super::schema::table::joined;
use super::syntax::{ArcTangent, Function};
use super::{AxisDef, Control, Limits, Macros, SpindleRules, Syntax};
use crate::controls::Address;

/// The control.
pub static CONTROL: Control = Control {
    id: "fanuc-0i-tf",
    name: "FANUC 0i-TF",
    syntax: Syntax {
        sequence_digits: 8,
        atan: ArcTangent::OfOneOrTwo,
        functions: joined![(&str, Function): &fanuc::FUNCTIONS, &fanuc::SHORT_FUNCTIONS, &fanuc::LATER_FUNCTIONS],
        block_words: 26,
        ..fanuc::SYNTAX
    },
    macros: Macros {
        code_calls: &[
            CodeCalls::Each { kind: CallKind::Macro, letter: Address::G, first: 6050, count: 10, program: 9010 },
            CodeCalls::Each { kind: CallKind::Macro, letter: Address::M, first: 6080, count: 10, program: 9020 },
            CodeCalls::Each { kind: CallKind::Sub, letter: Address::M, first: 6071, count: 9, program: 9001 },
        ],
        user_alarm_prefix: "MC",
        ..fanuc::MACROS
    },
    axes: &[
        AxisDef { letter: Address::X, rotary: false, incremental: Some(Address::U), diameter: true, cite: MEMORY },
        AxisDef { letter: Address::Z, rotary: false, incremental: Some(Address::W), diameter: false, cite: MEMORY },
        AxisDef { letter: Address::Y, rotary: false, incremental: Some(Address::V), diameter: false, cite: MEMORY },
        AxisDef { letter: Address::C, rotary: true, incremental: Some(Address::H), diameter: false, cite: MEMORY },
    ],
    startup: &g_codes([0, 18, 99, 21, 40, 54, 67, 80, 97]),
    limits: Limits { coordinate_max: 999_999.999, sub_depth: 10, macro_depth: 5, ..fanuc::LIMITS },
    timing: fanuc::TIMING,
    codes: fanuc::LATHE_CODES,
    vars: fanuc::LATHE_VARS,
    params: fanuc::LATHE_PARAMS,
    alarms: fanuc::ALARMS,
    interface: fanuc::SIGNALS,
    switches: rows::SWITCHES,
    spindle: SpindleRules { signed_output: true, ..fanuc::SPINDLE },
    bench: fanuc::BENCH,
};
