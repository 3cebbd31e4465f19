//! The ribbon line at the edges of its operation: a motor above its rated frequency or slower than its slip, feed in step, loops too long to build.

use macroline::motion::{Budget, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::repairs::repairs;
use macroline::project::run::{self, RunOptions};
use macroline::text::catalog::sentence;
use macroline::view::{Advice, Limit, Verdict};

use super::controls;
use super::each_control::project;
use crate::queries::{near, readout, sized_without_envelope};

/// 100 Hz at 10 V for 2960 r/min: at most 94.6 Hz with S at most 2800.
const FAST: [(&str, &str); 7] = [
    ("frequency-at-10v", "100"),
    ("no-load-speed", "3000"),
    ("rated-load-speed", "2930"),
    ("speed-at-10v", "2960"),
    ("speed-clamp", "2800"),
    ("spindle-speed", "2800"),
    ("unwinder-forced-cooling", "true"),
];

#[test]
fn motor_above_its_rated_frequency_has_less_torque() {
    let line = project("mitsubishi-e60", &FAST);
    let (frequency, torque) = (100.0 * 2800.0 / 2960.0, readout(&line, "unwinder-torque"));
    near(torque.limit.unwrap().value(), 5.0 * 50.0 / frequency, 1e-9);
    near(readout(&line, "unwinder-ramp-torque").limit.unwrap().value(), 7.5 * 50.0 / frequency, 1e-9);
    let braking = readout(&line, "unwinder-braking-torque").limit.unwrap().value();
    near(
        braking,
        readout(&project("mitsubishi-e60", &[]), "unwinder-braking-torque").limit.unwrap().value() * 50.0 / frequency,
        1e-9,
    );
    let heavy = project("mitsubishi-e60", &[&FAST[..], &[("reduction-ratio", "5"), ("reel-brake", "250")]].concat());
    let torque = readout(&heavy, "unwinder-torque");
    assert!(torque.value < 5.0 && torque.verdict == Verdict::Fail, "{torque:?}");
    assert!(sentence(&torque.advice[0].message).contains("94.6 Hz"), "{:?}", torque.advice);
}

/// A motor with 1500 r/min at no load and 1430 at rated torque loses 70 r/min at rated torque, at every speed.
#[test]
fn motor_slower_than_its_slip_stalls() {
    for (speed, verdict) in [("60", Verdict::Warn), ("80", Verdict::None)] {
        let entries = [
            ("no-load-speed", "1500"),
            ("rated-load-speed", "1430"),
            ("speed-at-10v", "1500"),
            ("spindle-speed", speed),
            ("unwinder-load", "10"),
            ("dancer", "false"),
        ];
        let line = project("sinumerik-802d", &entries);
        assert_eq!(readout(&line, "speed-error-rated").verdict, verdict, "{speed} r/min");
        assert_eq!(readout(&line, "speed-error").verdict, Verdict::None, "{speed} r/min");
        let loaded = line.with_entries(&[("unwinder-load", "100")]).unwrap();
        let at_load = if verdict == Verdict::Warn { Verdict::Fail } else { Verdict::None };
        assert_eq!(readout(&loaded, "speed-error").verdict, at_load, "{speed} r/min");
    }
}

#[test]
fn feed_in_step_with_the_unwinder_draws_no_ribbon() {
    let stiff = [("youngs-modulus", "3000"), ("dancer", "false"), ("wait", "dwell"), ("dwell", "0")];
    let in_step = [("feed-form", "per-revolution"), ("spindle-encoder", "true")];
    let tension = |entries: &[(&str, &str)]| readout(&project("sinumerik-802d", entries), "tension");
    assert!(tension(&stiff).value > 100.0);
    // What is left is that of a start, before the measured speed is there.
    let left = tension(&[&stiff[..], &in_step].concat()).value;
    assert!(left < 50.0, "{left}");
}

/// Loops of more than 5 m are no remedy; a steeper ramp with its dwell is one.
#[test]
fn long_ramp_is_repaired_by_a_shorter_one() {
    let entries = [("inverter-ramp", "20"), ("dancer", "true"), ("unwinder-motor-braking", "150")];
    for control in controls() {
        let line = project(control.id, &entries);
        let needed = readout(&line, "loop-needed");
        assert!(needed.value > 5000.0 && needed.verdict == Verdict::Fail, "{}", control.id);
        assert!(needed.advice[0].entries.is_empty(), "{}: {:?}", control.id, needed.advice);
        let steep = needed
            .advice
            .iter()
            .find(|advice| advice.entries.iter().any(|entry| entry.field == "inverter-ramp"))
            .unwrap();
        let after = line.with_entries(&steep.entries).unwrap();
        assert!(readout(&after, "loop-needed").verdict < Verdict::Fail, "{}", control.id);
        // A button that changes several entries names each change.
        let button = sentence(steep.button.as_ref().unwrap());
        assert!(button.contains("Set a ramp of") && button.contains("Set a dwell of"), "{button}");
        let loops = repairs(&line).changes.into_iter().flat_map(|change| change.entries);
        let loops =
            loops.filter(|entry| entry.field == "loop-capacity").map(|entry| entry.text.parse::<f64>().unwrap());
        assert!(loops.fold(0.0, f64::max) <= 5000.0, "{}", control.id);
    }
}

#[test]
fn exact_stop_that_the_control_lacks_is_reported() {
    for control in controls() {
        let line = project(control.id, &[("path-mode", "exact-stop")]);
        let reported = line.design().diagnostics.iter().any(|found| found.message.id == "ribbon.no-exact-stop");
        let stops = line
            .written()
            .files
            .0
            .iter()
            .any(|file| ["G09", "G61", "G9 ", "G60"].iter().any(|code| file.text.contains(code)));
        assert_eq!(reported, !stops, "{}", control.id);
    }
}

#[test]
fn knob_holds_within_its_positions() {
    for control in controls() {
        let slow = project(control.id, &[("spindle-speed", "60")]);
        let holds = readout(&slow, "knob-holds").value;
        let highest = control.spindle.knob.high.min(200.0);
        assert!(holds <= highest, "{}: {holds}", control.id);
        assert!(
            slow.design().readouts.iter().all(|row| row.id != "override-limit" || row.value < highest),
            "{}",
            control.id
        );
    }
    let full = readout(&project("mitsubishi-e60", &[]), "override-limit");
    near(full.value, 100.0 * 1480.0 / 1200.0, 1e-9);
    assert_eq!(full.limit.map(Limit::value), None);
}

#[test]
fn advice_against_a_taut_start_names_no_fitted_dancer() {
    let stiff = [
        ("dancer", "true"),
        ("ribbon-width", "100"),
        ("ribbon-thickness", "0.1"),
        ("youngs-modulus", "3500"),
        ("tensile-strength", "100"),
        ("dwell", "0.7"),
    ];
    let line = project("mitsubishi-e60", &stiff);
    let all: Vec<_> = line.design().readouts.into_iter().flat_map(|readout| readout.advice).collect();
    let slack = all.iter().find(|advice| advice.message.id == "ribbon.nip-slack");
    let sets_dwell = |advice: &Advice| advice.entries.iter().any(|entry| entry.field == "dwell");
    assert!(slack.is_some_and(sets_dwell), "{all:?}");
    assert!(all.iter().flat_map(|advice| &advice.entries).all(|entry| entry.field != "dancer"), "{all:?}");
}

/// 36 heads on a roller of 114.6 mm have 10 mm each, and dots of 8.1 mm every 8 mm run into each other.
#[test]
fn heads_and_dots_need_room() {
    let gap = |id, entries: &[(&'static str, &str)]| {
        let row = readout(&project("mitsubishi-e60", entries), id);
        (row.verdict, row.advice.first().map(|advice| advice.entries[0].text.clone()))
    };
    let roller = [("heads", "36"), ("print-roller-diameter", "114.6")];
    let heads = |length| gap("head-gap", &[roller[0], roller[1], ("head-length", length)]);
    assert_eq!(heads("10"), (Verdict::Ok, None));
    assert_eq!(heads("10.1"), (Verdict::Fail, Some("10".to_owned())));
    let matched = [("heads", "36"), ("pitch", "10"), ("print-roller-diameter", "114.592")];
    let dots = |length| gap("dot-gap", &[matched[0], matched[1], matched[2], ("head-length", length)]);
    assert_eq!(dots("9.9").0, Verdict::Ok);
    assert_eq!(dots("10.2").0, Verdict::Fail);
}

/// 150 m/min on a roller of 127.324 mm with a gear of 50 : 1 are 18 750 r/min of its motor.
#[test]
fn rapid_traverse_of_the_rollers_is_judged() {
    let entries = [("print-roller-diameter", "127.324"), ("gear-y", "50"), ("rapid-y", "150000")];
    let line = project("mitsubishi-e60", &entries);
    let row = readout(&line, "y-rapid-speed");
    near(row.value, 18750.0, 0.1);
    assert_eq!(row.verdict, Verdict::Fail);
    let slower = line.with_entries(&row.advice[0].entries).unwrap();
    assert_eq!(readout(&slower, "y-rapid-speed").verdict, Verdict::Ok);
}

/// The ramp to rapid traverse is as long as that to a feed, so that its torque grows with the speed.
#[test]
fn torque_of_rapid_traverse_is_judged() {
    let matched = Project::named("ribbon-line", Some("mitsubishi-e60"), None).unwrap();
    for (id, ramp, axis, entered) in
        [("x-rapid-torque", "x-ramp-torque", "x", "200000"), ("y-rapid-torque", "y-ramp-torque", "y", "150000")]
    {
        assert_eq!(readout(&matched, id).verdict, Verdict::Ok, "{id}");
        let rapid = if axis == "x" { "rapid-x" } else { "rapid-y" };
        let more = [("time-constant-x", "35"), ("time-constant-y", "35"), (rapid, entered), ("gear-y", "10")];
        let line = matched.with_entries(&[&more[..], &[("gear-x", "10")]].concat()).unwrap();
        let value = |id: &str| readout(&line, id).value;
        // T_L + (J_L / η + J_M) ω / t, by the ramp to the feed.
        let speeds = value(&format!("{axis}-rapid-speed")) / value(&format!("{axis}-motor-speed"));
        let wanted = value(&format!("{axis}-load-torque")) + value(ramp) * speeds;
        let row = readout(&line, id);
        near(row.value, wanted, 1e-9 * wanted);
        assert_eq!(row.verdict, Verdict::Fail, "{id}: {}", row.value);
        assert_eq!(readout(&line, &format!("{axis}-peak-torque")).verdict, Verdict::Ok, "{id}");
        let slower = line.with_entries(&row.advice[0].entries).unwrap();
        assert_eq!((row.advice[0].entries[0].field, readout(&slower, id).verdict), (rapid, Verdict::Ok), "{id}");
    }
}

/// An unwinder that turns half of what the control counts on: no dancer makes up for that, but the frequency of the inverter does.
#[test]
fn dancer_trims_away_a_tenth_at_most() {
    let line = project("mitsubishi-e60", &[("dancer", "true"), ("no-load-speed", "750"), ("rated-load-speed", "715")]);
    let row = readout(&line, "dancer-trim");
    assert!(row.verdict == Verdict::Fail && (-55.0..-45.0).contains(&row.value), "{row:?}");
    let set = line.with_entries(&row.advice[0].entries).unwrap();
    near(readout(&set, "dancer-trim").value, 0.0, 1.0);
    assert_eq!(readout(&project("mitsubishi-e60", &[("dancer", "true")]), "dancer-trim").verdict, Verdict::Ok);
}

/// A feed per revolution follows the measured speed, and the motors turn with it.
#[test]
fn motors_follow_the_measured_speed() {
    let line = |no_load, rated| {
        let encoder = Project::named("ribbon-line", Some("fanuc-0i-mf"), Some("encoder")).unwrap();
        encoder.with_entries(&[("no-load-speed", no_load), ("rated-load-speed", rated)]).unwrap()
    };
    let fast = line("2200", "2100");
    let share = 1.0 + readout(&fast, "speed-error").value / 100.0;
    assert!(share > 1.4, "{share}");
    for id in ["x-motor-speed", "y-motor-speed", "print-roller-speed"] {
        let slow = line("1500", "1430");
        let exact = readout(&slow, id).value / (1.0 + readout(&slow, "speed-error").value / 100.0);
        near(readout(&fast, id).value / exact, share, 1e-6);
    }
}

/// The program shortens a block that is longer than the product.
#[test]
fn block_longer_than_its_product_takes_the_time_of_the_product() {
    let time = |pitches| {
        let entries = [("pitches-per-block", pitches), ("pitch-count", "7")];
        readout(&project("mitsubishi-e60", &entries), "product-time").value
    };
    near(time("50"), time("7"), 1e-9);
}

#[test]
fn time_constants_are_in_the_control_s_range() {
    let refused = |control, constant| {
        let found = project(control, &[("time-constant-x", constant)]).design().diagnostics;
        found.iter().any(|found| found.message.id == "form.parameter-range" && found.field == Some("time-constant-x"))
    };
    assert!(refused("gsk-980tdc", "5") && !refused("gsk-980tdc", "10") && !refused("mitsubishi-e60", "5"));
}

/// The register of the final speed is 0 until an S is out: the program puts one out before it waits for a speed.
#[test]
fn line_with_a_final_speed_starts() {
    for variant in ["ready-made", "published", "precomputed"] {
        let entries = [("override-form", "final-speed"), ("variant", variant), ("pitch-count", "20")];
        let line = project("mitsubishi-e60", &entries);
        let limits = Budget { blocks: 10_000, seconds: 60.0 };
        let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Both };
        let mut planner = run::of_project(&line, &line.written(), &begin);
        assert_eq!(planner.advance(f64::INFINITY, usize::MAX).ended, Some(RunEnd::ProgramEnd), "{variant}");
    }
}

/// A ramp shorter than the servo loop takes to follow asks no more torque than no ramp: 1 / K is 30 ms.
#[test]
fn ramp_below_the_servo_loop_asks_its_torque() {
    let peak = |constant| {
        let line = project("mitsubishi-e60", &[("time-constant-x", constant), ("time-constant-y", constant)]);
        sized_without_envelope(&line).axes.iter().find(|axis| axis.id == "y").unwrap().demand.peak
    };
    let [none, short, equal] = ["0", "1", "30"].map(peak);
    assert!((short / none - 1.0).abs() < 0.05 && (equal / none - 1.0).abs() < 0.05, "{none} {short} {equal}");
}

#[test]
fn volts_and_frequency_are_those_of_the_slowest_knob() {
    // 0.81 V and 4.05 Hz at 100 %; at 50 %, the lowest position, half of them.
    let slow = project("mitsubishi-e60", &[("spindle-speed", "120"), ("knob-lowest", "50")]);
    let volts = readout(&slow, "volts");
    assert!((volts.value - 0.81).abs() < 0.01 && volts.verdict == Verdict::Warn, "{volts:?}");
    assert!(sentence(&volts.advice[0].message).contains("50 % the output gives 0.405 V"), "{:?}", volts.advice);
    let quick = project("mitsubishi-e60", &[("spindle-speed", "200"), ("knob-lowest", "50")]);
    let frequency = readout(&quick, "frequency");
    assert!((frequency.value - 6.76).abs() < 0.01 && frequency.verdict == Verdict::Warn, "{frequency:?}");
    let even = project("mitsubishi-e60", &[("spindle-speed", "200"), ("knob-lowest", "100")]);
    assert_eq!(readout(&even, "frequency").verdict, Verdict::Ok);
}

#[test]
fn tension_of_a_draw_adds_to_that_of_the_ribbon() {
    let paper = Project::named("ribbon-line", Some("mitsubishi-e60"), Some("paper")).unwrap();
    let stiff = [("youngs-modulus", "50"), ("pinch-force", "1000")];
    let with = |before: &str| {
        readout(&paper.with_entries(&[&stiff[..], &[("tension-before", before)]].concat()).unwrap(), "tension")
    };
    // A draw of 51.6 N; the ribbon tears at 150 N, and the tension switch opens at half of it.
    let (slack, taut) = (with("15"), with("30"));
    assert!((slack.value - 51.58).abs() < 0.01 && slack.value == taut.value, "{slack:?}");
    assert_eq!((slack.limit, slack.verdict), (Some(Limit::AtMost(60.0)), Verdict::Ok));
    assert_eq!((taut.limit, taut.verdict), (Some(Limit::AtMost(45.0)), Verdict::Fail));
    assert!(sentence(&taut.advice[0].message).contains("82 N"), "{:?}", taut.advice);
}
