//! GSK 980TDc: rows only. Most rows are from the manual of its successor 980TDi; the two texts are nearly the same where both are known.

mod alarms;
mod codes;
mod functions;
mod interface;
mod params;
mod sources;
mod switches;
mod vars;

use super::base::drives::{ANALOG_SPINDLE, PULSE};
use super::base::fanuc;
use super::bench::{Bench, BenchShift};
use super::code::g_codes;
use super::interface::PlcLanguage;
use super::macros::{ArgumentSets, CallKind, CodeCalls, VacantWord};
use super::schema::table::joined;
use super::spindle::RapidSpeed;
use super::syntax::Percent;
use super::{
    AnalogOutput, AxisDef, AxisScaling, Control, DriveSystem, FeedKnob, Limits, Macros, ScalingKind, SpindleRules,
    Syntax, Timing,
};
use crate::controls::Address;
use crate::drives::speed::KnobRange;
use crate::text::{Citation, Grade, Phrase};
use sources::{AXES, MACRO, PARAMETERS, RETURN};

/// The control.
pub static CONTROL: Control = Control {
    id: "gsk-980tdc",
    name: "GSK 980TDc",
    syntax: Syntax {
        program_letters: b"O",
        percent: Percent::End,
        modulo: false,
        comparison_signs: true,
        bare_functions: true,
        double_hash: false,
        nine_hash: true,
        absolute_holds: true,
        threads_per_inch: Some(Address::I),
        address_twice: true,
        block_read_chars: 256,
        block_words: 100,
        word_chars: 11,
        random: &["RAND", "SRAND"],
        point_alarm: false,
        // GSK980TDi manual, 3.11.
        corners: &[(Address::L, Phrase::new("chamfer")), (Address::D, Phrase::new("rounded corner"))],
        cite: Citation::new("GSK980TDi manual, 3.28 and 3.29; characters and alarms of the 980MDi", Grade::Sister),
        ..fanuc::SYNTAX
    },
    macros: Macros {
        vacant_word: VacantWord::Zero,
        vacant_equals_zero: true,
        whole_bits: true,
        value_range: None,
        argument_sets: ArgumentSets::PerLetter,
        call_first: true,
        program_next: true,
        call_ends_modal: true,
        call_after_return: false,
        functions: functions::FUNCTIONS,
        code_calls: &[
            CodeCalls::Range { kind: CallKind::Macro, letter: Address::G, count: 86, code: 87, program: 88 },
            CodeCalls::Range { kind: CallKind::Sub, letter: Address::M, count: 91, code: 89, program: 90 },
        ],
        calls_override: false,
        code_calls_alone: false,
        user_alarms: (0, 99),
        user_alarm_base: Some(5900),
        cite: MACRO,
        ..fanuc::MACROS
    },
    axes: &[
        AxisDef { letter: Address::X, rotary: false, incremental: Some(Address::U), diameter: true, cite: PARAMETERS },
        AxisDef { letter: Address::Y, rotary: false, incremental: Some(Address::V), diameter: false, cite: AXES },
        AxisDef { letter: Address::Z, rotary: false, incremental: Some(Address::W), diameter: false, cite: AXES },
        AxisDef { letter: Address::C, rotary: true, incremental: Some(Address::H), diameter: false, cite: AXES },
    ],
    startup: &g_codes([0, 18, 98, 21, 40, 54, 67, 80, 97]),
    limits: Limits {
        feed_max: 15_000.0,
        arc_centre_moves: true,
        point_arc_rests: false,
        feed_kept: true,
        speed_max: 9999.0,
        cite: Citation::new("GSK980TDi manual, 3.28; S 2.2.3 of the 980TDc; feed and arcs from memory", Grade::Open),
        ..fanuc::LIMITS
    },
    timing: Timing {
        block: 0.008,
        macro_block: 0.004,
        preread: 3,
        cite: Citation::new("assumed; measure with a counting loop and a clock", Grade::Open),
    },
    feed_knob: FeedKnob { cite: interface::PLC, ..fanuc::FEED_KNOB },
    codes: codes::CODES,
    vars: vars::VARS,
    alarms: alarms::ALARMS,
    params: params::PARAMS,
    interface: interface::SIGNALS,
    plc: PlcLanguage::Gsk,
    switches: switches::SWITCHES,
    spindle: SpindleRules {
        volts_stay: true,
        offset_at_rest: false,
        rapid: RapidSpeed::Kept,
        stop_last: true,
        knob: KnobRange { low: 50.0, high: 120.0, step: 10.0 },
        offsets: Some([(-1000.0, 1000.0), (-2000.0, 2000.0)]),
        stage_speeds: Some((10.0, 9999.0)),
        stop_between: true,
        cite: Citation::new("GSK980TDc manual, 2.2.2 and 2.2.3; override by 988TA", Grade::Sister),
        ..fanuc::SPINDLE
    },
    analog_output: AnalogOutput {
        cite: Citation::new("turning spindle facts 1; 12 bits from a similar control", Grade::Sister),
        ..fanuc::ANALOG_OUTPUT
    },
    scaling: Some(AxisScaling { kind: ScalingKind::Counts, greatest_term: 32_767, cite: params::SCALING }),
    zero_return: Some(RETURN),
    bench: Bench {
        axes: &[
            fanuc::bench_axis(Address::X, 7600.0, 8000.0),
            fanuc::bench_axis(Address::Y, 15_000.0, 15_000.0),
            fanuc::bench_axis(Address::Z, 15_000.0, 15_000.0),
            fanuc::bench_axis(Address::C, 15_000.0, 15_000.0),
        ],
        // Gear change delays of 5 s are the defaults of the standard ladder.
        shift: BenchShift { volts: 0.1, before: 5.0, meshing: 0.5, after: 5.0 },
        ..fanuc::BENCH
    },
    drives: joined![DriveSystem: &PULSE, ANALOG_SPINDLE],
};
