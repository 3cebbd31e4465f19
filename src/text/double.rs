//! Doubles and decimals without loss: the shortest decimal that reads back as the same double, and the double nearest to a decimal.
//!
//! In little code, for what is done a few times (the library's ways are fast, and cost the page 10 KB with their tables).

use core::cmp::Ordering;
use core::fmt;

/// A double as the shortest decimal that reads back as the same: `8`, `0.1`, `-12.5`, `1e300`; as it stands in JSON.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shortest(pub f64);

impl fmt::Display for Shortest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.0.is_finite() {
            return f.write_str("null");
        }
        if self.0.is_sign_negative() {
            f.write_str("-")?;
        }
        let (digits, exponent) = shortest(self.0.abs());
        match exponent {
            -19..0 => {
                let unit = 10_u64.pow(exponent.unsigned_abs());
                write!(f, "{}.{:0width$}", digits / unit, digits % unit, width = exponent.unsigned_abs() as usize)
            }
            0 => write!(f, "{digits}"),
            _ => {
                let text = digits.to_string();
                let (first, rest) = text.split_at_checked(1).unwrap_or_default();
                let point = if rest.is_empty() { "" } else { "." };
                write!(f, "{first}{point}{rest}e{}", exponent + rest.len() as i32)
            }
        }
    }
}

/// A double of any size, or none: `1e15`, `-1.5e300`, `inf`, `NaN`.
pub(super) fn exponential(f: &mut impl fmt::Write, x: f64) -> fmt::Result {
    match x {
        f64::INFINITY => f.write_str("∞"),
        f64::NEG_INFINITY => f.write_str("-∞"),
        _ if x.is_nan() => f.write_str("NaN"),
        _ => write!(f, "{}", Shortest(x)),
    }
}

/// The fewest digits, and the power of ten they count, that read back as this double, which is finite and not negative.
fn shortest(x: f64) -> (u64, i32) {
    // Most numbers that people write: up to 15 digits stand for one double only.
    for (decimals, power) in [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6].into_iter().enumerate() {
        let digits = (x * power).round();
        if digits < 1e15 && digits / power == x {
            return (digits as u64, -(decimals as i32));
        }
    }
    // Steele and White: how far the next doubles are tells when there are digits enough. All four are multiples of one small unit.
    let (mantissa, exponent) = parts(x);
    let lopsided = u32::from(mantissa == 1 << 52);
    let (mut rest, mut unit) = (Big::new(mantissa), Big::new(1));
    let (mut above, mut below) = (Big::new(1 << lopsided), Big::new(1));
    rest.shift(1 + lopsided);
    unit.shift(1 + lopsided);
    let scaled = if exponent < 0 { vec![&mut unit] } else { vec![&mut rest, &mut above, &mut below] };
    scaled.into_iter().for_each(|number| number.shift(exponent.unsigned_abs()));
    let even = mantissa & 1 == 0;
    let reaches = |order: Ordering| order == Ordering::Greater || even && order == Ordering::Equal;
    let (mut digits, mut power) = (0_u64, 0);
    while reaches(rest.plus(&above).against(&unit)) {
        unit.times(10);
        power += 1;
    }
    loop {
        rest.times(10);
        above.times(10);
        below.times(10);
        power -= 1;
        let mut digit = 0;
        while rest.take(&unit) {
            digit += 1;
        }
        let low = reaches(below.against(&rest));
        let high = reaches(rest.plus(&above).against(&unit));
        digits = digits * 10 + digit;
        if low || high {
            let nearer = rest.plus(&rest).against(&unit) != Ordering::Less;
            return (digits + u64::from(high && (!low || nearer)), power);
        }
    }
}

/// The double nearest to `digits · 10^exponent`, of two the even one; infinite where it is too large.
pub fn nearest(digits: u64, exponent: i32) -> f64 {
    // Exact as doubles both, so rounded once.
    if digits < 1 << 53 && exponent.abs() <= 22 {
        let power = (0..exponent.abs()).fold(1.0, |power, _| power * 10.0);
        return if exponent < 0 { digits as f64 / power } else { digits as f64 * power };
    }
    if digits == 0 || exponent < -400 {
        return 0.0;
    }
    if exponent > 400 {
        return f64::INFINITY;
    }
    let (mut over, mut under) = (Big::new(digits), Big::new(1));
    let scaled = if exponent < 0 { &mut under } else { &mut over };
    (0..exponent.abs()).for_each(|_| scaled.times(10));
    // A quotient of 55 or 56 bits, two more than a double has; fewer below the smallest double of full precision.
    let places = (55 + under.bits() - over.bits()).min(1076);
    if places > 0 { &mut over } else { &mut under }.shift(places.unsigned_abs());
    under.shift(56);
    let mut quotient = 0;
    for _ in 0..=56 {
        quotient = quotient * 2 + u64::from(over.take(&under));
        over.times(2);
    }
    quotient |= u64::from(over.bits() > 0);
    let drop = (11 - quotient.leading_zeros() as i32).max(places - 1074);
    let (kept, rest, half) = (quotient >> drop, quotient & ((1 << drop) - 1), 1 << (drop - 1));
    let up = rest > half || rest == half && kept & 1 == 1;
    scale(kept + u64::from(up), drop - places)
}

/// `mantissa · 2^exponent`, where that is a double or too large for one.
fn scale(mantissa: u64, exponent: i32) -> f64 {
    match exponent {
        972.. => f64::INFINITY,
        -1022.. => mantissa as f64 * f64::from_bits(((exponent + 1023) as u64) << 52),
        _ => mantissa as f64 * f64::from_bits(1 << (exponent + 1074)),
    }
}

/// A double that is finite and not negative as `mantissa · 2^exponent`.
fn parts(x: f64) -> (u64, i32) {
    let (bits, exponent) = (x.to_bits() & ((1 << 52) - 1), (x.to_bits() >> 52) as i32);
    if exponent == 0 { (bits, -1074) } else { (bits | 1 << 52, exponent - 1075) }
}

/// A whole number of any size, the lowest 32 bits first, without zeros at its end.
#[derive(Clone)]
struct Big(Vec<u32>);

impl Big {
    fn new(number: u64) -> Big {
        let mut big = Big(vec![number as u32, (number >> 32) as u32]);
        big.trim();
        big
    }

    fn trim(&mut self) {
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
    }

    /// How many binary digits it has.
    fn bits(&self) -> i32 {
        self.0.len() as i32 * 32 - self.0.last().map_or(0, |top| top.leading_zeros() as i32)
    }

    /// Multiplies.
    fn times(&mut self, factor: u32) {
        let mut carry = 0;
        for limb in &mut self.0 {
            carry += u64::from(*limb) * u64::from(factor);
            *limb = carry as u32;
            carry >>= 32;
        }
        if carry > 0 {
            self.0.push(carry as u32);
        }
    }

    /// Multiplies by a power of two.
    fn shift(&mut self, bits: u32) {
        self.times(1 << (bits % 32));
        if !self.0.is_empty() {
            self.0.splice(..0, (0..bits / 32).map(|_| 0));
        }
    }

    /// A sum.
    fn plus(&self, other: &Big) -> Big {
        let mut carry = 0;
        let len = self.0.len().max(other.0.len()) + 1;
        let limb = |big: &Big, at: usize| big.0.get(at).map_or(0, |limb| u64::from(*limb));
        let sum = (0..len).map(|at| {
            carry = (carry >> 32) + limb(self, at) + limb(other, at);
            carry as u32
        });
        let mut sum = Big(sum.collect());
        sum.trim();
        sum
    }

    fn against(&self, other: &Big) -> Ordering {
        self.0.len().cmp(&other.0.len()).then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }

    /// Subtracts, if it is large enough to.
    fn take(&mut self, other: &Big) -> bool {
        if self.against(other) == Ordering::Less {
            return false;
        }
        let mut borrow = 0;
        for (at, limb) in self.0.iter_mut().enumerate() {
            borrow += i64::from(*limb) - other.0.get(at).map_or(0, |limb| i64::from(*limb));
            *limb = borrow as u32;
            borrow >>= 32;
        }
        self.trim();
        true
    }
}
