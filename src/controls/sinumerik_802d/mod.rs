//! SINUMERIK 802D, turning: rows only. Where no page of the 802D itself is known, the 808D, its successor, and the 840D stand in, and say so.

mod alarms;
mod codes;
mod interface;
mod params;
mod switches;
mod vars;

pub(super) use params::PARAMS;

use super::bench::{Bench, BenchAxis, BenchShift};
use super::macros::{ArgumentSets, VacantWord};
use super::spindle::{LimitPlace, RapidSpeed, SpindleRules};
use super::syntax::{Function, Names, Percent, RoundBrackets, long};
use super::{AxisDef, Control, Limits, Macros, Syntax, Timing};
use crate::drives::Positioning;
use crate::drives::speed::Steps;
use crate::text::{Citation, Grade};

/// The page about S, M3, G25, SPOS and G96 of this very control.
const SPINDLE: Citation =
    Citation::new("SINUMERIK 802D spindle commands, Shenyang No. 1 Machine Tool, 2010", Grade::Manual);
/// Block layout, words, comments, block skip.
const BLOCKS: Citation = Citation::new("802D turning BP-D 08/2005, p.133", Grade::Manual);
/// Words, ranges, one G code per group.
const WORDS: Citation =
    Citation::new("802D sl BP-N 06/2006, p.8-122 and 8-126; grinding 07/2009, p.225", Grade::Manual);
/// Ranges of words: of T and of leads only memory knows.
const RANGES: Citation = Citation::new(
    "802D sl BP-N 06/2006, p.8-126 (F, D); 808D diagnostics, p.217 (S, LIMS); S, T and leads unverified",
    Grade::Manual,
);
/// Arithmetic: operators, their order, equality.
const ARITHMETIC: Citation = Citation::new("840D sl NC programming 12/2019, p.392 and 444", Grade::Sister);
/// Nothing but memory of Siemens controls.
const MEMORY: Citation = Citation::new("usage of Siemens controls, unverified", Grade::Open);

/// The control.
pub static CONTROL: Control = Control {
    id: "sinumerik-802d",
    name: "SINUMERIK 802D",
    syntax: Syntax {
        round: RoundBrackets::Group,
        variable: 'R',
        names: Some(Names {
            addresses: &[
                ("ANG", long::ANG),
                ("AP", long::AP),
                ("AR", long::AR),
                ("CHF", long::CHF),
                ("CHR", long::CHR),
                ("CR", long::CR),
                ("FRC", long::FRC),
                ("FRCM", long::FRCM),
                ("LIMS", long::LIMS),
                ("RND", long::RND),
                ("RNDM", long::RNDM),
                ("RP", long::RP),
                ("RPL", long::RPL),
                ("SF", long::SF),
                ("SPOS", long::SPOS),
            ],
            codes: codes::NAMES,
            cycle: "CYCLE",
            extended: b"HIJKMSXYZ",
            foreign: &[
                "CALL", "CASE", "COUPON", "DEF", "EGON", "ELSE", "ENDFOR", "ENDIF", "ENDLOOP", "ENDWHILE", "EXTERN",
                "FGROUP", "FOR", "GOTOC", "LOOP", "MCALL", "PCALL", "PROC", "REPEAT", "SETAL", "SPOSA", "TRAILON",
                "UNTIL", "WAITS", "WHILE",
            ],
            endings: ["MPF", "SPF"],
            numbered: &["L", "MPF", "SPF"],
            program_chars: 16,
            label_least: 2,
            whole_max: 2_147_483_647,
            auxiliary: [5, 3, 1, 10],
        }),
        program_letters: b"",
        percent: Percent::Head,
        sequence_digits: 8,
        program_digits: 8,
        block_chars: 200,
        message_chars: 65,
        bracket_depth: 8,
        if_then: false,
        modulo: true,
        comparison_signs: true,
        bare_functions: false,
        atan_of_two: true,
        double_hash: false,
        nine_hash: false,
        absolute_holds: false,
        threads_per_inch: None,
        lead_by_axis: true,
        dwell_addresses: b"FS",
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
        addresses: b"DFGHIJKMST",
        integer_addresses: b"DGMNPT",
        point_alarm: false,
        increment_addresses: b"",
        corners: &[
            (long::CHF, "chamfer"),
            (long::CHR, "chamfer"),
            (long::RND, "rounded corner"),
            (long::ANG, "angle of a contour"),
            (long::FRC, "feed of corners"),
            (long::RNDM, "rounded corners from here on"),
            (long::FRCM, "feed of all corners"),
            (long::AP, "polar angle"),
            (long::RP, "polar radius"),
            (long::SF, "start angle of a thread"),
        ],
        comma_addresses: b"",
        extension: "MPF",
        cite: BLOCKS,
    },
    macros: Macros {
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
        user_alarms: (65_000, 65_999),
        user_alarm_base: Some(0),
        cite: ARITHMETIC,
    },
    axes: &[
        AxisDef { letter: b'X', rotary: false, incremental: None, diameter: true, cite: SPINDLE },
        AxisDef { letter: b'Y', rotary: false, incremental: None, diameter: false, cite: MEMORY },
        AxisDef { letter: b'Z', rotary: false, incremental: None, diameter: false, cite: SPINDLE },
    ],
    startup: &[10, 180, 400, 600, 710, 900, 950, 5000],
    limits: Limits {
        increment: 0.001,
        coordinate_max: 99_999.999,
        feed_max: 99_999.999,
        revolution_feed_max: 99_999.999,
        inch_feeds: Some(7000),
        lead_max: 20_000.0,
        feed_increment: 0.001,
        arc_tolerance: 0.01,
        arc_centre_moves: false,
        feed_kept: false,
        speed_max: 99_999.999,
        speed_limit: Some((0.1, 999_999.9)),
        tool_max: 32_000,
        offset_max: Some(9),
        m_codes: 5,
        sub_depth: 7,
        macro_depth: 7,
        repeat_max: 9999,
        cite: RANGES,
    },
    spindle: SpindleRules {
        volts_stay: false,
        rapid: RapidSpeed::BeforeCut,
        surface_at_once: true,
        surface_limit_stays: false,
        surface_per_revolution: true,
        feed_ends_surface: true,
        last_speed_back: true,
        surface_range: Some((0.01, 9999.99)),
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
        // That of the interface; what a panel has of it is a switch.
        knob: Steps { low: 0.0, high: 200.0, step: 1.0 },
        offsets: None,
        stage_speeds: None,
        low_always: true,
        lower_wins: false,
        signed_output: true,
        stop_between: false,
        lock: None,
        driven_tool: None,
        cite: SPINDLE,
    },
    timing: Timing {
        block: 0.008,
        macro_block: 0.004,
        preread: 3,
        cite: Citation::new("assumed; measure with a counting loop", Grade::Open),
    },
    codes: codes::CODES,
    vars: vars::VARS,
    alarms: alarms::ALARMS,
    interface: interface::SIGNALS,
    switches: switches::SWITCHES,
    bench: Bench {
        axes: &[
            BenchAxis { letter: b'X', rapid: 10_000.0, clamp: 10_000.0, time_constant: 0.1, position_gain: 16.7 },
            BenchAxis { letter: b'Y', rapid: 15_000.0, clamp: 15_000.0, time_constant: 0.1, position_gain: 16.7 },
            BenchAxis { letter: b'Z', rapid: 15_000.0, clamp: 15_000.0, time_constant: 0.1, position_gain: 16.7 },
        ],
        gears: &[3750.0],
        shift: BenchShift { volts: 0.0, before: 0.0, meshing: 0.5, after: 0.0 },
        speed_clamp: 3500.0,
        volts_full: 10.0,
        output_bits: 12,
        in_position: 0.02,
        ramp: 2.0,
        positioning: Some(Positioning { speed: 100.0, acceleration: 500.0, clockwise: true }),
        override_echo: None,
        fin_delay: 0.02,
    },
};
