//! Hold, reset and emergency stop at any moment of every machine on every control: no motion from a place that is not known to be clear, and no
//! other product without an alarm.

use macroline::controls::{Address, CodeId};
use macroline::interp::{Canon, Interp};
use macroline::machines;
use macroline::motion::{Action, Budget, Event, Planner, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};

/// Moments of each kind of interruption, per machine and control.
const MOMENTS: u32 = 8;

/// Seconds from the interruption to cycle start.
const PAUSE: f64 = 9.0;

pub(super) struct Outcome {
    pub(super) planner: Planner<Interp>,
    pub(super) ended: Option<RunEnd>,
    /// Commands with the times at which they were read.
    pub(super) log: Vec<(f64, String)>,
}

fn outcome(project: &Project, events: &[(f64, Action)]) -> Outcome {
    within(7200.0, project, events)
}

/// The run with these events, of so many seconds at most.
pub(super) fn within(seconds: f64, project: &Project, events: &[(f64, Action)]) -> Outcome {
    let mut project = project.clone();
    events.iter().for_each(|(t, action)| project.panel.add(Event { t: *t, action: action.clone() }));
    let limits = Budget { blocks: 1_000_000, seconds };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Both };
    let mut planner = run::of_project(&project, &project.written(), &begin);
    let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
    // A preset that says where the tool is anyway differs with the place; what is driven to does not.
    let driven = planner.take_log().into_iter().filter(|(_, canon, _)| !matches!(canon, Canon::Preset { .. }));
    let names = planner.program().names();
    let log = driven.map(|(t, canon, _)| (t, canon.line(names).to_string())).collect();
    Outcome { planner, ended, log }
}

/// Moments between 0 and 1, the same in every run of the test.
fn shares(seed: u32) -> impl Iterator<Item = f64> {
    let next = |x: &u32| Some(x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    std::iter::successors(Some(seed), next).skip(1).take(MOMENTS as usize).map(|x| f64::from(x >> 8) / 16_777_216.0)
}

/// Each machine on each of its controls.
fn projects() -> impl Iterator<Item = (String, Project)> {
    machines::ALL.iter().flat_map(|machine| {
        machine.controls().iter().map(|control| {
            let project = Project::of(machine.id(), Some(control)).unwrap();
            (format!("{} {control}", machine.id()), project)
        })
    })
}

/// Turn of the print roller, in heads.
fn heads(project: &Project, planner: &Planner<Interp>, t: f64) -> f64 {
    let readouts = project.design().readouts;
    let stroke = readouts.iter().find(|row| row.id == "y-stroke").unwrap().value;
    planner.timeline().at(t).axes[project.control.axis(Address::Y).unwrap()].actual / stroke
}

/// When X begins to pull behind a moment.
fn first_pull(planner: &Planner<Interp>, from: f64) -> f64 {
    let still = planner.timeline().at(from).axes[0].actual;
    let (mut low, mut high) = (from, planner.timeline().end());
    while high - low > 1e-9 {
        let middle = 0.5 * (low + high);
        let moved = planner.timeline().at(middle).axes[0].actual != still;
        *(if moved { &mut high } else { &mut low }) = middle;
    }
    low
}

/// Places of the axes, as words count them.
fn place(planner: &Planner<Interp>, t: f64) -> Vec<f64> {
    planner.timeline().words_at(t).to_vec()
}

#[test]
fn hold_and_start_at_any_moment_gives_the_same_product() {
    for (seed, (name, project)) in (1..).zip(projects()) {
        let whole = outcome(&project, &[]);
        let end = whole.planner.ended_at().unwrap();
        let commands: Vec<&String> = whole.log.iter().map(|(_, canon)| canon).collect();
        for t in shares(seed).map(|share| end * share) {
            let held = outcome(&project, &[(t, Action::Hold), (t + PAUSE, Action::Start)]);
            assert_eq!(held.ended, Some(RunEnd::ProgramEnd), "{name} at {t}");
            assert_eq!(held.log.iter().map(|(_, canon)| canon).collect::<Vec<_>>(), commands, "{name} at {t}");
            let [one, other] = [&whole, &held].map(|run| place(&run.planner, run.planner.timeline().end()));
            assert!(one.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-6), "{name} at {t}: {one:?} {other:?}");
        }
    }
}

#[test]
fn reset_and_start_repeats_the_product_or_alarms() {
    let (mut alarms, mut repeats) = (0, 0);
    for (seed, (name, project)) in (100..).zip(projects()) {
        let whole = outcome(&project, &[]);
        let end = whole.planner.ended_at().unwrap();
        let ribbon = name.starts_with("ribbon");
        let product = place(&whole.planner, whole.planner.timeline().end());
        let begin = place(&whole.planner, 0.0);
        for (at, t) in shares(seed).map(|share| end * share).enumerate() {
            let broken = [Action::Reset, Action::EmergencyStop][at % 2].clone();
            let start = t + PAUSE;
            let again = outcome(&project, &[(t, broken), (start - 0.1, Action::Reset), (start, Action::Start)]);
            let [from, to] = [start, again.planner.timeline().end()].map(|t| place(&again.planner, t));
            let end = again.planner.timeline().end();
            let message = again.planner.timeline().message_at(end).unwrap_or_default().to_owned();
            match &again.ended {
                Some(stopped @ (RunEnd::Alarm(_) | RunEnd::Stop)) => {
                    // A control without alarms of a program shows its message and stops.
                    let said = format!("{stopped:?} {message}");
                    assert!(said.contains("BY HAND"), "{name} at {t}: {said}");
                    assert!(from.iter().zip(&to).all(|(a, b)| (a - b).abs() < 1e-6), "{name} at {t}: it moved");
                    alarms += 1;
                }
                ended => {
                    assert_eq!(*ended, Some(RunEnd::ProgramEnd), "{name} at {t}");
                    repeats += 1;
                    if ribbon {
                        // A whole product more, from wherever the ribbon is, with a head at the ribbon at its begin and its end.
                        for (at, most) in [(first_pull(&again.planner, start), 2.001e-3), (end, 1e-4)] {
                            let off = heads(&project, &again.planner, at);
                            assert!((off - off.round()).abs() < most, "{name} at {t}: {off} heads at {at}");
                        }
                        let from = place(&again.planner, first_pull(&again.planner, start) - 1e-9);
                        let whole = |k: usize| product[k] - begin[k];
                        assert!(
                            (0..product.len()).all(|k| (to[k] - from[k] - whole(k)).abs() < 1e-3),
                            "{name} at {t}: {from:?} to {to:?}"
                        );
                        continue;
                    }
                    let since: Vec<&String> =
                        again.log.iter().filter(|(read, _)| *read >= start).map(|(_, canon)| canon).collect();
                    let commands: Vec<&String> = whole.log.iter().map(|(_, canon)| canon).collect();
                    assert_eq!(since, commands, "{name} at {t}: another program");
                }
            }
        }
    }
    assert!(alarms > 10 && repeats > 50, "{alarms} alarms, {repeats} repeats");
}

/// On a lathe the first motion of a program goes away from the work, across it alone.
#[test]
fn first_motion_of_a_lathe_is_away_from_the_work() {
    for (name, project) in projects().filter(|(name, _)| !name.starts_with("ribbon")) {
        let whole = outcome(&project, &[]);
        let first = whole.log.iter().map(|(_, canon)| canon).find(|canon| canon.starts_with("rapid")).unwrap();
        let start = place(&whole.planner, 0.0);
        let t = whole.planner.timeline().next_block(0.0).unwrap();
        assert!(t >= 0.0 && first.contains('X') && !first.contains('Z'), "{name}: {first} from {start:?}");
        let opening = project.written().files.0.into_iter().find(|file| file.text.contains("WORK ZERO")).unwrap().text;
        let line = opening.lines().find(|line| line.contains("WORK ZERO")).unwrap();
        for code in [40, 54, 97].into_iter().filter(|code| project.control.code(CodeId::g(*code)).is_some()) {
            assert!(line.contains(&format!("G{code}")), "{name}: {line}");
        }
        assert!(opening.lines().any(|line| line.contains("T1")), "{name}: no tool");
    }
}
