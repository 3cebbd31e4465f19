//! Sections of a sizing: each answer states what its sheets show.

use std::collections::BTreeSet;

use macroline::machines::ALL;
use macroline::machines::form::Value;
use macroline::project::Project;
use macroline::project::size::sections::SizingSection;
use macroline::project::size::{Sizing, size};
use macroline::text::catalog::words;
use macroline::view::Verdict;

fn sized(project: &Project) -> Sizing {
    size(project, &project.written())
}

#[track_caller]
fn section<'s>(sections: &'s [SizingSection], id: &str) -> &'s SizingSection {
    sections.iter().find(|section| section.id == id).unwrap_or_else(|| panic!("no section {id}"))
}

#[test]
fn every_machine_has_an_answer_in_every_section() {
    for machine in ALL {
        let sizing = sized(&Project::of(machine.id(), None).unwrap());
        let sections = sizing.sections();
        let ids: Vec<&str> = sections.iter().map(|section| section.id).collect();
        let axes = sizing.axes.iter().map(|axis| axis.id);
        let wanted: Vec<&str> =
            ["envelope", "limits"].into_iter().chain(axes).chain(["cycle", "tornado", "bill", "terminals"]).collect();
        assert_eq!(ids, wanted);
        for section in &sections {
            assert!(!section.answer.is_empty() && !section.sheets.is_empty(), "{}: {}", machine.id(), section.id);
        }
        for axis in &sizing.axes {
            let motor = sizing.bill.iter().find(|row| row.axis == Some(axis.name)).unwrap();
            assert!(section(&sections, axis.id).answer.contains(&motor.model), "{}", axis.id);
        }
        let bill = &section(&sections, "bill").answer;
        assert!(bill.starts_with(&format!("{} items, ", sizing.bill.len())), "{bill}");
    }
}

#[test]
fn quantity_nearest_its_limit_and_quantities_beyond_are_named() {
    let mut project = Project::of("ribbon-line", None).unwrap();
    let sizing = sized(&project);
    let most =
        sizing.envelope.iter().filter(|row| row.quantity.id() == "loop").map(|row| row.value).fold(0.0, f64::max);
    let within = sizing.sections();
    let within = section(&within, "envelope");
    assert_eq!(within.verdict, Verdict::Ok);
    let nearest = format!("Nearest: Loop {most:.1} mm of 600 mm").replace(".0 ", " ");
    assert!(within.answer.contains(&nearest), "{} {most}", within.answer);
    project.values.insert("loop-capacity".to_owned(), Value::Number(150.0));
    let sizing = sized(&project);
    let beyond = sizing.sections();
    let beyond = section(&beyond, "envelope");
    assert_eq!(beyond.verdict, Verdict::Fail);
    assert!(beyond.answer.starts_with("Beyond the limit: Loop: "), "{}", beyond.answer);
    let worst = beyond.sheets[0].rows.iter().find(|row| row.cells[0] == "Loop").unwrap();
    assert!(worst.cells[1].starts_with("✕ ") && worst.cells[2] == "≤ 150 mm", "{:?}", worst.cells);
}

#[test]
fn worst_of_all_events_has_no_sign_of_a_verdict() {
    let sizing = sized(&Project::of("ribbon-line", None).unwrap());
    let sections = sizing.sections();
    let cells = section(&sections, "envelope").sheets.iter().flat_map(|sheet| &sheet.rows).flat_map(|row| &row.cells);
    let marks: BTreeSet<char> =
        cells.filter_map(|cell| cell.strip_suffix(['▲', '●']).and(cell.chars().last())).collect();
    assert_eq!(marks.into_iter().map(String::from).collect::<Vec<_>>(), ["●"]);
    for id in ["sheet.envelope", "page.all-events"] {
        assert!(words(id).contains("● the worst") && words(id).contains(Verdict::Fail.sign()));
        assert!(!words(id).contains(Verdict::Warn.sign()), "{id}");
    }
}

#[test]
fn next_limit_has_the_least_margin() {
    let sizing = sized(&Project::of("ribbon-line", None).unwrap());
    let least = sizing.limits.iter().filter(|growth| growth.binding.is_some()).map(|growth| growth.margin);
    let least = 100.0 * least.fold(f64::INFINITY, f64::min);
    let answer = &section(&sizing.sections(), "limits").answer.clone();
    assert!(answer.contains(&format!("up to {least:.0} % more")), "{answer}");
}

#[test]
fn unsuitable_motor_fails_its_axis() {
    let mut project = Project::of("ribbon-line", None).unwrap();
    let ordered = sized(&project).sections();
    assert_eq!(section(&ordered, "x").verdict, Verdict::Ok);
    let set = [("motor-x", "Mitsubishi Electric HG-KR053".to_owned())];
    project = project.with_entries(&set).unwrap();
    project.values.insert("transport-friction".to_owned(), Value::Number(300.0));
    let sizing = sized(&project);
    let refused = sizing.bill.iter().any(|row| row.refusal.is_some());
    assert!(refused);
    assert!(sizing.sections().iter().any(|section| section.verdict == Verdict::Fail));
}
