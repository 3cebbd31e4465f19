//! Numbers as people read them.

use macroline::machines::form::Value;
use macroline::math;
use macroline::text::catalog::{self, Language, number_text};
use macroline::text::number;
use macroline::text::quantity::{self, Typed};
use proptest::prelude::*;

#[test]
fn numbers_are_printed_short() {
    for (value, decimals, text) in [
        (0.0, 3, "0"),
        (-0.0, 3, "0"),
        (-0.0004, 3, "0"),
        (8.0, 6, "8"),
        (15.279, 6, "15.279"),
        (-0.05, 6, "-0.05"),
        (1e-6, 6, "0.000001"),
        (0.0025, 3, "0.003"),
        (2.675, 2, "2.68"),
        (119_391.393_301, 3, "119391.393"),
        (100.0, 0, "100"),
        (99.5, 0, "100"),
        (62_832_000_000.001, 6, "62832000000.001"),
        (1.0 / 3.0, 255, "0.3333333333"),
        (-1e15, 3, "-1e15"),
        (1.5e300, 0, "1.5e300"),
        (f64::INFINITY, 3, "∞"),
        (f64::NAN, 3, "NaN"),
    ] {
        assert_eq!(number_text(value, decimals), text, "{value:?} with {decimals} decimals");
    }
}

proptest! {
    #[test]
    fn printed_numbers_read_back_exactly(value in -1e12..1e12f64, shift in 0i32..15, decimals in 0u8..=10) {
        let value = value / math::pow(10.0, f64::from(shift));
        let text = number_text(value, decimals);
        let read = number::read(&text).unwrap();
        // Tolerance: half of the last decimal, plus the resolution of a double.
        let off = 0.5 * math::pow(10.0, -f64::from(decimals)) + 4.0 * f64::EPSILON * value.abs();
        prop_assert!((read - value).abs() <= off, "{value:?} as {text}");
        let behind = text.split_once('.').map_or("1", |(_, behind)| behind);
        prop_assert!(!behind.ends_with('0') && behind.len() <= usize::from(decimals).max(1) && text != "-0", "{value:?} as {text}");
    }
}

/// A number of twice as many digits: the sum of two doubles.
type Long = (f64, f64);

fn plus(a: Long, b: Long) -> Long {
    let sum = a.0 + b.0;
    let part = sum - a.0;
    let lost = (a.0 - (sum - part)) + (b.0 - part) + a.1 + b.1;
    (sum + lost, lost - (sum + lost - sum))
}

fn times(a: Long, b: Long) -> Long {
    let product = a.0 * b.0;
    let lost = a.0.mul_add(b.0, -product) + a.0 * b.1 + a.1 * b.0;
    (product + lost, lost - (product + lost - product))
}

fn over(a: Long, b: Long) -> Long {
    let part = a.0 / b.0;
    let rest = plus(a, times((-part, 0.0), b));
    plus((part, 0.0), (rest.0 / b.0, 0.0))
}

/// Sine and cosine of an angle in degrees by their series, to 30 digits.
fn series(x: f64) -> (Long, Long) {
    let quadrant = (x / 90.0).round();
    let radian = times((x - 90.0 * quadrant, 0.0), (0.017453292519943295, 2.9486522708701687e-19));
    let square = times(radian, radian);
    let sum = |first: Long, from: i32| {
        let mut term = first;
        (0..12).fold(first, |sum, k| {
            let divisor = f64::from((from + 2 * k) * (from + 2 * k + 1));
            term = over(times((-term.0, -term.1), square), (divisor, 0.0));
            plus(sum, term)
        })
    };
    let (sin, cos) = (sum(radian, 2), sum((1.0, 0.0), 1));
    let minus = |x: Long| (-x.0, -x.1);
    match quadrant.rem_euclid(4.0) as i32 {
        0 => (sin, cos),
        1 => (cos, minus(sin)),
        2 => (minus(sin), minus(cos)),
        _ => (minus(cos), sin),
    }
}

/// Error of a number in steps between neighbouring doubles.
fn steps(x: f64, is: Long) -> f64 {
    ((x - is.0) - is.1).abs() / (is.0.abs().next_up() - is.0.abs())
}

#[test]
fn functions_of_whole_degrees_are_exact() {
    for (x, sin, cos) in [(0.0, 0.0, 1.0), (30.0, 0.5, 0.75f64.sqrt()), (45.0, 0.5f64.sqrt(), 0.5f64.sqrt())] {
        for turn in [0.0, 360.0, -720.0, 36_000_000.0] {
            assert_eq!(math::sin_cos_degrees(turn + x), (sin, cos));
            assert_eq!(math::sin_cos_degrees(turn + 90.0 + x), (cos, 0.0 - sin));
            assert_eq!(math::sin_cos_degrees(turn + 180.0 + x), (0.0 - sin, -cos));
            assert_eq!(math::sin_cos_degrees(turn - 90.0 + x), (-cos, sin));
        }
    }
    for x in -360i32..=360 {
        let (sin, cos) = math::sin_cos_degrees(f64::from(x));
        assert!([sin, cos].iter().all(|part| *part != 0.0 || part.is_sign_positive()), "{x}");
        let within = f64::from((x + 540).rem_euclid(360) - 180);
        assert_eq!(math::acos_degrees(cos), within.abs(), "{x}");
        let upright = if within.abs() > 90.0 { 180.0f64.copysign(within) - within } else { within };
        assert_eq!(math::asin_degrees(sin), upright, "{x}");
        if (-90..=90).contains(&x) && x % 90 != 0 {
            assert_eq!(math::atan2_degrees(math::tan_degrees(f64::from(x)).unwrap(), 1.0), f64::from(x));
        }
    }
    let angles = [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (1.0, -1.0), (0.0, -1.0), (-1.0, -1.0), (-1.0, 0.0), (-1.0, 1.0)];
    assert_eq!(angles.map(|(y, x)| math::atan2_degrees(y, x)), [0.0, 45.0, 90.0, 135.0, 180.0, -135.0, -90.0, -45.0]);
    assert_eq!([45.0, 135.0, 180.0, -45.0].map(math::tan_degrees), [1.0, -1.0, 0.0, -1.0].map(Some));
    assert_eq!([90.0, -90.0, 270.0].map(math::tan_degrees), [None; 3]);
}

proptest! {
    #[test]
    fn functions_of_degrees_err_by_one_ulp_at_most(x in prop_oneof![-720.0..720.0f64, (-720_000i32..720_000).prop_map(|x| f64::from(x) / 1000.0)]) {
        let (sin, cos) = math::sin_cos_degrees(x);
        let (sine, cosine) = series(x);
        prop_assert!(steps(sin, sine) < 1.0 && steps(cos, cosine) < 1.0, "{x:?}: {} {}", steps(sin, sine), steps(cos, cosine));
        if let Some(tan) = math::tan_degrees(x) {
            prop_assert!(steps(tan, over(sine, cosine)) < 1.0, "{x:?}: {}", steps(tan, over(sine, cosine)));
        }
    }
}

#[test]
fn figures_are_written_as_the_language_has_them() {
    let figures = || {
        [(-15080.5, 1), (1_234_567.0, 0), (-0.25, 2), (999.0, 0)].map(|(size, decimals)| number::figure(size, decimals))
    };
    let english = ["\u{2212}15\u{202f}080.5", "1\u{202f}234\u{202f}567", "\u{2212}0.25", "999"];
    assert_eq!(figures(), english);
    catalog::speak(Language::Chinese.sentences());
    assert_eq!(figures(), ["-15080.5", "1234567", "-0.25", "999"]);
    assert_eq!(number::short(-12345.5, 3), "-12345.5");
    catalog::speak(Language::English.sentences());
    assert_eq!(figures(), english);
}

#[test]
fn typed_number_may_be_written_as_it_is_shown() {
    let cases = [
        ("1 200", Some(1200.0)),
        ("1\u{202f}200", Some(1200.0)),
        ("\u{2212}15 080,5", Some(-15_080.5)),
        ("12 345 678", Some(12_345_678.0)),
        ("１２００", Some(1200.0)),
        ("－１．５", Some(-1.5)),
        ("1 20", None),
        ("1200 300", None),
        ("1 200.5 300", None),
        ("1 .5", None),
        ("- 5", None),
        ("1 200 ", Some(1200.0)),
        ("1e3", None),
        ("1.2.3", None),
    ];
    for (text, wanted) in cases {
        assert_eq!(number::read(text), wanted, "{text:?}");
    }
}

#[test]
fn typed_number_in_another_unit_is_converted() {
    for (typed, unit, wanted) in [
        ("4.5 in", "mm", 114.3),
        ("4,5\"", "mm", 114.3),
        ("2 ft", "mm", 609.6),
        ("1 200 cm", "mm", 12_000.0),
        ("0.5 m", "mm", 500.0),
        ("15 m/min", "mm/min", 15_000.0),
        ("200 SFM", "m/min", 60.96),
        ("0.01 ipr", "mm/rev", 0.254),
        ("20 rps", "r/min", 1200.0),
        ("250 ms", "s", 0.25),
        ("1.5 min", "ms", 90_000.0),
        ("100 lbf·in", "Nm", 11.298_482_9),
        ("1 lb-ft", "Nm", 1.355_817_9),
        ("2 kN", "N", 2000.0),
        ("10 lb", "kg", 4.535_923_7),
        ("12 kg cm²", "kg·m²", 0.0012),
        ("0.0012 kgm2", "kg cm²", 12.0),
        ("10 hp", "kW", 7.456_998_7),
        ("10 PS", "kW", 7.354_987_5),
        ("0.7 MPa", "N/mm²", 0.7),
        ("100 psi", "N/mm²", 0.689_475_7),
        ("5 V", "mV", 5000.0),
        ("30′", "°", 0.5),
    ] {
        let Some(Typed::Converted(read)) = quantity::read(typed, unit) else { panic!("{typed} in {unit}") };
        assert!((read - wanted).abs() < 1e-7 * wanted, "{typed} in {unit}: {read}");
    }
}

#[test]
fn unit_of_another_quantity_is_refused() {
    for (typed, unit) in [
        ("5 kg", "mm"),
        ("5 s", "°"),
        ("5 mm/min", "mm"),
        ("in", "mm"),
        ("4.5 in in", "mm"),
        ("5 1/s", "r/min"),
        ("1 K", "°C"),
    ] {
        assert_eq!(quantity::read(typed, unit), None, "{typed} in {unit}");
    }
}

#[test]
fn unit_of_every_field_is_understood_behind_its_number() {
    for field in macroline::machines::ALL.iter().flat_map(|machine| machine.fields()) {
        let unit = field.unit();
        for typed in [format!("1 {unit}"), format!("1{unit}")] {
            assert!(matches!(quantity::read(&typed, unit), Some(Typed::Shown(1.0) | Typed::Converted(1.0))), "{typed}");
        }
    }
}

#[test]
fn converted_entry_has_the_decimals_of_its_field() {
    let fields = macroline::machines::find("ribbon-line").unwrap().fields();
    let pitch = fields.iter().find(|field| field.id == "pitch").unwrap();
    assert_eq!(pitch.read_displayed("0.333 in").ok(), Some(Value::Number(8.458)));
    assert!(pitch.read_displayed("400 in").is_err());
}

#[test]
fn typed_number_may_have_its_unit_behind_it() {
    let field = macroline::machines::find("ribbon-line").unwrap().fields();
    let field = field.iter().find(|field| field.id == "spindle-speed").unwrap();
    let read = |typed: &str| field.read_displayed(typed).ok();
    assert!(read("1200 r/min").is_some());
    assert_eq!(read("1200 r/min"), read("1200"));
    assert_eq!(read("1 200r/min"), read("1200"));
    assert_eq!(read("1200 mm"), None);
}
