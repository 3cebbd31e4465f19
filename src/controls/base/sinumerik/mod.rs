//! SINUMERIK controls: R parameters, named addresses and codes, subprograms by name. Rows of the 840D and 808D, sisters of one language.

mod alarms;
mod codes;
mod interface;
mod params;
mod sources;
mod switches;
mod vars;

pub use alarms::ALARMS;
pub use codes::{CODES, NAMES as CODE_NAMES};
pub use interface::SIGNALS;
pub use params::PARAMS;
pub use sources::*;
pub use switches::SWITCHES;
pub use vars::VARS;

use crate::controls::CodeId;
use crate::controls::base::drives::ANALOG_SPINDLE;
use crate::controls::bench::{Bench, BenchAxis, BenchShift};
use crate::controls::macros::{ArgumentSets, VacantWord};
use crate::controls::schema::table::joined;
use crate::controls::spindle::{LimitPlace, RapidSpeed};
use crate::controls::syntax::{ArcTangent, Function, Names, Percent, RoundBrackets};
use crate::controls::{Address, AddressSet, AnalogOutput, AxisScaling, ScalingKind};
use crate::controls::{DriveSystem, FeedKnob, Limits, Macros, SpindleRules, Syntax, Timing};
use crate::drives::Positioning;
use crate::drives::speed::KnobRange;
use crate::text::{Citation, Grade, Phrase};

/// Drive systems of the maker.
pub const DRIVES: &[DriveSystem] = joined![
    DriveSystem: &DriveSystem::axes(["1FT7"], OWN_DRIVES),
    &DriveSystem::auxiliary(["SIMOTICS S-1FK2", "SINAMICS S210"], OTHER_DRIVES),
    ANALOG_SPINDLE,
];

/// Addresses of several letters, named codes, names of programs and labels.
pub const NAMES: Names = Names {
    addresses: &[
        ("ANG", Address::Ang),
        ("AP", Address::Ap),
        ("AR", Address::Ar),
        ("CHF", Address::Chf),
        ("CHR", Address::Chr),
        ("CR", Address::Cr),
        ("FRC", Address::Frc),
        ("FRCM", Address::Frcm),
        ("LIMS", Address::Lims),
        ("RND", Address::Rnd),
        ("RNDM", Address::Rndm),
        ("RP", Address::Rp),
        ("RPL", Address::Rpl),
        ("SF", Address::Sf),
        ("SPOS", Address::Spos),
    ],
    codes: CODE_NAMES,
    extended: AddressSet::letters("HIJKMSXYZ"),
    foreign: &[
        "CALL", "CASE", "COUPON", "DEF", "EGON", "ENDFOR", "EXTERN", "FOR", "GOTOC", "PCALL", "PROC", "SETAL", "UNTIL",
    ],
    left_out: &[],
    unsimulated: &[
        "ELSE", "ENDIF", "ENDLOOP", "ENDWHILE", "EXTCALL", "FGROUP", "LOOP", "MCALL", "REPEAT", "REPEATB", "SPOSA",
        "TRAILON", "WAITS", "WHILE",
    ],
    local_data: false,
    endings: ["MPF", "SPF"],
    numbered: &["L", "MPF", "SPF"],
    program_chars: 16,
    label_least: 2,
    whole_max: 2_147_483_647,
    auxiliary: [5, 3, 1, 10],
};

/// Spelling, characters and file form.
pub const SYNTAX: Syntax = Syntax {
    round: RoundBrackets::Group,
    variable: 'R',
    names: Some(NAMES),
    program_letters: b"",
    percent: Percent::Head,
    sequence_digits: 8,
    sequence_zero: true,
    bracket_names: false,
    program_digits: 8,
    block_chars: 200,
    message_chars: 65,
    bracket_depth: 8,
    if_then: false,
    modulo: true,
    comparison_signs: true,
    bare_functions: false,
    atan: ArcTangent::OfTwo,
    double_hash: false,
    nine_hash: false,
    absolute_holds: false,
    threads_per_inch: None,
    lead_by_axis: true,
    dwell_addresses: AddressSet::letters("FS"),
    address_twice: true,
    block_read_chars: 200,
    block_words: 512,
    word_chars: u32::MAX,
    do_max: 0,
    do_depth: 0,
    random: &[],
    functions: &[
        ("SIN", Function::Sin),
        ("COS", Function::Cos),
        ("TAN", Function::Tan),
        ("ASIN", Function::Asin),
        ("ACOS", Function::Acos),
        ("ATAN2", Function::Atan),
        ("SQRT", Function::Sqrt),
        ("POT", Function::Square),
        ("ABS", Function::Abs),
        ("TRUNC", Function::Fix),
        ("ROUND", Function::Round),
        ("LN", Function::Ln),
        ("EXP", Function::Exp),
    ],
    addresses: AddressSet::letters("DFGHIJKMST"),
    integer_addresses: AddressSet::letters("DGMNPT"),
    point_alarm: false,
    increment_addresses: AddressSet::letters(""),
    corners: &[
        (Address::Chf, Phrase::new("chamfer")),
        (Address::Chr, Phrase::new("chamfer")),
        (Address::Rnd, Phrase::new("rounded corner")),
        (Address::Ang, Phrase::new("angle of a contour")),
        (Address::Frc, Phrase::new("feed of corners")),
        (Address::Rndm, Phrase::new("rounded corners from here on")),
        (Address::Frcm, Phrase::new("feed of all corners")),
        (Address::Ap, Phrase::new("polar angle")),
        (Address::Rp, Phrase::new("polar radius")),
        (Address::Sf, Phrase::new("start angle of a thread")),
    ],
    comma_addresses: AddressSet::letters(""),
    extension: "MPF",
    cite: MEMORY,
};

/// Values of programs with R parameters; subprograms take no arguments.
pub const MACROS: Macros = Macros {
    vacant_word: VacantWord::Zero,
    vacant_equals_zero: true,
    equal_within: 1e-12,
    truths: true,
    whole_bits: false,
    value_range: Some((0.0, 1e300)),
    round_words: true,
    argument_sets: ArgumentSets::InOrder,
    repeats_in_p: false,
    main_ends: true,
    ends_return: true,
    sub_sequence: false,
    call_first: false,
    program_next: false,
    call_ends_modal: false,
    call_after_return: true,
    common_kept: true,
    functions: &[],
    code_calls: &[],
    calls_override: false,
    code_calls_alone: false,
    user_alarms: (65_000, 65_999),
    user_alarm_base: Some(0),
    user_alarm_prefix: "",
    cite: ARITHMETIC,
};

/// Ranges of words and depths of calls.
pub const LIMITS: Limits = Limits {
    increment: 0.001,
    coordinate_max: 99_999.999,
    feed_max: 99_999.999,
    revolution_feed_max: 99_999.999,
    inch_feeds: Some(CodeId::g(700)),
    lead_max: 20_000.0,
    feed_increment: 0.001,
    arc_tolerance: 0.01,
    arc_centre_moves: false,
    point_arc_rests: false,
    feed_kept: false,
    speed_max: 99_999.999,
    speed_limit: Some((0.1, 999_999.9)),
    tool_max: 32_000,
    offset_max: Some(9),
    m_codes: 5,
    sub_depth: 7,
    macro_depth: 7,
    repeat_max: 9999,
    cite: MEMORY,
};

/// Analog spindle: S in r/min, constant surface speed, limits, positioning.
pub const SPINDLE: SpindleRules = SpindleRules {
    volts_stay: false,
    offset_at_rest: true,
    rapid: RapidSpeed::BeforeCutBlock,
    surface_at_once: true,
    surface_limit_stays: false,
    surface_per_revolution: true,
    feed_ends_surface: true,
    last_speed_back: true,
    surface_range: Some((0.01, 9999.99)),
    small_offset: 0.1,
    limit_place: LimitPlace::Nothing,
    override_last: false,
    thread_override: true,
    emergency_clears: false,
    reached: Some(0.1),
    stop_last: true,
    turns_through_reset: false,
    orients: true,
    angle_wraps: false,
    end_stops: true,
    manual_in_automatic: false,
    // Range of the interface signal; the range of the panel's knob is a switch.
    knob: KnobRange { low: 0.0, high: 200.0, step: 1.0 },
    override_codes: &[],
    offsets: None,
    stage_speeds: None,
    low_always: true,
    lower_wins: false,
    signed_output: true,
    stop_between: false,
    lock: None,
    driven_tool: None,
    cite: MEMORY,
};

/// Block times, assumed.
pub const TIMING: Timing = Timing {
    block: 0.008,
    macro_block: 0.004,
    preread: 3,
    cite: Citation::new("assumed; measure with a counting loop", Grade::Open),
};

/// Feed override of the machine control panels; the interface signal takes 0 to 200 %.
pub const FEED_KNOB: FeedKnob =
    FeedKnob { positions: KnobRange { low: 0.0, high: 120.0, step: 5.0 }, cite: switches::KNOB };

/// Analog output for the speed of the spindle.
pub const ANALOG_OUTPUT: AnalogOutput = AnalogOutput { volts: 10.0, bits: 12, cite: MEMORY };

/// Lead and gear of an axis. The parameters take longer numbers, but no gear needs them.
pub const SCALING: AxisScaling =
    AxisScaling { kind: ScalingKind::Lead, greatest_term: 1_000_000, cite: params::SCALING };

/// Test bench of a lathe: two slides, a third linear axis, a spindle without gears.
pub const BENCH: Bench = Bench {
    axes: &[
        BenchAxis { letter: Address::X, rapid: 10_000.0, clamp: 10_000.0, time_constant: 0.1, position_gain: 16.7 },
        BenchAxis { letter: Address::Y, rapid: 15_000.0, clamp: 15_000.0, time_constant: 0.1, position_gain: 16.7 },
        BenchAxis { letter: Address::Z, rapid: 15_000.0, clamp: 15_000.0, time_constant: 0.1, position_gain: 16.7 },
    ],
    gears: &[3750.0],
    shift: BenchShift { volts: 0.0, before: 0.0, meshing: 0.5, after: 0.0 },
    speed_clamp: 3500.0,
    in_position: 0.02,
    ramp: 2.0,
    positioning: Some(Positioning { speed: 100.0, acceleration: 500.0, clockwise: true }),
    override_echo: None,
    fin_delay: 0.02,
};
