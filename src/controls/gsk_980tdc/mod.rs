//! GSK 980TDc: rows only. Most of them are those of its successor 980TDi, whose text is nearly the same where both are known.

mod alarms;
mod codes;
mod functions;
mod interface;
mod params;
mod switches;
mod vars;

pub(super) use params::PARAMS;

use super::bench::{Bench, BenchAxis, BenchShift};
use super::macros::{ArgumentSets, CallKind, CodeCalls, VacantWord};
use super::spindle::{LimitPlace, RapidSpeed, SpindleRules};
use super::syntax::{Function, Percent, RoundBrackets};
use super::{AxisDef, Control, Limits, Macros, Syntax, Timing};
use crate::drives::speed::Steps;
use crate::text::{Citation, Grade};

/// Nothing but memory of the 980T family.
const MEMORY: Citation = Citation::new("GSK 980T usage, unverified", Grade::Open);
/// Macro variables, G65, calls.
const MACRO: Citation = Citation::new("GSK980TDi manual, 3.28", Grade::Sister);
/// Macro statements.
const STATEMENT: Citation = Citation::new("GSK980TDi manual, 3.29", Grade::Sister);
/// Additional axes.
const AXES: Citation = Citation::new("GSK980TDi manual, 3.27 and 3.28", Grade::Sister);
/// The pages about S, G96, G97 and G50 S of this very control.
const SPINDLE: Citation = Citation::new("GSK980TDc manual, 2.2.2 and 2.2.3", Grade::Manual);
/// Parameter file.
const PARAMETERS: Citation = Citation::new("GSK980TDi parameter list", Grade::Sister);

/// The control.
pub static CONTROL: Control = Control {
    id: "gsk-980tdc",
    name: "GSK 980TDc",
    syntax: Syntax {
        round: RoundBrackets::Comment,
        variable: '#',
        names: None,
        program_letters: b"O",
        percent: Percent::End,
        sequence_digits: 5,
        program_digits: 4,
        block_chars: 80,
        message_chars: 31,
        bracket_depth: 5,
        if_then: true,
        modulo: false,
        comparison_signs: true,
        bare_functions: true,
        atan_of_two: true,
        double_hash: false,
        nine_hash: true,
        absolute_holds: true,
        threads_per_inch: Some(b'I'),
        lead_by_axis: false,
        dwell_addresses: b"PUX",
        address_twice: true,
        block_read_chars: 256,
        block_words: 100,
        word_chars: 11,
        do_max: 3,
        do_depth: 3,
        random: &["RAND", "SRAND"],
        functions: &[
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
        ],
        addresses: b"ABDEFGHIJKLMPQRSTUVW",
        integer_addresses: b"GLMNOPST",
        point_alarm: false,
        increment_addresses: b"ABCHIJKRUVWXYZ",
        // GSK980TDi manual, 3.11.
        corners: &[(b'L', "chamfer"), (b'D', "rounded corner")],
        comma_addresses: b"ACR",
        extension: "nc",
        cite: Citation::new("GSK980TDi manual, 3.28 and 3.29; characters and alarms of the 980MDi", Grade::Sister),
    },
    macros: Macros {
        vacant_word: VacantWord::Zero,
        vacant_equals_zero: true,
        equal_within: 0.0,
        truths: false,
        whole_bits: true,
        value_range: None,
        round_words: true,
        argument_sets: ArgumentSets::PerLetter,
        repeats_in_p: true,
        main_ends: false,
        ends_return: false,
        sub_sequence: false,
        call_first: true,
        program_next: true,
        call_ends_modal: true,
        call_after_return: false,
        common_kept: false,
        functions: functions::FUNCTIONS,
        code_calls: &[
            CodeCalls::Range { kind: CallKind::Macro, letter: b'G', count: 86, code: 87, program: 88 },
            CodeCalls::Range { kind: CallKind::Sub, letter: b'M', count: 91, code: 89, program: 90 },
        ],
        calls_override: false,
        user_alarms: (0, 99),
        user_alarm_base: Some(5900),
        cite: MACRO,
    },
    axes: &[
        AxisDef { letter: b'X', rotary: false, incremental: Some(b'U'), diameter: true, cite: PARAMETERS },
        AxisDef { letter: b'Y', rotary: false, incremental: Some(b'V'), diameter: false, cite: AXES },
        AxisDef { letter: b'Z', rotary: false, incremental: Some(b'W'), diameter: false, cite: AXES },
        AxisDef { letter: b'C', rotary: true, incremental: Some(b'H'), diameter: false, cite: AXES },
    ],
    startup: &[0, 180, 980, 210, 400, 540, 670, 800, 970],
    limits: Limits {
        increment: 0.001,
        coordinate_max: 99_999.999,
        feed_max: 15_000.0,
        revolution_feed_max: 500.0,
        inch_feeds: None,
        lead_max: 500.0,
        feed_increment: 0.001,
        arc_tolerance: 0.1,
        arc_centre_moves: true,
        feed_kept: true,
        speed_max: 9999.0,
        speed_limit: None,
        tool_max: 99_999_999,
        offset_max: None,
        m_codes: 1,
        sub_depth: 4,
        macro_depth: 4,
        repeat_max: 9999,
        cite: Citation::new("GSK980TDi manual, 3.28; S 2.2.3 of the 980TDc; feed and arcs from memory", Grade::Open),
    },
    timing: Timing {
        block: 0.008,
        macro_block: 0.004,
        preread: 3,
        cite: Citation::new("assumed; measure with a counting loop and a clock", Grade::Open),
    },
    codes: codes::CODES,
    vars: vars::VARS,
    alarms: alarms::ALARMS,
    interface: interface::SIGNALS,
    switches: switches::SWITCHES,
    spindle: SpindleRules {
        volts_stay: true,
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
        stop_last: true,
        turns_through_reset: false,
        orients: false,
        angle_wraps: false,
        end_stops: false,
        knob: Steps { low: 50.0, high: 120.0, step: 10.0 },
        offsets: Some([(-1000.0, 1000.0), (-2000.0, 2000.0)]),
        stage_speeds: Some((10.0, 9999.0)),
        low_always: false,
        lower_wins: false,
        signed_output: false,
        stop_between: true,
        lock: None,
        driven_tool: None,
        cite: Citation::new(
            "GSK980TDc manual, 2.2.2 and 2.2.3; rapids, override by GSK980TDi and 988TA",
            Grade::Sister,
        ),
    },
    bench: Bench {
        axes: &[
            BenchAxis { letter: b'X', rapid: 7600.0, clamp: 8000.0, time_constant: 0.1, position_gain: 33.0 },
            BenchAxis { letter: b'Y', rapid: 15_000.0, clamp: 15_000.0, time_constant: 0.1, position_gain: 33.0 },
            BenchAxis { letter: b'Z', rapid: 15_000.0, clamp: 15_000.0, time_constant: 0.1, position_gain: 33.0 },
            BenchAxis { letter: b'C', rapid: 15_000.0, clamp: 15_000.0, time_constant: 0.1, position_gain: 33.0 },
        ],
        gears: &[3000.0, 2000.0, 1200.0, 600.0],
        // Delays of 5 s are those of the standard ladder before anyone sets them.
        shift: BenchShift { volts: 0.1, before: 5.0, meshing: 0.5, after: 5.0 },
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
