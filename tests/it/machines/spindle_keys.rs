//! S by hand in a begun program: its sign is a key of the spindle, and the run is that of the ladder.

use macroline::machines;
use macroline::motion::{Action, RunEnd};
use macroline::project::Project;

use super::every_machine::restart::{Outcome, within};

/// Each machine with a spindle on each of its controls, and a moment of its program at which spindle and axes move.
fn moving() -> impl Iterator<Item = (String, Project, f64)> {
    ["turning-spindle", "ribbon-line"].into_iter().flat_map(|id| {
        machines::find(id).unwrap().controls().iter().map(move |control| {
            let project = Project::of(id, Some(control)).unwrap();
            let whole = within(3600.0, &project, &[]).planner;
            let end = whole.timeline().end();
            let moves = |t: &f64| {
                let now = whole.timeline().at(*t);
                now.spindle.actual.abs() > 0.9 * now.spindle.command.abs()
                    && now.spindle.command != 0.0
                    && now.axes.iter().any(|axis| axis.feed.abs() > 1.0)
            };
            let at = (300..1000).map(|k| end * f64::from(k) / 1000.0).find(moves).expect("a cut");
            (format!("{id} on {control}"), project, at)
        })
    })
}

fn reports(outcome: &Outcome, id: &str) -> bool {
    outcome.planner.diagnostics().iter().any(|finding| finding.message.id == id)
}

#[test]
fn opposite_key_in_a_hold_leaves_the_direction() {
    for (name, project, at) in moving() {
        let turned = |events: &[(f64, Action)]| {
            let outcome = within(3600.0, &project, events);
            let least = outcome.planner.timeline().at(at + 4.0).spindle.actual;
            (least, outcome)
        };
        let (speed, held) = turned(&[(at, Action::Hold), (at + 1.0, Action::ManualSpeed(-300.0))]);
        let (left, _) = turned(&[(at, Action::Hold)]);
        assert!(reports(&held, "motion.spindle-key-refused"), "{name}");
        assert_eq!(speed, left, "{name}");
    }
}

#[test]
fn spindle_stopped_in_a_hold_refuses_cycle_start() {
    for (name, project, at) in moving() {
        let speed = within(3600.0, &project, &[]).planner.timeline().at(at).spindle.command;
        let stopped = [(at, Action::Hold), (at + 1.0, Action::ManualSpeed(0.0)), (at + 20.0, Action::Start)];
        let held = within(3600.0, &project, &stopped);
        assert!(reports(&held, "motion.start-refused"), "{name}");
        let [before, after] = [at + 19.0, at + 40.0].map(|t| held.planner.timeline().at(t));
        assert!(before.axes.iter().zip(&after.axes).all(|(a, b)| a.position == b.position), "{name}: it moved");
        let again = [(at + 21.0, Action::ManualSpeed(speed)), (at + 30.0, Action::Start)];
        let went_on = within(3600.0, &project, &[&stopped[..], &again].concat());
        assert_eq!(went_on.ended, Some(RunEnd::ProgramEnd), "{name}");
    }
}
