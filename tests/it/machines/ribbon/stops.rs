//! The ribbon line interrupted: hold, single block, alarm, reset, emergency stop, and the loop capacity that all of these need.

use macroline::controls::VarKind;
use macroline::interp::Interp;
use macroline::motion::{Action, Event, Planner, RunEnd};
use macroline::project::Project;
use macroline::text::catalog::sentence;
use macroline::text::{Grade, Severity};
use macroline::view::{FieldEntry, Limit, Verdict};
use proptest::prelude::*;

use super::each_control::{begun, ended, over_time, project};
use super::{controls, values};
use crate::queries::{readout, report_text, stop_table};

/// A line without slip whose F every control takes: 167.6 mm/s, a head every 8 mm.
const LINE: [(&str, &str); 4] =
    [("spindle-speed", "800"), ("heads", "47"), ("no-load-speed", "1480"), ("rated-load-speed", "1480")];

fn line(control: &str, more: &[(&str, &str)]) -> Project {
    project(control, &[&LINE, more].concat())
}

fn event(t: f64, action: Action) -> Event {
    Event { t, action }
}

/// Ribbon (mm) in the loop over time: time and slack.
fn slack(project: &Project, planner: &Planner<Interp>, points: usize) -> Vec<(f64, f64)> {
    let charts = project.prepared().charts(planner, 0.0, planner.timeline().end(), points);
    charts.iter().find(|chart| chart.id == "slack").unwrap().series[0].points.clone()
}

fn slack_at(points: &[(f64, f64)], t: f64) -> f64 {
    points[points.partition_point(|point| point.0 < t)].1
}

/// Ribbon (mm) that the unwinder lays while the PLC does not look: FIN takes some scans, and the wait for the speed is seen every 10 ms.
fn looks(project: &Project) -> f64 {
    readout(project, "line-speed").value / 60.0 * 0.06 + 0.5
}

#[test]
fn loop_is_judged_by_all_ribbon_that_a_product_lays() {
    // The clamp keeps the knob from turning the unwinder faster.
    let project = project("mitsubishi-e60", &[("speed-clamp", "1200")]);
    let value = |id: &str| readout(&project, id).value;
    let parts = ["slack-start", "slack-run", "slack-stop"].map(value);
    assert!((parts.iter().sum::<f64>() - 596.0).abs() < 0.5, "{parts:?}");
    // Each alone fits into 500 mm; the verdict is on their sum, with a hold and its restart.
    assert!(
        ["slack-start", "slack-run", "slack-stop", "slack-hold", "slack-resume"]
            .iter()
            .all(|id| readout(&project, id).verdict == Verdict::None)
    );
    let needed = readout(&project, "loop-needed");
    assert_eq!((needed.verdict, needed.limit), (Verdict::Fail, Some(Limit::AtMost(500.0))));
    let interruption = value("slack-interruption");
    // v · (wait + ramp / 4) is more than a hold that lasts: 251.3 mm/s, 2.05 s, 1.62 s.
    assert!((interruption - 251.327412 * (2.05 + 2.0 * 1200.0 / 1480.0 / 4.0)).abs() < 1e-3, "{interruption}");
    assert!(interruption > value("slack-hold") + value("slack-resume"));
    assert!((needed.value - (parts.iter().sum::<f64>() + interruption)).abs() < 1e-9);
    // The required capacity is the result itself.
    for (mm, verdict) in [(needed.value.ceil(), Verdict::Ok), (needed.value.floor(), Verdict::Fail)] {
        let mut other = project.clone();
        other.values.extend(values(&[("loop-capacity", &mm.to_string())]));
        assert_eq!(readout(&other, "loop-needed").verdict, verdict, "{mm}");
    }
    let buttons: Vec<_> = needed.advice.iter().map(|advice| advice.entries.clone()).collect();
    assert_eq!(buttons[0], [FieldEntry::new("loop-capacity", "1220")]);
}

#[test]
fn feed_that_waits_for_the_speed_counts_at_start_and_restart() {
    let in_step = [("feed-form", "per-revolution"), ("spindle-encoder", "true"), ("dwell", "0")];
    for (control, own) in [
        ("sinumerik-802d", &[("dwell", "0.6")][..]),
        ("mitsubishi-e60", &[("dwell", "0.6")][..]),
        ("sinumerik-802d", &in_step[..]),
        // A dwell beyond the ramp counts alone.
        ("sinumerik-802d", &[("dwell", "3")][..]),
    ] {
        let more = [("inverter-ramp", "4"), ("pitch-count", "400"), ("loop-capacity", "100000")];
        let mut line = line(control, &[own, &more].concat());
        let at_once = readout(&line, "slack-start").value;
        line.switches.0.retain(|(switch, _)| switch != "speed-reached");
        line.switches.0.push(("speed-reached".to_owned(), "wait".to_owned()));
        let value = |id: &str| readout(&line, id).value;
        let planner = over_time(&line, vec![event(8.0, Action::Hold), event(13.0, Action::Start)]);
        let points = slack(&line, &planner, 8001);
        let name = format!("{control} {own:?}");
        let (start, wanted) = (slack_at(&points, 7.9), value("slack-start"));
        assert!((start - wanted).abs() < looks(&line) + 1.0, "{name}: {start} {wanted}");
        assert_eq!(wanted > at_once + 50.0, own != &[("dwell", "3")][..], "{name}: {wanted} {at_once}");
        // X ends its block of 8 mm before it waits.
        let (again, wanted) = (slack_at(&points, 18.0), wanted + value("slack-hold") + value("slack-resume"));
        assert!((wanted - 8.0 - looks(&line)..wanted + looks(&line)).contains(&again), "{name}: {again} {wanted}");
        let most = points.iter().map(|point| point.1).fold(0.0, f64::max);
        assert!(most <= value("loop-needed") + looks(&line), "{name}: {most}");
    }
}

/// The first example with the knob free up to 123.3 %: K = 6.314 mm, a ramp of 2 s, a dwell of 0.7 s.
fn example(changes: &[(&str, &str)]) -> Project {
    let mut project = Project::named("ribbon-line", Some("mitsubishi-e60"), None).unwrap();
    project.values.extend(values(&[("dwell", "0.7")]));
    project.values.extend(values(changes));
    project
}

#[test]
fn loop_is_judged_at_the_end_of_the_knob() {
    let open = [("dancer", "false"), ("no-load-speed", "1480"), ("rated-load-speed", "1480")];
    let project = example(&[&open[..], &[("loop-capacity", "260")]].concat());
    let needed = readout(&project, "loop-needed");
    // v (t_w - t_r/2 + τ/2) + v/K, v (t_r/2 + τ/2) - v/K, v (t_w + t_r/4) at 1480 r/min.
    let v = std::f64::consts::PI * 100.5 / 50.0 * 1480.0 / 60.0;
    let (start, stop) = (v * (0.75 - 1.0 + 0.05 + 1.0 / 33.0), v * (1.0 + 0.05 - 1.0 / 33.0));
    let wanted = start.abs() + stop + v * (0.75 + 0.5);
    assert!((needed.value - wanted).abs() < 1e-9 && wanted.round() == 380.0, "{} {wanted}", needed.value);
    assert_eq!((needed.verdict, needed.limit), (Verdict::Fail, Some(Limit::AtMost(260.0))));
    let advice = sentence(&needed.advice[0].message);
    assert!(
        advice.starts_with("With the knob at 123.3 % one product may lay 380 mm into the loop of 260 mm"),
        "{advice}"
    );
    // A run at 123 % with a hold of a second ends with start, short stop and stop in the loop: more than 260 mm. A dancer takes the ribbon of
    // the hold away before the end; without one the motor turns as commanded, for the sum alone.
    let most = |changes: &[(&str, &str)]| {
        let mut fast = project.clone();
        fast.values.extend(values(&[&[("override", "123")], changes].concat()));
        let mut planner = over_time(&fast, vec![event(8.0, Action::Hold), event(9.0, Action::Start)]);
        assert_eq!(ended(&mut planner), RunEnd::ProgramEnd);
        slack(&fast, &planner, 6001).into_iter().map(|point| point.1).fold(0.0, f64::max)
    };
    let left = most(&[]);
    assert!((300.0..wanted).contains(&left), "{left}");
    let kept = most(&[("dancer", "true"), ("no-load-speed", "1500"), ("rated-load-speed", "1430")]);
    assert!((150.0..wanted).contains(&kept), "{kept}");
    // Held by the clamp, the knob adds nothing: 253 mm at 1200 r/min.
    let clamped = example(&[&open[..], &[("loop-capacity", "260"), ("speed-clamp", "1200")]].concat());
    assert_eq!(readout(&clamped, "loop-needed").verdict, Verdict::Ok);
}

#[test]
fn loop_is_judged_at_the_worst_position_of_the_knob() {
    // Slip weighs most at the slow end, where a product lasts longest; ramps at the fast one. The knob of the GSK ends at 50 and 120 %.
    let mut ends = [false; 2];
    for more in [&[][..], &[("rated-load-speed", "1400"), ("unwinder-load", "100"), ("pitch-count", "2000")]] {
        let sum = |percent: &str| {
            let project = line("gsk-980tdc", &[more, &[("override", percent)]].concat());
            let parts = ["slack-start", "slack-run", "slack-stop", "slack-interruption"];
            parts.iter().map(|id| readout(&project, id).value.abs()).sum::<f64>()
        };
        let [slow, now, fast] = ["50", "100", "120"].map(sum);
        let needed = readout(&line("gsk-980tdc", more), "loop-needed").value;
        assert!((needed - slow.max(now).max(fast)).abs() < 1e-9, "{needed}: {slow} {now} {fast}");
        ends[usize::from(slow > fast)] = true;
    }
    assert_eq!(ends, [true; 2]);
}

/// PET of 50 · 0.05 mm, which hardly stretches, with a dwell that is too short for the ramp.
const PET: [(&str, &str); 8] = [
    ("youngs-modulus", "4000"),
    ("ribbon-width", "50"),
    ("ribbon-thickness", "0.05"),
    ("tensile-strength", "150"),
    ("press-roller-diameter", "99.95"),
    ("dwell", "0.3"),
    ("loop-capacity", "1000"),
    ("pinch-force", "1000"),
];

#[test]
fn ribbon_missing_after_the_start_counts_in_the_tension() {
    for (clamp, percent) in [("1480", "123.3"), ("1200", "100")] {
        let project = example(&[&PET[..], &[("speed-clamp", clamp)]].concat());
        let (n, tension) = (clamp.parse::<f64>().unwrap(), readout(&project, "tension"));
        let v = std::f64::consts::PI * 99.95 / 50.0 * n / 60.0;
        // v (t_w - t_r/2 + τ/2 + 1/K), a ramp of 2 s for 1480 r/min.
        let missing = -v * (0.35 - n / 1480.0 + 0.05 + 1.0 / 33.0);
        let wanted = 4000.0 * 2.5 * missing / 2000.0 + 0.5;
        assert!((tension.value - wanted).abs() < 1e-9 * wanted, "{}: {wanted}", tension.value);
        assert_eq!((tension.verdict, tension.limit), (Verdict::Fail, Some(Limit::AtMost(187.5))));
        let advice = sentence(&tension.advice[0].message);
        assert!(advice.starts_with(&format!("With the knob at {percent} % X is {missing:.1} mm ahead")), "{advice}");
        // A run whose contacts do not act misses as much; the tension switch holds another one before.
        let mut fast = project.clone();
        let whole = if clamp == "1480" { "200" } else { "100" };
        fast.values.extend(values(&[("override", whole)]));
        let mut free = begun(&fast, vec![event(8.0, Action::Reset)]).without_contacts();
        ended(&mut free);
        let points = slack(&fast, &free, 4001);
        let least = points.iter().map(|point| point.1).fold(0.0, f64::min);
        assert!((least + missing).abs() < 1.0, "{least} {missing}");
        let mut held = over_time(&fast, vec![]);
        assert_eq!((ended(&mut held), held.is_held_by_plc()), (RunEnd::Stop, true));
        assert!(held.diagnostics().iter().any(|found| found.message_id() == "ribbon.held-web-tight"));
        // A longer dwell misses nothing.
        let mended = project.with_entries(&tension.advice[0].entries).unwrap();
        assert_eq!(tension.advice[0].entries[0].field, "dwell");
        assert_eq!((readout(&mended, "tension").verdict, readout(&mended, "tension").value), (Verdict::Ok, 0.0));
    }
    // 1200 r/min: 47.8 mm, 239 N.
    let tension = readout(&example(&[&PET[..], &[("speed-clamp", "1200")]].concat()), "tension").value;
    assert_eq!(tension.round(), 239.0);
}

#[test]
fn feed_override_fills_no_loop_where_it_is_fixed() {
    for control in controls() {
        let project = Project::named("ribbon-line", Some(control.id), None).unwrap();
        // Not valid, the override of these controls is 100 %, but at 0 % the axes stop all the same.
        let stops = control.id.starts_with("sinumerik");
        // v = K · 1200 r/min, the loop of 600 mm is full in 4.8 s.
        let v = readout(&project, "line-speed").value / 60.0;
        assert!((600.0 / v - 4.75).abs() < 0.01, "{}: {v}", control.id);
        let sentences: Vec<_> = project.design().diagnostics.iter().map(|found| sentence(&found.message)).collect();
        let warned = |sentences: &[String], text: &str| sentences.iter().any(|line| line.contains(text));
        assert_eq!(
            warned(&sentences, "keeps its 126 mm/s, and the loop of 600 mm is full after 4.8 s."),
            stops,
            "{sentences:?}"
        );
        for (percent, seconds) in [(0.0, "4.8 s"), (50.0, "9.5 s")] {
            let acts = stops && percent == 0.0;
            let planner =
                over_time(&project, vec![event(8.0, Action::FeedOverride(percent)), event(12.0, Action::Reset)]);
            let name = format!("{} at {percent} %", control.id);
            let points = slack(&project, &planner, 6001);
            let laid = slack_at(&points, 11.9) - slack_at(&points, 8.5);
            let wanted = if acts { v * 3.4 } else { 0.0 };
            // The dancer trims the unwinder meanwhile, by a tenth at most, and brings the loop to its set point.
            assert!(laid < wanted + 8.0 && laid > 0.9 * wanted - 3.0, "{name}: {laid} of {wanted}");
            let found = planner.diagnostics();
            let full = format!("full or empty after {seconds}");
            let full_loop = found.iter().find(|found| sentence(&found.message).contains(&full));
            assert_eq!(full_loop.map(|found| found.severity), acts.then_some(Severity::Warning), "{name}: {found:?}");
        }
    }
}

#[test]
fn advice_on_the_loop_makes_it_hold() {
    for control in controls() {
        for more in [
            &[][..],
            &[("inverter-ramp", "10")],
            &[("inverter-ramp", "20"), ("dwell", "0")],
            &[("wait", "fin"), ("loop-capacity", "300")],
        ] {
            let project = line(control.id, more);
            let needed = readout(&project, "loop-needed");
            assert_eq!(needed.verdict, Verdict::Fail, "{} {more:?}", control.id);
            assert!(needed.advice.iter().any(|advice| !advice.entries.is_empty()));
            for advice in needed.advice.iter().filter(|advice| !advice.entries.is_empty()) {
                let mut after = project.clone();
                let sets: Vec<_> = advice.entries.iter().map(|entry| (entry.field, entry.text.as_str())).collect();
                after.values.extend(values(&sets));
                assert_eq!(readout(&after, "loop-needed").verdict, Verdict::Ok, "{} {:?}", control.id, advice.entries);
            }
        }
    }
}

#[test]
fn hold_stops_the_unwinder_with_the_axes() {
    for control in controls() {
        for more in [[("wait", "dwell")], [("wait", "fin")]] {
            let project = line(control.id, &[&more[..], &[("loop-capacity", "2000")]].concat());
            let mut planner = over_time(&project, vec![event(8.0, Action::Hold), event(30.0, Action::Start)]);
            let name = format!("{} {more:?}", control.id);
            assert_eq!(ended(&mut planner), RunEnd::ProgramEnd, "{name}");
            let held = planner.timeline().at(29.0);
            assert_eq!((held.spindle.actual, held.axes[0].feed), (0.0, 0.0), "{name}");
            let points = slack(&project, &planner, 6001);
            let (before, during, after) = (slack_at(&points, 7.9), slack_at(&points, 29.0), slack_at(&points, 38.0));
            let value = |id: &str| readout(&project, id).value;
            assert!((during - before - value("slack-hold")).abs() < 0.5, "{name}: {before} {during}");
            // A PLC that waits for the speed looks every 10 ms.
            assert!((after - during - value("slack-resume")).abs() < 2.0, "{name}: {during} {after}");
        }
    }
}

#[test]
fn axes_that_follow_the_unwinder_restart_with_it() {
    for control in controls() {
        let more = [("feed-form", "per-revolution"), ("spindle-encoder", "true"), ("dwell", "0")];
        let project = line(control.id, &more);
        let mut planner = over_time(&project, vec![event(8.0, Action::Hold), event(30.0, Action::Start)]);
        assert_eq!(ended(&mut planner), RunEnd::ProgramEnd, "{}", control.id);
        let points = slack(&project, &planner, 6001);
        let laid = slack_at(&points, 38.0) - slack_at(&points, 29.0);
        assert!((laid - readout(&project, "slack-resume").value).abs() < 0.5, "{}: {laid}", control.id);
        assert!(laid < 15.0, "{}: {laid}", control.id);
    }
}

#[test]
fn every_stop_leaves_the_unwinder_at_rest() {
    for control in controls() {
        let project = line(control.id, &[]);
        let zero = Action::Variable(107, Some(0.0));
        for action in [zero, Action::SingleBlock(true), Action::Reset, Action::EmergencyStop] {
            let mut planner = over_time(&project, vec![event(8.0, action.clone())]);
            let name = format!("{} {action:?}", control.id);
            assert_ne!(ended(&mut planner), RunEnd::ProgramEnd, "{name}");
            let last = planner.timeline().at(planner.timeline().end());
            assert_eq!((last.spindle.actual, last.axes[0].feed), (0.0, 0.0), "{name}");
            let points = slack(&project, &planner, 6001);
            let laid = points[6000].1 - slack_at(&points, 7.9);
            assert!(laid <= readout(&project, "slack-stop").value + 1.0, "{name}: {laid}");
        }
    }
}

#[test]
fn hold_during_the_start_stays_within_the_loop() {
    for control in controls() {
        for wait in ["dwell", "fin"] {
            let mut project = line(control.id, &[("wait", wait), ("pitch-count", "20")]);
            // Its sensor does not hold a product in a loop of the required capacity.
            let needed = readout(&project, "loop-needed").value + looks(&project);
            project.values.extend(values(&[("loop-capacity", &needed.ceil().to_string())]));
            for held in [0.01, 0.06, 0.2, 0.8, 1.9] {
                let mut planner = over_time(&project, vec![event(held, Action::Hold), event(5.0, Action::Start)]);
                assert_eq!(ended(&mut planner), RunEnd::ProgramEnd, "{} {wait} {held}", control.id);
                let points = slack(&project, &planner, 3001);
                let most = points.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
                assert!(most <= needed, "{} {wait} {held}: {most} of {needed}", control.id);
            }
        }
    }
}

#[test]
fn fault_lets_the_unwinder_coast_by_its_inertia() {
    for control in controls() {
        for (brake, inertia) in [("0", "40"), ("0.5", "40"), ("0.5", "80")] {
            let project = line(control.id, &[("unwinder-motor-brake", brake), ("unwinder-inertia", inertia)]);
            let planner = over_time(&project, vec![event(8.0, Action::InverterFault(true))]);
            let name = format!("{} {brake} Nm {inertia} kg cm²", control.id);
            let value = |id: &str| readout(&project, id).value;
            let (torque, brake) = (value("unwinder-torque"), brake.parse::<f64>().unwrap());
            let speed = value("actual-speed") * std::f64::consts::TAU / 60.0;
            // The reel where it weighs most at the ribbon: full, 112 mm, or at its core, 34 mm; reduced through roller, gear and losses.
            let at_web = |id: &str, radius: f64| value(id) * 1e-4 / (radius * radius);
            let mass = at_web("reel-inertia-full", 0.112).max(at_web("reel-inertia-empty", 0.034));
            let reel = mass * 0.002 * 0.002 / 0.7;
            let inertia = inertia.parse::<f64>().unwrap() * 1e-4 + reel;
            // J ω / T, with the torque of web and friction; from 0.1 s on, when it has closed, also with that of the brake.
            let coasts = if brake > 0.0 {
                0.1 + (inertia * speed - torque * 0.1) / (torque + brake)
            } else {
                inertia * speed / torque
            };
            assert!((value("coasting-time") - coasts).abs() < 1e-9 * coasts, "{name}: {coasts}");
            // The run has one slope, in which the unwinder turns as far.
            let turns = |t: f64| planner.timeline().at(t).spindle.actual;
            assert!(turns(8.0 + 0.97 * coasts) > 0.0 && turns(8.0 + 1.01 * coasts + 0.1) == 0.0, "{name}: {coasts}");
            let points = slack(&project, &planner, 6001);
            let laid = points[6000].1 - slack_at(&points, 7.9);
            assert!((laid - value("slack-coasting")).abs() < 0.5 + 0.01 * laid, "{name}: {laid}");
        }
    }
}

#[test]
fn fault_behind_the_last_move_stays_within_the_loop() {
    for control in controls() {
        for more in [[("inverter-ramp", "0.01"), ("dwell", "2.5")], [("inverter-ramp", "2"), ("dwell", "0.7")]] {
            let project = line(control.id, &more);
            let whole = over_time(&project, vec![]);
            // X is nearly at rest, and M5 comes at once.
            let end = whole.timeline().end();
            let turns = |t: &f64| whole.timeline().at(*t).spindle.command > 0.0;
            let t = (0..4000).map(|step| end - f64::from(step) * 0.002).find(turns).expect("a moment before M5");
            let planner = over_time(&project, vec![event(t, Action::InverterFault(true))]);
            let points = slack(&project, &planner, 4001);
            let most = points.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
            let needed = readout(&project, "loop-coasting").value;
            assert!(most <= needed + looks(&project), "{} {more:?}: {most} of {needed}", control.id);
        }
    }
}

#[test]
fn unwinder_coasts_after_the_fault_until_a_run_command() {
    for control in controls() {
        let project = line(control.id, &[]);
        let events = [
            (8.0, Action::InverterFault(true)),
            (9.0, Action::InverterFault(false)),
            (9.1, Action::Reset),
            (9.5, Action::ManualSpeed(800.0)),
        ];
        let planner = over_time(&project, events.iter().map(|(t, action)| event(*t, action.clone())).collect());
        let turns = |t: f64| planner.timeline().at(t).spindle.actual;
        // From 800 r/min it loses no more in a second than by web and friction.
        let lost = readout(&project, "actual-speed").value / readout(&project, "coasting-time").value;
        assert!(
            (turns(8.1) - turns(9.4) - 1.3 * lost).abs() < 0.03 * lost,
            "{}: {} {}",
            control.id,
            turns(8.1),
            turns(9.4)
        );
        assert!(turns(10.5) > turns(9.4), "{}: {}", control.id, turns(10.5));
    }
}

#[test]
fn loop_that_a_coasting_unwinder_overfills_is_red_and_mended() {
    for control in controls() {
        let needed = readout(&line(control.id, &[]), "loop-coasting").value;
        let capacity = (needed - 50.0).floor();
        let project = line(control.id, &[("loop-capacity", &capacity.to_string())]);
        let judged = readout(&project, "loop-coasting");
        assert_eq!((judged.verdict, judged.limit), (Verdict::Fail, Some(Limit::AtMost(capacity))), "{}", control.id);
        let fields: Vec<_> = judged.advice.iter().map(|advice| advice.entries[0].field).collect();
        assert_eq!(fields, ["unwinder-motor-brake", "loop-capacity"], "{}", control.id);
        // The loop is not longer than needed; brakes are offered in steps of 0.5 Nm.
        for (advice, least) in judged.advice.iter().zip([0.0, needed - 0.1]) {
            let mended = readout(&project.with_entries(&advice.entries).unwrap(), "loop-coasting");
            assert_eq!(mended.verdict, Verdict::Ok, "{} {:?}", control.id, advice.entries);
            assert!(mended.value > least, "{} {:?}: {}", control.id, advice.entries, mended.value);
        }
    }
}

#[test]
fn brake_is_offered_in_sizes_that_are_sold() {
    for control in controls() {
        let brake = |capacity: f64| {
            let project = line(control.id, &[("loop-capacity", &capacity.to_string())]);
            let judged = readout(&project, "loop-coasting");
            let set = judged
                .advice
                .iter()
                .flat_map(|advice| &advice.entries)
                .find(|entry| entry.field == "unwinder-motor-brake");
            set.unwrap().text.parse::<f64>().unwrap()
        };
        let needed = readout(&line(control.id, &[]), "loop-coasting").value.floor();
        assert_eq!(brake(needed - 1.0), 0.5, "{}", control.id);
        let strong = brake(needed - 60.0);
        assert!(strong >= 0.5 && strong % 0.5 == 0.0, "{}: {strong}", control.id);
    }
}

#[test]
fn table_of_stops_names_spindle_axes_web_and_next_step() {
    for control in controls() {
        let rows = stop_table(&line(control.id, &[]));
        let names: Vec<_> = rows.iter().map(|cells| cells[0].as_str()).collect();
        let wanted = [
            "Feed hold",
            "Stop between two blocks: M00, single block",
            "Alarm",
            "Reset",
            "Emergency stop",
            "Inverter fault",
            "Power failure",
            "Loop at its longest limit",
            "Ribbon taut to its limit",
            "Reel at its end",
            "Inverter not ready",
            "Dry run, machine lock",
        ];
        assert_eq!(names, wanted, "{}", control.id);
        assert!(rows.iter().flatten().all(|cell| !cell.is_empty() && !cell.contains("ribbon.")), "{rows:?}");
        // The report has it, too.
        let report = report_text(&line(control.id, &[]));
        assert!(report.contains("## Hold, alarm, reset, emergency stop, inverter fault\n"), "{}", control.id);
    }
}

#[test]
fn dry_run_leaves_the_unwinder_turning_and_fills_the_loop() {
    for control in controls() {
        let project = line(control.id, &[("loop-capacity", "500")]);
        let sheets = project.prepared().sheets();
        let sheet = sheets.iter().find(|sheet| sheet.id == "stops").expect("a table of stops");
        let row = sheet.rows.last().expect("a row of the dry run");
        let cells: Vec<_> = row.cells.iter().map(String::as_str).collect();
        assert_eq!(cells[..2], ["Dry run, machine lock", "Keeps turning"], "{}", control.id);
        // 500 mm at 167.6 mm/s.
        assert!(cells[3].contains("500 mm is full after 3 s"), "{cells:?}");
        assert_eq!(row.grade, Grade::Open, "{}", control.id);
    }
}

#[test]
fn power_failure_names_the_assumption_of_its_loop() {
    let rows = stop_table(&line("mitsubishi-e60", &[]));
    let row = rows.iter().find(|cells| cells[0] == "Power failure").expect("a power failure");
    assert!(row[2].contains("stored energy") && row[2].contains("tight"), "{row:?}");
}

#[test]
fn table_counts_the_pauses_that_the_loop_holds() {
    for control in controls() {
        let counted = |capacity: f64| {
            let rows = stop_table(&line(control.id, &[("loop-capacity", &format!("{capacity:.1}"))]));
            let count = rows[0].iter().find_map(|cell| cell.split_once("The loop holds ")).expect("a count").1;
            count.split(' ').next().unwrap().parse::<u32>().unwrap()
        };
        // The capacity that the design requires holds one product at the highest knob position; each further product lays less.
        let needed = readout(&line(control.id, &[]), "loop-needed").value;
        assert_eq!([counted(needed - 1.0), counted(needed + 1.0)], [0, 1], "{}: {needed}", control.id);
        assert!(counted(3.0 * needed) >= 3, "{}", control.id);
    }
}

#[test]
fn operator_continues_as_in_the_table_of_stops() {
    let pitch = |project: &Project, planner: &Planner<Interp>| {
        planner.timeline().at(planner.timeline().end()).axes[0].position / readout(project, "product-length").value
    };
    for control in controls() {
        let project = line(control.id, &[("loop-capacity", "2000")]);
        let run = |actions: &[(f64, Action)]| {
            let events = actions.iter().map(|(t, action)| event(*t, action.clone())).collect();
            let mut planner = over_time(&project, events);
            (ended(&mut planner), planner)
        };
        // Hold and single block go on, and the product is whole.
        let single = [(8.0, Action::SingleBlock(true)), (12.0, Action::SingleBlock(false)), (12.1, Action::Start)];
        for actions in [&[(8.0, Action::Hold), (14.0, Action::Start)][..], &single] {
            let (end, planner) = run(actions);
            assert_eq!(end, RunEnd::ProgramEnd, "{} {actions:?}", control.id);
            assert!((pitch(&project, &planner) - 1.0).abs() < 1e-9, "{} {actions:?}", control.id);
        }
        // After reset and after emergency stop the product starts again; after emergency stop only once reset was pressed.
        let (end, _) = run(&[(8.0, Action::EmergencyStop), (14.0, Action::Start)]);
        assert!(matches!(end, RunEnd::Alarm(_)), "{} {end:?}", control.id);
        let anew = [(8.0, Action::EmergencyStop), (13.0, Action::Reset), (14.0, Action::Start)];
        // If the program cannot read positions, the operator has turned the roller to a head.
        let tells = control.vars.iter().any(|row| row.kind == VarKind::WorkPosition);
        let turned = (!tells).then_some((13.5, Action::Variable(138, Some(0.0))));
        for actions in [&anew[..], &[(8.0, Action::Reset), (14.0, Action::Start)]] {
            if !tells {
                assert_eq!(run(actions).0, RunEnd::Stop, "{} {actions:?}", control.id);
                // The program requires a turn of the roller by hand: cycle start would turn it back, a reset before it ends the product.
                let turned = [(16.0, Action::Variable(138, Some(0.0))), (17.0, Action::Start)];
                let (end, _) = run(&[actions, &turned[..]].concat());
                assert_eq!(end, RunEnd::Stop, "{} {actions:?}", control.id);
                let (end, planner) = run(&[actions, &[(15.0, Action::Reset)], &turned].concat());
                assert_eq!(end, RunEnd::ProgramEnd, "{} {actions:?}", control.id);
                assert!(pitch(&project, &planner) > 1.0, "{} {actions:?}", control.id);
            }
            let mut actions = actions.to_vec();
            actions.splice(actions.len() - 1..actions.len() - 1, turned.clone());
            let (end, planner) = run(&actions);
            assert_eq!(end, RunEnd::ProgramEnd, "{} {actions:?}", control.id);
            assert_eq!(planner.timeline().at(13.9).spindle.actual, 0.0, "{} {actions:?}", control.id);
            assert!(pitch(&project, &planner) > 1.0, "{} {actions:?}", control.id);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    /// For any machine and control: one product with one interruption at any moment stays within the loop capacity that the design
    /// requires.
    #[test]
    fn any_interruption_stays_within_the_required_loop(
        control in 0usize..7,
        (speed, ramp, dwell) in (50u32..900, 0.01f64..5.0, 0.0f64..3.0),
        (tau_x, tau_y, gain) in (20u32..400, 20u32..2000, 10u32..80),
        (in_step, fin) in (any::<bool>(), any::<bool>()),
        (kind, at, pause) in (0usize..5, 0.0f64..1.0, 0.0f64..8.0),
    ) {
        let dwell_is_short = dwell < 0.3 || fin;
        let (speed, gain) = (speed.to_string(), gain.to_string());
        let (tau_x, tau_y) = (tau_x.to_string(), tau_y.to_string());
        let (ramp, dwell) = (format!("{ramp:.3}"), format!("{dwell:.3}"));
        let control = controls().nth(control).unwrap();
        let project = line(control.id, &[
            ("spindle-speed", &speed), ("inverter-ramp", &ramp), ("dwell", &dwell), ("pitch-count", "100"),
            ("time-constant-x", &tau_x), ("time-constant-y", &tau_y), ("position-gain-x", &gain), ("position-gain-y", &gain),
            ("spindle-encoder", "true"), ("feed-form", if in_step { "per-revolution" } else { "per-minute" }),
            ("wait", if fin { "fin" } else { "dwell" }),
        ]);
        // Without current the unwinder coasts, independently of the ramp.
        let needed = readout(&project, if kind == 3 { "loop-coasting" } else { "loop-needed" }).value;
        let whole = over_time(&project, vec![]).ended_at().unwrap();
        let t = at * whole;
        let events = match kind {
            0 | 1 => vec![event(t, Action::Hold), event(t + pause, Action::Start)],
            2 => vec![event(t, Action::EmergencyStop)],
            3 => vec![event(t, Action::InverterFault(true))],
            _ => vec![event(t, Action::Reset)],
        };
        let planner = over_time(&project, events);
        let most = slack(&project, &planner, 2001).iter().map(|point| point.1.abs()).fold(0.0, f64::max);
        // Without a dwell the program reads its first block while the unwinder runs.
        let reads = if dwell_is_short { 0.3 } else { 0.0 } * readout(&project, "line-speed").value / 60.0;
        prop_assert!(most <= needed + looks(&project) + reads, "{most} mm in a loop of {needed}");
    }
}

#[test]
fn table_of_stops_has_the_steps_of_a_restart() {
    let mut by_hand = Vec::new();
    for control in controls().map(|control| control.id) {
        let project = line(control, &[]);
        let export = project.export();
        let report =
            &export.files.iter().map(|exported| &exported.file).find(|file| file.name == "report.md").unwrap().text;
        let row = |name: &str| {
            let found = report.lines().find(|line| line.starts_with(&format!("| {name} | ")));
            found.unwrap_or_else(|| panic!("{control}: no row {name}"))
        };
        // Broken off in the midst of a product, reset, started again.
        let half = 0.5 * over_time(&project, vec![]).ended_at().unwrap();
        let events = [(half, Action::Reset), (half + 9.0, Action::Start)].map(|(t, action)| event(t, action));
        let asks = ended(&mut over_time(&project, events.to_vec())) != RunEnd::ProgramEnd;
        for name in ["Alarm", "Reset", "Emergency stop", "Inverter fault"] {
            assert_eq!(row(name).contains("to a head by hand, set "), asks, "{control}: {}", row(name));
        }
        let (fault, laid) = (row("Inverter fault"), readout(&project, "slack-coasting").value);
        assert!(
            fault.contains("the motor coasts") && fault.contains(&format!("{laid:.0} mm more in the loop")),
            "{fault}"
        );
        by_hand.extend(asks.then_some(control));
    }
    assert_eq!(by_hand, ["sinumerik-802d", "sinumerik-808d"]);
}
