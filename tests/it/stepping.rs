//! Stepping through programs: commands and their answers; the stepped run equals the run itself.

mod values;
mod walks;

use std::rc::Rc;

use expect_test::Expect;
use macroline::controls::{Control, Switches, find};
use macroline::machines::form::Value;
use macroline::motion::{Action, Budget, Event, Panel, Retention, RunEnd};
use macroline::nc::{self, Files};
use macroline::project::Project;
use macroline::project::debugger::breakpoints::{Breakpoints, Location};
use macroline::project::debugger::console::{Console, Outcome};
use macroline::project::debugger::stepping::{Debugger, Goal, Stop};
use macroline::project::findings::render::{self, Renderer};
use macroline::project::run::{self, Run, RunOptions};
use macroline::text::FileId;
use proptest::prelude::*;

const LIMITS: Budget = Budget { blocks: 100_000, seconds: 100.0 };

fn e60() -> &'static Control {
    find("mitsubishi-e60").unwrap()
}

fn bench(files: &Files, panel: Panel) -> Run {
    bench_with(files, &Switches::default(), panel)
}

fn bench_with(files: &Files, switches: &Switches, panel: Panel) -> Run {
    let begin = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Both };
    run::of_programs(Rc::new(nc::parse_with(files, e60(), switches)), None, panel, &begin)
}

/// Answers to a script of commands, each command after a `>`.
fn talk(console: &mut Console, script: &str) -> String {
    let mut out = String::new();
    for line in script.lines() {
        let (outcome, answer) = console.line(line);
        let mark = if outcome == Outcome::Wrong { "> ?" } else { "> " };
        out += &format!("{mark}{line}\n{answer}");
    }
    out
}

#[track_caller]
fn check(program: &str, script: &str, expected: Expect) {
    check_with(&[], program, script, expected);
}

#[track_caller]
fn check_with(switches: &[(&str, &str)], program: &str, script: &str, expected: Expect) {
    let files = Files::one("a.nc", program);
    let switches = Switches(switches.iter().map(|(id, value)| (id.to_string(), value.to_string())).collect());
    let mut console = Console::new(bench_with(&files, &switches, Panel::default()), Renderer::new(&files));
    expected.assert_eq(&talk(&mut console, script));
}

const CALLS: &str = "\
O1000
N10 #100=3
N20 G65 P2000 A1. B2.
N30 M98 P3000 L2
N40 G01 X10. F1000
N50 M30
O2000
N10 #3=#1+#2
N20 #101=#3
N30 M99
O3000
N10 #102=#102+1
N20 G65 P2000 A#102
N30 M99
%
";

#[test]
fn help_lists_every_command() {
    let files = Files::one("a.nc", CALLS);
    let mut console = Console::new(bench(&files, Panel::default()), Renderer::new(&files));
    let (_, help) = console.line("help");
    let commands: Vec<&str> = help.lines().filter(|line| !line.starts_with(' ')).collect();
    assert!(commands.len() > 5, "{help}");
    for line in commands {
        let command = line.split([' ', ',']).next().unwrap();
        let (_, answer) = console.line(command);
        assert!(!answer.starts_with("There is no command"), "{command}: {answer}");
    }
    assert_eq!(console.line("step").0, Outcome::Wrong);
}

#[test]
fn fault_of_the_inverter_ends_only_once_cleared_and_reset() {
    let project = Project::named("ribbon-line", None, Some("paper")).unwrap();
    let limits = Budget { blocks: u64::MAX, seconds: 60.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Both };
    let files = project.written().files;
    let mut console = Console::new(run::of_project(&project, &project.written(), &begin), Renderer::new(&files));
    (0..40).for_each(|_| drop(console.line("into")));
    let alarm = "the control stops with an alarm\n";
    for (line, answer) in [
        ("fault", alarm),
        ("reset", alarm),
        ("start", alarm),
        ("fault off", alarm),
        ("reset", "the control waits for the operator: “start” goes on\n"),
    ] {
        let (outcome, reply) = console.line(line);
        assert!(outcome == Outcome::Done && reply.starts_with(answer), "{line}: {reply}");
    }
    let (_, reply) = console.line("start");
    assert!(!reply.contains("alarm") && !reply.contains("waits"), "{reply}");
    assert_eq!(console.line("fault there").0, Outcome::Wrong);
}

#[test]
fn zero_returns_to_the_reference_point_at_the_end() {
    let files = Files::one("a.nc", "O0001\nG00 X60. Z40.\nG50 S2000\nG00 X20. Z5.\nM30\n%\n");
    let begin = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Both };
    let parsed = Rc::new(nc::parse(&files, find("gsk-980tdc").unwrap()));
    let mut console = Console::new(run::of_programs(parsed, None, Panel::default(), &begin), Renderer::new(&files));
    for (lines, x) in [(["continue", "zero"], "60"), (["start", "continue"], "20"), (["where", "zero"], "60")] {
        let [_, (_, reply)] = lines.map(|line| console.line(line));
        assert!(reply.starts_with("the program is over\n"), "{lines:?}: {reply}");
        assert_eq!(console.line("print #5041").1, format!("#5041 = {x}\n"), "{lines:?}");
    }
}

fn reach(debugger: &mut Debugger, points: &mut Breakpoints, goal: Goal) -> Stop {
    debugger.go(goal);
    arrive(debugger, points)
}

fn arrive(debugger: &mut Debugger, points: &mut Breakpoints) -> Stop {
    (0..10_000_000).find_map(|_| debugger.advance(points, f64::INFINITY, 1)).unwrap()
}

/// The ribbon line with an operator who turns a knob, holds and starts again, planned for a time.
fn ribbon(seconds: f64) -> Run {
    let mut project = Project::named("ribbon-line", None, Some("paper")).unwrap();
    // After the hold the axes wait as long as after M3.
    project.values.insert("dwell".to_owned(), Value::Number(0.2));
    for (t, action) in [(0.4, Action::SpindleOverride(60.0)), (0.9, Action::Hold), (1.3, Action::Start)] {
        project.panel.add(Event { t, action });
    }
    let limits = Budget { blocks: u64::MAX, seconds };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut main = run::of_project(&project, &project.written(), &begin);
    while main.advance(seconds, 100_000).ended.is_none() {}
    main
}

/// Observable state of a run at some moments.
fn seen(run: &Run, from: f64, to: f64) -> Vec<String> {
    let at = |k: u32| from + (to - from) * f64::from(k) / 100.0;
    (0..=100).map(|k| format!("{:?}", run.timeline().at(at(k)))).collect()
}

#[test]
fn stepping_gives_the_log_of_the_run() {
    let main = ribbon(2.5);
    let mut points = Breakpoints::default();
    let mut debugger = Debugger::new(&main, 0.3, Goal::Into);
    assert_eq!(arrive(&mut debugger, &mut points), Stop::Reached);
    assert!(debugger.t() >= 0.3 && debugger.t() < 0.32, "{}", debugger.t());
    // Block by block over two seconds, the machine is where the run has it, in the block that the run executes.
    let mut steps = 0;
    while debugger.t() < 2.3 {
        let t = debugger.t();
        assert_eq!(debugger.run().timeline().at(t), main.timeline().at(t));
        for number in [100, 105, 110, 115, 1033] {
            let value = debugger.evaluate(&format!("#{number}")).unwrap();
            // The run has read this block at this very time.
            let shown = main.variable_at(number, t.next_down());
            assert_eq!(value, shown.or(value.filter(|v| *v == 0.0)), "#{number} at {t}");
        }
        assert_eq!(reach(&mut debugger, &mut points, Goal::Into), Stop::Reached);
        assert!(debugger.t() >= t);
        steps += 1;
    }
    assert!(steps > 50, "{steps}");
    let from = debugger.t() - 0.1;
    assert_eq!(seen(debugger.run(), from, debugger.t()), seen(&main, from, debugger.t()));
    assert_eq!(reach(&mut debugger, &mut points, Goal::Continue), Stop::Ended(RunEnd::Seconds));
}

#[test]
fn stepping_back_restores_the_state() {
    let main = ribbon(4.0);
    let mut points = Breakpoints::default();
    let mut debugger = Debugger::new(&main, 1.0, Goal::Into);
    arrive(&mut debugger, &mut points);
    let look = |debugger: &Debugger| {
        let values = ["#100", "#105", "#115", "#5021", "#3001"].map(|text| debugger.evaluate(text));
        let levels = debugger.levels();
        // A vacant value is not equal to itself, so the state is compared as text.
        format!("{:?}", (debugger.t(), debugger.place(), debugger.executing(), levels, debugger.changes(), values))
    };
    let mut been = Vec::new();
    for _ in 0..150 {
        reach(&mut debugger, &mut points, Goal::Into);
        been.push(look(&debugger));
    }
    for there in been.iter().rev().skip(1) {
        assert!(debugger.back(&main));
        assert_eq!(arrive(&mut debugger, &mut points), Stop::Reached);
        assert_eq!(look(&debugger), *there);
    }
    // At the very beginning there is no block to step back to.
    let mut first = Debugger::new(&main, 0.0, Goal::Into);
    arrive(&mut first, &mut points);
    assert!(!first.back(&main));
}

#[test]
fn breakpoints_follow_their_blocks_through_edits() {
    let before = nc::parse(&Files::one("a.nc", CALLS), e60());
    let after = nc::parse(&Files::one("a.nc", CALLS.replace("N40", "N38\nN40")), e60());
    let mut points = Breakpoints::default();
    points.add(Location::Sequence { program: 1000, number: Some(40) }, "#100 EQ 3", &before).unwrap();
    points.add(Location::Line { file: FileId(0), line: 99 }, "", &before).unwrap();
    let line = 1 + CALLS.lines().position(|line| line.starts_with("N40")).unwrap() as u32;
    points.add(Location::Line { file: FileId(0), line }, "", &before).unwrap();
    points.resolve(&after);
    let place = points.list()[0].place.unwrap();
    assert_eq!(after.text(place), "N40 G01 X10. F1000");
    assert_eq!(points.list()[1].place, None);
    // A line is found by its text; where that is another, by its number; in no other file.
    let line_of = |points: &Breakpoints| points.list()[2].place.map(|place| after.text(place).to_owned());
    assert_eq!(line_of(&points).as_deref(), Some("N40 G01 X10. F1000"));
    let other = nc::parse(&Files::one("b.nc", CALLS), e60());
    points.resolve(&other);
    assert_eq!(points.list()[2].place, None);
    let changed = nc::parse(&Files::one("a.nc", CALLS.replace("N40", "N38\nN41")), e60());
    points.resolve(&changed);
    assert_eq!(points.list()[2].place.map(|place| changed.text(place)), Some("N41 G01 X10. F1000"));
    assert!(points.add(Location::Line { file: FileId(0), line: 1 }, "#1 EQ", &before).is_err());
}

#[test]
fn expression_errors_have_no_place_in_the_program() {
    let files = Files::one("a.nc", CALLS);
    let mut debugger = Debugger::new(&bench(&files, Panel::default()), 0.0, Goal::Into);
    arrive(&mut debugger, &mut Breakpoints::default());
    let why = debugger.evaluate("SQRT[-4]").unwrap_err();
    assert_eq!((render::headline(&why), why.place), ("error[P282]: SQRT of -4 has no value.".to_owned(), None));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    /// Any input gets an answer.
    #[test]
    fn any_console_line_gets_an_answer(lines in prop::collection::vec("(into|over|out|to|break|watch|print|set|back|start|c|clear|on)?[ #\\[\\]NOI0-9A-Z+*/.=-]{0,12}", 1..20)) {
        let files = Files::one("a.nc", CALLS);
        let mut console = Console::new(bench(&files, Panel::default()), Renderer::new(&files));
        talk(&mut console, &lines.join("\n"));
    }

    /// Any text as an expression has a value or a reason.
    #[test]
    fn any_watch_expression_gets_an_answer(text in "\\PC{0,40}") {
        for control in macroline::controls::ALL {
            let program = nc::parse(&Files::one("a.nc", ""), control);
            if let Err(why) = nc::formula(&text, &program) {
                let place = why.place.unwrap().span;
                prop_assert!(place.start <= place.end && place.end as usize <= text.len(), "{why:?}");
            }
        }
    }
}
