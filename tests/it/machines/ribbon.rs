//! The ribbon dot-printing line: its results against the paper and the sizing table, its limits and its notes.

mod contacts;
mod dancer;
pub(super) mod each_control;
mod edges;
mod endless;
mod holds;
mod knob;
mod length;
mod lists;
mod phase;
mod program;
mod reserve;
mod states;
mod stops;
mod synchronism;

use macroline::controls::{Control, Switches};
use macroline::drives::web;
use macroline::machines::form::{Origins, Provenance, Value, Values};
use macroline::machines::{self, AnyMachine, ControlContext, Design};
use macroline::text::Severity;
use macroline::text::catalog::{sentence, words};
use macroline::view::{Limit, Readout, Verdict};

use crate::queries;

pub(super) fn machine() -> &'static dyn AnyMachine {
    machines::find("ribbon-line").unwrap()
}

pub(super) fn control() -> &'static Control {
    macroline::controls::find("mitsubishi-e60").unwrap()
}

/// A control with its open points at their defaults.
pub(super) fn at_defaults(control: &'static Control) -> ControlContext<'static> {
    static DEFAULTS: Switches = Switches(Vec::new());
    ControlContext { control, switches: &DEFAULTS }
}

pub(super) fn on() -> ControlContext<'static> {
    at_defaults(control())
}

/// Every control that the line can have.
pub(super) fn controls() -> impl Iterator<Item = &'static Control> {
    machine().controls().iter().map(|id| macroline::controls::find(id).unwrap())
}

/// Values that differ from the paper's example: numbers as they are, words as choices, `true` and `false` as flags.
pub(super) fn values(changes: &[(&str, &str)]) -> Values {
    queries::values(machine(), changes)
}

fn design(changes: &[(&str, &str)]) -> Design {
    machine().prepare(&values(changes), on()).design(&Origins::new())
}

#[track_caller]
fn readout(design: &Design, id: &str) -> Readout {
    design.readouts.iter().find(|readout| readout.id == id).cloned().unwrap_or_else(|| panic!("no result {id}"))
}

/// Results by id, to a relative tolerance.
#[track_caller]
fn check(changes: &[(&str, &str)], tolerance: f64, expected: &[(&str, f64)]) {
    let design = design(changes);
    for (id, wanted) in expected {
        let value = readout(&design, id).value;
        assert!((value - wanted).abs() <= tolerance * wanted.abs().max(1e-9), "{id}: {value}, expected {wanted}");
    }
}

fn advice(readout: &Readout) -> Vec<String> {
    readout.advice.iter().map(|advice| sentence(&advice.message)).collect()
}

#[test]
fn paper_example_with_exact_pi_gives_its_figures() {
    check(
        &[],
        2e-9,
        &[
            ("k", 12.566370614359172),
            ("actual-speed", 1200.0),
            ("line-speed", 15079.644737),
            ("y-stroke", 62.831853072),
            ("vector-feed", 119391.393301),
            ("block-time", 31.830988618),
            ("dots-per-second", 31.415926536),
            ("volts-command", 8.108108108),
            ("volts", 10.0 * 3320.0 / 4095.0),
        ],
    );
}

#[test]
fn paper_example_with_short_pi_gives_its_figures() {
    check(
        &[("pi", "3.14")],
        1e-9,
        &[
            ("k", 12.56),
            ("line-speed", 15072.0),
            ("y-stroke", 62.8),
            ("vector-feed", 119271.336603),
            ("x-feed", 15072.0),
            ("y-feed", 118315.2),
            ("block-time", 31.847133758),
            ("dots-per-second", 31.4),
        ],
    );
}

/// Override, #104, then #105, #115 and T in ms with 3.14 and with the exact π, V.
type Row = (u32, f64, [f64; 3], [f64; 3], f64);

/// Section 6.2 of the sheet.
const OVERRIDES: [Row; 7] = [
    (10, 120.0, [1507.200, 11927.134, 318.471], [1507.964, 11939.139, 318.310], 0.811),
    (50, 600.0, [7536.000, 59635.668, 63.694], [7539.822, 59695.697, 63.662], 4.054),
    (80, 960.0, [12057.600, 95417.069, 39.809], [12063.716, 95513.115, 39.789], 6.486),
    (100, 1200.0, [15072.000, 119271.337, 31.847], [15079.645, 119391.393, 31.831], 8.108),
    (110, 1320.0, [16579.200, 131198.470, 28.952], [16587.609, 131330.533, 28.937], 8.919),
    (120, 1440.0, [18086.400, 143125.604, 26.539], [18095.574, 143269.672, 26.526], 9.730),
    (123, 1476.0, [18538.560, 146703.744, 25.892], [18547.963, 146851.414, 25.879], 9.973),
];

#[test]
fn design_reproduces_the_override_table() {
    for (knob, speed, short, exact, volts) in OVERRIDES {
        for (pi, [line, feed, time]) in [("3.14", short), ("exact", exact)] {
            let design = design(&[("override", &knob.to_string()), ("knob-lowest", "10"), ("pi", pi)]);
            let near = |id: &str, wanted: f64| {
                let value = readout(&design, id).value;
                assert!((value - wanted).abs() <= 0.00051, "{knob} % {pi} {id}: {value}, expected {wanted}");
            };
            near("actual-speed", speed);
            near("line-speed", line);
            near("vector-feed", feed);
            near("block-time", time);
            near("volts-command", volts);
        }
    }
}

#[test]
fn speed_above_the_clamp_slows_the_line_with_a_verdict() {
    let design = design(&[("override", "124")]);
    assert_eq!(readout(&design, "actual-speed").value, 1480.0);
    let volts = readout(&design, "volts");
    // 1488 r/min would take more than the output gives.
    assert!((volts.value - 10.0 * 1488.0 / 1480.0).abs() < 1e-9, "{}", volts.value);
    assert_eq!((volts.verdict, volts.limit), (Verdict::Fail, Some(Limit::AtMost(10.0))));
    assert_eq!(
        advice(&volts),
        [
            "1488 r/min are asked for, 1480 are possible: the line runs slower than asked. Above 123.3 % the knob does nothing."
        ]
    );
}

#[test]
fn y_in_degrees_keeps_x_feed_and_changes_the_vector() {
    check(
        &[("y-unit", "degrees")],
        1e-8,
        &[("y-stroke", 60.0), ("vector-feed", 114098.216), ("surface-ratio", 7.853981634)],
    );
    check(&[("y-unit", "degrees"), ("pi", "3.14")], 1e-8, &[("vector-feed", 114040.373)]);
}

#[test]
fn design_reproduces_the_sizing_table() {
    // Rows A, D, E, F and G of the test table (docs/reference/sizing.md, section 6), in the units of the readouts.
    check(
        &[],
        1e-4,
        &[
            ("line-speed", 251.327 * 60.0),
            ("vector-feed", 119391.0),
            ("block-time", 31.831),
            ("dots-per-second", 31.4159),
            ("surface-speed", 1973.92 * 60.0),
            ("print-roller-speed", 314.159),
            ("x-motor-speed", 480.0),
            ("y-motor-speed", 1570.8),
            ("volts-command", 8.10811),
            ("frequency", 40.5405),
            ("speed-error", 1.21802),
            ("slack-rate", 183.673),
            ("speed-error-rated", -4.48198),
            ("slack-rate-rated", -675.867),
            ("analog-step", 0.361416),
            ("override-step", 2.51327),
            ("override-limit", 123.333),
            ("thickness-error", 0.5),
            ("loop-time", 44.3874),
            ("surface-ratio", 7.85398),
            ("matching-diameter", 15.2789),
            ("matching-heads", 47.1239),
            ("smear", 1.7454),
            ("x-resolution", 0.314159),
        ],
    );
    // Tension of +1 % draw (D11): a motor that loses 1 %, and twice that with the knob at 50 %.
    check(
        &[
            ("speed-at-10v", "1500"),
            ("speed-clamp", "1500"),
            ("no-load-speed", "1500"),
            ("rated-load-speed", "1488"),
            ("knob-lowest", "100"),
        ],
        1e-4,
        &[("speed-error-rated", -1.0), ("tension", 2.0)],
    );
    check(&[("pi", "3.14")], 1e-3, &[("pi-drift", 7.64474)]);
    check(&[("encoder-resolution-x", "131072")], 1e-4, &[("x-resolution", 0.239684)]);
    check(&[("encoder-resolution-x", "8192")], 1e-4, &[("x-resolution", 3.83495)]);
    // F6 is that of X; with six heads the print roller, which runs faster, settles later.
    check(&[("heads", "60")], 1e-4, &[("start-stop-speed", 12.1707)]);
    let short = [("time-constant-x", "30"), ("time-constant-y", "30"), ("heads", "60")];
    check(&short, 1e-4, &[("start-stop-speed", 14.7994)]);
}

#[test]
fn start_and_stop_slack_match_the_sizing_table() {
    // D23: X waits for the speed. D24: both start together. D25: both stop together. v 251.327 mm/s, ramps 2 s and 0.1 s.
    for (slack, wanted) in [
        (web::slack_after_start(251.327412, 2.0, 0.1, 2.0), 263.894),
        (web::slack_after_start(251.327412, 2.0, 0.1, 0.0), -238.761),
        (web::slack_after_stop(251.327412, 2.0, 0.1, 0.0), 238.761),
    ] {
        assert!((slack - wanted).abs() < 0.001, "{slack}, expected {wanted}");
    }
}

#[test]
fn paper_example_fails_the_slip_rule_and_names_the_match() {
    let design = design(&[]);
    let ratio = readout(&design, "surface-ratio");
    assert_eq!(ratio.verdict, Verdict::Fail);
    assert!((ratio.value - 7.854).abs() < 0.0005);
    assert_eq!(
        advice(&ratio),
        [
            "slips: match 47 heads",
            "The roller’s surface runs 7.854 times as fast as the ribbon: each head slips 1.745 mm while it touches, 0.05 are allowed.",
            "Or match the heads: 47 on this roller give a ratio of 1.00264 and a smear of 0.005 mm.",
            "6 heads would roll without slip on Ø 15.28 mm, which is thinner than the two walls of the print roller, 20 mm.",
            "Or a pitch of 62.832 mm.",
            "That makes another result fail: Ribbon missing after a turn of the knob.",
            "Or an electronic cam in the drive that matches the speed only in the contact: by a modified sine the print motor takes 99.42 Nm at most (5.02 are allowed) and 57.06 Nm effective (1.65 are allowed); it suffices for ribbon speeds up to 3660 mm/min. A G01 block cannot do this: its ratio is constant.",
        ]
    );
    assert!(design.diagnostics.iter().all(|finding| finding.severity == Severity::Info), "verdicts never bar export");
}

/// Every rule once beyond its limit: the result, its verdict.
#[test]
fn rules_give_their_verdicts() {
    type Case = (&'static [(&'static str, &'static str)], &'static str, Verdict);
    let cases: &[Case] = &[
        (&[("heads", "47")], "surface-ratio", Verdict::Ok),
        (&[("heads", "45")], "smear", Verdict::Warn),
        (&[("motor-rated-y", "1500")], "y-motor-speed", Verdict::Warn),
        (&[("motor-max-y", "1500"), ("motor-rated-y", "1500")], "y-motor-speed", Verdict::Fail),
        (&[], "x-motor-speed", Verdict::Ok),
        (&[("pitches-per-block", "2")], "block-time", Verdict::Ok),
        (&[], "block-time", Verdict::Fail),
        (&[("pitches-per-block", "2"), ("macro-time", "5")], "block-time", Verdict::Warn),
        (
            &[
                ("override", "150"),
                ("speed-at-10v", "3000"),
                ("speed-clamp", "3000"),
                ("clamp-x", "99999"),
                ("clamp-y", "999999"),
            ],
            "block-time",
            Verdict::Fail,
        ),
        (&[], "volts", Verdict::Ok),
        (&[("spindle-speed", "60")], "volts", Verdict::Warn),
        (&[("speed-clamp", "2000")], "volts", Verdict::Warn),
        (&[("override", "10"), ("knob-lowest", "10")], "frequency", Verdict::Warn),
        (&[("override", "10")], "frequency", Verdict::Ok),
        (&[], "register-error", Verdict::Ok),
        (&[("position-gain-y", "40")], "register-error", Verdict::Fail),
        (&[("time-constant-y", "50")], "register-error", Verdict::Fail),
        (&[], "loop-needed", Verdict::Fail),
        (&[("loop-capacity", "1900")], "loop-needed", Verdict::Ok),
        (&[("loop-capacity", "1900"), ("inverter-ramp", "10")], "loop-needed", Verdict::Fail),
        (&[], "slack-rate", Verdict::Fail),
        (&[("dancer", "true")], "slack-rate", Verdict::Ok),
        (&[("youngs-modulus", "3000")], "tension", Verdict::Fail),
        // The slip of the motor, 18 r/min less than commanded, is twice the part of the speed at half of it.
        (&[], "tension", Verdict::Fail),
        // 6 N beside the 15 N of the ribbon open a switch at 20 N, half of what the nip holds, and none at 40 N.
        (&[("knob-lowest", "100")], "tension", Verdict::Fail),
        (&[("knob-lowest", "100"), ("pinch-force", "200")], "tension", Verdict::Ok),
        (&[("dwell", "0"), ("youngs-modulus", "200")], "tension", Verdict::Fail),
        (&[("pi", "3.14")], "pi-drift", Verdict::Warn),
        (&[], "thickness-error", Verdict::Warn),
        (&[("effective-diameter", "true")], "thickness-error", Verdict::Ok),
        (&[("path-mode", "exact-stop")], "start-stop-speed", Verdict::Warn),
        (&[("encoder-resolution-x", "1000")], "x-resolution", Verdict::Warn),
        (&[("encoder-resolution-x", "1000")], "y-resolution", Verdict::Ok),
        (&[("encoder-resolution-y", "1000")], "y-resolution", Verdict::Warn),
    ];
    for (changes, id, verdict) in cases {
        assert_eq!(readout(&design(changes), id).verdict, *verdict, "{id} with {changes:?}");
    }
}

#[test]
fn feed_above_a_clamp_is_an_error_with_the_possible_speed() {
    let slow = design(&[("clamp-y", "100000")]);
    let [error] = slow.diagnostics.iter().filter(|d| d.severity == Severity::Error).collect::<Vec<_>>()[..] else {
        panic!("one error: {:?}", slow.diagnostics)
    };
    assert_eq!(error.field, Some("clamp-y"));
    assert_eq!(
        sentence(&error.hints[0]),
        "At most 1013 r/min of the unwinder keep within the limits of the axes and of F: as its S, and as its clamp, beyond which the knob cannot go."
    );
    let share = design(&[("clamp-y", "100000"), ("spindle-speed", "1013")]);
    assert!(share.diagnostics.iter().all(|d| d.severity != Severity::Error));
}

#[test]
fn blocks_too_long_for_the_control_are_errors() {
    let errors = |changes: &[(&str, &str)]| -> Vec<String> {
        let found = design(changes).diagnostics.into_iter().filter(|d| d.severity == Severity::Error);
        found.map(|d| sentence(&d.message)).collect()
    };
    let long = [("pitch", "10000"), ("pitches-per-block", "11"), ("heads", "47")];
    assert_eq!(errors(&long), ["X would move by 110000 in one block; a word of the control has 99999.999 at most."]);
    // A block is never longer than the product.
    let short = [long[0], long[1], long[2], ("pitch-count", "9")];
    assert_eq!(errors(&short), [""; 0]);
    // A limit above the control's own does not help.
    let fast = [("pitch", "0.5"), ("clamp-y", "10000000"), ("feed-limit", "10000000"), ("dancer", "true")];
    let slow =
        [("spindle-speed", "1"), ("reduction-ratio", "10000"), ("press-roller-diameter", "1"), ("heads", "1000")];
    assert!(errors(&slow)[0].contains("steps of 0.001, less is F0"), "{:?}", errors(&slow));
    // The program stops by itself before anything moves: no error, but red.
    assert_eq!(errors(&fast), [""; 0]);
    let feed = readout(&design(&fast), "vector-feed");
    assert_eq!((feed.verdict, feed.limit), (Verdict::Fail, Some(Limit::AtMost(1e6 * (1200.0 / 1480.0)))));
    assert_eq!(advice(&feed)[1], "The vector feed would be 1895024.044 mm/min, the control takes 1000000 at most.");
}

#[test]
fn labels_contain_no_placeholders() {
    let fields = machine().fields().into_iter().flat_map(|field| [field.label, field.help, field.group]);
    let readouts = design(&[]).readouts.into_iter().map(|readout| readout.label);
    let variables = machine().prepare(&Values::new(), on()).variables().into_iter().map(|row| row.label);
    for label in fields.chain(readouts).chain(variables) {
        let text = words(label);
        assert!(!text.is_empty() && !text.contains('{'), "{label}: {text}");
    }
}

#[test]
fn line_at_standstill_has_finite_results() {
    let design = design(&[("override", "0")]);
    for readout in &design.readouts {
        assert!(!readout.value.is_nan(), "{}: no number", readout.id);
    }
    assert_eq!(readout(&design, "line-speed").value, 0.0);
    assert_eq!(readout(&design, "products-per-hour").value, 0.0);
}

#[test]
fn override_knob_moves_in_its_steps() {
    for (step, speed) in [("1", 876.0), ("5", 900.0), ("10", 840.0)] {
        check(&[("override", "73"), ("knob-step", step)], 1e-12, &[("actual-speed", speed)]);
    }
}

#[test]
fn product_length_becomes_whole_pitches() {
    check(
        &[("job", "product-length"), ("product-length", "4003")],
        1e-12,
        &[("dots-per-product", 500.0), ("product-length", 4000.0)],
    );
}

#[test]
fn values_without_origin_are_listed_as_assumed() {
    let count = |origins: &Origins| {
        let design = machine().prepare(&Values::new(), on()).design(origins);
        let infos = design.diagnostics.into_iter().filter(|d| d.severity == Severity::Info);
        infos.map(|d| sentence(&d.message)).collect::<String>()
    };
    let label = words("ribbon.inverter-ramp");
    assert!(count(&Origins::new()).contains(label));
    let measured = Origins::from_iter([("inverter-ramp".to_owned(), Provenance::Measured)]);
    assert!(!count(&measured).contains(label));
}

#[test]
fn invalid_value_is_an_error_and_the_default_stays() {
    let values =
        Values::from_iter([("pitch".to_owned(), Value::Number(0.0)), ("heads".to_owned(), Value::Number(2.5))]);
    let design = machine().prepare(&values, on()).design(&Origins::new());
    let fields: Vec<_> =
        design.diagnostics.iter().filter(|d| d.severity == Severity::Error).filter_map(|d| d.field).collect();
    assert_eq!(fields, ["pitch", "heads"]);
    assert!((readout(&design, "line-speed").value - 15079.644737).abs() < 1e-5);
}
