//! FANUC 0i-MF, machining center: rows only. Its manuals are not at hand; alarms are those of its sister, the 30i.

mod rows;

use super::base::fanuc;
use super::bench::{Bench, BenchShift};
use super::code::g_codes;
use super::macros::{CallKind, CodeCalls};
use super::schema::control::axis;
use super::schema::table::joined;
use super::syntax::{ArcTangent, Function};
use super::{Address, AddressSet, Control, Limits, Macros, SpindleRules, Syntax, Timing};
use rows::MEMORY;

/// The control.
pub static CONTROL: Control = Control {
    id: "fanuc-0i-mf",
    name: "FANUC 0i-MF",
    syntax: Syntax {
        sequence_digits: 8,
        atan: ArcTangent::OfOneOrTwo,
        functions: joined![(&str, Function): &fanuc::FUNCTIONS, &fanuc::SHORT_FUNCTIONS, &fanuc::LATER_FUNCTIONS],
        block_words: 26,
        dwell_addresses: AddressSet::letters("PX"),
        addresses: AddressSet::letters("BDEFGHIJKLMPQRST"),
        integer_addresses: AddressSet::letters("DGHLMNOPST"),
        increment_addresses: AddressSet::letters("ABCIJKQRUVWXYZ"),
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
        axis(Address::X, false, MEMORY),
        axis(Address::Y, false, MEMORY),
        axis(Address::Z, false, MEMORY),
        axis(Address::A, true, MEMORY),
    ],
    startup: &g_codes([0, 17, 21, 40, 54, 64, 67, 80, 90, 94, 97]),
    limits: Limits { coordinate_max: 999_999.999, sub_depth: 10, macro_depth: 5, cite: MEMORY, ..fanuc::LIMITS },
    timing: Timing { cite: fanuc::TIMING.cite, ..fanuc::TIMING },
    codes: rows::CODES,
    vars: rows::VARS,
    params: rows::PARAMS,
    alarms: rows::ALARMS,
    interface: rows::SIGNALS,
    switches: rows::SWITCHES,
    spindle: SpindleRules { signed_output: true, cite: MEMORY, ..fanuc::SPINDLE },
    bench: Bench {
        axes: &[
            fanuc::bench_axis(Address::X, 240_000.0, 240_000.0),
            fanuc::bench_axis(Address::Y, 240_000.0, 240_000.0),
            fanuc::bench_axis(Address::Z, 30_000.0, 30_000.0),
        ],
        gears: &[3000.0],
        shift: BenchShift { volts: 0.0, before: 0.0, meshing: 0.0, after: 0.0 },
        ..fanuc::BENCH
    },
};
