//! Every machine on every control comes to rest within its timeline: at program end, hold, reset, emergency stop and alarm.

use macroline::interp::Interp;
use macroline::machines::{Frame, Samples};
use macroline::motion::{Action, Budget, Event, Planner, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};

use crate::queries::{every_machine_on_every_control, machine_on_control};

fn planned(project: &Project, events: &[Event]) -> Planner<Interp> {
    let mut project = project.clone();
    for event in events {
        project.panel.add(event.clone());
    }
    let limits = Budget { blocks: 1_000_000, seconds: 3600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut planner = run::of_project(&project, &project.written(), &begin);
    planner.advance(f64::INFINITY, usize::MAX);
    planner
}

/// Axes, PLC axes and spindle have settled at the end of the timeline.
#[track_caller]
fn settled(planner: &Planner<Interp>, name: &str) {
    let timeline = planner.timeline();
    let (end, over) = (timeline.end(), planner.ended_at().expect("the run ends"));
    assert!(over <= end && end < over + 60.0, "{name}: {over} to {end}");
    let (now, later) = (timeline.at(end), timeline.at(end + 100.0));
    for axis in &now.axes {
        assert!(axis.feed.abs() < 1e-6, "{name}: {axis:?}");
        assert!((axis.position - axis.actual).abs() < 1.001e-5, "{name}: {axis:?}");
    }
    for (now, later) in now.pmc.iter().zip(&later.pmc) {
        assert!((now.feed - later.feed).abs() < 1e-6, "{name}: {now:?} {later:?}");
    }
    assert!((now.spindle.actual - later.spindle.actual).abs() < 0.5, "{name}: {:?} {:?}", now.spindle, later.spindle);
}

#[test]
fn every_machine_comes_to_rest_within_its_timeline() {
    let mut interrupted = 0;
    for project in every_machine_on_every_control() {
        let name = machine_on_control(&project);
        let whole = planned(&project, &[]);
        settled(&whole, &name);
        let end = whole.ended_at().unwrap();
        // Moments at which an axis moves, of a hundred.
        let moments = (1..100).map(|at| end * f64::from(at) / 100.0);
        let moving: Vec<f64> =
            moments.filter(|t| whole.timeline().at(*t).axes.iter().any(|axis| axis.feed.abs() > 1.0)).collect();
        let picks = [0, moving.len() / 3, 2 * moving.len() / 3, moving.len().saturating_sub(1)];
        for t in picks.into_iter().filter_map(|at| moving.get(at)) {
            for action in [Action::Hold, Action::Reset, Action::EmergencyStop] {
                let stopped = planned(&project, &[Event { t: *t, action: action.clone() }]);
                settled(&stopped, &format!("{name}: {action:?} at {t}"));
                assert!(stopped.ended_at().unwrap() >= *t);
                interrupted += 1;
            }
        }
    }
    assert!(interrupted > 60, "{interrupted} interruptions");
}

#[test]
fn emergency_stop_brings_every_drive_to_rest() {
    for project in every_machine_on_every_control() {
        let whole = planned(&project, &[]).ended_at().unwrap();
        let stopped = planned(&project, &[Event { t: 0.5 * whole, action: Action::EmergencyStop }]);
        let end = stopped.timeline().at(stopped.timeline().end());
        assert!(end.spindle.actual.abs() < 0.5, "{}: {:?}", project.machine.id(), end.spindle);
        assert!(end.pmc.iter().all(|axis| axis.feed.abs() < 1e-6), "{}: {:?}", project.machine.id(), end.pmc);
    }
}

#[test]
fn alarm_of_a_program_ends_at_standstill() {
    // A run that a message stops before its end has no alarm.
    let ends = |project: &Project| planned(project, &[]).advance(0.0, 0).ended == Some(RunEnd::ProgramEnd);
    let (ending, others): (Vec<_>, Vec<_>) = every_machine_on_every_control().partition(ends);
    assert!(
        ending.len() > 5,
        "programs that a message stops: {:?}",
        others.iter().map(machine_on_control).collect::<Vec<_>>()
    );
    for mut project in ending {
        let mut files = project.written().files;
        // The block that ends the program is replaced by a call of a missing program.
        for file in &mut files.0 {
            for end in ["M30", "M2", "M02"] {
                file.text = file.text.replace(&format!("{end}\n"), &format!("{}\n", missing(&project)));
            }
        }
        project.edited = Some(files);
        let name = machine_on_control(&project);
        let stopped = planned(&project, &[]);
        settled(&stopped, &name);
        let ended = stopped.clone().advance(0.0, 0).ended;
        assert!(matches!(ended, Some(RunEnd::Alarm(_))), "{name}: {ended:?}");
    }
}

fn missing(project: &Project) -> &'static str {
    if project.control.syntax.names().is_some() { "L7777" } else { "M98 P7777" }
}

#[test]
fn ribbon_line_ends_with_every_dot_printed() {
    let project = Project::of("ribbon-line", None).unwrap();
    let planner = planned(&project, &[]);
    let now = Samples::at(&planner, planner.timeline().end());
    let pose = project.prepared().pose(&planner, &now, Frame { step: 0.01, drawing_option: false });
    let texts: Vec<&str> = pose.texts.iter().map(|(_, text)| text.as_str()).collect();
    for text in ["500 dots", "5\u{202f}000.0 mm", "0 mm/min", "0.0 r/min"] {
        assert!(texts.contains(&text), "{text}: {texts:?}");
    }
}
