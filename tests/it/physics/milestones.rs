//! Milestones of a run, and the first contact with the work.

use macroline::controls::Code;
use macroline::machines;
use macroline::motion::{Budget, Milestone, Mode, Retention};
use macroline::project::Project;
use macroline::project::run::{self, Run, RunOptions};

fn whole(project: &Project) -> Run {
    let limits = Budget { blocks: 1_000_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = run::of_project(project, &project.written(), &begin);
    while run.advance(f64::INFINITY, 4096).ended.is_none() {}
    run
}

fn all() -> impl Iterator<Item = Project> {
    machines::ALL.iter().filter_map(|machine| Project::of(machine.id(), None))
}

#[test]
fn milestones_agree_with_the_snapshots_around_them() {
    for project in all() {
        let run = whole(&project);
        let timeline = run.timeline();
        let found = timeline.milestones();
        assert!(found.windows(2).all(|pair| pair[0].0 <= pair[1].0), "{}", project.machine.id());
        for (t, milestone) in &found {
            let (before, after) = (timeline.at(t - 1e-6), timeline.at(t + 1e-6));
            match milestone {
                Milestone::Mode(mode) => assert!(after.mode == *mode && before.mode != *mode, "{t} {milestone:?}"),
                Milestone::Spindle(code) => {
                    let sign = |speed: f64| if speed == 0.0 { 0 } else { speed.signum() as i32 };
                    let expected = [(Code::SpindleCw, 1), (Code::SpindleCcw, -1), (Code::SpindleStop, 0)];
                    assert!(expected.contains(&(*code, sign(after.spindle.command))), "{t} {milestone:?}");
                }
            }
        }
        assert_eq!(found.iter().filter(|row| row.1 == Milestone::Mode(Mode::Ended)).count(), 1, "{found:?}");
    }
}

#[test]
fn ribbon_line_starts_waits_prints_and_stops_in_this_order() {
    let project = Project::of("ribbon-line", None).unwrap();
    let run = whole(&project);
    let end = run.timeline().end();
    let at = |wanted: Milestone| run.timeline().milestones().into_iter().find(|row| row.1 == wanted).unwrap().0;
    let start = at(Milestone::Spindle(Code::SpindleCw));
    let (dot, name) = project.prepared().first_contact(&run, end).unwrap();
    assert_eq!(name, "ribbon.first-dot");
    let times = [start, at(Milestone::Mode(Mode::Dwell)), dot, at(Milestone::Mode(Mode::Ended)), end];
    assert!(times.windows(2).all(|pair| pair[0] < pair[1] + 1e-9), "{times:?}");
    // Within the first block of a dot.
    let pulled = |t: f64| run.timeline().at(t).axes[0].actual;
    assert!((pulled(dot) - 10.0).abs() < 1e-3, "{}", pulled(dot));
}

#[test]
fn every_machine_meets_its_work() {
    for project in all() {
        let (run, machine) = (whole(&project), project.prepared());
        let (t, _) = machine.first_contact(&run, run.timeline().end()).unwrap();
        assert!(t > 0.0 && t < run.timeline().end(), "{}", project.machine.id());
        assert_eq!(machine.first_contact(&run, 0.5 * t), None, "{}", project.machine.id());
    }
}
