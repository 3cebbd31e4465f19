//! The operating envelope from runs of the program, checked by the formulas.

use macroline::machines::form::Value;
use macroline::math;
use macroline::motion::{Budget, Retention};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::project::size::{EnvelopeRow, OperatingEvent, Sizing};
use macroline::text::catalog::sentence;
use macroline::view::Verdict;
use proptest::prelude::*;

use crate::queries::{sized, value};

/// Highest position of the knob of the line's control, %: the speed clamp of the form comes first.
const KNOB: f64 = 200.0;

fn row<'a>(sizing: &'a Sizing, event: OperatingEvent, id: &str) -> &'a EnvelopeRow {
    sizing
        .envelope
        .iter()
        .find(|row| row.event == event && row.quantity.id() == id)
        .unwrap_or_else(|| panic!("no {id} at {}", event.id()))
}

/// A line without slip, whose loop is empty in the run, and without a brake at the motor of the unwinder. Its motor turns as commanded: a
/// dancer would trim the speeds by which the formulas of single stops are checked.
fn line() -> Project {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    for (field, value) in [
        ("dancer", Value::Flag(false)),
        ("no-load-speed", Value::Number(1480.0)),
        ("rated-load-speed", Value::Number(1480.0)),
        ("pitch-count", Value::Number(400.0)),
        ("unwinder-motor-brake", Value::Number(0.0)),
    ] {
        project.values.insert(field.to_owned(), value);
    }
    project
}

/// The project with the knob at the position of a row: the formulas apply to the form's position, the envelope to the worst one.
fn at_knob(project: &Project, row: &EnvelopeRow) -> Project {
    let mut project = project.clone();
    if let Some(percent) = row.knob {
        assert!(project.values.insert("override".to_owned(), Value::Number(percent)).is_some());
    }
    project
}

/// The run of a project to its end.
fn run_of(project: &Project) -> run::Run {
    let limits = Budget { blocks: 100_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = run::of_project(project, &project.written(), &begin);
    while run.advance(f64::INFINITY, 100_000).ended.is_none() {}
    run
}

/// Ribbon in the loop in the middle of the work, mm.
fn loop_in_the_run(project: &Project) -> f64 {
    let run = run_of(project);
    let middle = 0.5 * run.ended_at().unwrap();
    project.prepared().gauges(&run, (middle, middle), 2)[0].value
}

/// The most ribbon in the loop from cycle start to the first dot, mm.
fn loop_at_start(project: &Project) -> f64 {
    let run = run_of(project);
    let (contact, _) = project.prepared().first_contact(&run, run.ended_at().unwrap()).unwrap();
    project.prepared().gauges(&run, (0.0, contact), 400)[0].value
}

/// The byte of some controls has up to 254 %; the ladder of the line passes on at most 200 %.
#[test]
fn envelope_names_positions_of_the_knob_that_the_line_takes() {
    for (control, highest) in [("fanuc-0i-mf", 200.0), ("knd-k2000t", 200.0), ("gsk-980tdc", 120.0)] {
        let line = Project::named("ribbon-line", Some(control), None).unwrap();
        let line = line.with_entries(&[("pitch-count", "20")]).unwrap();
        let sizing = sized(&line);
        let knobs =
            sizing.envelope.iter().filter_map(|row| row.knob).chain(sizing.axes.iter().filter_map(|axis| axis.knob));
        assert_eq!(knobs.fold(0.0, f64::max), highest, "{control}");
    }
}

#[test]
fn loop_at_every_stop_is_that_of_the_formulas() {
    let project = line();
    let sizing = sized(&project);
    for (event, id) in [
        (OperatingEvent::EmergencyStop, "slack-hold"),
        (OperatingEvent::Alarm, "slack-coasting"),
        (OperatingEvent::PowerFailure, "slack-coasting"),
    ] {
        let worst = row(&sizing, event, "loop");
        let there = at_knob(&project, worst);
        super::same(event.id(), worst.value - loop_in_the_run(&there), value(&there, id), 0.02);
    }
    // The restart after standstill adds the ribbon of a start until X has caught up.
    let worst = row(&sizing, OperatingEvent::Hold, "loop");
    let there = at_knob(&project, worst);
    let both = value(&there, "slack-hold") + loop_at_start(&there);
    super::same("hold", worst.value - loop_in_the_run(&there), both, 0.02);
}

/// A disc of 140 mm, faced to its centre at a constant surface speed: the spindle is fastest at the end of the cut.
fn faced_disc() -> Project {
    let project = Project::named("turning-spindle", None, Some("facing")).unwrap();
    let entries = [("stock-diameter", "140"), ("finished-diameter", "10"), ("spindle-ramp", "6")];
    project.with_entries(&entries).unwrap()
}

#[test]
fn lathe_is_stopped_from_its_highest_speed() {
    let project = faced_disc();
    let sizing = sized(&project);
    let run = run_of(&project);
    let end = run.timeline().end();
    let highest =
        (0..4000).map(|at| run.timeline().at(end * f64::from(at) / 4000.0).spindle.actual).fold(0.0, f64::max);
    let (early, stage) = (run.timeline().at(0.3 * end).spindle.actual, value(&project, "stage-speed"));
    assert!(highest > 1.5 * early, "{highest} of {early}");
    // By the ramp of 6 s from standstill to the speed at 10 V.
    let stop = row(&sizing, OperatingEvent::EmergencyStop, "time");
    super::same("stop", stop.value, 6.0 * highest / stage, 0.02);
    let coasts = row(&sizing, OperatingEvent::PowerFailure, "time");
    super::same("coasting", coasts.value, value(&project, "coasting-time"), 0.01);
}

#[test]
fn torque_is_limited_by_the_motor_at_its_speed() {
    // A small square in brass at a high speed of the tool, whose motor has its power up to 1500 r/min.
    let entries = [
        ("material", "brass"),
        ("across-flats", "8"),
        ("stock-diameter", "11"),
        ("speed", "2000"),
        ("feed", "1.2"),
        ("tool-limit", "6000"),
        ("work-limit", "3000"),
        ("fastest-cut", "1500"),
        ("depth", "1.5"),
        ("tool-power", "5.5"),
        ("tool-base", "1500"),
        ("work-power", "5.5"),
    ];
    let project = Project::named("polygon-lathe", None, None).unwrap();
    let project = project.with_entries(&entries).unwrap();
    let sizing = sized(&project);
    let of_run = row(&sizing, OperatingEvent::Run, "tool-torque");
    let of_rules = project.design().readouts.into_iter().find(|row| row.id == "tool-torque").unwrap();
    assert_eq!((of_run.verdict, of_rules.verdict), (Verdict::Fail, Verdict::Fail), "{of_run:?} {of_rules:?}");
    // 250 % of 5.5 kW at 4000 r/min.
    super::same("limit", of_run.limit.unwrap().value(), 2.5 * 5500.0 / (4000.0 * std::f64::consts::TAU / 60.0), 1e-3);
}

#[test]
fn verdicts_follow_the_limits_of_the_machine() {
    let mut project = line();
    let before = sized(&project);
    let emergency = row(&before, OperatingEvent::EmergencyStop, "loop");
    assert_eq!(emergency.verdict, Verdict::Ok);
    // A loop that is a little too small for it.
    project.values.insert("loop-capacity".to_owned(), Value::Number((emergency.value - 1.0).floor()));
    let after = sized(&project);
    assert_eq!(row(&after, OperatingEvent::EmergencyStop, "loop").verdict, Verdict::Fail);
    assert_eq!(row(&after, OperatingEvent::Start, "loop").verdict, Verdict::Ok);
}

#[test]
fn start_and_stops_are_rated_at_both_ends_of_the_knob() {
    use OperatingEvent::{Alarm, EmergencyStop, Hold, PowerFailure, Run, Start};
    let project = line();
    let sizing = sized(&project);
    for percent in [50.0, KNOB] {
        let mut there = project.clone();
        there.values.insert("override".to_owned(), Value::Number(percent));
        let there = sized(&there);
        for event in [Start, Run, Hold, Alarm, EmergencyStop, PowerFailure] {
            for id in ["loop", "x-torque"] {
                let (all, one) = (row(&sizing, event, id).value, row(&there, event, id).value);
                assert!(all > one - 1e-3 * one.abs(), "{id} at {}: {all} of all, {one} at {percent} %", event.id());
            }
            assert_eq!(row(&sizing, event, "x-torque").knob, Some(KNOB), "{}", event.id());
        }
    }
    let lines = sizing.findings().iter().map(|found| sentence(&found.message)).collect::<Vec<_>>();
    assert!(
        lines.iter().any(|line| line.starts_with("Power failure with the knob at 200 %: Loop comes to ")),
        "{lines:?}"
    );
}

#[test]
fn loop_behind_the_end_of_the_program_belongs_to_the_run() {
    let project = line();
    let sizing = sized(&project);
    // M5 is read when X has stopped: the unwinder lays on.
    let worst = row(&sizing, OperatingEvent::Run, "loop");
    let there = at_knob(&project, worst);
    let laid = worst.value - loop_in_the_run(&there);
    super::same("laid behind the program", laid, value(&there, "slack-stop"), 0.02);
}

#[test]
fn loop_that_would_hold_at_every_event_is_offered() {
    let project = line();
    let sizing = sized(&project);
    assert_eq!(row(&sizing, OperatingEvent::PowerFailure, "loop").verdict, Verdict::Fail);
    let sheet = sizing.sheets().into_iter().find(|sheet| sheet.id == "envelope").unwrap();
    let sets: Vec<_> = sheet.rows.into_iter().flat_map(|row| row.entries).collect();
    let findings_of =
        |sizing: &Sizing| -> Vec<String> { sizing.findings().iter().map(|found| sentence(&found.message)).collect() };
    let lines = findings_of(&sizing);
    assert_eq!(lines.len(), 2, "{lines:?}");
    for (line, event) in lines.iter().zip(["Inverter fault", "Power failure"]) {
        assert!(line.starts_with(&format!("{event} with the knob at 200 %: Loop comes to ")), "{line}");
    }
    let [set] = sets.as_slice() else { panic!("{sets:?}") };
    assert_eq!(set.field, "loop-capacity");
    let after = sized(&project.with_entries(&sets).unwrap());
    assert_eq!(findings_of(&after), [""; 0]);
    assert!(after.envelope.iter().all(|row| row.quantity.id() != "loop" || row.verdict == Verdict::Ok));
    let sheet = after.sheets().into_iter().find(|sheet| sheet.id == "envelope").expect("an envelope");
    assert!(!sheet.rows.is_empty() && sheet.rows.iter().all(|row| row.entries.is_empty()));
}

#[test]
fn loop_that_is_offered_holds_by_every_rule_too() {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    project.values.insert("loop-capacity".to_owned(), Value::Number(100.0));
    let sheet = sized(&project).sheets().into_iter().find(|sheet| sheet.id == "envelope").unwrap();
    let sets: Vec<_> = sheet.rows.into_iter().flat_map(|row| row.entries).collect();
    let after = project.with_entries(&sets).unwrap();
    let readouts = after.design().readouts;
    let judged: Vec<_> = readouts.iter().filter(|row| row.id.starts_with("loop-")).collect();
    assert!(judged.iter().any(|row| row.id == "loop-needed"));
    assert!(judged.iter().all(|row| row.verdict <= Verdict::Ok), "{sets:?}: {judged:?}");
    assert!(sized(&after).envelope.iter().all(|row| row.quantity.id() != "loop" || row.verdict == Verdict::Ok));
}

#[test]
fn knob_turned_up_overfills_the_loop_by_the_formula() {
    // Blocks of four pitches: one runs, five are read ahead, and these 240 mm keep the feed of 10 % while the unwinder goes to 123.3 %.
    let mut project = line();
    // A ribbon that may miss as much does not ask for smaller turns down.
    for (field, value) in [
        ("pitches-per-block", 4.0),
        ("loop-capacity", 100_000.0),
        ("pinch-force", 3000.0),
        ("tensile-strength", 100.0),
        ("knob-lowest", 10.0),
    ] {
        project.values.insert(field.to_owned(), Value::Number(value));
    }
    let highest = row(&sized(&project), OperatingEvent::Knob, "loop").value;
    let queued = 6.0 * 4.0 * 10.0;
    let top = 100.0 * 1480.0 / 1200.0;
    let wanted = queued * (top / 10.0 - 1.0) + value(&project, "slack-start");
    assert!((highest / wanted - 1.0).abs() < 0.1, "{highest} {wanted}");
    // The lowest position that is offered is the one from which the loop just holds.
    project.values.insert("loop-capacity".to_owned(), Value::Number(1000.0));
    let row = |project: &Project| project.design().readouts.into_iter().find(|row| row.id == "loop-turned").unwrap();
    let judged = row(&project);
    assert_eq!((judged.verdict, judged.advice.len()), (Verdict::Fail, 3));
    for advice in &judged.advice {
        let after = project.with_entries(&advice.entries).unwrap();
        assert_eq!(row(&after).verdict, Verdict::Ok, "{:?}", advice.entries);
        assert_eq!(
            self::row(&sized(&after), OperatingEvent::Knob, "loop").verdict,
            Verdict::Ok,
            "{:?}",
            advice.entries
        );
    }
}

/// Blocks of six pitches: one turn lays 528 mm, which a loop of 580 mm takes with the start, but not with the stop at the end of the product.
#[test]
fn loop_keeps_the_ribbon_of_a_turn_until_the_stop() {
    let line = Project::named("ribbon-line", None, None).unwrap();
    let entries = [("pitches-per-block", "6"), ("loop-capacity", "580")];
    // A dancer takes the ribbon of the turn away before the stop; without one the motor turns as commanded.
    let kept = sized(&line.with_entries(&entries).unwrap());
    let open = [("dancer", "false"), ("no-load-speed", "1480"), ("rated-load-speed", "1480")];
    let line = line.with_entries(&[&entries[..], &open].concat()).unwrap();
    let form = line.design().readouts.into_iter().find(|row| row.id == "loop-turned").unwrap();
    let turned = row(&sized(&line), OperatingEvent::Knob, "loop").clone();
    assert_eq!((form.verdict, turned.verdict), (Verdict::Fail, Verdict::Fail), "{} {}", form.value, turned.value);
    assert!(turned.value <= form.value, "{} {}", turned.value, form.value);
    let kept = row(&kept, OperatingEvent::Knob, "loop").value;
    assert!(kept < turned.value, "{kept} {}", turned.value);
}

/// A macro time of 10 ms and four pitches a block: 240 mm keep the feed of 10 % while the unwinder goes to 123.3 %.
#[test]
fn turn_that_the_envelope_holds_fails_in_the_form() {
    let line = Project::named("ribbon-line", None, None).unwrap();
    let line = line.with_entries(&[("macro-time", "10"), ("pitches-per-block", "4"), ("knob-lowest", "10")]).unwrap();
    let verdicts = |project: &Project| {
        let form = project.design().readouts.into_iter().find(|row| row.id == "loop-turned").unwrap();
        let sizing = sized(project);
        let holds = sizing.envelope.iter().any(|row| row.event == OperatingEvent::Knob && row.quantity.id() == "hold");
        (form, holds, row(&sizing, OperatingEvent::Knob, "loop").verdict)
    };
    let (form, holds, of_run) = verdicts(&line);
    assert_eq!((form.verdict, holds, of_run), (Verdict::Fail, true, Verdict::Fail));
    let after = line.with_entries(&form.advice[0].entries).unwrap();
    let (form, holds, of_run) = verdicts(&after);
    assert_eq!((form.verdict, holds, of_run), (Verdict::Ok, false, Verdict::Ok));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// A loop that every result of the form passes takes the ribbon of every event, within 5 % and a look of the PLC.
    #[test]
    fn loop_that_the_form_passes_holds_at_every_event(
        control in 0_usize..7,
        (speed, percent, capacity) in (100_u32..1400, 50_u32..150, 100_u32..4000),
        (ramp, dwell) in (0.05..4.0_f64, 0.0..2.0_f64),
        (tau, gain, macro_time) in (20_u32..300, 20_u32..80, 1_u32..13),
        (pitches, dancer, lowest) in (1_u32..6, any::<bool>(), 10_u32..=100),
    ) {
        let ids = macroline::machines::find("ribbon-line").unwrap().controls();
        let line = Project::named("ribbon-line", Some(ids[control]), None).unwrap();
        let entries = [
            ("spindle-speed", speed.to_string()),
            ("override", percent.to_string()),
            ("loop-capacity", capacity.to_string()),
            ("inverter-ramp", format!("{ramp:.3}")),
            ("dwell", format!("{dwell:.3}")),
            ("time-constant-x", tau.to_string()),
            ("time-constant-y", tau.to_string()),
            ("position-gain-x", gain.to_string()),
            ("position-gain-y", gain.to_string()),
            ("macro-time", macro_time.to_string()),
            ("pitches-per-block", pitches.to_string()),
            ("dancer", dancer.to_string()),
            ("knob-lowest", lowest.to_string()),
            ("pitch-count", "300".to_owned()),
        ];
        let line = line.with_entries(&entries.each_ref().map(|(field, text)| (*field, text.as_str()))).unwrap();
        let judged = line.design().readouts;
        prop_assume!(judged.iter().filter(|row| row.id.starts_with("loop-")).all(|row| row.verdict <= Verdict::Ok));
        let look = 0.1 * value(&line, "line-speed") / 60.0;
        for row in sized(&line).envelope.iter().filter(|row| row.quantity.id() == "loop") {
            let most = 1.05 * f64::from(capacity) + look;
            prop_assert!(row.value <= most, "{} at {:?} %: {} of {capacity} mm", row.event.id(), row.knob, row.value);
        }
    }
}

/// A stiff ribbon that the nip holds, its start with ribbon to spare, and a ramp in which the unwinder hardly gives any more.
#[test]
fn knob_turned_to_zero_pulls_the_queue_from_the_loop() {
    let entries = [
        ("youngs-modulus", "4000"),
        ("ribbon-width", "50"),
        ("ribbon-thickness", "0.05"),
        ("tensile-strength", "150"),
        ("pinch-force", "2000"),
        ("inverter-ramp", "0.7"),
        ("dwell", "1.2"),
        ("pitches-per-block", "3"),
        ("loop-capacity", "1000"),
        ("motor-stall-x", "10"),
    ];
    let line = line().with_entries(&entries).unwrap();
    let form = line.design().readouts.into_iter().find(|row| row.id == "missing-turned").unwrap();
    let least = row(&sized(&line), OperatingEvent::Knob, "loop-least").clone();
    assert_eq!((form.verdict, least.verdict), (Verdict::Fail, Verdict::Fail), "{form:?} {least:?}");
    // Six blocks of three pitches, less half of the ramp of the unwinder from 600 r/min, and the lag of X.
    let (speed, ramp) = (value(&line, "line-speed") / 60.0 / 2.0, 0.7 * 600.0 / 1480.0);
    super::same("missing", form.value, 180.0 - speed * (ramp / 2.0 - 0.05 - 1.0 / 33.0), 1e-6);
    // Each remedy holds in the runs too.
    for advice in form.advice.iter().filter(|advice| !advice.entries.is_empty()) {
        let after =
            row(&sized(&line.with_entries(&advice.entries).unwrap()), OperatingEvent::Knob, "loop-least").clone();
        assert_eq!(after.verdict, Verdict::Ok, "{:?} {after:?}", advice.entries);
    }
}

/// The axes wait under a knob at 0: the other positions of the knob have the rows.
#[test]
fn knob_at_zero_leaves_the_rows_to_the_runs_that_work() {
    let line = Project::named("ribbon-line", None, None).unwrap();
    let sizing = sized(&line.with_entries(&[("override", "0"), ("pitch-count", "100")]).unwrap());
    assert!(row(&sizing, OperatingEvent::Start, "time").value < 10.0);
    let of_knob = [OperatingEvent::Knob, OperatingEvent::SpeedChange];
    assert!(
        sizing
            .envelope
            .iter()
            .all(|row| !of_knob.contains(&row.event) || row.value > 0.0 || row.quantity.id() != "x-torque")
    );
    assert!(row(&sizing, OperatingEvent::EmergencyStop, "loop").knob.is_some());
}

#[test]
fn loop_misses_at_most_the_stretch_at_the_tension_limit() {
    let mut project = line();
    assert!(sized(&project).envelope.iter().all(|row| row.quantity.id() != "loop-least" || row.verdict == Verdict::Ok));
    // PET of 50 · 0.05 mm: (187.5 - 15) N · 2000 mm / (4000 N/mm² · 2.5 mm²) = 34.5 mm.
    for (field, value) in [
        ("youngs-modulus", 4000.0),
        ("ribbon-width", 50.0),
        ("ribbon-thickness", 0.05),
        ("tensile-strength", 150.0),
        ("pinch-force", 1000.0),
        ("dwell", 0.3),
        ("tension-before", 15.0),
    ] {
        project.values.insert(field.to_owned(), Value::Number(value));
    }
    let sizing = sized(&project);
    let least = row(&sizing, OperatingEvent::Run, "loop-least");
    assert_eq!(least.verdict, Verdict::Fail);
    assert!(least.limit.is_some_and(|limit| (limit.value() + 34.5).abs() < 1e-9), "{:?}", least.limit);
    // The tension is that of the stretch.
    let tension = row(&sizing, OperatingEvent::Run, "tension").value;
    super::same("tension", tension, 15.0 - least.value * 4000.0 * 2.5 / 2000.0, 1e-9);
    assert!(sizing.findings().iter().any(|found| sentence(&found.message).contains("Loop, lowest")));
}

#[test]
fn torque_at_start_is_the_peak_torque_of_the_results() {
    let project = line();
    let sizing = sized(&project);
    for axis in ["x", "y"] {
        let start_torque = row(&sizing, OperatingEvent::Start, &format!("{axis}-torque"));
        let there = at_knob(&project, start_torque);
        super::same(axis, start_torque.value, value(&there, &format!("{axis}-peak-torque")), 1e-3);
    }
}

#[test]
fn another_pitch_speeds_the_print_roller_and_leaves_the_loop() {
    let mut project = line();
    project.values.insert("dwell".to_owned(), Value::Number(0.7));
    let sizing = sized(&project);
    let at = |event, id| row(&sizing, event, id).value;
    let worst = row(&sizing, OperatingEvent::ProductChange, "loop");
    super::same("loop", worst.value, loop_in_the_run(&at_knob(&project, worst)), 0.02);
    // The line keeps its speed: X does not accelerate, as it does when the knob is turned, and its torque is that of the tautest ribbon at a
    // roller of 100 mm with 0.3 Nm of friction, through a gear of 50 : 1 with 95 %. Y gets a head to each shorter pitch.
    let taut = (at(OperatingEvent::ProductChange, "tension") * 0.05 + 0.3) / (50.0 * 0.95);
    super::same("x", at(OperatingEvent::ProductChange, "x-torque"), taut, 1e-3);
    assert!(taut < at(OperatingEvent::SpeedChange, "x-torque"));
    assert!(at(OperatingEvent::ProductChange, "y-torque") > at(OperatingEvent::SpeedChange, "y-torque"));
}

#[test]
fn pitch_that_the_program_refuses_is_an_alarm_of_the_event() {
    let mut project = line();
    assert!(sized(&project).envelope.iter().all(|row| row.quantity.id() != "alarm"));
    // A tenth less pitch at the same speed needs a higher F than this limit.
    let limit = (1.03 * value(&project, "vector-feed")).round();
    project.values.insert("feed-limit".to_owned(), Value::Number(limit));
    let sizing = sized(&project);
    assert_eq!(row(&sizing, OperatingEvent::ProductChange, "alarm").verdict, Verdict::Fail);
    // In an edited program the variable may have any meaning.
    project.edited = Some(macroline::nc::Files::one("O1.NC", "%\nO1\nM30\n%\n"));
    assert!(sized(&project).envelope.iter().all(|row| row.event != OperatingEvent::ProductChange));
}

#[test]
fn every_machine_has_its_events_and_one_worst_each() {
    use OperatingEvent::{
        Alarm, EmergencyStop, FeedKnob, Hold, Knob, PowerFailure, ProductChange, Run, SpeedChange, Start,
    };
    for (machine, events) in [
        ("ribbon-line", vec![Start, Run, Knob, SpeedChange, ProductChange, Hold, Alarm, EmergencyStop, PowerFailure]),
        ("turning-spindle", vec![Start, Run, Knob, FeedKnob, SpeedChange, Hold, Alarm, EmergencyStop, PowerFailure]),
        ("polygon-lathe", vec![Start, Run, FeedKnob, Hold, EmergencyStop, PowerFailure]),
    ] {
        let sizing = sized(&Project::named(machine, None, None).unwrap());
        let mut found: Vec<OperatingEvent> = sizing.envelope.iter().map(|row| row.event).collect();
        found.dedup();
        assert_eq!(found, events, "{machine}");
        let mut ids: Vec<String> = sizing.envelope.iter().map(|row| row.quantity.id()).collect();
        ids.sort_unstable();
        ids.dedup();
        for id in ids {
            let worst = sizing.envelope.iter().filter(|row| row.quantity.id() == id && row.is_worst).count();
            assert_eq!(worst, 1, "{machine}: worst {id}");
        }
        assert!(sizing.envelope.iter().all(|row| row.value.is_finite()), "{machine}");
    }
}

/// A lathe with one diameter and one speed, the knob at its upper end.
fn lathe() -> Project {
    let mut project = Project::named("turning-spindle", None, Some("shaft")).unwrap();
    project.values.insert("speed-mode".to_owned(), Value::Text("fixed".to_owned()));
    assert!(project.values.insert("override".to_owned(), Value::Number(120.0)).is_some());
    project
}

#[test]
fn lathe_coasts_at_fault_and_power_failure_as_calculated() {
    let project = lathe();
    let sizing = sized(&project);
    for event in [OperatingEvent::Alarm, OperatingEvent::PowerFailure] {
        let time = row(&sizing, event, "time");
        super::same(event.id(), time.value, value(&project, "coasting-time"), 0.01);
    }
}

/// Ids of the torques and currents at an event.
fn torques(sizing: &Sizing, event: OperatingEvent) -> Vec<String> {
    let rows = sizing.envelope.iter().filter(|row| row.event == event);
    rows.map(|row| row.quantity.id()).filter(|id| id.ends_with("-torque") || id.ends_with("-current")).collect()
}

#[test]
fn motor_without_current_has_no_torque() {
    use OperatingEvent::{Alarm, EmergencyStop, PowerFailure, Run};
    let lathe = Project::named("turning-spindle", None, Some("shaft")).unwrap();
    let sizing = sized(&lathe.with_entries(&[("bed-angle", "60")]).unwrap());
    for event in [Alarm, PowerFailure] {
        assert!(
            !torques(&sizing, event).contains(&"spindle-torque".to_owned()),
            "{}: {:?}",
            event.id(),
            torques(&sizing, event)
        );
    }
    // The spindle brakes over its ramp, with current.
    for event in [Run, EmergencyStop] {
        assert!(torques(&sizing, event).contains(&"spindle-torque".to_owned()), "{}", event.id());
    }
    // Z feeds and brakes; X is at rest, and its amplifier goes off with that of Z.
    for event in [EmergencyStop, PowerFailure] {
        let all = torques(&sizing, event);
        assert!(
            all.contains(&"z-torque".to_owned()) && !all.contains(&"x-torque".to_owned()),
            "{}: {all:?}",
            event.id()
        );
    }
    // At an inverter fault the amplifiers of the slides stay on, and X holds its weight.
    let weight = 100.0 * 9.806_65 * math::sin(60_f64.to_radians()) * 0.005 / std::f64::consts::TAU;
    assert!(row(&sizing, Alarm, "x-torque").value > 0.9 * weight);
}

#[test]
fn coasting_work_and_tool_have_no_torque_at_an_emergency_stop() {
    let project = |stop: &str| {
        let lathe = Project::named("polygon-lathe", None, None).unwrap();
        sized(&lathe.with_entries(&[("emergency", stop)]).unwrap())
    };
    let of = |sizing: &Sizing| {
        let all = torques(sizing, OperatingEvent::EmergencyStop);
        all.into_iter().filter(|id| id.starts_with("work-") || id.starts_with("tool-")).count()
    };
    assert!(of(&project("held")) >= 2);
    assert_eq!(of(&project("off")), 0);
}

#[test]
fn power_failure_at_the_polygon_lathe_has_the_whole_lost_phase() {
    let project = Project::named("polygon-lathe", None, None).unwrap();
    let sizing = sized(&project);
    // Work and tool coast from 200 of 1000 r/min in 4 s and from 400 of 2000 r/min in 2 s: beyond a turn, not wrapped.
    let row = |id: &str| row(&sizing, OperatingEvent::PowerFailure, id);
    assert!((row("phase").value - 480.0).abs() < 1e-9 && row("phase").is_worst, "{:?}", row("phase"));
    assert!((row("time").value - 0.8).abs() < 1e-9, "{:?}", row("time"));
    assert_eq!(row("phase").value, value(&project, "coast-phase").abs());
    // A machine that keeps its drives on at an emergency stop has none of it there.
    let stop =
        sizing.envelope.iter().find(|row| row.event == OperatingEvent::EmergencyStop && row.quantity.id() == "phase");
    assert!(stop.is_some_and(|row| row.value < 1.0), "{stop:?}");
}

#[test]
fn long_coasting_runs_to_its_end() {
    let mut project = lathe();
    project.values.insert("spindle-friction".to_owned(), Value::Number(0.05));
    let sizing = sized(&project);
    for event in [OperatingEvent::Alarm, OperatingEvent::PowerFailure] {
        let time = row(&sizing, event, "time");
        assert!(!time.is_truncated && time.value > 300.0, "{time:?}");
        super::same(event.id(), time.value, value(&project, "coasting-time"), 0.01);
    }
}

#[test]
fn unwinder_that_nothing_slows_coasts_beyond_the_run() {
    let mut project = line();
    for field in ["unwinder-friction", "reel-brake", "unwinder-motor-brake"] {
        assert!(project.values.insert(field.to_owned(), Value::Number(0.0)).is_some(), "{field}");
    }
    assert!(value(&project, "loop-coasting").is_infinite());
    let sizing = sized(&project);
    for event in [OperatingEvent::Alarm, OperatingEvent::PowerFailure] {
        let (time, slack) = (row(&sizing, event, "time"), row(&sizing, event, "loop"));
        assert!(time.is_truncated && time.value >= 3600.0, "{time:?}");
        assert!(slack.is_truncated && slack.verdict == Verdict::Fail, "{slack:?}");
    }
    assert!(!row(&sizing, OperatingEvent::EmergencyStop, "time").is_truncated);
    let sentences = sizing.findings().iter().map(|found| sentence(&found.message)).collect::<Vec<_>>();
    assert!(sentences.iter().any(|line| line.contains(": Loop comes to > ")), "{sentences:?}");
    // No loop would hold.
    assert!(
        sizing
            .holding_limits
            .iter()
            .all(|limit| limit.quantity.id() != "loop" || limit.is_truncated && limit.entry.is_none())
    );
}

#[test]
fn long_product_is_sized_whole_and_a_cut_run_has_a_reason() {
    let mut project = line();
    project.values.insert("pitch-count".to_owned(), Value::Number(7000.0));
    let sizing = sized(&project);
    assert_eq!(sizing.truncated, None);
    super::same("cycle", sizing.cycle.unwrap().seconds, value(&project, "product-time"), 0.02);

    let endless = "%\nO1\nG91\n#1=0\nWHILE[#1LT100000]DO1\nG01 X0.1 F1000.\nX-0.1\n#1=#1+1\nEND1\nM30\n%\n";
    project.edited = Some(macroline::nc::Files::one("O1.NC", endless));
    let sizing = sized(&project);
    assert!(sizing.cycle.is_none());
    let cut = sentence(&sizing.truncated.as_ref().unwrap().message());
    assert!(cut.starts_with("The run was ended at ") && cut.contains("after 200000 blocks"), "{cut}");
    assert_eq!(sentence(&sizing.findings()[0].message), cut);
    assert_eq!(sizing.json()["cut"]["reason"], cut);
    let sheets = sizing.sheets();
    let cycle = sheets.iter().find(|sheet| sheet.id == "cycle").unwrap();
    assert_eq!(cycle.rows[0].cells[1], cut);
}

#[test]
fn lines_of_the_run_at_the_highest_knob_are_marked() {
    let project = line();
    let sizing = sized(&project);
    let x = &sizing.axes[0];
    let chart = x.chart.as_ref().unwrap();
    assert!(x.peak_is_at_knob && x.knob == Some(KNOB));
    for at_highest_knob in [false, true] {
        let of_run = || chart.lines.iter().filter(|line| line.is_at_highest_knob == at_highest_knob);
        let most = of_run().map(|line| line.torque).fold(0.0, f64::max);
        let speed = of_run().map(|line| line.speeds.1).fold(0.0, f64::max);
        let mut there = project.clone();
        there.values.insert("override".to_owned(), Value::Number(if at_highest_knob { KNOB } else { 100.0 }));
        super::same("speed", speed, value(&there, "x-motor-speed"), 1e-3);
        assert_eq!(most < x.motor_load.unwrap().peak.torque, !at_highest_knob);
    }
    let demand = sizing.sheets().into_iter().find(|sheet| sheet.id == "asked").unwrap();
    assert!(demand.rows[0].cells[1].ends_with(" s, knob at 200 %)"), "{:?}", demand.rows[0].cells);
    // A click leads to a moment of the run that is shown; its torque is there.
    let lines: Vec<&str> = demand.drawing.split("<g").skip(1).collect();
    assert!(
        lines.iter().any(|line| line.contains("data-at=")) && lines.iter().any(|line| line.contains("knob at 200 %"))
    );
    assert!(lines.iter().all(|line| line.contains("data-at=") != line.contains("knob at 200 %")));
}

#[test]
fn web_that_pulls_the_roller_along_asks_most_in_the_stop() {
    let mut project = line();
    for (field, value) in
        [("gear-x", 10.0), ("tension-behind", 800.0), ("tension-before", 0.0), ("pinch-force", 20000.0)]
    {
        project.values.insert(field.to_owned(), Value::Number(value));
    }
    let design = project.design();
    let peak = design.readouts.iter().find(|row| row.id == "x-peak-torque").unwrap();
    assert_eq!(peak.verdict, Verdict::Fail);
    let sizing = sized(&project);
    super::same("peak", peak.value, sizing.axes[0].motor_load.unwrap().peak.torque, 1e-3);
}

#[test]
fn program_that_does_not_run_is_sized_as_far_as_it_comes() {
    let mut project = line();
    project.edited = Some(macroline::nc::Files::one("O1.NC", "%\nO1\nG01 X1000. F1000.\nGOTO 77\nM30\n%\n"));
    let sizing = sized(&project);
    assert!(!sizing.envelope.is_empty() && sizing.envelope.iter().all(|row| row.value.is_finite()));
    assert!(!sizing.axes.is_empty());
}

#[test]
fn hold_by_a_contact_is_a_row_of_its_event() {
    // The start of the published machine lays 332 mm before X pulls.
    let entries = [("no-load-speed", "1480"), ("rated-load-speed", "1480"), ("loop-capacity", "300")];
    let project = Project::named("ribbon-line", None, Some("paper")).unwrap();
    let project = project.with_entries(&entries).unwrap();
    let sizing = sized(&project);
    let hold = row(&sizing, OperatingEvent::Start, "hold");
    assert_eq!((hold.verdict, hold.knob), (Verdict::Fail, None));
    // The measured span ends with the hold and the stop of the unwinder: 251 mm/s over a ramp of 1.62 s, knob at its highest position 310 mm/s over 2 s.
    let filled = row(&sizing, OperatingEvent::Run, "loop").value;
    assert!((300.0 + 200.0..300.0 + 320.0).contains(&filled), "{filled}");
    let sentences = sizing.findings().iter().map(|found| sentence(&found.message)).collect::<Vec<_>>();
    assert!(sentences[0].starts_with("A contact of the machine holds the program from 2."), "{sentences:?}");
    assert_eq!((sizing.truncated.as_ref().unwrap().is_held, sizing.cycle), (true, None));
    assert!(
        sentences.iter().any(|line| line.starts_with("Start: a contact of the machine holds the program.")),
        "{sentences:?}"
    );
    // The offered loop capacity is that of runs without a hold by contacts.
    let sets: Vec<_> = sizing.holding_limits.iter().filter_map(|limit| limit.entry.clone()).collect();
    let after = sized(&project.with_entries(&sets).unwrap());
    assert!(
        after
            .envelope
            .iter()
            .all(|row| row.quantity.id() != "hold" && (row.quantity.id() != "loop" || row.verdict == Verdict::Ok))
    );
    assert_eq!(after.truncated, None);
}
