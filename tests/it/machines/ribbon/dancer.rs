//! The regulator of a dancer in the run: it takes away what starts, holds and stops lay into the loop.

use macroline::motion::{Action, Budget, Event, Mover, Retention};
use macroline::project::Project;
use macroline::project::run::{self, Run, RunOptions};

/// The ready-made example with a dancer, with other entries.
fn line(entries: &[(&'static str, &str)]) -> Project {
    let project = Project::named("ribbon-line", None, Some("matched")).unwrap();
    project.with_entries(&[&[("pitch-count", "9000")], entries].concat()).unwrap()
}

/// The same without a dancer, with a motor that turns as commanded.
const OPEN: [(&str, &str); 3] = [("dancer", "false"), ("no-load-speed", "1480"), ("rated-load-speed", "1480")];

fn begun(project: &Project, seconds: f64) -> Run {
    let limits = Budget { blocks: 10_000_000, seconds };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    run::of_project(project, &project.written(), &begin)
}

fn ended(mut run: Run) -> Run {
    while run.advance(f64::INFINITY, 100_000).ended.is_none() {}
    run
}

/// The run until `seconds`, with holds at these times (s), each for 3 s.
fn held(project: &Project, holds: &[f64], seconds: f64) -> Run {
    let mut run = begun(project, seconds);
    for &t in holds {
        run.event(Event { t, action: Action::Hold });
        run.event(Event { t: t + 3.0, action: Action::Start });
    }
    ended(run)
}

/// Ribbon (mm) in the loop.
fn loop_at(project: &Project, run: &Run, t: f64) -> f64 {
    project.prepared().gauges(run, (t, t), 2)[0].value
}

fn value(project: &Project, id: &str) -> f64 {
    crate::queries::value(project, id)
}

/// The trim left for the loop, and the time constant (s) of the slack, by the form.
fn trim_and_time(project: &Project) -> (f64, f64) {
    let trim = 0.1 - value(project, "dancer-trim").abs() / 100.0;
    // 10 s at the highest speed, that of 10 V.
    (trim, 10.0 * 1480.0 / value(project, "actual-speed"))
}

#[test]
fn slack_after_a_hold_falls_exponentially() {
    let project = line(&[]);
    let (_, time) = trim_and_time(&project);
    let run = held(&project, &[200.0], 320.0);
    let laid = value(&project, "slack-hold") + value(&project, "slack-resume");
    // Restart with its wait of 0.7 s, and X at its speed.
    let from = 205.0;
    let set_point = value(&project, "dancer-set-point");
    let first = loop_at(&project, &run, from) - set_point;
    let before = loop_at(&project, &run, 199.9) - set_point;
    assert!(before.abs() < 3.0, "the start is taken away: {before}");
    assert!(first > 0.6 * laid && first <= laid + before, "{first} of {laid}");
    for seconds in [5.0, 10.0, 20.0, 40.0, 80.0] {
        let slack = loop_at(&project, &run, from + seconds) - set_point;
        let wanted = first * macroline::math::exp(-seconds / time);
        assert!((slack - wanted).abs() < 3.0 + 0.01 * wanted, "after {seconds} s {slack}, expected {wanted}");
        assert!(slack > -1.5, "it does not overshoot: {slack}");
    }
}

#[test]
fn twenty_holds_leave_the_loop_within_its_bound() {
    let project = line(&[]);
    let open = line(&OPEN);
    let holds: Vec<f64> = (1..=20).map(|at| 30.0 * f64::from(at)).collect();
    let [kept, left] = [&project, &open].map(|line| {
        let run = held(line, &holds, 640.0);
        assert!(run.diagnostics().iter().all(|found| found.message.id != "ribbon.held-loop-full") || line == &open);
        (0..6400).map(|at| loop_at(line, &run, 0.1 * f64::from(at))).fold(0.0, f64::max)
    });
    assert!(kept < value(&project, "loop-needed"), "{kept} of {}", value(&project, "loop-needed"));
    assert!(left >= 600.0, "without a dancer the loop fills: {left}");
}

#[test]
fn trim_leaves_command_and_volts_alone() {
    let (project, open) = (line(&[]), line(&OPEN));
    let [with, without] = [&project, &open].map(|line| held(line, &[60.0], 100.0));
    let (trim, _) = trim_and_time(&project);
    let mut least = f64::INFINITY;
    for at in 0..2000 {
        let t = 0.05 * f64::from(at);
        let [a, b] = [&with, &without].map(|run| run.timeline().at(t).spindle);
        assert_eq!((a.command, a.volts), (b.command, b.volts), "at {t}");
        // The restart after the hold has ended its ramp.
        if t > 66.0 && t < 90.0 {
            least = least.min(a.actual / a.command);
        }
        assert!(a.actual <= (1.0 + trim) * 1480.0 + 1e-6);
    }
    assert!(least < 1.0 && least >= 1.0 - trim - 1e-9, "{least}");
}

#[test]
fn trim_replans_to_the_bit() {
    let project = line(&[]);
    let straight = held(&project, &[21.3, 47.7], 80.0);
    let mut again = begun(&project, 80.0);
    again.advance(70.0, usize::MAX);
    for t in [47.7, 21.3] {
        again.event(Event { t, action: Action::Hold });
        again.event(Event { t: t + 3.0, action: Action::Start });
        again.advance(60.0, usize::MAX);
    }
    let again = ended(again);
    for at in 0..1600 {
        let t = 0.05 * f64::from(at);
        let [a, b] = [&straight, &again].map(|run| run.timeline().at(t).spindle);
        assert_eq!((a.turns.to_bits(), a.actual.to_bits()), (b.turns.to_bits(), b.actual.to_bits()), "at {t}");
    }
}

#[test]
fn next_product_takes_the_ribbon_of_the_stop_away() {
    let project = line(&[("pitch-count", "1500")]);
    let mut run = begun(&project, 1000.0);
    run.advance(f64::INFINITY, usize::MAX);
    // The unwinder is at rest after the end of the program.
    let (end, rest) = (run.ended_at().unwrap(), run.timeline().end());
    let set_point = value(&project, "dancer-set-point");
    let left = loop_at(&project, &run, rest) - set_point;
    let stop = value(&project, "slack-stop");
    assert!((left / stop - 1.0).abs() < 0.05, "{left} {stop}");
    run.event(Event { t: rest + 5.0, action: Action::Start });
    let run = ended(run);
    assert_eq!(run.diagnostics().len(), 0, "{:?}", run.diagnostics());
    let second = run.ended_at().unwrap();
    assert!(second > 1.9 * end);
    let before = loop_at(&project, &run, second - 10.0) - set_point;
    assert!(before.abs() < 6.0, "{before}");
}

#[test]
fn trim_keeps_a_line_that_loses_speed_within_the_form() {
    for entries in [
        &[("path-mode", "exact-stop"), ("pitches-per-block", "60")][..],
        &[("macro-time", "12")],
        &[("macro-time", "20")],
    ] {
        let project = line(&[entries, &[("pitch-count", "3000"), ("loop-capacity", "2000")]].concat());
        let run = ended(begun(&project, 1000.0));
        let end = run.ended_at().unwrap();
        // From the time at which X is at its speed.
        let most = (0..2000).map(|at| loop_at(&project, &run, 3.0 + (end - 3.0) * f64::from(at) / 2000.0));
        let most = most.fold(0.0, f64::max);
        let laid = ["slack-start", "slack-run"].map(|id| value(&project, id).abs());
        let set_point = value(&project, "dancer-set-point");
        assert!(most <= set_point + 1.05 * (laid[0] + laid[1]) + 20.0, "{entries:?}: {most} of {laid:?}");
    }
}

#[test]
fn feed_per_revolution_leaves_nothing_to_trim() {
    let in_step = [("feed-form", "per-revolution"), ("spindle-encoder", "true"), ("dwell", "0")];
    assert!(line(&[]).prepared().plant().spindle.regulator.is_some());
    let project = line(&in_step);
    assert!(project.prepared().plant().spindle.regulator.is_none());
    let without = project.with_entries(&[("dancer", "false")]).unwrap();
    for id in ["slack-rate", "slack-run", "loop-needed"] {
        assert_eq!(value(&project, id), value(&without, id), "{id}");
    }
}

#[test]
fn steady_line_gives_no_further_ramps() {
    let project = line(&[]);
    let run = held(&project, &[], 600.0);
    let ramps = |from: f64, to: f64| run.timeline().run_segments(Mover::Spindle, from, to).len();
    assert!(ramps(0.0, 100.0) < 200, "{}", ramps(0.0, 100.0));
    assert!(ramps(200.0, 600.0) < 20, "{}", ramps(200.0, 600.0));
}
