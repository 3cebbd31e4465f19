//! Milestones of a run, the first contact with the work, and the passes over it.

use macroline::drives::Rotation;
use macroline::machines;
use macroline::motion::{Action, Budget, Event, Milestone, Mode, Panel, Retention};
use macroline::project::Project;
use macroline::project::run::{self, Run, RunOptions};
use macroline::text::catalog::sentence;

fn whole(project: &Project) -> Run {
    let limits = Budget { blocks: 1_000_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = run::of_project(project, &project.written(), &begin);
    while run.advance(f64::INFINITY, 4096).ended.is_none() {}
    run
}

fn all() -> impl Iterator<Item = Project> {
    machines::ALL.iter().map(|machine| Project::of(machine.id(), None).expect("a new project"))
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
                Milestone::Spindle(rotation) => {
                    assert_eq!(*rotation, Rotation::of(after.spindle.command), "{t}");
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
    let start = at(Milestone::Spindle(Rotation::Clockwise));
    let (dot, name) = project.prepared().first_contact(&run, end).unwrap();
    assert_eq!(name, "ribbon.first-dot");
    let times = [start, at(Milestone::Mode(Mode::Dwell)), dot, at(Milestone::Mode(Mode::Ended)), end];
    assert!(times.windows(2).all(|pair| pair[0] < pair[1] + 1e-9), "{times:?}");
    // Within the first block of a dot.
    let pulled = |t: f64| run.timeline().at(t).axes[0].actual;
    assert!((pulled(dot) - 10.0).abs() < 1e-3, "{}", pulled(dot));
}

#[test]
fn gears_that_mesh_before_the_start_are_no_start() {
    let project = Project::of("turning-spindle", None).unwrap();
    let run = whole(&project);
    let (contact, _) = project.prepared().first_contact(&run, run.timeline().end()).unwrap();
    let of_spindle = run.timeline().milestones().into_iter().filter_map(|row| match row {
        (t, Milestone::Spindle(rotation)) if t < contact => Some((t, rotation)),
        _ => None,
    });
    let [(start, Rotation::Clockwise)] = of_spindle.collect::<Vec<_>>()[..] else { panic!("one start before the cut") };
    // The spindle has turned before, while its gears meshed.
    let turned = (1..100).map(|step| run.timeline().at(start * f64::from(step) / 100.0).spindle.actual);
    assert!(turned.fold(0.0, f64::max) > 1.0);
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

#[test]
fn first_contact_stays_after_an_emergency_stop_in_the_cut() {
    for mut project in all() {
        let whole_run = whole(&project);
        let (contact, name) = project.prepared().first_contact(&whole_run, whole_run.timeline().end()).unwrap();
        let works = project.prepared().working(&whole_run, whole_run.timeline().end());
        let stop = works.map_or(contact + 1.0, |works| 0.5 * (works[0].0 + works[0].1));
        project.panel = Panel::new([Event { t: stop, action: Action::EmergencyStop }]);
        let stopped = whole(&project);
        let found = project.prepared().first_contact(&stopped, stopped.timeline().end());
        let (t, found) = found.unwrap_or_else(|| panic!("{}", project.machine.id()));
        assert!((t - contact).abs() < 1e-3 && found == name, "{} {t} {contact}", project.machine.id());
    }
}

/// Operation of the machine on the work halfway between two times.
fn activity(project: &Project, run: &Run, (from, to): (f64, f64)) -> Option<String> {
    let activity = project.prepared().activity(run, &run.timeline().at(0.5 * (from + to)));
    activity.map(|activity| sentence(&activity))
}

#[test]
fn lathes_tell_the_pass_that_they_cut() {
    for (id, passes, third) in [("turning-spindle", 2, None), ("polygon-lathe", 4, Some("Cutting, pass 3 / 4"))] {
        let project = Project::of(id, None).unwrap();
        let (run, machine) = (whole(&project), project.prepared());
        let end = run.timeline().end();
        let begins = machine.pass_starts(&run, end);
        assert_eq!(begins.len(), passes, "{id}");
        let pass_activity =
            |at: usize| activity(&project, &run, (begins[at], begins.get(at + 1).copied().unwrap_or(end)));
        assert_eq!(pass_activity(0), Some(format!("Cutting, pass 1 / {passes}")), "{id}");
        // At every moment of the pass, and not by turns.
        let during = |share: f64| begins[0] + share * (begins[1] - begins[0]);
        let silent = (0..200).map(|step| during(0.4 + 0.1 * f64::from(step) / 200.0));
        let silent: Vec<_> = silent.filter(|t| activity(&project, &run, (*t, *t)).is_none()).collect();
        assert_eq!(silent, [0.0; 0], "{id}");
        assert!(third.is_none_or(|third| pass_activity(2).as_deref() == Some(third)), "{id}");
        // Before the first pass, and at the end.
        assert_eq!(activity(&project, &run, (0.0, begins[0])), None, "{id}");
        assert_eq!(activity(&project, &run, (end, end)), None, "{id}");
        assert_eq!(machine.pass_starts(&run, begins[1] - 1e-6).len(), 1, "{id}");
    }
}

#[test]
fn activity_of_the_ribbon_line_has_the_number_of_the_dot() {
    let project = Project::of("ribbon-line", None).unwrap();
    let run = whole(&project);
    let (dot, _) = project.prepared().first_contact(&run, run.timeline().end()).unwrap();
    assert_eq!(activity(&project, &run, (0.0, dot)), None);
    assert_eq!(activity(&project, &run, (dot, dot + 1e-3)).as_deref(), Some("Printing, dot 1"));
    assert!(project.prepared().pass_starts(&run, f64::INFINITY).is_empty());
}
