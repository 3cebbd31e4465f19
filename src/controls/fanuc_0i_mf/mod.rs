//! FANUC 0i-MF, machining center: rows only. Its manuals are not at hand; alarms are those of its sister, the 30i.

mod rows;

use super::base::fanuc;
use super::base::fanuc::series_0i_f;
use super::bench::{Bench, BenchShift};
use super::code::g_codes;
use super::interface::PlcLanguage;
use super::schema::control::{linear_axis, rotary_axis};
use super::{Address, AddressSet, AnalogOutput, AxisScaling, Control, Limits, SpindleRules, Syntax};
use rows::MEMORY;

/// The control.
pub static CONTROL: Control = Control {
    id: "fanuc-0i-mf",
    name: "FANUC 0i-MF",
    syntax: Syntax {
        dwell_addresses: AddressSet::letters("PX"),
        addresses: AddressSet::letters("BDEFGHIJKLMPQRST"),
        integer_addresses: AddressSet::letters("DGHLMNOPST"),
        increment_addresses: AddressSet::letters("ABCIJKQRUVWXYZ"),
        ..series_0i_f::SYNTAX
    },
    macros: series_0i_f::MACROS,
    axes: &[
        linear_axis(Address::X, MEMORY),
        linear_axis(Address::Y, MEMORY),
        linear_axis(Address::Z, MEMORY),
        rotary_axis(Address::A, MEMORY),
    ],
    startup: &g_codes([0, 17, 21, 40, 54, 64, 67, 80, 90, 94, 97]),
    limits: Limits { cite: MEMORY, ..series_0i_f::LIMITS },
    timing: fanuc::TIMING,
    feed_knob: fanuc::FEED_KNOB,
    codes: rows::CODES,
    vars: rows::VARS,
    params: rows::PARAMS,
    alarms: rows::ALARMS,
    interface: rows::SIGNALS,
    plc: PlcLanguage::Pmc,
    switches: rows::SWITCHES,
    spindle: SpindleRules { signed_output: true, cite: MEMORY, ..fanuc::SPINDLE },
    analog_output: AnalogOutput { cite: MEMORY, ..fanuc::ANALOG_OUTPUT },
    scaling: Some(AxisScaling { cite: MEMORY, ..fanuc::SCALING }),
    zero_return: None,
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
    drives: series_0i_f::DRIVES,
};
