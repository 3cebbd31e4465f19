//! Numbers as people read them.

use macroline::math;
use macroline::text::catalog::number_text;
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

proptest! {
    #[test]
    fn what_is_written_reads_back(value in -1e12..1e12f64, shift in 0i32..15, decimals in 0u8..=10) {
        let value = value / math::pow(10.0, f64::from(shift));
        let text = number_text(value, decimals);
        let read = number::read(&text).unwrap();
        // Half of the last decimal, and what a double cannot tell apart.
        let off = 0.5 * math::pow(10.0, -f64::from(decimals)) + 3.0 * f64::EPSILON * value.abs();
        prop_assert!((read - value).abs() <= off, "{value:?} as {text}");
        let behind = text.split_once('.').map_or("1", |(_, behind)| behind);
        prop_assert!(!behind.ends_with('0') && behind.len() <= usize::from(decimals).max(1) && text != "-0", "{value:?} as {text}");
    }
}
