//! Controls that follow FANUC: ISO codes, custom macro B. Rows of the FANUC 0i; each control states what differs.

mod alarms;
mod codes;
mod interface;
mod params;
pub mod series_0i_f;
mod sources;
mod switches;
mod vars;

pub use alarms::{ALARMS, LATHE as LATHE_ALARMS};
pub use codes::{LATHE as LATHE_CODES, MILL as MILL_CODES};
pub use interface::{BITS, SIGNALS};
pub use params::{LATHE as LATHE_PARAMS, MILL as MILL_PARAMS};
pub use sources::*;
pub use switches::{LATHE as LATHE_SWITCHES, MILL as MILL_SWITCHES};
pub use vars::{LATHE as LATHE_VARS, MILL as MILL_VARS};

use crate::controls::bench::{Bench, BenchAxis, BenchShift};
use crate::controls::macros::{ArgumentSets, VacantWord};
use crate::controls::spindle::{LimitPlace, RapidSpeed};
use crate::controls::syntax::{ArcTangent, Function, Percent, RoundBrackets};
use crate::controls::{
    Address, AddressSet, AnalogOutput, AxisScaling, FeedKnob, Limits, Macros, ScalingKind, SpindleRules, Syntax, Timing,
};
use crate::drives::speed::KnobRange;
use crate::text::{Citation, Grade};

/// Functions of every control of the family, by their first spelling.
pub const FUNCTIONS: [(&str, Function); 15] = [
    ("SIN", Function::Sin),
    ("COS", Function::Cos),
    ("TAN", Function::Tan),
    ("ASIN", Function::Asin),
    ("ACOS", Function::Acos),
    ("ATAN", Function::Atan),
    ("SQRT", Function::Sqrt),
    ("ABS", Function::Abs),
    ("BIN", Function::Bin),
    ("BCD", Function::Bcd),
    ("ROUND", Function::Round),
    ("FIX", Function::Fix),
    ("FUP", Function::Fup),
    ("LN", Function::Ln),
    ("EXP", Function::Exp),
];

/// Short spellings read by some controls of the family.
pub const SHORT_FUNCTIONS: [(&str, Function); 2] = [("SQR", Function::Sqrt), ("RND", Function::Round)];

/// Functions introduced with the 30i and the 0i-F.
pub const LATER_FUNCTIONS: [(&str, Function); 2] = [("POW", Function::Power), ("ADP", Function::AddPoint)];

/// Spelling, characters and file form.
pub const SYNTAX: Syntax = Syntax {
    round: RoundBrackets::Comment,
    variable: '#',
    names: None,
    program_letters: b"O:",
    percent: Percent::Both,
    sequence_digits: 5,
    sequence_zero: false,
    bracket_names: false,
    program_digits: 4,
    block_chars: 80,
    message_chars: 31,
    bracket_depth: 5,
    if_then: true,
    modulo: true,
    comparison_signs: false,
    bare_functions: false,
    atan: ArcTangent::OfTwo,
    double_hash: true,
    nine_hash: false,
    absolute_holds: false,
    threads_per_inch: None,
    lead_by_axis: false,
    dwell_addresses: AddressSet::letters("PUX"),
    address_twice: false,
    block_read_chars: 60_000,
    block_words: 60_000,
    word_chars: u32::MAX,
    do_max: 3,
    do_depth: 3,
    random: &[],
    functions: &FUNCTIONS,
    addresses: AddressSet::letters("ABDEFGHIJKLMPQRSTUVW"),
    integer_addresses: AddressSet::letters("GLMNOPST"),
    point_alarm: true,
    increment_addresses: AddressSet::letters("ABCHIJKRUVWXYZ"),
    corners: &[],
    comma_addresses: AddressSet::letters("ACR"),
    extension: "nc",
    cite: Citation::new("FANUC Custom Macro B, sheet section 4; block length unknown", Grade::Open),
};

/// Calls, arguments and values of macro programs. A code calls a macro only if a parameter binds it.
pub const MACROS: Macros = Macros {
    vacant_word: VacantWord::Dropped,
    vacant_equals_zero: false,
    equal_within: 0.0,
    truths: false,
    whole_bits: false,
    value_range: Some((1e-29, 1e47)),
    round_words: true,
    argument_sets: ArgumentSets::InOrder,
    repeats_in_p: true,
    main_ends: false,
    ends_return: false,
    sub_sequence: false,
    call_first: false,
    program_next: false,
    call_ends_modal: false,
    call_after_return: true,
    common_kept: false,
    functions: &[],
    code_calls: &[],
    calls_override: true,
    code_calls_alone: false,
    user_alarms: (0, 200),
    user_alarm_base: Some(3000),
    user_alarm_prefix: "",
    cite: CALLS,
};

/// Ranges of words and depths of calls.
pub const LIMITS: Limits = Limits {
    increment: 0.001,
    coordinate_max: 99_999.999,
    feed_max: 240_000.0,
    revolution_feed_max: 500.0,
    inch_feeds: None,
    lead_max: 500.0,
    feed_increment: 0.001,
    arc_tolerance: 0.1,
    arc_centre_moves: false,
    point_arc_rests: true,
    feed_kept: false,
    speed_max: 99_999.0,
    speed_limit: None,
    tool_max: 99_999_999,
    offset_max: None,
    m_codes: 1,
    sub_depth: 4,
    macro_depth: 4,
    repeat_max: 9999,
    cite: MEMORY,
};

/// Block times, assumed.
pub const TIMING: Timing = Timing {
    block: 0.004,
    macro_block: 0.002,
    preread: 5,
    cite: Citation::new("assumed; measure with #3001", Grade::Open),
};

/// Feed override of the panels, 0 to 150 % in tens; the register takes 0 to 254 %.
pub const FEED_KNOB: FeedKnob = FeedKnob { positions: KnobRange { low: 0.0, high: 150.0, step: 10.0 }, cite: MEMORY };

/// Analog spindle: S in r/min, constant surface speed, limits.
pub const SPINDLE: SpindleRules = SpindleRules {
    volts_stay: false,
    offset_at_rest: true,
    rapid: RapidSpeed::OfEnd,
    surface_at_once: true,
    surface_limit_stays: false,
    surface_per_revolution: false,
    feed_ends_surface: false,
    last_speed_back: false,
    surface_range: None,
    small_offset: 0.0,
    limit_place: LimitPlace::Nothing,
    override_last: false,
    thread_override: false,
    emergency_clears: false,
    reached: None,
    stop_last: false,
    turns_through_reset: false,
    orients: false,
    angle_wraps: false,
    end_stops: false,
    manual_in_automatic: false,
    knob: KnobRange { low: 0.0, high: 254.0, step: 1.0 },
    override_codes: &[],
    offsets: None,
    stage_speeds: None,
    low_always: false,
    lower_wins: false,
    signed_output: false,
    stop_between: false,
    lock: None,
    driven_tool: None,
    cite: MEMORY,
};

/// Analog output for the speed of the spindle.
pub const ANALOG_OUTPUT: AnalogOutput = AnalogOutput { volts: 10.0, bits: 12, cite: MEMORY };

/// Feed gear of 2084 and 2085, command multiplier of 1820.
pub const SCALING: AxisScaling = AxisScaling {
    kind: ScalingKind::FeedGear { feedback: 1_000_000.0, multiplier: 2.0, diameter_multiplier: 102.0 },
    greatest_term: 32_767,
    cite: MEMORY,
};

/// An axis of the test bench with 0.1 s of acceleration and a position gain of 33/s.
pub const fn bench_axis(letter: Address, rapid: f64, clamp: f64) -> BenchAxis {
    BenchAxis { letter, rapid, clamp, time_constant: 0.1, position_gain: 33.0 }
}

/// Test bench of a lathe: two slides, a third linear and a rotary axis, four gears.
pub const BENCH: Bench = Bench {
    axes: &[
        bench_axis(Address::X, 12_000.0, 12_000.0),
        bench_axis(Address::Z, 24_000.0, 24_000.0),
        bench_axis(Address::Y, 240_000.0, 240_000.0),
        bench_axis(Address::C, 240_000.0, 240_000.0),
    ],
    gears: &[3000.0, 2000.0, 1200.0, 600.0],
    shift: BenchShift { volts: 0.1, before: 1.0, meshing: 0.5, after: 1.0 },
    speed_clamp: 3000.0,
    in_position: 0.02,
    ramp: 2.0,
    positioning: None,
    override_echo: Some(1032),
    fin_delay: 0.05,
};
