//! Speed of the same programs natively and in wasm under Node (`scripts/both.mjs` compares).
#![allow(clippy::unwrap_used, reason = "a bench stops at a fault")]

mod summary;
#[allow(dead_code, reason = "each bench takes a part of it")]
mod work;

use std::hint::black_box;

use macroline::drives::polygon::{CutterSetup, Ratio, Section};
use macroline::motion::{Budget, Panel, Retention};
use macroline::nc::Files;
use macroline::project::Project;
use macroline::project::chance::chance;
use macroline::project::run::{AtStop, RunOptions, of_programs, to_end};
use macroline::project::size::{SizingRuns, size, size_without_envelope};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::Criterion;
use work::{COUNT, flat, formulas, parse, run};

/// Reads, runs and plans on the control's bench; machine time at the end.
fn plan(files: &Files) -> f64 {
    let begin = RunOptions {
        start: None,
        settings: &[],
        limits: Budget { blocks: u64::MAX, seconds: 1e9 },
        keep: Retention::Log,
    };
    let mut planner = of_programs(parse(files), None, Panel::default(), &begin);
    to_end(&mut planner, AtStop::End, |_| Ok::<(), ()>(())).unwrap().time
}

/// Angles of a full section.
const ANGLES: u64 = 36_000;

/// Seconds that a section may take.
const ASKED: f64 = if cfg!(target_arch = "wasm32") { 10e-3 } else { 5e-3 };

/// The section that twelve inserts turn at ratio 12/5: 144 sides.
fn section() -> Vec<f64> {
    let setup = CutterSetup::even(20.0, 45.0, Ratio::new(12, 5).unwrap(), 12);
    Section::new(black_box(&setup), 10.2).unwrap().radii(ANGLES as usize)
}

/// The first machine: design, choice of motors, sensitivities and inverse, by runs that are already planned.
fn sized(project: &Project, runs: &SizingRuns) -> usize {
    project.design().readouts.len() + size_without_envelope(project, runs).axes.len()
}

fn sizing() {
    let project = Project::of("ribbon-line", None).unwrap();
    let runs = SizingRuns::new(&project, &project.written());
    let motors: usize = size_without_envelope(&project, &runs).axes.iter().map(|axis| axis.candidates.len()).sum();
    // 10 ms natively, 25 ms in wasm, with 50 motors.
    assert!(motors >= 50, "{motors} motors");
    let asked = if cfg!(target_arch = "wasm32") { 1.0 / 25e-3 } else { 1.0 / 10e-3 };
    summary::line("sizing, design with every motor", 1, "designs", Some(asked), || sized(&project, &runs));
    let written = project.written();
    summary::line("sizing, with the runs of the envelope", 1, "sizings", Some(0.5), || size(&project, &written));
    summary::line("sizing, machines drawn", 1000, "machines", Some(1e4 / 3.0), || chance(&project, 1000, 1));
}

fn figures() {
    sizing();
    let (flat, formulas) = (flat(COUNT), formulas());
    summary::line("flat blocks, text to canon", COUNT, "blocks", None, || run(&parse(&flat)));
    summary::line("O9100 passes, text to canon", COUNT, "passes", None, || run(&parse(&formulas)));
    summary::line("flat blocks, planned", COUNT, "blocks", None, || plan(&flat));
    let asked = Some(ANGLES as f64 / ASKED);
    summary::line("polygon, 12 inserts at ratio 12/5, full section", ANGLES, "angles", asked, section);
}

#[cfg(target_arch = "wasm32")]
#[wasm_bindgen_test::wasm_bindgen_bench]
fn both(_: &mut Criterion) {
    figures();
}

fn main() {
    #[cfg(not(target_arch = "wasm32"))]
    figures();
}
