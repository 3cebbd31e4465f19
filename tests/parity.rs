//! The same goldens natively and in wasm under Node: what the browser computes is what was tested, to the bit.
#![allow(clippy::unwrap_used)]

use std::fmt::Write as _;
use std::rc::Rc;

use macroline::controls;
use macroline::machines::form::Value;
use macroline::math;
use macroline::motion::{Action, Budget, Event, Panel, Retention, Snapshot};
use macroline::nc::{self, Files};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::view;

/// The host: files are read through the standard library natively, through Node in wasm.
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

/// The bits of a number. A NaN has many, and no two machines need to agree on them.
fn bits(x: f64) -> String {
    if x.is_nan() { "nan".to_owned() } else { format!("{:x}", x.to_bits()) }
}

/// Arguments of every size, odd and even, with the awkward ones first: edges of the functions, halves, huge angles.
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

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn the_math_gate_gives_the_same_bits() {
    let mut table =
        "x sin cos tan asin(1/x) acos(1/x) atan atan2(x,y) exp ln log10 pow(|x|,y) hypot(x,y); y is the x above\n"
            .to_owned();
    let mut y = 3.0;
    for x in arguments() {
        let (sin, cos) = math::sin_cos(x);
        assert_eq!((bits(sin), bits(cos)), (bits(math::sin(x)), bits(math::cos(x))), "sin_cos({x})");
        let row = [
            x,
            sin,
            cos,
            math::tan(x),
            math::asin(1.0 / x),
            math::acos(1.0 / x),
            math::atan(x),
            math::atan2(x, y),
            math::exp(x),
            math::ln(x),
            math::log10(x),
            math::pow(x.abs(), y),
            math::hypot(x, y),
        ];
        table.push_str(&row.map(bits).join(" "));
        table.push('\n');
        y = x;
    }
    golden("math.bits", &table);
}

const BEGIN: RunOptions = RunOptions {
    start: None,
    settings: &[],
    limits: Budget { blocks: 200_000, seconds: 600.0 },
    keep: Retention::Timeline,
};

/// All that moves, to the bit.
fn moment(now: &Snapshot) -> String {
    let mut out = format!("{:?} {}", now.mode, bits(now.t));
    for axis in &now.axes[..3] {
        let _ = write!(
            out,
            " {} {} {} {}",
            bits(axis.position),
            bits(axis.actual),
            bits(axis.feed),
            bits(axis.acceleration)
        );
    }
    let spindle = &now.spindle;
    for value in [spindle.command, spindle.actual, spindle.volts, spindle.turns] {
        let _ = write!(out, " {}", bits(value));
    }
    out
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn programs_run_the_same_on_the_bench() {
    let mut out = String::new();
    for control in controls::ALL {
        let folder = format!("{}/tests/data/programs/{}/ok", env!("CARGO_MANIFEST_DIR"), control.id);
        let mut names = host::names(&folder);
        names.retain(|name| name.ends_with(".nc"));
        names.sort();
        assert!(!names.is_empty(), "{folder} has programs");
        for name in names {
            let text = host::read(&format!("{folder}/{name}"));
            let parsed = Rc::new(nc::parse(&Files::one(name.clone(), text), control));
            let mut planner = run::of_programs(parsed, None, Panel::default(), &BEGIN);
            let progress = planner.advance(f64::INFINITY, usize::MAX);
            let _ = writeln!(out, "{} {name} {:?} blocks {:?}", control.id, progress.ended.is_some(), planner.blocks());
            for (variable, value) in planner.program().variables() {
                let _ = writeln!(out, "{variable} {}", bits(value));
            }
            let _ = writeln!(out, "{}", moment(&planner.timeline().at(progress.planned_to)));
        }
    }
    golden("parity/programs.bits", &out);
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn the_ribbon_line_is_designed_written_run_and_drawn_the_same() {
    let mut project = Project::of("ribbon-line", None).unwrap();
    project.values.insert("pitch-count".to_owned(), Value::Number(120.0));
    project.panel.add(Event { t: 4.0, action: Action::SpindleOverride(80.0) });
    project.panel.add(Event { t: 5.0, action: Action::Hold });
    project.panel.add(Event { t: 6.0, action: Action::Start });
    let mut out = String::new();
    for readout in project.design().readouts {
        let _ = writeln!(out, "{} {} {:?}", readout.id, bits(readout.value), readout.verdict);
    }
    let written = project.written();
    for file in &written.files.0 {
        out.push_str(&file.text);
    }
    let mut planner = run::of_project(&project, &written, &BEGIN);
    let end = planner.advance(f64::INFINITY, usize::MAX).planned_to;
    for k in 0..=100 {
        let _ = writeln!(out, "{}", moment(&planner.timeline().at(end * f64::from(k) / 100.0)));
    }
    for chart in project.machine.charts(&project.values, project.on(), &planner, 0.0, end, 60) {
        out.push_str(&view::plot::svg(&chart));
        out.push('\n');
    }
    golden("parity/ribbon-line.bits", &out);
}
