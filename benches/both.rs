//! What is as fast in the browser: the same programs natively and in wasm under Node (`scripts/both.mjs` compares).
#![allow(clippy::unwrap_used, missing_docs)]

mod summary;
#[allow(dead_code)]
mod work;

use macroline::motion::{Keep, Limits, Panel};
use macroline::nc::Files;
use macroline::project::run::{Begin, of_programs, to_end};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::Criterion;
use work::{COUNT, flat, formulas, parse, run};

/// Reads, runs and plans on the control's bench; machine time at the end.
fn plan(files: &Files) -> f64 {
    let begin =
        Begin { start: None, settings: &[], limits: Limits { blocks: u64::MAX, seconds: 1e9 }, keep: Keep::Log };
    let mut planner = of_programs(parse(files), None, Panel::default(), &begin);
    to_end(&mut planner, |_| Ok::<(), ()>(())).unwrap().time
}

fn figures() {
    let (flat, formulas) = (flat(COUNT), formulas());
    summary::line("flat blocks, text to canon", COUNT, "blocks", None, || run(&parse(&flat)));
    summary::line("P9100 passes, text to canon", COUNT, "passes", None, || run(&parse(&formulas)));
    summary::line("flat blocks, planned", COUNT, "blocks", None, || plan(&flat));
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
