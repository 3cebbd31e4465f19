//! The loop that a dancer keeps: errors that it trims away, its set point, what products before leave, and turns of the knob that miss ribbon.

use macroline::motion::{Action, Budget, Event, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::text::catalog::sentence;
use macroline::view::Verdict;

use super::each_control::{begun, ended};
use crate::queries::{near, readout, sized_without_envelope, value};
use macroline::machines::driven::devices::BillItem;

/// The ready-made example with a dancer, with other entries.
fn line(entries: &[(&'static str, &str)]) -> Project {
    Project::named("ribbon-line", None, Some("matched")).unwrap().with_entries(entries).unwrap()
}

/// Least and greatest loop (mm) of a run from one time to another.
fn loop_between(project: &Project, planner: &run::Run, from: f64, to: f64) -> (f64, f64) {
    let at = |t: f64| project.prepared().gauges(planner, (t, t), 2)[0].value;
    let values = (0..=2000).map(|step| at(from + (to - from) * f64::from(step) / 2000.0));
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), slack| (least.min(slack), most.max(slack)))
}

fn has_dancer(project: &Project) -> bool {
    sized_without_envelope(project).bill.iter().any(|row| row.item == BillItem::Dancer)
}

#[test]
fn dancer_under_a_feed_per_revolution_is_left_out() {
    let in_step = line(&[("feed-form", "per-revolution"), ("spindle-encoder", "true"), ("dwell", "0")]);
    let idle = |project: &Project| project.design().diagnostics.iter().any(|d| d.message.id == "ribbon.dancer-idle");
    assert!(has_dancer(&line(&[])) && !idle(&line(&[])));
    assert!(!has_dancer(&in_step) && idle(&in_step));
    assert!(!idle(&in_step.with_entries(&[("dancer", "false")]).unwrap()));
}

/// A ribbon as thick as its press roller is thin: 3/20 - 3/100.
const THICK: [(&str, &str); 7] = [
    ("effective-diameter", "false"),
    ("press-roller-diameter", "20"),
    ("ribbon-thickness", "3"),
    ("reduction-ratio", "10"),
    ("reel-diameter", "900"),
    ("reel-core-diameter", "300"),
    ("pitch-count", "300"),
];

#[test]
fn thickness_of_the_ribbon_takes_of_the_dancers_trim() {
    let motor = value(&line(&[]), "dancer-trim") / 100.0;
    let project = line(&THICK);
    let row = readout(&project, "dancer-trim");
    near(row.value, 100.0 * ((1.0 + motor) * 1.12 - 1.0), 1e-9);
    assert_eq!(row.verdict, Verdict::Fail);
    for advice in &row.advice {
        let after = project.with_entries(&advice.entries).unwrap();
        assert_eq!(readout(&after, "dancer-trim").verdict, Verdict::Ok, "{}", advice.message.id);
    }
}

#[test]
fn shortage_of_a_turn_is_shown_in_tenths() {
    let row = readout(&line(&[&THICK[..], &[("dwell", "0.7")]].concat()), "missing-turned");
    let texts: Vec<_> = row.advice.iter().map(|advice| sentence(&advice.message)).collect();
    assert_eq!(row.verdict, Verdict::Fail);
    assert!(texts.iter().all(|text| !text.contains(" 0 mm")), "{texts:?}");
    assert!(texts.iter().any(|text| text.contains("0.1 mm more")), "{texts:?}");
}

#[test]
fn slip_is_judged_at_the_lowest_position_of_the_knob() {
    let slow = [("unwinder-load", "100"), ("knob-lowest", "10")];
    let project = line(&slow);
    let row = readout(&project, "dancer-trim");
    // 70 r/min of 120, and a motor of 1500 r/min at 1480.
    near(row.value, 100.0 * (1500.0 / 1480.0 - 70.0 / 120.0 - 1.0), 1e-9);
    assert_eq!((row.verdict, value(&project, "dancer-loop-trim")), (Verdict::Fail, 0.0));
    let higher = row.advice.iter().find(|advice| !advice.entries.is_empty()).expect("a higher position");
    assert_eq!(higher.message.id, "ribbon.higher-lowest-to-trim");
    let after = project.with_entries(&higher.entries).unwrap();
    assert_eq!(readout(&after, "dancer-trim").verdict, Verdict::Ok);
}

#[test]
fn short_pi_with_a_dancer_lays_no_ribbon() {
    let advice = |project: &Project| readout(project, "pi-drift").advice[0].message.id;
    let short = line(&[("pi", "3.14")]);
    assert_eq!(advice(&short), "ribbon.pi-short-trimmed");
    assert_eq!(advice(&short.with_entries(&[("dancer", "false")]).unwrap()), "ribbon.pi-short");
    let more = (1.0 + value(&line(&[]), "dancer-trim") / 100.0) * std::f64::consts::PI * 100.0 / 314.0 - 1.0;
    near(value(&short, "dancer-trim"), 100.0 * more, 1e-9);
}

/// A long ramp, one block read ahead, and a motor that turns as commanded without a dancer.
const OUTRUN: [(&str, &str); 13] = [
    ("preread", "1"),
    ("inverter-ramp", "4"),
    ("dwell", "2"),
    ("youngs-modulus", "90"),
    ("tensile-strength", "100"),
    ("pitch-count", "1000"),
    ("reel-diameter", "600"),
    ("reel-core-diameter", "200"),
    ("reel-brake", "10"),
    ("loop-capacity", "2500"),
    ("knob-lowest", "10"),
    ("dancer", "false"),
    ("no-load-speed", "1480.02"),
];

#[test]
fn turn_up_counts_the_least_queue_at_the_worst_position() {
    let project = line(&OUTRUN).with_entries(&[("rated-load-speed", "1479.5")]).unwrap();
    let row = readout(&project, "missing-turned");
    let v2 = value(&project, "line-speed") / 60.0 * 1480.0 / 1200.0;
    // One block of 10 mm is read ahead, the running one is almost done.
    let missing = |percent: f64| {
        let v1 = v2 * percent / 100.0 * 1200.0 / 1480.0;
        let ramp = 4.0 * (1.0 - v1 / v2);
        (v2 - v1) * (ramp / 2.0 - 10.0 / v1 - 0.05 - 1.0 / 33.0)
    };
    assert_eq!((row.verdict, row.advice[0].message.id), (Verdict::Fail, "ribbon.knob-outruns"));
    let worst = (10..120).map(|percent| missing(f64::from(percent))).fold(0.0, f64::max);
    assert!(row.value > missing(10.0) && row.value <= worst + 1e-9, "{} {worst}", row.value);
    assert!(row.value > 150.0, "{}", row.value);
}

/// A stiff ribbon behind a long ramp: a turn up misses more than the start lays at the highest position.
const STIFF: [(&str, &str); 8] = [
    ("preread", "1"),
    ("inverter-ramp", "4"),
    ("dwell", "1.9"),
    ("youngs-modulus", "300"),
    ("tensile-strength", "100"),
    ("pitch-count", "3000"),
    ("reel-diameter", "900"),
    ("loop-capacity", "1500"),
];

#[test]
fn dancer_keeps_the_ribbon_of_a_turn_in_reserve() {
    let project = line(&STIFF);
    let set = value(&project, "dancer-set-point");
    near(set, value(&project, "missing-turned"), 1e-9);
    assert!(set > 80.0, "{set}");
    let events = vec![
        Event { t: 0.0, action: Action::SpindleOverride(50.0) },
        Event { t: 120.0, action: Action::SpindleOverride(200.0) },
        Event { t: 160.0, action: Action::Reset },
    ];
    let mut run = begun(&project, events);
    ended(&mut run);
    assert!(run.diagnostics().iter().all(|found| found.message.id != "ribbon.held-web-tight"));
    let (least, _) = loop_between(&project, &run, 100.0, 150.0);
    assert!((-1.0..set).contains(&least), "{least} of {set}");
}

/// The loop before each of so many products that are started one after another.
fn before_products(project: &Project, products: usize) -> Vec<f64> {
    let limits = Budget { blocks: 10_000_000, seconds: 3600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = run::of_project(project, &project.written(), &begin);
    let mut before = Vec::new();
    while before.len() < products {
        while run.advance(f64::INFINITY, 100_000).ended.is_none() {}
        if run.ended_at().is_none() || run.diagnostics().iter().any(|d| d.message.id == "ribbon.held-loop-full") {
            break;
        }
        let rest = run.timeline().end();
        before.push(loop_between(project, &run, rest, rest).0);
        run.event(Event { t: rest + 3.0, action: Action::Start });
    }
    before
}

#[test]
fn loop_of_many_products_stays_within_its_bound() {
    let project = line(&[("pitch-count", "160"), ("dwell", "0.7")]);
    let bound = readout(&project, "slack-before");
    let before = before_products(&project, 8);
    assert_eq!((before.len(), readout(&project, "loop-growth").verdict), (8, Verdict::Ok));
    assert!(before.iter().all(|slack| *slack <= bound.value), "{before:?} of {}", bound.value);
    assert!(*before.last().unwrap() > 0.5 * bound.value, "{before:?} of {}", bound.value);
    // The loop holds it with a hold and its restart in the next product.
    assert!(value(&project, "loop-needed") > bound.value + value(&project, "slack-interruption"));
}

#[test]
fn short_products_fill_the_loop_with_a_warning() {
    let project = line(&[("pitch-count", "20")]);
    let row = readout(&project, "loop-growth");
    assert!(row.verdict == Verdict::Warn && row.value > 0.0, "{row:?}");
    assert!(project.design().readouts.iter().all(|row| row.id != "slack-before"));
    assert_eq!(row.advice[0].message.id, "ribbon.loop-fills-by-products");
    let before = before_products(&project, 6);
    assert!(before.is_sorted() && before[5] > 450.0, "{before:?}");
    // Without a dancer the operator takes the loop up.
    let open = line(&[("pitch-count", "20"), ("dancer", "false")]);
    assert!(open.design().readouts.iter().all(|row| row.id != "loop-growth" && row.id != "slack-before"));
}

#[test]
fn free_knob_within_the_trim_leaves_a_standing_loop() {
    let entries = [
        ("knob-use", "free"),
        ("knob-lowest", "93"),
        ("speed-clamp", "1300"),
        ("dwell", "0.749"),
        ("loop-capacity", "400"),
        ("youngs-modulus", "300"),
        ("tensile-strength", "100"),
        ("reel-brake", "10"),
    ];
    let of = |knob: &str| {
        let mut project = Project::named("ribbon-line", Some("sinumerik-802d"), Some("matched")).unwrap();
        project.switches.0.push(("spindle-knob".to_owned(), "50-to-120".to_owned()));
        project.with_entries(&entries).unwrap().with_entries(&[("knob-use", knob)]).unwrap()
    };
    let (free, locked) = (of("free"), of("locked"));
    assert_eq!(readout(&free, "slack-rate-knob").verdict, Verdict::Ok);
    let [trim, range, set] = ["dancer-loop-trim", "dancer-range", "dancer-set-point"].map(|id| value(&free, id));
    let row = readout(&free, "missing-low-knob");
    near(row.value, range * (100.0 / 93.0 - 1.0) / (trim / 100.0) - set, 1e-9);
    assert_eq!(row.verdict, Verdict::Fail);
    let locks = free.with_entries(&row.advice[0].entries).unwrap();
    assert!(locks.design().readouts.iter().all(|row| row.id != "missing-low-knob"));
    // At 1300 r/min ribbon stands in the loop.
    let standing = range * (1.0 - 1200.0 / 1300.0) / (trim / 100.0);
    for id in ["loop-needed", "loop-coasting"] {
        assert!(value(&free, id) > value(&locked, id) + 0.9 * standing, "{id}: {standing}");
    }
}

#[test]
fn upward_trim_of_a_dancer_is_judged_at_the_motor() {
    let heavy = [("unwinder-forced-cooling", "true"), ("unwinder-friction", "166"), ("unwinder-load", "20")];
    let row = |dancer| readout(&line(&[&heavy[..], &[("dancer", dancer)]].concat()), "unwinder-torque");
    assert_eq!(row("false").limit.map(|limit| limit.value()), Some(5.0));
    let with = row("true");
    // 55 Hz weaken the field: 5 Nm · 50 / 55.
    near(with.limit.unwrap().value(), 5.0 / 1.1, 1e-9);
    assert_eq!(with.verdict, Verdict::Fail);
}

#[test]
fn settings_of_the_regulator_are_results_and_in_the_bill() {
    let project = line(&[]);
    near(value(&project, "dancer-loop-trim"), 10.0 - value(&project, "dancer-trim"), 1e-9);
    let highest = value(&project, "line-speed") / 60.0 * 1480.0 / 1200.0;
    near(value(&project, "dancer-range"), value(&project, "dancer-loop-trim") / 100.0 * 10.0 * highest, 1e-9);
    let devices = project.prepared().devices();
    let dancer = devices.iter().find(|device| device.item == BillItem::Dancer).unwrap();
    let text = sentence(&dancer.asked);
    for part in ["set point 39 mm", "proportional band 136 mm", "±8.8 %", "every 0.1 s"] {
        assert!(text.contains(part), "{text} lacks {part}");
    }
    let open = line(&[("dancer", "false")]);
    assert!(open.design().readouts.iter().all(|row| !row.id.starts_with("dancer-") && row.id != "slack-before"));
    assert_eq!(RunEnd::ProgramEnd, ended(&mut begun(&project, vec![])));
}
