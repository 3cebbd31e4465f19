//! KND K2000T: rows only. Its manuals are not public: rows without a better source follow FANUC 0i-T, with whose codes it is compatible.

mod alarms;
mod codes;
mod interface;
mod params;
mod switches;
mod vars;

pub(super) use params::PARAMS;

use super::bench::{Bench, BenchAxis, BenchShift};
use super::macros::{ArgumentSets, CallKind, CodeCalls, VacantWord};
use super::spindle::{LimitPlace, RapidSpeed, SpindleRules};
use super::syntax::{Function, Percent, Round};
use super::{AxisDef, Control, Limits, Macros, Syntax, Timing};
use crate::drives::speed::Steps;
use crate::text::{Citation, Grade};

/// Nothing but memory of FANUC lathe controls.
const MEMORY: Citation = Citation::new("FANUC 0i-T usage, unverified", Grade::Open);
/// The published paper about the polygon lathe, on this very control.
const PAPER: Citation = Citation::new("polygon turning paper, K2000T", Grade::Manual);
/// Custom macro B, calls and arguments.
const CALLS: Citation = Citation::new("FANUC 16i/18i-PB manual B-63684EN, p.278", Grade::Inferred);

/// The control.
pub static CONTROL: Control = Control {
    id: "knd-k2000t",
    name: "KND K2000T",
    syntax: Syntax {
        round: Round::Comment,
        variable: '#',
        names: None,
        program_letters: b"O",
        percent: Percent::Both,
        sequence_digits: 5,
        program_digits: 4,
        block_chars: 80,
        message_chars: 31,
        bracket_depth: 5,
        if_then: true,
        modulo: true,
        comparison_signs: false,
        bare_functions: false,
        atan_of_two: true,
        double_hash: true,
        nine_hash: false,
        absolute_holds: false,
        threads_per_inch: None,
        lead_by_axis: false,
        dwell_addresses: b"PUX",
        address_twice: false,
        block_read_chars: 60_000,
        block_words: 60_000,
        do_max: 3,
        do_depth: 3,
        functions: &[
            ("SIN", Function::Sin),
            ("COS", Function::Cos),
            ("TAN", Function::Tan),
            ("ASIN", Function::Asin),
            ("ACOS", Function::Acos),
            ("ATAN", Function::Atan),
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
        addresses: b"ABDEFGHIJKLMPQRSTUVW",
        integer_addresses: b"GLMNOPST",
        point_alarm: true,
        increment_addresses: b"ABCHIJKRUVWXYZ",
        corners: &[],
        comma_addresses: b"ACR",
        extension: "nc",
        cite: Citation::new("FANUC Custom Macro B, sheet section 4; block length unknown", Grade::Open),
    },
    macros: Macros {
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
        code_calls: &[CodeCalls::Each { kind: CallKind::Macro, letter: b'G', first: 4120, count: 20, program: 9120 }],
        calls_override: true,
        user_alarms: (0, 200),
        user_alarm_base: Some(3000),
        cite: CALLS,
    },
    axes: &[
        AxisDef { letter: b'X', rotary: false, incremental: Some(b'U'), diameter: true, cite: PAPER },
        AxisDef { letter: b'Z', rotary: false, incremental: Some(b'W'), diameter: false, cite: PAPER },
        AxisDef { letter: b'Y', rotary: false, incremental: Some(b'V'), diameter: false, cite: MEMORY },
        AxisDef { letter: b'C', rotary: true, incremental: Some(b'H'), diameter: false, cite: MEMORY },
    ],
    startup: &[0, 180, 980, 210, 400, 540, 670, 800, 970],
    limits: Limits {
        increment: 0.001,
        coordinate_max: 99_999.999,
        feed_max: 240_000.0,
        revolution_feed_max: 500.0,
        feed_increment: 0.001,
        arc_tolerance: 0.1,
        arc_centre_moves: false,
        feed_kept: false,
        speed_max: 99_999.0,
        speed_limit: None,
        m_codes: 1,
        sub_depth: 4,
        macro_depth: 4,
        repeat_max: 9999,
        cite: MEMORY,
    },
    timing: Timing {
        block: 0.004,
        macro_block: 0.002,
        preread: 5,
        cite: Citation::new("assumed; measure with #3001", Grade::Open),
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
        thread_override: false,
        emergency_clears: false,
        reached: None,
        stop_last: false,
        turns_through_reset: false,
        orients: false,
        angle_wraps: false,
        end_stops: false,
        knob: Steps { low: 0.0, high: 254.0, step: 1.0 },
        offsets: None,
        stage_speeds: None,
        low_always: false,
        signed_output: true,
        stop_between: false,
        lock: None,
        driven_tool: None,
        cite: MEMORY,
    },
    bench: Bench {
        axes: &[
            BenchAxis { letter: b'X', rapid: 12_000.0, clamp: 12_000.0, time_constant: 0.1, position_gain: 33.0 },
            BenchAxis { letter: b'Z', rapid: 24_000.0, clamp: 24_000.0, time_constant: 0.1, position_gain: 33.0 },
            BenchAxis { letter: b'Y', rapid: 240_000.0, clamp: 240_000.0, time_constant: 0.1, position_gain: 33.0 },
            BenchAxis { letter: b'C', rapid: 240_000.0, clamp: 240_000.0, time_constant: 0.1, position_gain: 33.0 },
        ],
        gears: &[3000.0, 2000.0, 1200.0, 600.0],
        shift: BenchShift { volts: 0.1, before: 1.0, meshing: 0.5, after: 1.0 },
        speed_clamp: 3000.0,
        volts_full: 10.0,
        output_bits: 12,
        in_position: 0.02,
        ramp: 2.0,
        positioning: None,
        override_echo: Some(1032),
        fin_delay: 0.05,
    },
};
