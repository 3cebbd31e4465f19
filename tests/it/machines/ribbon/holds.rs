//! The ribbon line held by its contacts in a run: loop at its limits, reel at its end, and how the operator goes on.

use macroline::interp::Interp;
use macroline::motion::{Action, Budget, Event, Mode, Planner, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::view::Verdict;

use super::controls;
use super::each_control::{begun, ended, over_time, project};
use crate::queries::{readout, sized_without_envelope, value};

/// An unwinder without slip, so that starts and stops alone fill and empty the loop.
const EVEN: [(&str, &str); 2] = [("no-load-speed", "1480"), ("rated-load-speed", "1480")];

/// Time (s) between two readings of a contact near its limit.
const READING: f64 = 0.01;

/// Interval (s) between two readings of a run.
const LOOK: f64 = 0.001;

/// Ribbon (mm) per turn of the unwinder's motor: a roller of 100 mm through a gear of 25 : 1.
const PER_TURN: f64 = std::f64::consts::PI * 100.0 / 25.0;

/// Ribbon speed (mm/s) at 1200 r/min.
const SPEED: f64 = PER_TURN * 20.0;

/// Time (s) of the ramp to 1200 r/min: 2 s for the 1480 r/min at 10 V.
const RAMP: f64 = 2.0 * 1200.0 / 1480.0;

fn line(more: &[(&str, &str)]) -> Project {
    project("mitsubishi-e60", &[&EVEN, more].concat())
}

/// A reel with three quarters of a product's ribbon, and a loop that takes up holds.
fn short_reel(more: &[(&str, &str)]) -> Project {
    line(&[&[("reel-diameter", "69.4"), ("ribbon-thickness", "0.05"), ("loop-capacity", "2000")], more].concat())
}

/// A web of PET from an unwinder whose motor slips by an eighth. It stretches by 34.5 mm at its tension limit: (187.5 - 15) N · 2000 mm /
/// (4000 N/mm² · 2.5 mm²).
fn slipping() -> Project {
    let changes = [
        ("no-load-speed", "1480"),
        ("rated-load-speed", "1300"),
        ("unwinder-load", "100"),
        ("youngs-modulus", "4000"),
        ("ribbon-width", "50"),
        ("ribbon-thickness", "0.05"),
        ("tensile-strength", "150"),
        ("pinch-force", "1000"),
        ("pitch-count", "5000"),
    ];
    project("mitsubishi-e60", &changes)
}

/// The run to its end, with actions of the operator.
fn run(project: &Project, actions: &[(f64, Action)]) -> (Planner<Interp>, RunEnd) {
    let events = actions.iter().map(|(t, action)| Event { t: *t, action: action.clone() }).collect();
    let mut planner = over_time(project, events);
    let end = ended(&mut planner);
    (planner, end)
}

/// Ids of the findings of a run.
fn finding_ids(planner: &Planner<Interp>) -> Vec<&str> {
    planner.diagnostics().iter().map(|finding| finding.message_id()).collect()
}

/// The first moment (s) from `t` on at which the condition holds.
fn first(planner: &Planner<Interp>, t: f64, is: impl Fn(&macroline::motion::Snapshot) -> bool) -> f64 {
    let steps = ((planner.timeline().end() - t) / LOOK) as u32;
    let found = (0..=steps).map(|step| t + f64::from(step) * LOOK).find(|t| is(&planner.timeline().at(*t)));
    found.unwrap_or_else(|| panic!("never from {t} s to {} s: {:?}", planner.timeline().end(), finding_ids(planner)))
}

/// Time (s) at which the program is held, from `t` on.
fn held_from(planner: &Planner<Interp>, t: f64) -> f64 {
    first(planner, t, |now| now.mode == Mode::Hold)
}

/// Ribbon (mm) unwound, and ribbon (mm) in the loop.
fn ribbon(planner: &Planner<Interp>, t: f64) -> (f64, f64) {
    let now = planner.timeline().at(t);
    let unwound = now.spindle.turns * PER_TURN;
    (unwound, unwound - now.axes[0].actual)
}

#[test]
fn full_loop_holds_the_run_when_the_ramp_has_filled_it() {
    // The dwell of 2 s before the first pull lays 332 mm.
    let project = line(&[("loop-capacity", "300")]);
    let (planner, end) = run(&project, &[]);
    assert_eq!((end, finding_ids(&planner)), (RunEnd::Stop, vec!["ribbon.held-loop-full"]));
    assert_eq!(planner.plc_hold().map(|message| message.id), Some("ribbon.held-loop-full"));
    // v · (t - t_r / 2) = 300 mm.
    let begins = first(&planner, 0.0, |now| now.spindle.command > 0.0);
    let wanted = begins + 300.0 / SPEED + RAMP / 2.0;
    let held = held_from(&planner, 0.0);
    assert!((wanted - LOOK..wanted + READING + LOOK).contains(&held), "{held} {wanted}");
    // The unwinder stops by its own rule at a hold, and lays v · t_r / 2 more.
    let rests = planner.timeline().end();
    assert_eq!(planner.timeline().at(rests).spindle.actual, 0.0);
    let more = ribbon(&planner, rests).1 - 300.0 - SPEED * RAMP / 2.0;
    assert!((-SPEED * LOOK..SPEED * (READING + LOOK)).contains(&more), "{more}");
    // A loop that takes up start and end runs through.
    let (planner, end) = run(&line(&[("loop-capacity", "400")]), &[]);
    assert_eq!((end, finding_ids(&planner).len()), (RunEnd::ProgramEnd, 0));
}

#[test]
fn start_is_refused_while_the_loop_is_full() {
    let project = line(&[("loop-capacity", "300")]);
    let (planner, end) = run(&project, &[(10.0, Action::Start)]);
    assert_eq!((end, finding_ids(&planner)), (RunEnd::Stop, vec!["ribbon.held-loop-full", "motion.start-refused"]));
    assert_eq!(ribbon(&planner, planner.timeline().end()).1, ribbon(&planner, 9.9).1);
    // After a reset the operator takes up the loop, and a new product begins with an empty one.
    let (planner, end) = run(&project, &[(10.0, Action::Reset), (11.0, Action::Start)]);
    assert_eq!((end, finding_ids(&planner)), (RunEnd::Stop, vec!["ribbon.held-loop-full"]));
    let begins = first(&planner, 11.0, |now| now.spindle.command > 0.0);
    let held = held_from(&planner, begins);
    let wanted = begins + 300.0 / SPEED + RAMP / 2.0;
    assert!((wanted - LOOK..wanted + READING + LOOK).contains(&held), "{held} {wanted}");
}

#[test]
fn contacts_that_do_not_act_let_the_loop_overflow() {
    let project = line(&[("loop-capacity", "300")]);
    let mut planner = begun(&project, vec![]).without_contacts();
    assert_eq!((ended(&mut planner), finding_ids(&planner).len()), (RunEnd::ProgramEnd, 0));
    let roomy = run(&line(&[("loop-capacity", "100000")]), &[]).0;
    let end = roomy.timeline().end();
    assert_eq!((planner.timeline().end(), ribbon(&planner, end)), (end, ribbon(&roomy, end)));
}

#[test]
fn tight_ribbon_holds_the_run_at_its_tension_limit() {
    let project = slipping();
    let (planner, end) = run(&project, &[]);
    assert_eq!(
        (end, finding_ids(&planner).contains(&"ribbon.held-web-tight")),
        (RunEnd::Stop, true),
        "{:?}",
        finding_ids(&planner)
    );
    let held = held_from(&planner, 0.0);
    let (_, slack) = ribbon(&planner, held);
    assert!((-35.5..=-34.4).contains(&slack), "{slack}");
    // X stops sooner than the unwinder: the loop hangs again, and cycle start goes on.
    let (planner, _) = run(&project, &[(held + 5.0, Action::Start)]);
    assert!(!finding_ids(&planner).contains(&"motion.start-refused"));
    let at = |t: f64| planner.timeline().at(t).axes[0].actual;
    assert!(at(held + 9.0) > at(held + 5.0) + 100.0);
    // An immediate cycle start is refused, and nothing moves.
    let (planner, end) = run(&project, &[(held + 0.01, Action::Start)]);
    assert_eq!((end, finding_ids(&planner).contains(&"motion.start-refused")), (RunEnd::Stop, true));
}

#[test]
fn tension_switch_opens_before_the_nip_slips() {
    let text = |force: &str| {
        let sizing = sized_without_envelope(&project("mitsubishi-e60", &[("pinch-force", force)]));
        let requirement = sizing
            .bill
            .iter()
            .map(|row| row.asked.clone())
            .find(|requirement| requirement.contains("limit of the tension"));
        requirement.expect("a tension switch")
    };
    // Half of 0.4 · 100 N behind a ribbon without tension: the strength of 75 N is out of reach. 1000 N reach it.
    assert!(text("100").ends_with("limit of the tension 20 N"), "{}", text("100"));
    assert!(text("1000").ends_with("limit of the tension 75 N"), "{}", text("1000"));
}

/// A film of PET before a nip with a force (N), on a line whose loop takes up holds.
fn film(control: &str, force: &str, more: &[(&str, &str)]) -> Project {
    let film = [
        ("youngs-modulus", "4000"),
        ("ribbon-width", "50"),
        ("ribbon-thickness", "0.05"),
        ("tensile-strength", "150"),
        ("pinch-force", force),
        ("loop-capacity", "2000"),
    ];
    project(control, &[&EVEN[..], &film, more].concat())
}

/// Ribbon (mm) in the loop at its least in a run.
fn least(planner: &Planner<Interp>) -> f64 {
    let end = planner.timeline().end();
    let at = |step: u32| ribbon(planner, end * f64::from(step) / 4000.0).1;
    (0..=4000).map(at).fold(f64::INFINITY, f64::min)
}

/// Missing ribbon (mm) at which a film before a nip of 600 N slips: (0.4 · 600 - 15) N · 2000 mm / (4000 N/mm² · 2.5 mm²). At half of what
/// the nip holds 21 mm are missing.
const SLIPS: f64 = 45.0;

#[test]
fn tension_switch_leaves_x_its_way_to_the_stop() {
    // X goes on for half of its ramp and for its lag behind the command, with the knob at its highest position.
    let way = PER_TURN * 1480.0 / 60.0 * (0.1 / 2.0 + 1.0 / 33.0);
    let project =
        film("mitsubishi-e60", "600", &[("time-constant-x", "100"), ("position-gain-x", "33"), ("dwell", "0")]);
    let room = value(&project, "stop-room");
    assert!((room - (SLIPS - way)).abs() < 1e-6, "{room}");
    let (planner, end) = run(&project, &[]);
    assert_eq!((end, finding_ids(&planner)), (RunEnd::Stop, vec!["ribbon.held-web-tight"]));
    let lowest = least(&planner);
    assert!((-SLIPS..-room).contains(&lowest), "{lowest} {room}");
    // Bill, design and envelope have one tension for it.
    let tension = 15.0 + room * 4000.0 * 2.5 / 2000.0;
    let sizing = sized_without_envelope(&project);
    let requirement = sizing
        .bill
        .iter()
        .map(|row| row.asked.clone())
        .find(|requirement| requirement.contains("limit of the tension"));
    assert!(
        requirement.is_some_and(|requirement| requirement.ends_with(&format!("limit of the tension {tension:.1} N"))),
        "{tension}"
    );
    let design = project.design();
    let limit = design.readouts.iter().find(|row| row.id == "tension").and_then(|row| row.limit);
    assert!(limit.is_some_and(|limit| (limit.value() - tension).abs() < 1e-6), "{limit:?}");
}

#[test]
fn nip_that_slips_before_x_stops_fails() {
    let judged = |project: &Project| project.design().readouts.into_iter().find(|row| row.id == "stop-room").unwrap();
    let project = film("mitsubishi-e60", "100", &[]);
    let row = judged(&project);
    assert_eq!((row.verdict, row.advice.len()), (Verdict::Fail, 1), "{row:?}");
    let pressed = project.with_entries(&row.advice[0].entries).unwrap();
    assert_eq!(judged(&pressed).verdict, Verdict::Ok);
    // A film that breaks before X has stopped breaks at any pinch force.
    let weak = film("mitsubishi-e60", "1000", &[("tensile-strength", "10")]);
    assert_eq!((judged(&weak).verdict, judged(&weak).advice[0].entries.len()), (Verdict::Fail, 0));
}

#[test]
fn line_under_override_0_waits_for_the_unwinder_again() {
    for (control, variant, wait) in [
        ("mitsubishi-e60", "ready-made", "dwell"),
        ("mitsubishi-e60", "ready-made", "fin"),
        ("mitsubishi-e60", "published", "dwell"),
        ("mitsubishi-e60", "precomputed", "fin"),
        ("fanuc-0i-tf", "ready-made", "dwell"),
    ] {
        let own = [("variant", variant), ("wait", wait)];
        let more = [&own[..], &[("dwell", "0.7"), ("spindle-speed", "600"), ("pitch-count", "400")]].concat();
        let project = film(control, "1000", &more);
        let turned = |t: f64, percent: f64| (t, Action::SpindleOverride(percent));
        let stops = [turned(8.0, 0.0), turned(14.0, 100.0), turned(20.0, 0.0), turned(26.0, 100.0)];
        let (planner, end) = run(&project, &stops);
        assert_eq!((end, finding_ids(&planner)), (RunEnd::ProgramEnd, vec![]), "{control} {variant} {wait}");
        assert!(least(&planner) > -0.5, "{control} {variant} {wait}: {}", least(&planner));
    }
}

#[test]
fn start_under_override_0_waits_for_the_unwinder_too() {
    for wait in ["dwell", "fin"] {
        let project = film("mitsubishi-e60", "1000", &[("wait", wait)]);
        let usual = run(&project, &[]).0;
        let (late, end) = run(&project, &[(0.0, Action::SpindleOverride(0.0)), (5.0, Action::SpindleOverride(100.0))]);
        assert_eq!((end, finding_ids(&late)), (RunEnd::ProgramEnd, vec![]), "{wait}");
        assert!((least(&late) - least(&usual)).abs() < 0.5, "{wait}: {} {}", least(&late), least(&usual));
    }
}

#[test]
fn reel_at_its_end_holds_with_ribbon_for_the_stop() {
    let project = short_reel(&[]);
    let wound = value(&project, "reel-length") * 1000.0;
    assert!((0.6..0.9).contains(&(wound / value(&project, "product-length"))), "{wound}");
    assert_eq!(value(&project, "reel-products"), 0.0);
    let (planner, end) = run(&project, &[]);
    assert_eq!((end, finding_ids(&planner)), (RunEnd::Stop, vec!["ribbon.held-reel-empty"]));
    // With the knob at its highest position the stop takes v · t_r / 2 off the reel: 1480 r/min, 2 s.
    let opens = wound - PER_TURN * 1480.0 / 60.0;
    let late = ribbon(&planner, held_from(&planner, 0.0)).0 - opens;
    assert!((0.0..SPEED * (READING + LOOK)).contains(&late), "{late}");
    // At 1200 r/min the stop takes less: the end of the ribbon stays in front of the unwinder.
    let left = wound - ribbon(&planner, planner.timeline().end()).0;
    let wanted = wound - opens - SPEED * RAMP / 2.0;
    assert!((wanted - SPEED * (READING + LOOK)..wanted + 0.1).contains(&left), "{left} {wanted}");
}

#[test]
fn advised_reel_lasts_for_a_product_with_its_loop() {
    // The dwell of 2 s lays 332 mm into the loop; a step of 0.1 mm of the reel's diameter is 218 mm of ribbon.
    let project = short_reel(&[]);
    let advice = readout(&project, "reel-products").advice.into_iter().find(|advice| !advice.entries.is_empty());
    let diameter = advice.expect("a reel that suffices").entries[0].text.clone();
    let enough = short_reel(&[("reel-diameter", &diameter)]);
    assert_eq!(value(&enough, "reel-products"), 1.0);
    let (planner, end) = run(&enough, &[]);
    assert_eq!((end, finding_ids(&planner)), (RunEnd::ProgramEnd, vec![]));
    // Two steps less lack a part of the loop.
    let less = format!("{:.1}", diameter.parse::<f64>().unwrap() - 0.2);
    let short = short_reel(&[("reel-diameter", &less)]);
    assert_eq!(value(&short, "reel-products"), 0.0);
    let (planner, end) = run(&short, &[]);
    assert_eq!((end, finding_ids(&planner)), (RunEnd::Stop, vec!["ribbon.held-reel-empty"]));
}

#[test]
fn start_puts_a_new_reel_on_and_the_product_goes_on() {
    let project = short_reel(&[]);
    let product = value(&project, "product-length");
    let (planner, _) = run(&project, &[]);
    let held = held_from(&planner, 0.0);
    let (planner, end) = run(&project, &[(held + 30.0, Action::Start)]);
    assert_eq!((end, finding_ids(&planner)), (RunEnd::ProgramEnd, vec!["ribbon.held-reel-empty"]));
    let end = planner.timeline().end();
    assert!((planner.timeline().at(end).axes[0].position - product).abs() < 1e-6);
    // The next product begins with a full reel, and is held after as much ribbon as the first.
    let (planner, _) = run(&project, &[(held + 30.0, Action::Start), (end + 5.0, Action::Start)]);
    let again = held_from(&planner, end + 5.0);
    let used = |from: f64, to: f64| ribbon(&planner, to).0 - ribbon(&planner, from).0;
    let difference = used(end, again) - used(0.0, held);
    assert!(difference.abs() < SPEED * (READING + 2.0 * LOOK), "{difference}");
}

#[test]
fn new_reel_does_not_help_while_the_loop_is_full() {
    // Start and hold lay 332 and 183 mm.
    let project = short_reel(&[("loop-capacity", "500")]);
    let held = held_from(&run(&project, &[]).0, 0.0);
    let (planner, end) = run(&project, &[(held + 30.0, Action::Start)]);
    let wanted = ["ribbon.held-reel-empty", "ribbon.held-loop-full", "motion.start-refused"];
    assert_eq!((end, finding_ids(&planner)), (RunEnd::Stop, wanted.to_vec()));
}

#[test]
fn examples_run_to_their_end_with_contacts_that_act() {
    let names = macroline::machines::find("ribbon-line").expect("the line").examples();
    let mut held = Vec::new();
    for control in controls() {
        for example in names {
            let project = Project::named("ribbon-line", Some(control.id), Some(example.id)).expect("an example");
            let (planner, end) = run(&project, &[]);
            if planner.is_held_by_plc() {
                held.push((control.id, example.id, end, finding_ids(&planner).join(" ")));
            } else {
                assert!(matches!(end, RunEnd::ProgramEnd | RunEnd::Alarm(_) | RunEnd::Stop), "{} {end:?}", control.id);
            }
        }
    }
    // Slip and late blocks of the published machine fill the loop that is assumed for it.
    let full = ("sinumerik-808d", "paper", RunEnd::Stop, "motion.starved ribbon.held-loop-full".to_owned());
    assert_eq!(held, [full]);
}

#[test]
fn action_in_the_past_holds_the_run_as_from_the_beginning() {
    let project = line(&[("loop-capacity", "400")]);
    let knob = Event { t: 8.3, action: Action::SpindleOverride(123.0) };
    let pause = Event { t: 9.1, action: Action::Hold };
    let again = Event { t: 12.0, action: Action::Start };
    let mut later = over_time(&project, vec![]);
    for event in [&knob, &pause, &again] {
        later.event(event.clone());
    }
    let mut whole = over_time(&project, vec![knob, pause, again]);
    assert_eq!((ended(&mut later), ended(&mut whole)), (RunEnd::Stop, RunEnd::Stop));
    assert!(whole.is_held_by_plc() && finding_ids(&whole).contains(&"ribbon.held-loop-full"));
    assert_eq!((finding_ids(&later), later.timeline().end()), (finding_ids(&whole), whole.timeline().end()));
    let held = held_from(&whole, 12.0);
    assert_eq!((held, ribbon(&later, held)), (held_from(&later, 12.0), ribbon(&whole, held)));
}

#[test]
fn extreme_values_run_to_the_end() {
    let cases: [&[(&str, &str)]; 12] = [
        &[("loop-capacity", "0")],
        &[("loop-capacity", "0.1")],
        // No ribbon on the reel, less than a dot of it, and more than the line will ever print.
        &[("reel-diameter", "10"), ("reel-core-diameter", "5000")],
        &[("reel-diameter", "68.1"), ("reel-core-diameter", "68"), ("inverter-ramp", "0.01")],
        &[("reel-diameter", "5000"), ("reel-core-diameter", "10"), ("ribbon-thickness", "0.001")],
        &[("no-load-speed", "1"), ("rated-load-speed", "1"), ("speed-at-10v", "1"), ("clamp-x", "1"), ("rapid-x", "1")],
        &[("spindle-speed", "1")],
        &[("inverter-ramp", "600")],
        &[("inverter-ramp", "0.01"), ("dwell", "0")],
        &[("reduction-ratio", "0.001"), ("clamp-x", "10000000"), ("rapid-x", "10000000")],
        &[("youngs-modulus", "1"), ("web-span", "1000000"), ("tension-before", "0")],
        &[("press-roller-diameter", "1"), ("reduction-ratio", "10000")],
    ];
    let starts = [(5.0, Action::Start), (9.0, Action::Reset), (10.0, Action::Start), (20.0, Action::Start)];
    for control in ["mitsubishi-e60", "sinumerik-808d"] {
        for changes in cases {
            let mut project = project(control, changes);
            for (t, action) in starts.clone() {
                project.panel.add(Event { t, action });
            }
            let limits = Budget { blocks: 10_000_000, seconds: 30.0 };
            let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Log };
            let mut planner = run::of_project(&project, &project.written(), &begin);
            // Each second has at most 100 readings, and a few thousand blocks.
            let progress = planner.advance(f64::INFINITY, 1_000_000);
            assert!(progress.ended.is_some(), "{control} {changes:?}: {} s", progress.planned_to);
        }
    }
}
