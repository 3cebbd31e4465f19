//! One line a figure behind the details: its rate, what is asked of it, and its ratio to a calibration loop of the same run.

use std::hint::black_box;

/// The host: its clock in seconds, and its console.
#[cfg(not(target_arch = "wasm32"))]
mod host {
    use std::sync::LazyLock;
    use std::time::Instant;

    static START: LazyLock<Instant> = LazyLock::new(Instant::now);

    pub(super) fn now() -> f64 {
        START.elapsed().as_secs_f64()
    }

    #[allow(clippy::print_stdout, reason = "its figures are for people")]
    pub(super) fn say(line: &str) {
        println!("{line}");
    }
}

#[cfg(target_arch = "wasm32")]
mod host {
    use wasm_bindgen::prelude::*;

    #[wasm_bindgen]
    extern "C" {
        #[wasm_bindgen(js_namespace = performance, js_name = now)]
        fn milliseconds() -> f64;
        #[wasm_bindgen(js_namespace = console, js_name = log)]
        pub(super) fn say(line: &str);
    }

    pub(super) fn now() -> f64 {
        milliseconds() / 1000.0
    }
}

/// Times that are measured; their median counts.
const TIMES: usize = 9;

/// What other figures are judged by: a chain of 100,000 square roots, each waiting for the one before.
fn calibration() -> f64 {
    (0..100_000).fold(black_box(2.0_f64), |x, _| (x + 1.0).sqrt())
}

/// Median of the seconds that `work` takes.
fn median<R>(mut work: impl FnMut() -> R) -> f64 {
    let mut seconds: Vec<f64> = (0..TIMES)
        .map(|_| {
            let start = host::now();
            black_box(work());
            host::now() - start
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    seconds[TIMES / 2]
}

/// Prints how many `unit`s a second `work` does where one call does `count`, and how many calibration loops a call takes.
pub(crate) fn line<R>(what: &str, count: u64, unit: &str, at_least: Option<f64>, work: impl FnMut() -> R) {
    let (loops, seconds) = (median(calibration), median(work));
    let rate = count as f64 / seconds;
    let asked = at_least.map_or(String::new(), |least| {
        format!("; at least {least:.0} asked: {}", if rate >= least { "met" } else { "MISSED" })
    });
    host::say(&format!("summary: {what}: {rate:.0} {unit}/s, {:.3} calibration loops a call{asked}", seconds / loops));
}
