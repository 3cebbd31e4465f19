//! Native code and wasm under Node compute the same to the bit: the same goldens for both, decimals to read and checksums over all bits.
//!
//! `UPDATE_EXPECT=1 cargo test --test parity` writes the goldens natively; `make test-wasm` compares wasm with them.
#![allow(clippy::unwrap_used, reason = "a test stops at a fault")]

use std::fmt::Write as _;
use std::rc::Rc;

use macroline::controls;
use macroline::machines;
use macroline::machines::form::Value;
use macroline::math;
use macroline::motion::{Action, Budget, Event, Panel, Retention, Snapshot};
use macroline::nc::{self, Files};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::text::catalog::{Language, speak};
use macroline::view;

/// File access: the standard library natively, Node in wasm.
#[cfg(not(target_arch = "wasm32"))]
mod host {
    pub(super) fn read(path: &str) -> String {
        std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}"))
    }

    pub(super) fn names(folder: &str) -> Vec<String> {
        let entries = std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{folder}: {error}"));
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    pub(super) fn update(path: &str, text: &str) {
        if std::env::var_os("UPDATE_EXPECT").is_some() {
            std::fs::write(path, text).unwrap();
        }
    }
}

#[cfg(target_arch = "wasm32")]
mod host {
    use wasm_bindgen::prelude::*;

    #[wasm_bindgen(module = "fs")]
    extern "C" {
        #[wasm_bindgen(js_name = readFileSync)]
        fn read_file(path: &str, encoding: &str) -> String;
        #[wasm_bindgen(js_name = readdirSync)]
        fn read_dir(path: &str) -> Vec<String>;
    }

    pub(super) fn names(folder: &str) -> Vec<String> {
        read_dir(folder)
    }

    pub(super) fn read(path: &str) -> String {
        read_file(path, "utf8")
    }

    /// Goldens are written natively only.
    pub(super) fn update(_path: &str, _text: &str) {}
}

/// Holds `actual` against the golden file `tests/data/<name>`; `UPDATE_EXPECT=1` writes it (natively).
#[track_caller]
fn golden(name: &str, actual: &str) {
    let path = format!("{}/tests/data/{name}", env!("CARGO_MANIFEST_DIR"));
    host::update(&path, actual);
    let expected = host::read(&path);
    for (at, (actual, expected)) in actual.lines().zip(expected.lines()).enumerate() {
        assert_eq!(actual, expected, "{name}, line {}", at + 1);
    }
    assert_eq!(actual.lines().count(), expected.lines().count(), "{name}: number of lines");
}

/// Checksum over the bits of numbers and the bytes of texts (FNV-1a, 64 bits), printed in decimal.
struct Sum(u64);

impl Sum {
    fn new() -> Sum {
        Sum(0xcbf2_9ce4_8422_2325)
    }

    fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// NaN has many bit patterns, on which machines need not agree: all count as one.
    fn number(&mut self, x: f64) {
        self.bytes(&(if x.is_nan() { u64::MAX } else { x.to_bits() }).to_le_bytes());
    }

    /// Everything that moves.
    fn snapshot(&mut self, now: &Snapshot) {
        self.bytes(format!("{:?}", now.mode).as_bytes());
        self.number(now.t);
        for axis in now.axes.iter().chain(&now.pmc) {
            for value in [axis.position, axis.actual, axis.feed, axis.acceleration] {
                self.number(value);
            }
        }
        let spindle = &now.spindle;
        for value in [spindle.command, spindle.actual, spindle.volts, spindle.turns, spindle.angle] {
            self.number(value);
        }
    }
}

/// A moment for people: mode, time, the first three axes, spindle.
fn moment(now: &Snapshot) -> String {
    let [a, b, c] = [0, 1, 2].map(|axis| now.axes[axis].actual);
    let spindle = &now.spindle;
    format!(
        "{:?} at {:.4} s, axes {a:.4} {b:.4} {c:.4} mm, spindle {:.2} r/min {:.4} V {:.3} turns",
        now.mode, now.t, spindle.actual, spindle.volts, spindle.turns
    )
}

/// 300 arguments of every size, odd and even, after the awkward ones: edges of the functions, halves, huge angles.
fn arguments() -> Vec<f64> {
    let mut all = vec![0.0, -0.0, 1.0, -1.0, 0.5, -0.5, math::PI, math::PI / 2.0, 1e-300, 1e300, 1e22, 710.0, -746.0];
    all.extend([f64::INFINITY, f64::NEG_INFINITY, f64::NAN, f64::MIN_POSITIVE / 4.0]);
    // A linear congruential generator (Knuth, MMIX): the mantissa from its top bits, the exponent from 2^-30 to 2^33.
    let mut state = 1_u64;
    while all.len() < 300 {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let exponent = 993 + (state >> 33) % 64;
        all.push(f64::from_bits(state & 0x8000_0000_0000_0000 | exponent << 52 | state.rotate_left(20) >> 12));
    }
    all
}

/// A function of an argument and the argument before it.
type Function = (&'static str, fn(f64, f64) -> f64);

const FUNCTIONS: [Function; 14] = [
    ("sin(x)", |x, _| math::sin(x)),
    ("cos(x)", |x, _| math::cos(x)),
    ("sin_cos(x).0", |x, _| math::sin_cos(x).0),
    ("sin_cos(x).1", |x, _| math::sin_cos(x).1),
    ("tan(x)", |x, _| math::tan(x)),
    ("asin(1/x)", |x, _| math::asin(1.0 / x)),
    ("acos(1/x)", |x, _| math::acos(1.0 / x)),
    ("atan(x)", |x, _| math::atan(x)),
    ("atan2(x, y)", math::atan2),
    ("exp(x)", |x, _| math::exp(x)),
    ("ln(x)", |x, _| math::ln(x)),
    ("log10(x)", |x, _| math::log10(x)),
    ("pow(|x|, y)", |x, y| math::pow(x.abs(), y)),
    ("hypot(x, y)", math::hypot),
];

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn math_functions_give_the_golden_bits() {
    let arguments = arguments();
    let mut out = "300 arguments x, y is the one before; results for the last three, checksum over all\n".to_owned();
    for (name, function) in FUNCTIONS {
        let mut sum = Sum::new();
        let pairs = std::iter::once(&3.0).chain(&arguments).zip(&arguments);
        let results: Vec<f64> = pairs.map(|(y, x)| function(*x, *y)).collect();
        results.iter().for_each(|result| sum.number(*result));
        let last: Vec<String> = results[297..].iter().map(|result| format!("{result:.9e}")).collect();
        let _ = writeln!(out, "{name}: {}; sum {}", last.join(", "), sum.0);
    }
    golden("parity/math.txt", &out);
}

const OPTIONS: RunOptions = RunOptions {
    start: None,
    settings: &[],
    limits: Budget { blocks: 200_000, seconds: 600.0 },
    keep: Retention::Timeline,
};

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn fixture_programs_run_to_the_golden_bits() {
    for control in controls::ALL {
        let mut out = String::new();
        let folder = format!("{}/tests/data/programs/{}/ok", env!("CARGO_MANIFEST_DIR"), control.id);
        let mut names = host::names(&folder);
        names.retain(|name| name.ends_with(".nc"));
        names.sort();
        assert!(!names.is_empty(), "{folder} has programs");
        for name in names {
            let text = host::read(&format!("{folder}/{name}"));
            let parsed = Rc::new(nc::parse(&Files::one(name.clone(), text), control));
            let mut planner = run::of_programs(parsed, None, Panel::default(), &OPTIONS);
            planner.advance(f64::INFINITY, usize::MAX);
            let mut sum = Sum::new();
            let mut variables = 0;
            for (variable, value) in planner.program().variables() {
                sum.bytes(variable.as_bytes());
                sum.number(value);
                variables += 1;
            }
            let now = planner.timeline().at(planner.ended_at().unwrap_or(OPTIONS.limits.seconds));
            sum.snapshot(&now);
            let blocks = planner.blocks();
            let _ = writeln!(
                out,
                "{name}: {} blocks, {} macro blocks, {variables} variables; {}; sum {}",
                blocks.nc,
                blocks.macros,
                moment(&now),
                sum.0
            );
        }
        golden(&format!("parity/{}.txt", control.id), &out);
    }
}

/// Values beside the defaults that let a run end: a short product, and a loop that takes up its start, its hold and its restart.
const VALUES: [(&str, &str, f64); 2] =
    [("ribbon-line", "pitch-count", 120.0), ("ribbon-line", "loop-capacity", 2000.0)];

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn machines_on_their_controls_give_the_golden_bits() {
    // The page's module has no sentences of its own, and charts name their limits.
    speak(Language::English.sentences());
    for machine in machines::ALL {
        let mut out = String::new();
        for control in machine.controls() {
            let mut project = Project::of_form(*machine, controls::find(control).unwrap());
            for (_, field, value) in VALUES.iter().filter(|(id, ..)| *id == machine.id()) {
                project.values.insert((*field).to_owned(), Value::Number(*value));
            }
            project.panel.add(Event { t: 4.0, action: Action::SpindleOverride(80.0) });
            project.panel.add(Event { t: 5.0, action: Action::Hold });
            project.panel.add(Event { t: 6.0, action: Action::Start });
            out += &machine_on_control(&project);
        }
        golden(&format!("parity/{}.txt", machine.id()), &out);
    }
}

/// Results, program, run and charts of a project: each with its checksum.
fn machine_on_control(project: &Project) -> String {
    let mut out = format!("# {} on {}\n", project.machine.id(), project.control.id);
    let mut sum = Sum::new();
    for readout in project.design().readouts {
        sum.number(readout.value);
        let _ = writeln!(out, "{} {:.4} {} {:?}", readout.id, readout.value, readout.unit, readout.verdict);
    }
    let _ = writeln!(out, "results: sum {}", sum.0);
    let written = project.written();
    for file in &written.files.0 {
        let mut sum = Sum::new();
        sum.bytes(file.text.as_bytes());
        let _ = writeln!(out, "{}: {} bytes; sum {}", file.name, file.text.len(), sum.0);
    }
    let mut planner = run::of_project(project, &written, &OPTIONS);
    planner.advance(f64::INFINITY, usize::MAX);
    let end = planner.ended_at().unwrap_or(OPTIONS.limits.seconds);
    let mut sum = Sum::new();
    for k in 0..=100 {
        // Exact quotient: the last moment is the end itself.
        let now = planner.timeline().at(end * (f64::from(k) / 100.0));
        sum.snapshot(&now);
        if k % 10 == 0 {
            let _ = writeln!(out, "{}", moment(&now));
        }
    }
    let _ = writeln!(out, "run at 101 moments: sum {}", sum.0);
    for chart in project.prepared().charts(&planner, 0.0, end, 60) {
        let svg = view::plot::svg(&chart);
        let mut sum = Sum::new();
        sum.bytes(svg.as_bytes());
        let _ = writeln!(out, "chart {}: {} bytes of SVG; sum {}", chart.id, svg.len(), sum.0);
    }
    out.push('\n');
    out
}
