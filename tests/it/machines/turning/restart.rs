//! Reset, hold or emergency stop at any moment, then reset and cycle start: the turning spindle never moves from an assumed position.

use macroline::interp::Interp;
use macroline::machines;
use macroline::motion::{Action, Planner, RunEnd};
use macroline::project::Project;

use super::project;
use crate::machines::every_machine::restart::{Outcome, within};

/// Seconds from reset to cycle start.
const PAUSE: f64 = 2.0;

fn outcome(project: &Project, events: &[(f64, Action)]) -> Outcome {
    within(3600.0, project, events)
}

/// A run that is broken off at `t`, reset, and started again.
fn restarted(project: &Project, t: f64, broken: Action) -> (Planner<Interp>, Option<RunEnd>, Vec<String>) {
    let start = t + PAUSE;
    let Outcome { planner, ended, log } =
        outcome(project, &[(t, broken), (start - 0.1, Action::Reset), (start, Action::Start)]);
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
        let Outcome { planner: whole, ended: end, log } = outcome(&project, &[]);
        assert_eq!(end, Some(RunEnd::ProgramEnd), "{name}");
        let commands: Vec<String> = log.into_iter().map(|(_, canon)| canon).collect();
        let end = whole.ended_at().unwrap();
        for at in 1..20 {
            let t = end * f64::from(at) / 20.0;
            let broken = [Action::Reset, Action::Hold, Action::EmergencyStop][at as usize % 3].clone();
            let (planner, ended, again) = restarted(&project, t, broken);
            match ended {
                // A control without alarms of a program shows its message and stops.
                Some(stopped @ (RunEnd::Alarm(_) | RunEnd::Stop)) => {
                    let message = planner.timeline().message_at(planner.timeline().end()).unwrap_or_default();
                    let ending = format!("{stopped:?} {message}");
                    assert!(ending.contains("RETRACT THE TOOL"), "{name} at {t}: {ending}");
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
    // Within the swing of the turret: only the approach to the first cut and the last retract are clear of the work.
    assert!(alarms > 300 && repeats > 10, "{alarms} alarms, {repeats} repeats");
}

#[test]
fn tool_beyond_the_clear_diameter_starts_the_same_part() {
    // Reset in the approach to the first cut: the tool is clear of the work.
    let project = project("gsk-980tdc", &[]);
    let (_, end, again) = restarted(&project, 0.3, Action::Reset);
    assert_eq!(end, Some(RunEnd::ProgramEnd));
    let whole: Vec<String> = outcome(&project, &[]).log.into_iter().map(|(_, canon)| canon).collect();
    assert_eq!(again, whole);
}

#[test]
fn program_zero_return_after_reset_lets_the_program_repeat() {
    for path in ["facing", "turning", "taper"] {
        let project = project("gsk-980tdc", &[("path", path), ("depth", "5")]);
        let Outcome { planner: whole, log, .. } = outcome(&project, &[]);
        let commands: Vec<String> = log.into_iter().map(|(_, canon)| canon).collect();
        let point = whole.reference_point().expect("G50 S sets it");
        let end = whole.ended_at().unwrap();
        // From the first quarter on G50 S is done.
        for at in 5..20 {
            let (name, t) = (format!("{path} at {at}/20"), end * f64::from(at) / 20.0);
            let start = t + 10.0;
            let events = [(t, Action::Reset), (t + 1.0, Action::ProgramZeroReturn), (start, Action::Start)];
            let Outcome { planner, ended, log } = outcome(&project, &events);
            let back = planner.timeline().words_at(start);
            assert!(back.iter().zip(point).all(|(a, b)| (a - b).abs() < 1e-6), "{name}: {back:?} {point:?}");
            let again: Vec<String> =
                log.into_iter().filter(|(read, _)| *read >= start).map(|(_, canon)| canon).collect();
            assert_eq!((ended, again), (Some(RunEnd::ProgramEnd), commands.clone()), "{name}");
        }
    }
}

#[test]
fn keyway_restart_waits_for_the_mill_and_unlocks() {
    for control in ["sinumerik-802d", "sinumerik-808d"] {
        let project = Project::named("turning-spindle", Some(control), Some("keyway")).unwrap();
        let whole = outcome(&project, &[]);
        let block = whole.planner.program().numbered(61).unwrap();
        let steps = (1..4000).map(|k| whole.planner.timeline().end() * f64::from(k) / 4000.0);
        let along = steps.into_iter().find(|t| whole.planner.timeline().block_at(*t) == Some(block)).unwrap();
        let (planner, ended, again) = restarted(&project, along, Action::Reset);
        assert_eq!(ended, Some(RunEnd::Stop), "{control}");
        let end = planner.timeline().end();
        let message = planner.timeline().message_at(end).unwrap_or_default();
        assert!(message.contains("RESET, RETRACT THE TOOL BY HAND, R124=0"), "{control}: {message}");
        let [before, after] = [along + PAUSE, end].map(|t| planner.timeline().words_at(t));
        assert!(before.iter().zip(after).all(|(b, a)| (b - a).abs() < 1e-6), "{control}: it moved");
        assert_eq!(again, ["show RESET, RETRACT THE TOOL BY HAND, R124=0", "stop"], "{control}: no turret indexes");
    }
}

/// The tool is out of the groove at the first reset. In M0 cycle start would bring a jogged mill back into the groove: only a reset ends it.
#[test]
fn cleared_mark_frees_the_start_only_after_a_reset() {
    for control in ["sinumerik-802d", "sinumerik-808d"] {
        let project = Project::named("turning-spindle", Some(control), Some("keyway")).unwrap();
        let whole = outcome(&project, &[]);
        // At the end of its retract the tool is out of the groove, and the spindle is still locked.
        let block = whole.planner.program().numbered(64).unwrap();
        let end = whole.planner.timeline().end();
        let steps = (1..40_000).map(|k| end * f64::from(k) / 40_000.0);
        let out = steps.filter(|t| whole.planner.timeline().block_at(*t) == Some(block)).last().unwrap();
        let stopped = [(out, Action::Reset), (out + 2.0, Action::Start), (out + 6.0, Action::Start)];
        let again = outcome(&project, &stopped);
        assert_eq!(again.ended, Some(RunEnd::Stop), "{control}: the mark is set");
        let start = out + 12.0;
        let unreset = [(out + 10.0, Action::Variable(124, Some(0.0))), (start, Action::Start)];
        let again = outcome(&project, &[&stopped[..], &unreset].concat());
        assert_eq!(again.ended, Some(RunEnd::Stop), "{control}: no reset");
        let cleared = [&[(out + 9.0, Action::Reset)][..], &unreset].concat();
        let Outcome { planner, ended, log } = outcome(&project, &[&stopped[..], &cleared].concat());
        assert_eq!(ended, Some(RunEnd::ProgramEnd), "{control}: {:?}", planner.diagnostics());
        assert_eq!(planner.timeline().message_at(start + 2.0), None, "{control}");
        let since: Vec<&String> = log.iter().filter(|(read, _)| *read >= start).map(|(_, canon)| canon).collect();
        assert!(since.ends_with(&whole.log.iter().map(|(_, canon)| canon).collect::<Vec<_>>()), "{since:?}");
        // The program opens the clamp before M3.
        let speeds = (0..400).map(|k| planner.timeline().at(start + f64::from(k) * 0.1).spindle.actual.abs());
        assert!(speeds.fold(0.0, f64::max) > 100.0, "{control}: the spindle turns again");
    }
}

#[test]
fn spindle_locked_without_a_cut_is_released_for_the_next_part() {
    let keyway = |release: &str| {
        let project = Project::named("turning-spindle", Some("sinumerik-802d"), Some("keyway")).unwrap();
        let sets = [("driven-tool", "false"), ("release-code", release)].map(|(id, typed)| (id, typed.to_owned()));
        project.with_entries(&sets).unwrap()
    };
    let warns = |project: &Project| {
        project.design().diagnostics.iter().any(|found| found.message.id == "turning.keyway-stays-locked")
    };
    assert!(warns(&keyway("0")) && !warns(&keyway("82")));
    // Cycle start at M0, and for the second part; its M0 ends the run.
    let project = keyway("82");
    let stop = outcome(&project, &[]).planner.timeline().end();
    let first = outcome(&project, &[(stop + 1.0, Action::Start)]);
    assert_eq!(first.ended, Some(RunEnd::ProgramEnd));
    let second = first.planner.ended_at().unwrap() + 1.0;
    let Outcome { planner, ended, .. } = outcome(&project, &[(stop + 1.0, Action::Start), (second, Action::Start)]);
    assert_eq!(ended, Some(RunEnd::Stop), "{:?}", planner.diagnostics());
    assert!(planner.timeline().end() > second + 0.9 * stop, "the second part is cut");
}
