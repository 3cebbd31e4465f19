//! Numbers as people read them.

use macroline::math;
use macroline::text::catalog::number_text;
use macroline::text::double::{Shortest, nearest};
use macroline::text::number;
use proptest::prelude::*;

#[test]
fn numbers_are_short() {
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
        (f64::INFINITY, 3, "inf"),
        (f64::NAN, 3, "NaN"),
    ] {
        assert_eq!(number_text(value, decimals), text, "{value:?} with {decimals} decimals");
    }
}

#[test]
fn numbers_of_a_file_are_as_short_as_they_can_be() {
    for (value, text) in [
        (0.0, "0"),
        (8.0, "8"),
        (-12.5, "-12.5"),
        (0.1 + 0.2, "0.30000000000000004"),
        (1e-7, "0.0000001"),
        (5e-324, "5e-324"),
        (1e16, "1e16"),
        (f64::MAX, "1.7976931348623157e308"),
        (f64::NAN, "null"),
    ] {
        assert_eq!(Shortest(value).to_string(), text, "{value:?}");
    }
}

/// Doubles of every size, and such as people write.
fn double() -> impl Strategy<Value = f64> {
    let of_a_person =
        (-1_000_000i64..1_000_000, 0i32..6).prop_map(|(n, shift)| n as f64 / f64::from(10i32.pow(shift as u32)));
    prop_oneof![any::<f64>(), of_a_person].prop_filter("numbers", |value| value.is_finite())
}

proptest! {
    #[test]
    fn the_shortest_text_is_the_librarys(value in double()) {
        let text = Shortest(value).to_string();
        prop_assert_eq!(text.parse(), Ok(value));
        let digits = |text: &str| {
            let mantissa = text.split('e').next().unwrap_or_default().replace(['-', '.'], "");
            mantissa.trim_matches('0').to_owned()
        };
        prop_assert_eq!(digits(&text), digits(&format!("{value:e}")), "{}", text);
    }

    #[test]
    fn the_nearest_double_is_the_librarys(digits in any::<u64>(), shift in 0u32..64, exponent in -400i32..400) {
        let digits = digits >> shift;
        prop_assert_eq!(Ok(nearest(digits, exponent)), format!("{digits}e{exponent}").parse());
    }

    #[test]
    fn what_is_written_reads_back(value in -1e12..1e12f64, shift in 0i32..15, decimals in 0u8..=10) {
        let value = value / math::pow(10.0, f64::from(shift));
        let text = number_text(value, decimals);
        let read = number::read(&text).unwrap();
        // Half of the last decimal, and what a double cannot tell apart.
        let off = 0.5 * math::pow(10.0, -f64::from(decimals)) + 4.0 * f64::EPSILON * value.abs();
        prop_assert!((read - value).abs() <= off, "{value:?} as {text}");
        let behind = text.split_once('.').map_or("1", |(_, behind)| behind);
        prop_assert!(!behind.ends_with('0') && behind.len() <= usize::from(decimals).max(1) && text != "-0", "{value:?} as {text}");
    }
}
