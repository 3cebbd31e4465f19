//! The chance that every verdict holds, against the share that follows from one fact alone.

use macroline::machines::form::{FieldRole, Provenance, Value};
use macroline::project::Project;
use macroline::project::chance::{chance, chance_with_progress};
use macroline::project::size::{size, size_with_progress};

/// A line whose facts are all measured.
fn measured() -> Project {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    for field in project.machine.fields().iter().filter(|field| field.role.is_fact()) {
        project.provenance.insert(field.id.to_owned(), Provenance::Measured);
    }
    project
}

#[test]
fn one_assumed_fact_gives_the_share_of_its_range() {
    let mut project = measured().with_entries(&[("knob-lowest", "10")]).unwrap();
    let needed = project.design().readouts.iter().find(|row| row.id == "loop-turned").unwrap().value;
    // Loops are drawn from 0.9 to 1.1 of this one; loops below 0.95 of it are too small, a quarter of the range.
    project.values.insert("loop-capacity".to_owned(), Value::Number((10.0 * needed / 0.95).round() / 10.0));
    project.provenance.remove("loop-capacity");
    let found = chance(&project, 4000, 7);
    assert_eq!((found.draws, found.facts), (4000, 1));
    assert!((found.probability() - 0.75).abs() < 0.03, "{found:?}");
    assert_eq!(found.failing.iter().map(|row| row.0).collect::<Vec<_>>(), ["loop-turned"]);
    assert_eq!(found.failing[0].2 + found.hold, 4000);
}

#[test]
fn without_assumed_facts_the_design_decides() {
    let mut project = measured();
    let of = |project: &Project| chance(project, 5, 1);
    assert_eq!((of(&project).facts, of(&project).hold), (0, 5));
    project.values.insert("loop-capacity".to_owned(), Value::Number(1.0));
    assert_eq!(of(&project).hold, 0);
}

#[test]
fn seed_decides_which_machines_are_drawn() {
    let project = Project::named("ribbon-line", None, None).unwrap();
    let counts = |seed: u64| {
        let found = chance(&project, 300, seed);
        (found.hold, found.failing)
    };
    assert_eq!(counts(3), counts(3));
    assert!((4..8).any(|seed| counts(seed) != counts(3)));
}

#[test]
fn draws_and_sizing_report_their_progress() {
    let project = Project::named("ribbon-line", None, None).unwrap();
    let (mut drawn, mut sized) = (Vec::new(), Vec::new());
    let found = chance_with_progress(&project, 1200, 1, &mut |share| drawn.push(share));
    assert_eq!((found == chance(&project, 1200, 1), drawn), (true, vec![0.0, 500.0 / 1200.0, 1000.0 / 1200.0]));
    let found = size_with_progress(&project, &project.written(), &mut |share| sized.push(share));
    assert_eq!(found, size(&project, &project.written()));
    assert!(sized.is_sorted() && sized.len() > 8, "{sized:?}");
    assert_eq!((sized.first(), sized.last()), (Some(&0.0), Some(&1.0)));
}

#[test]
fn settings_and_counts_are_not_drawn() {
    let mut project = Project::named("ribbon-line", None, None).unwrap();
    let fails = chance(&project, 300, 1).failing;
    // Time constants that differ between the axes would fail it always: both are set at the control.
    assert!(fails.iter().all(|row| row.0 != "register-error"), "{fails:?}");
    // A clamp of X little above the speed of the line flips a verdict.
    project.values.insert("clamp-x".to_owned(), Value::Number(20_000.0));
    let tried = size(&project, &project.written()).sensitivities;
    let settings: Vec<_> = project
        .machine
        .fields()
        .into_iter()
        .filter(|field| field.role == FieldRole::ExactFact)
        .map(|field| field.id)
        .collect();
    assert!(!tried.is_empty() && !settings.is_empty());
    assert!(tried.iter().all(|flip| !settings.contains(&flip.field)), "{tried:?}");
}
