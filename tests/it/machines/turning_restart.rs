//! Reset, hold or emergency stop at any moment, then reset and cycle start: the turning spindle never moves from a place that it has guessed.

use macroline::interp::{Canon, Interp};
use macroline::machines;
use macroline::motion::{Action, Budget, Event, Planner, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};

use super::turning::project;

/// Seconds from reset to cycle start.
const PAUSE: f64 = 2.0;

fn ended(project: &Project, events: Vec<Event>) -> (Planner<Interp>, Option<RunEnd>, Vec<(f64, String)>) {
    let mut project = project.clone();
    events.into_iter().for_each(|event| project.panel.add(event));
    let limits = Budget { blocks: 1_000_000, seconds: 3600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Both };
    let mut planner = run::of_project(&project, &project.written(), &begin);
    let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
    // A preset that says where the tool is anyway differs with the place; what is driven to does not.
    let driven = planner.take_log().into_iter().filter(|(_, canon, _)| !matches!(canon, Canon::Preset { .. }));
    let names = planner.program().names();
    let log = driven.map(|(t, canon, _)| (t, canon.line(names).to_string())).collect();
    (planner, ended, log)
}

/// A run that is broken off at `t`, reset, and started again.
fn restarted(project: &Project, t: f64, broken: Action) -> (Planner<Interp>, Option<RunEnd>, Vec<String>) {
    let start = t + PAUSE;
    let all = [(t, broken), (start - 0.1, Action::Reset), (start, Action::Start)];
    let events = all.into_iter().map(|(t, action)| Event { t, action }).collect();
    let (planner, ended, log) = ended(project, events);
    (planner, ended, log.into_iter().filter(|(read, _)| *read >= start).map(|(_, canon)| canon).collect())
}

fn lathes() -> impl Iterator<Item = (String, Project)> {
    let controls = machines::find("turning-spindle").unwrap().controls();
    let paths = ["facing", "turning", "taper"];
    let all = controls.iter().flat_map(move |control| {
        paths.map(|path| (format!("{control} {path}"), project(control, &[("path", path), ("depth", "5")])))
    });
    // A limit by G50 S alone would make the place of the tool work zero.
    let mut shifts = project("gsk-980tdc", &[]);
    shifts.switches.0.push(("speed-limit-sets-zero".to_owned(), "work-zero".to_owned()));
    all.chain([("G50 S sets work zero".to_owned(), shifts)])
}

#[test]
fn restart_repeats_the_program_or_raises_an_alarm() {
    let (mut alarms, mut repeats) = (0, 0);
    for (name, project) in lathes() {
        let (whole, end, log) = ended(&project, Vec::new());
        assert_eq!(end, Some(RunEnd::ProgramEnd), "{name}");
        let commands: Vec<String> = log.into_iter().map(|(_, canon)| canon).collect();
        let end = whole.ended_at().unwrap();
        for at in 1..20 {
            let t = end * f64::from(at) / 20.0;
            let broken = [Action::Reset, Action::Hold, Action::EmergencyStop][at as usize % 3].clone();
            let (planner, ended, again) = restarted(&project, t, broken);
            match ended {
                Some(RunEnd::Alarm(alarm)) => {
                    let said = format!("{alarm:?}");
                    assert!(said.contains("RETRACT THE TOOL"), "{name} at {t}: {said}");
                    let [before, after] = [t + PAUSE, planner.timeline().end()].map(|t| planner.timeline().words_at(t));
                    assert!(before.iter().zip(after).all(|(b, a)| (b - a).abs() < 1e-6), "{name} at {t}: it moved");
                    alarms += 1;
                }
                ended => {
                    assert_eq!(ended, Some(RunEnd::ProgramEnd), "{name} at {t}");
                    assert_eq!(again, commands, "{name} at {t}: another program");
                    repeats += 1;
                }
            }
        }
    }
    assert!(alarms > 50 && repeats > 50, "{alarms} alarms, {repeats} repeats");
}

#[test]
fn tool_beyond_the_clear_diameter_starts_the_same_part() {
    // Reset on the way to the first cut: the tool is clear of the work.
    let project = project("gsk-980tdc", &[]);
    let (_, end, again) = restarted(&project, 0.3, Action::Reset);
    assert_eq!(end, Some(RunEnd::ProgramEnd));
    let whole: Vec<String> = ended(&project, Vec::new()).2.into_iter().map(|(_, canon)| canon).collect();
    assert_eq!(again, whole);
}
