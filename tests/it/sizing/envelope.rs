//! The operating envelope from runs of the program, checked by the formulas.

use macroline::machines::form::Value;
use macroline::motion::{Budget, Retention};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::project::size::{EnvelopeRow, OperatingEvent, Sizing, size};
use macroline::text::catalog::sentence;
use macroline::view::Verdict;

fn sized(project: &Project) -> Sizing {
    size(project, &project.written())
}

fn result(project: &Project, id: &str) -> f64 {
    project.design().readouts.iter().find(|row| row.id == id).unwrap().value
}

fn row<'a>(sizing: &'a Sizing, event: OperatingEvent, id: &str) -> &'a EnvelopeRow {
    sizing
        .envelope
        .iter()
        .find(|row| row.event == event && row.id == id)
        .unwrap_or_else(|| panic!("no {id} at {}", event.id()))
}

/// A line without slip, whose loop is empty in the run, and without a brake at the motor of the unwinder.
fn line() -> Project {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    for (field, value) in [
        ("dancer", Value::Flag(true)),
        ("pitch-count", Value::Number(400.0)),
        ("unwinder-motor-brake", Value::Number(0.0)),
    ] {
        project.values.insert(field.to_owned(), value);
    }
    project
}

/// Ribbon in the loop in the middle of the work, mm.
fn loop_in_the_run(project: &Project) -> f64 {
    let limits = Budget { blocks: 100_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = run::of_project(project, &project.written(), &begin);
    while run.advance(f64::INFINITY, 100_000).ended.is_none() {}
    let middle = 0.5 * run.ended_at().unwrap();
    project.prepared().gauges(&run, (middle, middle), 2)[0].value
}

#[test]
fn loop_at_every_stop_is_that_of_the_formulas() {
    let project = line();
    let sizing = sized(&project);
    let start = loop_in_the_run(&project);
    for (event, id) in [
        (OperatingEvent::EmergencyStop, "slack-hold"),
        (OperatingEvent::Alarm, "slack-coasting"),
        (OperatingEvent::PowerFailure, "slack-coasting"),
    ] {
        let laid = row(&sizing, event, "loop").value - start;
        super::same(event.id(), laid, result(&project, id), 0.02);
    }
    // The restart after standstill lays on top what a start lays until X has caught up.
    let laid = row(&sizing, OperatingEvent::Hold, "loop").value - start;
    let both = result(&project, "slack-hold") + row(&sizing, OperatingEvent::Start, "loop").value;
    super::same("hold", laid, both, 0.02);
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
    assert_eq!(row(&after, OperatingEvent::Run, "loop").verdict, Verdict::Ok);
}

#[test]
fn loop_that_would_hold_at_every_event_is_offered() {
    let project = line();
    let sizing = sized(&project);
    assert_eq!(row(&sizing, OperatingEvent::PowerFailure, "loop").verdict, Verdict::Fail);
    let sheet = sizing.sheets().into_iter().find(|sheet| sheet.id == "envelope").unwrap();
    let sets: Vec<_> = sheet.rows.into_iter().flat_map(|row| row.sets).collect();
    let told =
        |sizing: &Sizing| -> Vec<String> { sizing.findings().iter().map(|found| sentence(&found.message)).collect() };
    let lines = told(&sizing);
    assert_eq!(lines.len(), 2, "{lines:?}");
    for (line, event) in lines.iter().zip(["Inverter fault", "Power failure"]) {
        assert!(line.starts_with(&format!("{event}: Loop comes to ")), "{line}");
    }
    let [(field, _)] = sets.as_slice() else { panic!("{sets:?}") };
    assert_eq!(*field, "loop-capacity");
    let after = sized(&project.with_entries(&sets).unwrap());
    assert_eq!(told(&after), [""; 0]);
    assert!(after.envelope.iter().all(|row| row.id != "loop" || row.verdict == Verdict::Ok));
    assert!(
        after
            .sheets()
            .iter()
            .filter(|sheet| sheet.id == "envelope")
            .all(|sheet| sheet.rows.iter().all(|row| row.sets.is_empty()))
    );
}

#[test]
fn torque_at_start_is_the_peak_torque_of_the_results() {
    let project = line();
    let sizing = sized(&project);
    for axis in ["x", "y"] {
        let asked = row(&sizing, OperatingEvent::Start, &format!("{axis}-torque"));
        super::same(axis, asked.value, result(&project, &format!("{axis}-peak-torque")), 1e-3);
    }
}

#[test]
fn another_pitch_speeds_the_print_roller_and_leaves_the_loop() {
    let project = line();
    let sizing = sized(&project);
    let at = |event, id| row(&sizing, event, id).value;
    super::same("loop", at(OperatingEvent::ProductChange, "loop"), loop_in_the_run(&project), 0.02);
    // The line keeps its speed: X does not accelerate, as it does when the knob is turned. Y gets a head to each shorter pitch.
    assert!(at(OperatingEvent::ProductChange, "x-torque") < 0.7 * at(OperatingEvent::SpeedChange, "x-torque"));
    assert!(at(OperatingEvent::ProductChange, "y-torque") > at(OperatingEvent::SpeedChange, "y-torque"));
}

#[test]
fn pitch_that_the_program_refuses_is_an_alarm_of_the_event() {
    let mut project = line();
    assert!(sized(&project).envelope.iter().all(|row| row.id != "alarm"));
    // A tenth less pitch at the same speed asks for more than this F.
    let limit = (1.03 * result(&project, "vector-feed")).round();
    project.values.insert("feed-limit".to_owned(), Value::Number(limit));
    let sizing = sized(&project);
    assert_eq!(row(&sizing, OperatingEvent::ProductChange, "alarm").verdict, Verdict::Fail);
    // A program of somebody else may mean anything by that variable.
    project.edited = Some(macroline::nc::Files::one("O1.NC", "%\nO1\nM30\n%\n"));
    assert!(sized(&project).envelope.iter().all(|row| row.event != OperatingEvent::ProductChange));
}

#[test]
fn every_machine_has_its_events_and_one_worst_each() {
    use OperatingEvent::{Alarm, EmergencyStop, Hold, Knob, PowerFailure, ProductChange, Run, SpeedChange, Start};
    for (machine, events) in [
        ("ribbon-line", vec![Start, Run, Knob, SpeedChange, ProductChange, Hold, Alarm, EmergencyStop, PowerFailure]),
        ("turning-spindle", vec![Start, Run, Knob, SpeedChange, Hold, Alarm, EmergencyStop, PowerFailure]),
        ("polygon-lathe", vec![Start, Run, Hold, EmergencyStop]),
    ] {
        let sizing = sized(&Project::named(machine, None, None).unwrap());
        let mut found: Vec<OperatingEvent> = sizing.envelope.iter().map(|row| row.event).collect();
        found.dedup();
        assert_eq!(found, events, "{machine}");
        let mut ids: Vec<&str> = sizing.envelope.iter().map(|row| row.id.as_str()).collect();
        ids.sort_unstable();
        ids.dedup();
        for id in ids {
            let worst = sizing.envelope.iter().filter(|row| row.id == id && row.is_worst).count();
            assert_eq!(worst, 1, "{machine}: worst {id}");
        }
        assert!(sizing.envelope.iter().all(|row| row.value.is_finite()), "{machine}");
    }
}

#[test]
fn lathe_coasts_at_fault_and_power_failure_as_long_as_it_says() {
    // One diameter, one speed: from the middle of the cut to rest.
    let mut project = Project::named("turning-spindle", None, Some("shaft")).unwrap();
    project.values.insert("speed-mode".to_owned(), Value::Text("fixed".to_owned()));
    let sizing = sized(&project);
    let coasting = result(&project, "coasting-time");
    for event in [OperatingEvent::Alarm, OperatingEvent::PowerFailure] {
        super::same(event.id(), row(&sizing, event, "time").value, coasting, 0.01);
    }
}

#[test]
fn program_that_does_not_run_is_sized_as_far_as_it_comes() {
    let mut project = line();
    project.edited = Some(macroline::nc::Files::one("O1.NC", "%\nO1\nG01 X1000. F1000.\nGOTO 77\nM30\n%\n"));
    let sizing = sized(&project);
    assert!(sizing.envelope.iter().all(|row| row.value.is_finite()));
    assert!(!sizing.axes.is_empty());
}
