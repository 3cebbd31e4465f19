//! Speed of computing the section of a polygon.
#![allow(clippy::unwrap_used, reason = "a bench stops at a fault")]

mod summary;

use std::hint::black_box;

use criterion::{Criterion, Throughput};
use macroline::drives::polygon::{CutterSetup, Ratio, Section};
use macroline::machines::form::Value;
use macroline::project::Project;

/// Angles of a full section.
const ANGLES: u64 = 36_000;

/// Twelve inserts at ratio 12/5: 144 sides.
fn twelve() -> CutterSetup {
    CutterSetup::even(20.0, 45.0, Ratio::new(12, 5).unwrap(), 12)
}

/// The same with inserts that are all a little out of their places, so that nothing repeats.
fn worn() -> CutterSetup {
    let mut setup = twelve();
    for (tip, off) in setup.tips.iter_mut().zip([3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8]) {
        tip.radius += 0.001 * f64::from(off);
    }
    setup
}

fn section(setup: &CutterSetup) -> Vec<f64> {
    Section::new(black_box(setup), 10.2).unwrap().radii(ANGLES as usize)
}

fn speed(c: &mut Criterion) {
    let mut group = c.benchmark_group("polygon");
    group.sample_size(20);
    group.throughput(Throughput::Elements(ANGLES));
    let (even, worn) = (twelve(), worn());
    group.bench_function("full section", |b| b.iter(|| section(&even)));
    group.bench_function("full section, worn inserts", |b| b.iter(|| section(&worn)));
    group.bench_function("outline without radii", |b| b.iter(|| Section::new(black_box(&even), 10.2)));
    group.finish();
}

/// A value of the form is dragged: results with advice, and the drawing. The hollow sides ask for the list of better ways.
fn drag(project: &Project) -> usize {
    let design = black_box(project).design();
    design.readouts.len() + project.prepared().scene().nodes.len()
}

/// A polygon lathe whose inserts turn five to twelve, badly.
fn lathe() -> Project {
    let mut project = Project::of("polygon-lathe", None).unwrap();
    project.values.insert("shape".to_owned(), Value::Text("own".to_owned()));
    for (id, value) in
        [("inserts", 5.0), ("work-ratio", 5.0), ("tool-ratio", -12.0), ("most-inserts", 12.0), ("most-work-turns", 9.0)]
    {
        project.values.insert(id.to_owned(), Value::Number(value));
    }
    project
}

fn main() {
    speed(&mut Criterion::default().configure_from_args());
    // 5 ms for a section.
    let asked = Some(ANGLES as f64 / 5e-3);
    let (even, worn) = (twelve(), worn());
    summary::line("polygon, 12 inserts at ratio 12/5, full section", ANGLES, "angles", asked, || section(&even));
    summary::line("polygon, the same with worn inserts", ANGLES, "angles", None, || section(&worn));
    // 60 values a second, and half of the time for the page.
    let lathe = lathe();
    summary::line("polygon lathe, one step of dragging", 1, "steps", Some(120.0), || drag(&lathe));
}
