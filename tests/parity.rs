//! The same goldens natively and in wasm under Node: what the browser computes is what was tested, to the bit.
#![allow(clippy::unwrap_used)]

use macroline::math;

/// The host: files are read through the standard library natively, through Node in wasm.
#[cfg(not(target_arch = "wasm32"))]
mod host {
    pub(super) fn read(path: &str) -> String {
        std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}"))
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
