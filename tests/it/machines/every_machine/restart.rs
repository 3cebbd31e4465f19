//! Hold, reset and emergency stop at any moment of every machine on every control.
//!
//! No motion starts from a position that is not known to be clear, and no different product is made without an alarm.

use macroline::controls::{Address, CodeId};
use macroline::interp::{Canon, Interp};
use macroline::motion::{Action, Budget, Event, Planner, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};

use crate::queries::{every_machine_on_every_control, machine_on_control};

/// Moments of each kind of interruption, per machine and control.
const MOMENTS: u32 = 8;

/// Seconds from the interruption to cycle start.
const PAUSE: f64 = 9.0;

pub(in crate::machines) struct Outcome {
    pub(in crate::machines) planner: Planner<Interp>,
    pub(in crate::machines) ended: Option<RunEnd>,
    /// Commands with the times at which they were read.
    pub(in crate::machines) log: Vec<(f64, String)>,
}

fn outcome(project: &Project, events: &[(f64, Action)]) -> Outcome {
    within(7200.0, project, events)
}

/// A run with these events, of at most `seconds` s.
pub(in crate::machines) fn within(seconds: f64, project: &Project, events: &[(f64, Action)]) -> Outcome {
    let mut project = project.clone();
    for (t, action) in events {
        project.panel.add(Event { t: *t, action: action.clone() });
    }
    let limits = Budget { blocks: 1_000_000, seconds };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Both };
    let mut planner = run::of_project(&project, &project.written(), &begin);
    let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
    // A preset of the present position depends on that position; driven motions do not.
    let driven = planner.take_log().into_iter().filter(|(_, canon, _)| !matches!(canon, Canon::Preset { .. }));
    let names = planner.program().names();
    let log = driven.map(|(t, canon, _)| (t, canon.line(names).to_string())).collect();
    Outcome { planner, ended, log }
}

/// Pseudo-random moments between 0 and 1, the same in every run of the test.
fn shares(seed: u32) -> impl Iterator<Item = f64> {
    let next = |x: &u32| Some(x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    std::iter::successors(Some(seed), next).skip(1).take(MOMENTS as usize).map(|x| f64::from(x >> 8) / 16_777_216.0)
}

/// Turn of the print roller, in heads.
fn heads(project: &Project, planner: &Planner<Interp>, t: f64) -> f64 {
    let readouts = project.design().readouts;
    let stroke = readouts.iter().find(|row| row.id == "y-stroke").unwrap().value;
    planner.timeline().at(t).axes[project.control.axis(Address::Y).unwrap()].actual / stroke
}

/// Time (s) at which X first pulls after a moment.
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
    for (seed, project) in (1..).zip(every_machine_on_every_control()) {
        let name = machine_on_control(&project);
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

/// Kinds of a correct restart: the whole product again, or an alarm before anything moves.
#[derive(Debug, PartialEq)]
enum Restart {
    Repeated,
    Alarmed,
}

/// Compares the run `again`, restarted at `start` (s), with the whole product, and returns the kind of restart.
#[track_caller]
fn judged(name: &str, project: &Project, whole: &Outcome, again: &Outcome, start: f64) -> Restart {
    let end = again.planner.timeline().end();
    let [from, to] = [start, end].map(|t| place(&again.planner, t));
    let message = again.planner.timeline().message_at(end).unwrap_or_default();
    if let Some(stopped @ (RunEnd::Alarm(_) | RunEnd::Stop)) = &again.ended {
        // A control without alarms of a program shows its message and stops.
        let ending = format!("{stopped:?} {message}");
        assert!(ending.contains("BY HAND"), "{name}: {ending}");
        assert!(from.iter().zip(&to).all(|(a, b)| (a - b).abs() < 1e-6), "{name}: it moved");
        return Restart::Alarmed;
    }
    assert_eq!(again.ended, Some(RunEnd::ProgramEnd), "{name}");
    if project.machine.id() == "ribbon-line" {
        let [begin, product] = [0.0, whole.planner.timeline().end()].map(|t| place(&whole.planner, t));
        // A whole product more, from wherever the ribbon is, with a head at the ribbon at its begin and its end.
        for (at, most) in [(first_pull(&again.planner, start), 2.001e-3), (end, 1e-4)] {
            let off = heads(project, &again.planner, at);
            assert!((off - off.round()).abs() < most, "{name}: {off} heads at {at}");
        }
        let from = place(&again.planner, first_pull(&again.planner, start) - 1e-9);
        let left = |k: usize| to[k] - from[k] - (product[k] - begin[k]);
        assert!((0..product.len()).all(|k| left(k).abs() < 1e-3), "{name}: {from:?} to {to:?}");
    } else {
        let since = again.log.iter().filter(|(read, _)| *read >= start).map(|(_, canon)| canon);
        assert!(since.eq(whole.log.iter().map(|(_, canon)| canon)), "{name}: another program");
    }
    Restart::Repeated
}

#[test]
fn reset_and_start_repeats_the_product_or_alarms() {
    let mut seen = Vec::new();
    for (seed, project) in (100..).zip(every_machine_on_every_control()) {
        let name = machine_on_control(&project);
        let whole = outcome(&project, &[]);
        let end = whole.planner.ended_at().unwrap();
        for (at, t) in shares(seed).map(|share| end * share).enumerate() {
            let broken = [Action::Reset, Action::EmergencyStop][at % 2].clone();
            let start = t + PAUSE;
            let again = outcome(&project, &[(t, broken), (start - 0.1, Action::Reset), (start, Action::Start)]);
            seen.push(judged(&format!("{name} at {t}"), &project, &whole, &again, start));
        }
    }
    let alarms = seen.iter().filter(|end| **end == Restart::Alarmed).count();
    assert!(alarms > 40 && seen.len() - alarms > 40, "{alarms} alarms of {}", seen.len());
}

/// Machines with an inverter, each on each of its controls.
fn with_inverter() -> impl Iterator<Item = Project> {
    every_machine_on_every_control().filter(|project| project.prepared().plc().watches_inverter())
}

#[test]
fn fault_of_the_inverter_stops_spindle_and_axes() {
    let mut machines = std::collections::BTreeSet::new();
    for (seed, project) in (200..).zip(with_inverter()) {
        let name = machine_on_control(&project);
        machines.insert(project.machine.id());
        let end = outcome(&project, &[]).planner.ended_at().unwrap();
        for t in shares(seed).map(|share| end * share) {
            let name = format!("{name} at {t}");
            let fault = |on: bool| Action::InverterFault(on);
            // Cycle start and reset do not continue the run while the fault lasts, nor does cycle start without reset.
            let sequences = [
                vec![(t, fault(true)), (t + 5.0, Action::Start)],
                vec![(t, fault(true)), (t + 5.0, Action::Reset), (t + 6.0, Action::Start)],
                vec![(t, fault(true)), (t + 5.0, fault(false)), (t + 6.0, Action::Start)],
                vec![(t, Action::Hold), (t + 2.0, fault(true)), (t + 3.0, fault(false)), (t + 4.0, Action::Start)],
            ];
            // The axes stop where reset stops them.
            let reset = place(&outcome(&project, &[(t, Action::Reset)]).planner, t + 60.0);
            for events in sequences {
                let stopped = outcome(&project, &events);
                let Some(RunEnd::Alarm(alarm)) = &stopped.ended else { panic!("{name}: {:?}", stopped.ended) };
                assert_eq!(alarm.message.id, "motion.inverter-fault", "{name}");
                let last = stopped.planner.timeline().at(stopped.planner.timeline().end());
                assert!(last.spindle.actual.abs() < 1e-9 && !last.spindle.held, "{name}: {:?}", last.spindle);
                assert!(last.axes.iter().all(|axis| axis.feed == 0.0), "{name}: {:?}", last.axes);
                let stands = place(&stopped.planner, t + 60.0);
                let same = reset.iter().zip(&stands).all(|(a, b)| (a - b).abs() < 1e-6);
                assert!(same || events[0].1 == Action::Hold, "{name}: {reset:?} {stands:?}");
            }
        }
    }
    assert_eq!(machines.into_iter().collect::<Vec<_>>(), ["ribbon-line", "turning-spindle"]);
}

#[test]
fn start_after_a_cleared_fault_repeats_or_alarms() {
    let mut seen = Vec::new();
    for (seed, project) in (300..).zip(with_inverter()) {
        let name = machine_on_control(&project);
        let whole = outcome(&project, &[]);
        let end = whole.planner.ended_at().unwrap();
        let fastest = |run: &Outcome, from: f64| {
            let ramps = (0..400).map(|k| from + end * f64::from(k) / 400.0);
            ramps.map(|t| run.planner.timeline().at(t).spindle.actual.abs()).fold(0.0, f64::max)
        };
        for t in shares(seed).map(|share| end * share) {
            let start = t + PAUSE;
            let events = [
                (t, Action::InverterFault(true)),
                (start - 2.0, Action::InverterFault(false)),
                (start - 0.1, Action::Reset),
                (start, Action::Start),
            ];
            let again = outcome(&project, &events);
            let name = format!("{name} at {t}");
            let ended = judged(&name, &project, &whole, &again, start);
            if ended == Restart::Repeated {
                // The run command comes back with the M3 of the program, and nothing is cut before it.
                let [one, other] = [fastest(&whole, 0.0), fastest(&again, start)];
                assert!(one > 0.0 && (one - other).abs() < 0.05 * one, "{name}: {one} {other}");
                let still = |d: &&macroline::text::Diagnostic| d.message.id == "motion.feed-without-rotation";
                assert_eq!(again.planner.diagnostics().iter().find(still), None, "{name}");
            }
            seen.push(ended);
        }
    }
    let alarms = seen.iter().filter(|end| **end == Restart::Alarmed).count();
    assert!(alarms > 10 && seen.len() - alarms > 40, "{alarms} alarms of {}", seen.len());
}

#[test]
fn fault_releases_a_spindle_held_at_its_angle() {
    let project = Project::named("turning-spindle", Some("sinumerik-802d"), Some("keyway")).unwrap();
    let whole = outcome(&project, &[]);
    let held = |t: &f64| whole.planner.timeline().at(*t).spindle.held;
    let t = (0..4000).map(|k| f64::from(k) * 0.05).find(held).expect("the spindle is held");
    let stopped = outcome(&project, &[(t, Action::InverterFault(true))]);
    let end = stopped.planner.timeline().at(stopped.planner.timeline().end());
    assert!(matches!(stopped.ended, Some(RunEnd::Alarm(_))) && !end.spindle.held, "{:?}", end.spindle);
}

#[test]
fn fault_without_an_inverter_is_a_remark_and_stops_nothing() {
    let project = Project::of("polygon-lathe", None).unwrap();
    let [whole, run] = [vec![], vec![(5.0, Action::InverterFault(true))]].map(|events| outcome(&project, &events));
    assert_eq!((&run.ended, &run.log), (&whole.ended, &whole.log));
    assert!(run.planner.diagnostics().iter().any(|found| found.message.id == "motion.no-inverter"));
}

/// On a lathe the first motion of a program goes away from the work, across it alone.
#[test]
fn first_motion_of_a_lathe_is_away_from_the_work() {
    let lathes = every_machine_on_every_control().filter(|project| project.machine.id() != "ribbon-line");
    let mut seen = 0;
    for project in lathes {
        seen += 1;
        let name = machine_on_control(&project);
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
    assert!(seen > 5, "{seen} lathes");
}
