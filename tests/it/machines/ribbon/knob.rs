//! The ribbon line over the whole range of its override knob: verdicts at its highest position, and the cost of turning it.

use macroline::machines::form::Value;
use macroline::motion::{Action, Event, RunEnd};
use macroline::project::Project;
use macroline::view::{FieldEntry, Limit, Verdict};
use proptest::prelude::*;

use super::each_control::{begun, ended, first_cut, over_time, project};
use super::{controls, values};
use crate::queries::{readout, value};

fn knob(t: f64, percent: f64) -> Event {
    Event { t, action: Action::SpindleOverride(percent) }
}

/// The project with the entries of the first advice on a result that sets some.
fn mended(project: &Project, id: &str) -> Project {
    let mut after = project.clone();
    let advice = readout(project, id).advice.into_iter().find(|advice| !advice.entries.is_empty());
    let sets = advice.unwrap_or_else(|| panic!("{id} has no remedy")).entries;
    let sets: Vec<_> = sets.iter().map(|entry| (entry.field, entry.text.as_str())).collect();
    after.values.extend(values(&sets));
    after
}

/// Results that are judged over the range of the knob.
const JUDGED: [&str; 5] = ["block-time", "x-feed", "y-feed", "vector-feed", "volts"];

/// Whether the program reads the knob: on controls without a macro input the override is typed, and no knob moves X.
fn has_knob(project: &Project) -> bool {
    project.prepared().variables().iter().any(|row| [1032, 1033].contains(&row.number))
}

#[test]
fn block_time_is_judged_at_the_end_of_the_knob() {
    let line = project("mitsubishi-e60", &[]);
    let block = readout(&line, "block-time");
    assert_eq!(block.verdict, Verdict::Fail);
    // 28.1 ms at 123.3 % are 34.66 ms at 100 %.
    let Some(Limit::AtLeast(limit)) = block.limit else { panic!("{:?}", block.limit) };
    assert!((limit - 28.1 * 1480.0 / 1200.0).abs() < 1e-9, "{limit}");
    assert!((readout(&line, "knob-holds").value - 31.830988618 / 28.1 * 100.0).abs() < 1e-6);
    assert_eq!(block.advice[0].entries, [FieldEntry::new("pitches-per-block", "2")]);
    let better = mended(&line, "block-time");
    assert_eq!(readout(&better, "block-time").verdict, Verdict::Ok);
    assert!((readout(&better, "knob-holds").value - 1480.0 / 12.0).abs() < 1e-9);
    // In a run, a block starves from 114 % on with one pitch per block, and not with two.
    for (project, percent, starves) in [(&line, 113.0, false), (&line, 114.0, true), (&better, 130.0, false)] {
        // Five blocks are read ahead: a small deficit takes a while, and the loop takes it up.
        let mut long = project.clone();
        let rolls = [("endless", "roll-over"), ("y-unit", "degrees")];
        long.values.extend(values(&[&rolls[..], &[("pitch-count", "3000"), ("loop-capacity", "10000")]].concat()));
        let mut planner = over_time(&long, vec![knob(6.0, percent)]);
        assert_eq!(ended(&mut planner), RunEnd::ProgramEnd);
        assert_eq!(planner.starved() > 0, starves, "{percent} %");
    }
}

#[test]
fn clamps_and_feed_limit_hold_at_the_end_of_the_knob() {
    for (field, value, id) in
        [("clamp-x", "16000", "x-feed"), ("clamp-y", "120000", "y-feed"), ("feed-limit", "125000", "vector-feed")]
    {
        let line = project("mitsubishi-e60", &[(field, value), ("pitches-per-block", "2")]);
        assert_eq!(readout(&line, id).verdict, Verdict::Fail, "{field}");
        let better = mended(&line, id);
        assert!(JUDGED.iter().all(|id| readout(&better, id).verdict == Verdict::Ok), "{field}");
        // S stays; the clamp keeps the knob within the limit.
        assert_eq!(better.values.get("spindle-speed"), line.values.get("spindle-speed"), "{field}");
        let mut planner = over_time(&better, vec![knob(6.0, 200.0)]);
        assert_eq!(ended(&mut planner), RunEnd::ProgramEnd, "{field}");
        let now = planner.timeline().at(10.0);
        assert!((now.axes[0].feed - now.spindle.command * 12.566370614).abs() < 0.5, "{field}");
    }
}

/// Percent of a knob that goes from 80 to 100 and back in steps of 1 % over four seconds, again and again.
fn swept(step: u32) -> f64 {
    let at = step % 40;
    80.0 + f64::from(if at <= 20 { at } else { 40 - at })
}

#[test]
fn turned_knob_costs_little_time_and_piles_up_little() {
    let base = [
        ("override", "80"),
        ("heads", "47"),
        ("spindle-speed", "800"),
        ("no-load-speed", "1480"),
        ("rated-load-speed", "1480"),
        ("pitch-count", "400"),
    ];
    let fast = |id: &str| if id == "mitsubishi-e60" { "1200" } else { "800" };
    let mut turned = 0;
    for control in controls() {
        let mut line = project(control.id, &base);
        line.values.extend(values(&[("spindle-speed", fast(control.id))]));
        if !has_knob(&line) {
            continue;
        }
        turned += 1;
        for _ in 0..2 {
            if readout(&line, "block-time").verdict != Verdict::Ok {
                line = mended(&line, "block-time");
            }
        }
        let steady = over_time(&line, vec![]);
        let first = first_cut(&line, &steady);
        let speed = readout(&line, "line-speed").value / 60.0;
        let length = readout(&line, "product-length").value;
        let tail = steady.ended_at().unwrap() - first - length / speed;
        let begin = (first + 1.0).ceil();
        let events: Vec<_> = (0..600).map(|step| knob(begin + f64::from(step) * 0.1, swept(step))).collect();
        // The time that the ribbon would take if X followed the knob at once.
        let (mut left, mut ideal) = (length - speed * (begin - first), begin - first);
        for step in 0.. {
            let now = speed / 80.0 * swept(step);
            if left <= now * 0.1 {
                ideal += left / now;
                break;
            }
            (left, ideal) = (left - now * 0.1, ideal + 0.1);
        }
        let planner = over_time(&line, events);
        let end = planner.timeline().end();
        let done = (0..)
            .map(|ms| first + f64::from(ms) * 0.001)
            .find(|t| *t > end || planner.timeline().at(*t).axes[0].position >= length - 1e-6);
        let took = done.unwrap() - first - tail.min(0.3);
        let charts = line.prepared().charts(&planner, 0.0, done.unwrap() - 0.5, 4001);
        let slack = &charts.iter().find(|chart| chart.id == "slack").unwrap().series[0].points;
        let before = slack[slack.partition_point(|point| point.0 < begin)].1;
        let periods = ((done.unwrap() - 0.5 - begin) / 4.0).floor();
        let after = slack[slack.partition_point(|point| point.0 < begin + 4.0 * periods)].1;
        let most =
            slack.iter().filter(|point| point.0 > begin).map(|point| (point.1 - before).abs()).fold(0.0, f64::max);
        assert!(periods >= 2.0, "{}: {periods}", control.id);
        assert!(took <= ideal * 1.01 + 0.2, "{}: {took} s, ideal {ideal}", control.id);
        assert!((after - before).abs() < 10.0, "{}: {before} to {after} mm", control.id);
        // Between two turns the loop breathes: X notices the knob when the blocks read ahead are done, the unwinder at once.
        let lag = readout(&line, "override-delay").value / 1000.0 + 0.15;
        assert!(most < 10.0 + 2.0 * 0.1 * speed / 0.8 * lag, "{}: {most} mm", control.id);
    }
    assert!(turned > 1, "{turned} knobs");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, max_global_rejects: 4096, ..ProptestConfig::default() })]

    /// For any machine and control: if the results that the knob changes are ok, X follows the unwinder at every position of the knob, and
    /// no block is late.
    #[test]
    fn line_that_holds_follows_the_knob_everywhere(
        control in 0usize..7,
        (speed, pitch, heads, count) in (50u32..1480, 10u32..300, 2u32..60, 1u32..8),
        (clamp, entered, limit) in (100u32..1480, 50u32..120, 10_000u32..1_000_000),
        turns in prop::collection::vec(40.0f64..210.0, 3),
    ) {
        let control = controls().nth(control).unwrap();
        let pitch = format!("{:.1}", f64::from(pitch) / 10.0);
        let number = |n: u32| n.to_string();
        let mut line = project(control.id, &[
            ("spindle-speed", &number(speed)), ("pitch", &pitch), ("heads", &number(heads)), ("pitches-per-block", &number(count)),
            ("speed-clamp", &number(clamp)), ("override", &number(entered)), ("feed-limit", &number(limit)),
            ("clamp-x", "25000"), ("pitch-count", "10000000"),
            // The contacts of a full loop would hold the line: until X follows, a turn of the knob piles up ribbon.
            ("loop-capacity", "100000"),
        ]);
        prop_assume!(has_knob(&line));
        // Repairs of each failing result hold, tried as often as there are results.
        for _ in 0..3 {
            for id in JUDGED {
                let row = readout(&line, id);
                if row.verdict == Verdict::Fail && row.advice.iter().any(|advice| !advice.entries.is_empty()) {
                    line = mended(&line, id);
                }
            }
        }
        prop_assume!(JUDGED.iter().all(|id| readout(&line, id).verdict != Verdict::Fail));
        // X notices the knob when the blocks that were read ahead are done.
        prop_assume!(readout(&line, "override-delay").value < 2000.0);
        let k = readout(&line, "k").value;
        let Some(Value::Number(most)) = line.values.get("speed-clamp").cloned() else { panic!("no clamp") };
        let events = (0u32..).zip(&turns).map(|(at, percent)| knob(8.0 + 8.0 * f64::from(at), *percent));
        let end = Event { t: 34.0, action: Action::Reset };
        let planner = over_time(&line, events.chain([end]).collect());
        prop_assert_eq!(planner.starved(), 0);
        for (at, percent) in (0u32..).zip(&turns) {
            let now = planner.timeline().at(15.5 + 8.0 * f64::from(at));
            prop_assert!(now.spindle.command <= most + 1e-6);
            let wanted = now.spindle.command * k;
            // Y words are rounded, and with them the direction of each block.
            prop_assert!((now.axes[0].feed - wanted).abs() <= wanted * 2e-3, "{percent} %: X {} of {wanted}", now.axes[0].feed);
        }
    }
}

/// The ready-made example without a dancer, with a motor that turns as commanded.
fn open() -> Project {
    let entries = [("dancer", "false"), ("no-load-speed", "1480"), ("rated-load-speed", "1480")];
    Project::named("ribbon-line", None, None).unwrap().with_entries(&entries).unwrap()
}

/// The results of a turn of the knob with a lowest position.
fn turned(entries: &[(&'static str, &str)]) -> [macroline::view::Readout; 2] {
    let line = open().with_entries(entries).unwrap();
    ["loop-turned", "missing-turned"].map(|id| readout(&line, id))
}

#[test]
fn turns_of_the_knob_begin_at_its_lowest_position() {
    // Six blocks of one pitch keep their feed while the unwinder goes from 50 to 123.3 % and back.
    let [up, down] = turned(&[]);
    let ratio = 1480.0 / 1200.0 / 0.5;
    let laid = 60.0 * (ratio - 1.0);
    let line = open();
    // To 0 the unwinder stops over its ramp of 2 s, while X carries out the queue and makes up its lag.
    let to_zero = |share: f64| {
        let (speed, ramp) = (value(&line, "line-speed") / 60.0 * share, 2.0 * 1200.0 * share / 1480.0);
        let (stop, lag) = (speed * ramp, speed * (0.05 + 1.0 / 33.0));
        lag + if stop > 60.0 { 60.0 * 60.0 / (2.0 * stop) } else { 60.0 - stop / 2.0 }
    };
    let missing = f64::max(60.0 * (1.0 - 1.0 / ratio), to_zero(0.5));
    assert!((down.value - missing).abs() < 1e-9, "{} {missing}", down.value);
    // Start and stop lay most at one of the positions.
    let ends = |percent: &str| {
        let there = line.with_entries(&[("override", percent)]).unwrap();
        value(&there, "slack-start").abs() + value(&there, "slack-stop").abs()
    };
    let most = ["50", "100", "200"].map(ends).into_iter().fold(0.0, f64::max);
    assert!((up.value - laid - most).abs() < 1e-6, "{} {laid} {most}", up.value);
    let [_, down_alone] = turned(&[("knob-lowest", "100")]);
    let missing = f64::max(60.0 * (1.0 - 2.0 / ratio), to_zero(1.0));
    assert!((down_alone.value - missing).abs() < 1e-9, "{} {missing}", down_alone.value);
}

#[test]
fn queue_of_a_turned_knob_ends_with_the_product() {
    // One block is the whole product, 20 pitches of 10 mm: five more such blocks do not exist.
    let product = [("pitch-count", "20"), ("pitches-per-block", "20")];
    let line = open().with_entries(&product).unwrap();
    assert_eq!(value(&line, "product-length"), 200.0);
    let [up, down] = turned(&product);
    let ends = |percent: &str| {
        let there = line.with_entries(&[("override", percent)]).unwrap();
        value(&there, "slack-start").abs() + value(&there, "slack-stop").abs()
    };
    let most = ["50", "100", "200"].map(ends).into_iter().fold(0.0, f64::max);
    let laid = 200.0 * (1480.0 / 600.0 - 1.0);
    assert!((up.value - laid - most).abs() < 1e-6, "{} {laid} {most}", up.value);
    // From 50 % to 0: the queue less what the unwinder lays over its ramp, and the lag of X.
    let (speed, ramp) = (value(&line, "line-speed") / 120.0, 2.0 * 600.0 / 1480.0);
    let missing = 200.0 - speed * ramp / 2.0 + speed * (0.05 + 1.0 / 33.0);
    assert!((down.value - missing).abs() < 1e-9, "{} {missing}", down.value);
    // Fewer pitches per block shorten the queue from the product's length on, not from six blocks of 20 pitches.
    let [up, _] = turned(&[&product[..], &[("loop-capacity", "300")]].concat());
    let offered = up.advice.iter().flat_map(|advice| &advice.entries).find(|set| set.field == "pitches-per-block");
    let offered = offered.expect("fewer pitches per block").text.clone();
    let [up, _] = turned(&[product[0], ("pitches-per-block", &offered), ("loop-capacity", "300")]);
    assert_eq!(up.verdict, Verdict::Ok, "{offered}");
}

/// Short blocks behind an unwinder with a long ramp: 10 to 12 mm of queue at 39 mm/s, and 4.5 s to 156 mm/s.
const OUTRUN: [(&str, &str); 14] = [
    ("inverter-ramp", "6"),
    ("pitch", "2"),
    ("heads", "180"),
    ("spindle-speed", "740"),
    ("print-roller-diameter", "114.592"),
    ("head-length", "1"),
    ("loop-capacity", "1500"),
    ("dwell", "2.7"),
    ("youngs-modulus", "2000"),
    ("ribbon-thickness", "0.05"),
    ("tensile-strength", "150"),
    ("block-time", "2"),
    ("macro-time", "0.3"),
    ("pitch-count", "1000"),
];

#[test]
fn turn_up_outruns_an_unwinder_on_its_ramp() {
    let line = Project::named("ribbon-line", None, None).unwrap().with_entries(&OUTRUN).unwrap();
    let slow = line.with_entries(&[("override", "50")]).unwrap();
    let (v1, start) = (value(&slow, "line-speed") / 60.0, value(&slow, "slack-start"));
    let (v2, ramp) = (v1 * 1480.0 / 370.0, 6.0 * (1480.0 - 370.0) / 1480.0);
    let missing = (v2 - v1) * (ramp / 2.0 - 10.0 / v1 - 0.05 - 1.0 / 33.0);
    let row = readout(&line, "missing-turned");
    assert!((row.value - missing).abs() < 1e-6, "{} {missing}", row.value);
    assert_eq!(row.verdict, Verdict::Fail);
    assert_eq!(row.advice[0].message.id, "ribbon.knob-outruns");
    // A run misses as much but for the block in which the knob turns.
    // A dancer would trim before and after the turn; without one the motor turns as commanded.
    let open = open().with_entries(&OUTRUN).unwrap().with_entries(&[("override", "50")]).unwrap();
    let mut planner = begun(&open, vec![knob(8.0, 200.0)]).without_contacts();
    assert_eq!(ended(&mut planner), RunEnd::ProgramEnd);
    let charts = line.prepared().charts(&planner, 0.0, planner.timeline().end(), 8001);
    let slack = &charts.iter().find(|chart| chart.id == "slack").unwrap().series[0].points;
    let least = slack.iter().filter(|point| point.0 > 6.0).map(|point| point.1).fold(f64::INFINITY, f64::min);
    assert!((least - start + missing).abs() < 12.0, "{least} {start} {missing}");
    // A longer dwell lays the ribbon before.
    let remedy = row.advice.iter().find(|advice| advice.message.id == "ribbon.dwell-for-turn").expect("a dwell");
    let after = line.with_entries(&remedy.entries).unwrap();
    assert_eq!(readout(&after, "missing-turned").verdict, Verdict::Ok);
    // A queue that lasts as long as the ramp misses nothing.
    let queued = line.with_entries(&[("pitches-per-block", "16")]).unwrap();
    assert!(readout(&queued, "missing-turned").value < missing);
}

#[test]
fn loop_too_small_for_a_turn_offers_a_higher_lowest_position() {
    let entries = [("pitches-per-block", "4"), ("knob-lowest", "10"), ("loop-capacity", "700")];
    let [up, _] = turned(&entries);
    assert_eq!(up.verdict, Verdict::Fail);
    let offered = up.advice.iter().find(|advice| advice.entries.iter().any(|set| set.field == "knob-lowest")).unwrap();
    let lowest: f64 = offered.entries[0].text.parse().unwrap();
    let [after, _] = turned(&[entries[0], ("knob-lowest", &offered.entries[0].text), entries[2]]);
    assert_eq!(after.verdict, Verdict::Ok, "{lowest}");
    let below = (lowest - 1.0).to_string();
    let [too_low, _] = turned(&[entries[0], ("knob-lowest", &below), entries[2]]);
    assert_eq!(too_low.verdict, Verdict::Fail, "{lowest}");
}

#[test]
fn ladder_raises_a_lower_knob_and_leaves_zero() {
    for control in ["mitsubishi-e60", "knd-k2000t", "fanuc-0i-mf", "gsk-980tdc"] {
        let line = Project::named("ribbon-line", Some(control), None).unwrap();
        let line = line.with_entries(&[("knob-lowest", "60"), ("pitch-count", "4000")]).unwrap();
        let at = |percent: f64| {
            let planner = over_time(&line, vec![knob(8.0, percent)]);
            planner.timeline().at(16.0).spindle.command.abs()
        };
        let speed = value(&line, "actual-speed");
        for (percent, share) in [(20.0, 0.6), (59.0, 0.6), (80.0, 0.8)] {
            assert!((at(percent) - speed * share).abs() < 1e-6, "{control} {percent}: {}", at(percent));
        }
        // The switch of the GSK has no 0.
        let stopped = if control == "gsk-980tdc" { speed * 0.6 } else { 0.0 };
        assert!((at(0.0) - stopped).abs() < 1e-6, "{control}: {}", at(0.0));
    }
}

#[test]
fn form_below_the_lowest_position_has_its_results() {
    let line = Project::named("ribbon-line", None, None).unwrap();
    let low = line.with_entries(&[("override", "20")]).unwrap();
    let there = line.with_entries(&[("override", "50")]).unwrap();
    for id in ["actual-speed", "line-speed", "loop-needed", "frequency"] {
        assert_eq!(value(&low, id), value(&there, id), "{id}");
    }
    let found = low.design().diagnostics;
    assert!(found.iter().any(|found| found.message.id == "ribbon.knob-raised"), "{found:?}");
    assert!(there.design().diagnostics.iter().all(|found| found.message.id != "ribbon.knob-raised"));
}
