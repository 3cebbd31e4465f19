//! Projects, results and runs as the tests query them, and comparisons of numbers.

use macroline::interp::Interp;
use macroline::machines::form::Values;
use macroline::machines::{self, AnyMachine};
use macroline::motion::{Planner, Snapshot};
use macroline::project::Project;
use macroline::project::size::{Sizing, SizingRuns, size, size_without_envelope};
use macroline::view::Readout;

/// Each machine, with the values of a new project, on each of its controls.
pub(crate) fn every_machine_on_every_control() -> impl Iterator<Item = Project> {
    machines::ALL.iter().flat_map(|machine| {
        machine
            .controls()
            .iter()
            .map(|control| Project::of(machine.id(), Some(control)).expect("a machine on a control"))
    })
}

/// Machine and control of a project, for messages of a test.
pub(crate) fn machine_on_control(project: &Project) -> String {
    format!("{} on {}", project.machine.id(), project.control.id)
}

/// A result of the design by its id.
pub(crate) fn readout(project: &Project, id: &str) -> Readout {
    project.design().readouts.into_iter().find(|row| row.id == id).unwrap_or_else(|| panic!("no result {id}"))
}

/// The number of a result.
pub(crate) fn value(project: &Project, id: &str) -> f64 {
    readout(project, id).value
}

/// A number that differs from another one by `within` at most.
#[track_caller]
pub(crate) fn near(value: f64, wanted: f64, within: f64) {
    assert!((value - wanted).abs() <= within, "{value}, expected {wanted} ± {within}: off {:e}", value - wanted);
}

/// A number that differs from another one by this share of it at most.
#[track_caller]
pub(crate) fn near_share(value: f64, wanted: f64, share: f64) {
    assert!((value - wanted).abs() <= share * wanted.abs(), "{value}, expected {wanted} to a share of {share}");
}

/// The sizing of a project with the programs as exported.
pub(crate) fn sized(project: &Project) -> Sizing {
    size(project, &project.written())
}

/// The sizing without the operating envelope.
pub(crate) fn sized_without_envelope(project: &Project) -> Sizing {
    size_without_envelope(project, &SizingRuns::new(project, &project.written()))
}

/// Cells of the table of stops.
pub(crate) fn stop_table(project: &Project) -> Vec<Vec<String>> {
    let sheet = project.prepared().sheets().into_iter().find(|sheet| sheet.id == "stops").expect("a table of stops");
    sheet.rows.into_iter().map(|row| row.cells).collect()
}

/// Entries of a form as typed, by their fields.
pub(crate) fn values(machine: &dyn AnyMachine, changes: &[(&str, &str)]) -> Values {
    let fields = machine.fields();
    let read = |(id, typed): &(&str, &str)| {
        let field = fields.iter().find(|field| field.id == *id).unwrap_or_else(|| panic!("no field {id}"));
        ((*id).to_owned(), field.read_metric(typed).unwrap_or_else(|problem| panic!("{id}: {problem:?}")))
    };
    changes.iter().map(read).collect()
}

/// The first time (s), in steps of 0.1 ms from `t`, at which the machine is in a state.
pub(crate) fn first_at(planner: &Planner<Interp>, mut t: f64, holds: impl Fn(&Snapshot) -> bool) -> f64 {
    while !holds(&planner.timeline().at(t)) {
        t += 1e-4;
        assert!(t < planner.timeline().end(), "never holds");
    }
    t
}

/// The exported report of a project, as Markdown.
pub(crate) fn report_text(project: &Project) -> String {
    let files = project.export().files.into_iter().map(|exported| exported.file);
    files.into_iter().find(|file| file.name.ends_with(".md")).expect("a report").text
}
