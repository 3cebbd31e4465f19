//! Mitsubishi MELDAS E60: rows only.

mod alarms;
mod codes;
mod drives;
mod interface;
mod params;
mod sources;
mod switches;
mod vars;

use super::base::fanuc;
use super::bench::{Bench, BenchShift};
use super::code::g_codes;
use super::interface::PlcLanguage;
use super::macros::CodeCalls;
use super::schema::control::{linear_axis, rotary_axis};
use super::schema::table::joined;
use super::syntax::{ArcTangent, Function};
use super::{AnalogOutput, AxisScaling, Control, FeedKnob, Limits, Macros, ScalingKind, SpindleRules, Syntax, Timing};
use crate::controls::{Address, AddressSet};
use crate::drives::speed::KnobRange;
use crate::text::{Citation, Grade};
use drives::DRIVES;
use sources::{MEMORY, PAPER};

/// The control.
pub static CONTROL: Control = Control {
    id: "mitsubishi-e60",
    name: "Mitsubishi E60",
    syntax: Syntax {
        program_letters: b"OL",
        program_digits: 8,
        if_then: false,
        modulo: false,
        atan: ArcTangent::OfOne,
        threads_per_inch: Some(Address::E),
        dwell_addresses: AddressSet::letters("PX"),
        do_max: 127,
        do_depth: 27,
        functions: joined![(&str, Function): &fanuc::FUNCTIONS, &fanuc::SHORT_FUNCTIONS, &[("ATN", Function::Atan)]],
        addresses: AddressSet::letters("BDEFGHIJKLMPQRST"),
        integer_addresses: AddressSet::letters("DGHLMNOST"),
        point_alarm: false,
        increment_addresses: AddressSet::letters("ABCIJKRUVWXYZ"),
        comma_addresses: AddressSet::letters("ACDFHIJKPQRST"),
        cite: Citation::new("M700V/M70V programming manual, p.19, 23, 28, 40; macro text from memory", Grade::Sister),
        ..fanuc::SYNTAX
    },
    macros: Macros {
        value_range: None,
        round_words: false,
        repeats_in_p: false,
        sub_sequence: true,
        common_kept: true,
        code_calls: &[
            CodeCalls::Pairs { letter: Address::G, code: 7201, kind: 7202, program: 7203, step: 10, count: 10 },
            CodeCalls::Pairs { letter: Address::M, code: 7001, kind: 7002, program: 7003, step: 10, count: 10 },
        ],
        user_alarms: (1, 9999),
        user_alarm_base: None,
        cite: Citation::new(
            "M700V/M70V programming manual, p.326; calls, arguments, macro list from memory",
            Grade::Open,
        ),
        ..fanuc::MACROS
    },
    axes: &[
        linear_axis(Address::X, PAPER),
        linear_axis(Address::Y, PAPER),
        linear_axis(Address::Z, MEMORY),
        rotary_axis(Address::A, MEMORY),
    ],
    startup: &g_codes([1, 17, 21, 54, 64, 67, 80, 90, 94, 97]),
    limits: Limits {
        feed_max: 1_000_000.0,
        revolution_feed_max: 1_000_000.0,
        lead_max: 1_000_000.0,
        speed_max: 99_999_999.0,
        m_codes: 4,
        sub_depth: 8,
        cite: Citation::new(
            "M700V/M70V programming manual, p.23, 40, 158; feed, arcs and nesting from memory",
            Grade::Open,
        ),
        ..fanuc::LIMITS
    },
    timing: Timing {
        block: 0.0071,
        macro_block: 0.003,
        cite: Citation::new(
            "E68 class block rate 7.1 ms and 1 to 5 ms a macro block, assumed: measure with #3001",
            Grade::Open,
        ),
        ..fanuc::TIMING
    },
    feed_knob: FeedKnob {
        cite: Citation::new("M70 driver: codes of the feed override, 0 to 150 %", Grade::Sister),
        ..fanuc::FEED_KNOB
    },
    codes: codes::CODES,
    vars: vars::VARS,
    alarms: alarms::ALARMS,
    params: params::PARAMS,
    interface: interface::SIGNALS,
    plc: PlcLanguage::Melsec,
    switches: switches::SWITCHES,
    spindle: SpindleRules {
        thread_override: true,
        knob: KnobRange { low: 0.0, high: 200.0, step: 1.0 },
        cite: Citation::new(
            "ribbon dot-printing paper, E60: S times override, clamped; the rest from memory",
            Grade::Open,
        ),
        ..fanuc::SPINDLE
    },
    analog_output: AnalogOutput {
        cite: Citation::new("ribbon line facts, 4; 12 bits from memory", Grade::Open),
        ..fanuc::ANALOG_OUTPUT
    },
    scaling: Some(AxisScaling { kind: ScalingKind::WholeLead, greatest_term: 32_767, cite: params::SCALING }),
    zero_return: None,
    bench: Bench {
        axes: &[
            fanuc::bench_axis(Address::X, 240_000.0, 240_000.0),
            fanuc::bench_axis(Address::Y, 240_000.0, 240_000.0),
            fanuc::bench_axis(Address::Z, 30_000.0, 30_000.0),
        ],
        gears: &[1480.0],
        shift: BenchShift { volts: 0.0, before: 0.0, meshing: 0.0, after: 0.0 },
        speed_clamp: 1480.0,
        override_echo: Some(1033),
        ..fanuc::BENCH
    },
    drives: DRIVES,
};
