//! Axis scaling: the ratio of gears and leads as a fraction of whole numbers, for the parameters of a control.

/// A fraction of two whole numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fraction {
    /// Numerator.
    pub over: u64,
    /// Denominator.
    pub under: u64,
}

impl Fraction {
    /// Its value.
    pub fn value(self) -> f64 {
        self.over as f64 / self.under as f64
    }

    /// The fraction nearest to a ratio, with terms from 1 to `limit`; `None` for a ratio beyond `limit` or below its reciprocal.
    ///
    /// By continued fractions: the nearer of the last convergent within the limit and the semiconvergent after it.
    pub fn nearest(ratio: f64, limit: u64) -> Option<Fraction> {
        let most = limit as f64;
        if !ratio.is_finite() || ratio < 1.0 / most || ratio > most {
            return None;
        }
        let (mut before, mut last) = ((0u64, 1u64), (1u64, 0u64));
        let mut rest = ratio;
        // The denominators at least double every two steps.
        for _ in 0..64 {
            let whole = rest.floor() as u64;
            let next = |times: u64| {
                let over = last.0.saturating_mul(times).saturating_add(before.0);
                (over, last.1.saturating_mul(times).saturating_add(before.1))
            };
            let fits = |(over, under): (u64, u64)| over <= limit && under <= limit;
            if !fits(next(whole)) {
                let part = |last: u64, before: u64| (limit - before.min(limit)).checked_div(last).unwrap_or(u64::MAX);
                let semi = next(part(last.0, before.0).min(part(last.1, before.1)).min(whole));
                last = nearer(ratio, last, semi);
                break;
            }
            (before, last) = (last, next(whole));
            let left = rest - rest.floor();
            // The remainder is the rounding error of the ratio itself.
            if (last.0 as f64 / last.1 as f64 - ratio).abs() <= 4.0 * f64::EPSILON * ratio || left <= 0.0 {
                break;
            }
            rest = 1.0 / left;
        }
        Some(Fraction { over: last.0, under: last.1 }).filter(|found| found.over > 0 && found.under > 0)
    }
}

/// The one of two fractions nearer to a ratio; a zero term excludes a fraction.
fn nearer(ratio: f64, one: (u64, u64), other: (u64, u64)) -> (u64, u64) {
    let error = |(over, under): (u64, u64)| {
        if over > 0 && under > 0 { (over as f64 / under as f64 - ratio).abs() } else { f64::INFINITY }
    };
    if error(other) < error(one) { other } else { one }
}
