//! Named examples: the first one without a failed verdict, and the papers' own with the faults that they name.

use std::collections::BTreeSet;

use macroline::controls;
use macroline::controls::Control;
use macroline::machines::form::Value;
use macroline::machines::{self, AnyMachine};
use macroline::motion::{Budget, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::examples::{NameKind, Unknown};
use macroline::project::origins::{Origin, values};
use macroline::project::run::{self, RunOptions};
use macroline::text::Severity;
use macroline::view::Verdict;

/// Every machine with each of its controls.
fn machines_on_controls() -> impl Iterator<Item = (&'static dyn AnyMachine, &'static Control)> {
    let controls = |machine: &&'static dyn AnyMachine| {
        let machine = *machine;
        machine.controls().iter().map(move |id| (machine, controls::find(id).unwrap()))
    };
    machines::ALL.iter().flat_map(controls)
}

fn verdicts(project: &Project, verdict: Verdict) -> BTreeSet<&'static str> {
    let readouts = project.design().readouts.into_iter();
    readouts.filter(|readout| readout.verdict == verdict).map(|readout| readout.id).collect()
}

/// The end of the run of a project.
fn end_of_run(project: &Project) -> RunEnd {
    let limits = Budget { blocks: 10_000_000, seconds: 3600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut planner = run::of_project(project, &project.written(), &begin);
    planner.advance(f64::INFINITY, usize::MAX).ended.expect("the run ends")
}

#[test]
fn first_example_has_neither_failure_nor_warning() {
    for (machine, control) in machines_on_controls() {
        let project = Project::new(machine, control);
        for verdict in [Verdict::Fail, Verdict::Warn] {
            assert!(
                verdicts(&project, verdict).is_empty(),
                "{} on {}: {:?}",
                machine.id(),
                control.id,
                verdicts(&project, verdict)
            );
        }
        let design = project.design();
        let found = design.diagnostics.iter().find(|found| found.severity != Severity::Info);
        assert_eq!(found, None, "{} on {}", machine.id(), control.id);
        assert!(machine.examples()[0].faults.is_empty());
    }
}

#[test]
fn examples_fail_in_exactly_the_named_results() {
    for machine in machines::ALL {
        for example in machine.examples() {
            let failed: Vec<_> = machine
                .controls()
                .iter()
                .map(|id| verdicts(&Project::example(*machine, controls::find(id).unwrap(), example), Verdict::Fail))
                .collect();
            for fault in example.faults {
                let times = failed.iter().filter(|failed| failed.contains(fault.result)).count();
                let place = format!("{} {}: {} fails on {times} controls", machine.id(), example.id, fault.result);
                assert!(times > 0 && (times == failed.len()) == fault.everywhere, "{place}");
            }
            let named: BTreeSet<_> = example.faults.iter().map(|fault| fault.result).collect();
            for failed in failed {
                assert!(failed.is_subset(&named), "{} {}: {failed:?}", machine.id(), example.id);
            }
        }
    }
}

#[test]
fn examples_run_to_their_end_unless_f_is_beyond_the_range() {
    for (machine, control) in machines_on_controls() {
        for example in machine.examples() {
            let project = Project::example(machine, control, example);
            let end = end_of_run(&project);
            let failed = verdicts(&project, Verdict::Fail);
            let place = format!("{} {} on {}: {end:?}", machine.id(), example.id, control.id);
            // Late blocks and slip fill the assumed loop of the published line, so its sensor holds the program.
            let held = (example.id, control.id) == ("paper", "sinumerik-808d");
            assert!(!held || failed.contains("loop-needed") && failed.contains("slack-rate"), "{place}: {failed:?}");
            assert_eq!(end == RunEnd::ProgramEnd, !held && !failed.contains("vector-feed"), "{place}");
        }
    }
}

#[test]
fn every_entry_of_an_example_is_taken_and_needed() {
    for machine in machines::ALL {
        let fields = machine.fields();
        for example in machine.examples() {
            for (id, typed) in example.entries {
                let field = fields.iter().find(|field| field.id == *id);
                let value = field.and_then(|field| field.read_metric(typed).ok());
                assert!(value.is_some(), "{} {}: {id}={typed}", machine.id(), example.id);
                assert_ne!(value, field.map(|field| field.default()), "{} {}: {id}", machine.id(), example.id);
            }
        }
    }
}

#[test]
fn ids_of_examples_differ_and_values_identify_each() {
    for (machine, control) in machines_on_controls() {
        let ids: BTreeSet<_> = machine.examples().iter().map(|example| example.id).collect();
        assert!(!ids.is_empty() && ids.len() == machine.examples().len(), "{}", machine.id());
        for example in machine.examples() {
            let mut project = Project::example(machine, control, example);
            assert_eq!(project.present_example().map(|found| found.id), Some(example.id));
            project.values.insert("product".to_owned(), Value::Text("OTHER".to_owned()));
            assert!(project.present_example().is_none() && project.faults().is_empty());
        }
    }
}

#[test]
fn example_follows_its_machine_to_another_control() {
    // Choosing another control of the page keeps the values.
    for machine in machines::ALL {
        let mut project = Project::of(machine.id(), None).unwrap();
        for id in machine.controls() {
            project.move_to(controls::find(id).unwrap());
            assert!(verdicts(&project, Verdict::Fail).is_empty(), "{} on {id}", machine.id());
            assert_eq!(end_of_run(&project), RunEnd::ProgramEnd, "{} on {id}", machine.id());
        }
    }
}

#[test]
fn paper_of_the_ribbon_line_has_the_printed_values() {
    let project = Project::named("ribbon-line", None, Some("paper")).unwrap();
    let printed = [
        ("spindle-speed", 1200.0),
        ("reduction-ratio", 25.0),
        ("press-roller-diameter", 100.0),
        ("pitch", 8.0),
        ("heads", 6.0),
        ("print-roller-diameter", 120.0),
        ("speed-at-10v", 1480.0),
    ];
    for (id, value) in printed {
        assert_eq!(project.values.get(id), Some(&Value::Number(value)), "{id}");
    }
    // K = 3.14 · 102 / 101, #105 = K · 1200, #110 = 3.14 · 120 / 6.
    for (id, value) in [("k", 12.56), ("line-speed", 15072.0), ("y-stroke", 62.8)] {
        let readout = project.design().readouts.into_iter().find(|readout| readout.id == id).unwrap();
        assert!((readout.value - value).abs() < 1e-9, "{id}: {}", readout.value);
    }
    let failing: Vec<_> = project.faults().into_iter().map(|(readout, _)| readout.id).collect();
    assert_eq!(
        failing,
        [
            "block-time",
            "surface-ratio",
            "smear",
            "slack-rate",
            "slack-rate-rated",
            "loop-needed",
            "loop-turned",
            "loop-coasting",
            "tension"
        ]
    );
}

#[test]
fn paper_of_the_polygon_lathe_runs_as_o3000() {
    let project = Project::named("polygon-lathe", None, Some("paper")).unwrap();
    let program = project.written().files.0.iter().map(|file| file.text.clone()).collect::<String>();
    assert!(program.contains("G512 B200. D1 Q2 A0. E0."), "{program}");
    assert!(program.contains("F200"), "{program}");
}

#[test]
fn unknown_names_are_refused_with_the_known_ones() {
    let refused = |machine, control, example| Project::named(machine, control, example).err();
    let known = |kind, known: &[&'static str]| Some(Unknown { kind, known: known.to_vec() });
    let all: Vec<_> = machines::ALL.iter().map(|machine| machine.id()).collect();
    assert_eq!(refused("press", None, None), known(NameKind::Machine, &all));
    assert_eq!(refused("polygon-lathe", Some("gsk-980tdc"), None), known(NameKind::Control, &["knd-k2000t"]));
    let examples: Vec<_> = machines::find("ribbon-line").unwrap().examples().iter().map(|example| example.id).collect();
    assert_eq!(refused("ribbon-line", None, Some("Paper")), known(NameKind::Example, &examples));
}

#[test]
fn origin_of_a_choice_is_default_example_or_entered() {
    let origin = |project: &Project, id: &str| values(project).into_iter().find(|(input, _)| input.id == id).unwrap().1;
    let fresh = Project::of("ribbon-line", None).unwrap();
    let mut paper = Project::named("ribbon-line", None, Some("paper")).unwrap();
    assert_eq!((origin(&fresh, "pitch"), origin(&fresh, "heads")), (Origin::Default, Origin::Assumed));
    assert_eq!((origin(&paper, "pitch"), origin(&paper, "pitch-count")), (Origin::Example, Origin::Default));
    paper.values.insert("pitch".to_owned(), Value::Number(9.0));
    assert_eq!(origin(&paper, "pitch"), Origin::Entered);
}
