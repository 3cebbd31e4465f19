//! What is as fast in the browser: the same programs natively and in wasm under Node (`scripts/both.mjs` compares).
#![allow(clippy::unwrap_used, missing_docs)]

mod summary;
#[allow(dead_code)]
mod work;

use std::hint::black_box;

use macroline::drives::polygon::{CutterSetup, Ratio, Section};
use macroline::motion::{Budget, Panel, Retention};
use macroline::nc::Files;
use macroline::project::run::{AtStop, RunOptions, of_programs, to_end};
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

fn figures() {
    let (flat, formulas) = (flat(COUNT), formulas());
    summary::line("flat blocks, text to canon", COUNT, "blocks", None, || run(&parse(&flat)));
    summary::line("P9100 passes, text to canon", COUNT, "passes", None, || run(&parse(&formulas)));
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
