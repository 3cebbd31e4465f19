//! Mitsubishi MELDAS E60: rows only.

mod alarms;
mod codes;
mod interface;
mod params;
mod switches;
mod vars;

pub(super) use params::PARAMS;

use super::bench::{Bench, BenchAxis, BenchShift};
use super::macros::{ArgumentSets, CodeCalls, VacantWord};
use super::schema::control::axis;
use super::spindle::{LimitPlace, RapidSpeed, SpindleRules};
use super::syntax::{Function, Percent, RoundBrackets};
use super::{Control, Limits, Macros, Syntax, Timing};
use crate::drives::speed::Steps;
use crate::text::{Citation, Grade};

/// Programming manual of the younger sister control.
const M700: &str = "M700V/M70V programming manual, machining center";
/// Nothing but memory of the MELDAS manuals.
const MEMORY: Citation = Citation::new("MELDAS M-type usage, unverified", Grade::Open);
/// The published paper about the ribbon line, on this very control.
const PAPER: Citation = Citation::new("ribbon dot-printing paper, E60", Grade::Manual);

/// The control.
pub static CONTROL: Control = Control {
    id: "mitsubishi-e60",
    name: "Mitsubishi E60",
    syntax: Syntax {
        round: RoundBrackets::Comment,
        variable: '#',
        names: None,
        program_letters: b"OL",
        percent: Percent::Both,
        sequence_digits: 5,
        program_digits: 8,
        block_chars: 80,
        message_chars: 31,
        bracket_depth: 5,
        if_then: false,
        modulo: false,
        comparison_signs: false,
        bare_functions: false,
        atan_of_two: false,
        double_hash: true,
        nine_hash: false,
        absolute_holds: false,
        threads_per_inch: Some(b'E'),
        lead_by_axis: false,
        dwell_addresses: b"PUX",
        address_twice: false,
        block_read_chars: 60_000,
        block_words: 60_000,
        word_chars: u32::MAX,
        do_max: 127,
        do_depth: 27,
        random: &[],
        functions: &[
            ("SIN", Function::Sin),
            ("COS", Function::Cos),
            ("TAN", Function::Tan),
            ("ASIN", Function::Asin),
            ("ACOS", Function::Acos),
            ("ATAN", Function::Atan),
            ("ATN", Function::Atan),
            ("SQRT", Function::Sqrt),
            ("SQR", Function::Sqrt),
            ("ABS", Function::Abs),
            ("BIN", Function::Bin),
            ("BCD", Function::Bcd),
            ("ROUND", Function::Round),
            ("RND", Function::Round),
            ("FIX", Function::Fix),
            ("FUP", Function::Fup),
            ("LN", Function::Ln),
            ("EXP", Function::Exp),
        ],
        addresses: b"BDEFGHIJKLMPQRST",
        integer_addresses: b"DGHLMNOST",
        point_alarm: false,
        increment_addresses: b"ABCIJKRUVWXYZ",
        corners: &[],
        comma_addresses: b"ACDFHIJKPQRST",
        extension: "nc",
        cite: Citation::new("M700V/M70V programming manual, p.19, 23, 28, 40; macro text from memory", Grade::Sister),
    },
    macros: Macros {
        vacant_word: VacantWord::Dropped,
        vacant_equals_zero: false,
        equal_within: 0.0,
        truths: false,
        whole_bits: false,
        value_range: None,
        round_words: false,
        argument_sets: ArgumentSets::InOrder,
        repeats_in_p: false,
        main_ends: false,
        ends_return: false,
        sub_sequence: true,
        call_first: false,
        program_next: false,
        call_ends_modal: false,
        call_after_return: true,
        common_kept: true,
        functions: &[],
        code_calls: &[
            CodeCalls::Pairs { letter: b'G', code: 7201, kind: 7202, program: 7203, step: 10, count: 10 },
            CodeCalls::Pairs { letter: b'M', code: 7001, kind: 7002, program: 7003, step: 10, count: 10 },
        ],
        calls_override: true,
        user_alarms: (1, 9999),
        user_alarm_base: None,
        cite: Citation::new(
            "M700V/M70V programming manual, p.326; calls, arguments, macro list from memory",
            Grade::Open,
        ),
    },
    axes: &[axis(b'X', false, PAPER), axis(b'Y', false, PAPER), axis(b'Z', false, MEMORY), axis(b'A', true, MEMORY)],
    startup: &[10, 170, 210, 540, 640, 670, 800, 900, 940, 970],
    limits: Limits {
        increment: 0.001,
        coordinate_max: 99_999.999,
        feed_max: 1_000_000.0,
        revolution_feed_max: 1_000_000.0,
        inch_feeds: None,
        lead_max: 1_000_000.0,
        feed_increment: 0.001,
        arc_tolerance: 0.1,
        arc_centre_moves: false,
        feed_kept: false,
        speed_max: 99_999_999.0,
        speed_limit: None,
        tool_max: 99_999_999,
        offset_max: None,
        m_codes: 4,
        sub_depth: 8,
        macro_depth: 4,
        repeat_max: 9999,
        cite: Citation::new(
            "M700V/M70V programming manual, p.23, 40, 158; feed, arcs and nesting from memory",
            Grade::Open,
        ),
    },
    timing: Timing {
        block: 0.0071,
        macro_block: 0.003,
        preread: 5,
        cite: Citation::new(
            "E68 class block rate 7.1 ms and 1 to 5 ms a macro block, assumed: measure with #3001",
            Grade::Open,
        ),
    },
    codes: codes::CODES,
    vars: vars::VARS,
    alarms: alarms::ALARMS,
    interface: interface::SIGNALS,
    switches: switches::SWITCHES,
    spindle: SpindleRules {
        volts_stay: false,
        rapid: RapidSpeed::OfEnd,
        surface_at_once: true,
        surface_limit_stays: false,
        surface_per_revolution: false,
        feed_ends_surface: false,
        last_speed_back: false,
        surface_range: None,
        limit_place: LimitPlace::Nothing,
        override_last: false,
        thread_override: true,
        emergency_clears: false,
        reached: None,
        stop_last: false,
        turns_through_reset: false,
        orients: false,
        angle_wraps: false,
        end_stops: false,
        knob: Steps { low: 0.0, high: 200.0, step: 1.0 },
        offsets: None,
        stage_speeds: None,
        low_always: false,
        lower_wins: false,
        signed_output: false,
        stop_between: false,
        lock: None,
        driven_tool: None,
        cite: Citation::new(
            "ribbon dot-printing paper, E60: S times override, clamped; the rest from memory",
            Grade::Open,
        ),
    },
    bench: Bench {
        axes: &[
            BenchAxis { letter: b'X', rapid: 240_000.0, clamp: 240_000.0, time_constant: 0.1, position_gain: 33.0 },
            BenchAxis { letter: b'Y', rapid: 240_000.0, clamp: 240_000.0, time_constant: 0.1, position_gain: 33.0 },
            BenchAxis { letter: b'Z', rapid: 30_000.0, clamp: 30_000.0, time_constant: 0.1, position_gain: 33.0 },
        ],
        gears: &[1480.0],
        shift: BenchShift { volts: 0.0, before: 0.0, meshing: 0.0, after: 0.0 },
        speed_clamp: 1480.0,
        volts_full: 10.0,
        output_bits: 12,
        in_position: 0.02,
        ramp: 2.0,
        positioning: None,
        override_echo: Some(1033),
        fin_delay: 0.05,
    },
};
