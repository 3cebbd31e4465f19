//! Numbers as people type them, and as they are written for people.

use core::fmt;

/// Digits that are read; more than a double can tell apart would only round it twice.
const DIGITS: usize = 17;

/// A decimal number as people type it: `1.5`, `1,5`, `-1.50`, `−3`; no exponent, no separators of thousands, not two points, not more
/// than 40 characters. (The library's reading of floats would cost the page 10 KB of tables for exponents that nobody types.)
pub fn read(text: &str) -> Option<f64> {
    let text = text.trim();
    let negative = text.starts_with(['-', '\u{2212}']);
    let digits = text.strip_prefix(['-', '+', '\u{2212}']).unwrap_or(text);
    let (mut mantissa, mut scale, mut count, mut point, mut any) = (0_u64, 0_i32, 0, false, false);
    for c in digits.chars() {
        match c {
            '0'..='9' => {
                any = true;
                // Digits beyond the last that counts move the scale only.
                if count < DIGITS {
                    mantissa = mantissa * 10 + u64::from(c as u32 - '0' as u32);
                    count += usize::from(mantissa > 0);
                    scale -= i32::from(point);
                } else {
                    scale += i32::from(!point);
                }
            }
            '.' | ',' if !point => point = true,
            _ => return None,
        }
    }
    if !any || digits.len() > 40 {
        return None;
    }
    // Powers of ten are exact to 22, beyond which nothing that fits a field reaches.
    let power = |n: i32| (0..n).fold(1.0_f64, |p, _| p * 10.0);
    let size = if scale < 0 { mantissa as f64 / power(-scale) } else { mantissa as f64 * power(scale) };
    Some(if negative { -size } else { size })
}

/// A number as it is written for people: with at most so many decimals, without trailing zeros, never `-0`: `8`, `15.279`, `-0.5`; from
/// 10¹⁵ on with an exponent. A half is rounded away from zero.
///
/// Digits are made here, as a run writes three numbers a block and the library's way to decimals takes longer than running the block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plain(pub f64, pub u8);

/// Below this a double tells each whole number from the next.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// Powers of ten by which numbers are scaled to be written.
const POW10: [f64; 11] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10];

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let &Plain(number, decimals) = self;
        if number.is_nan() || number.abs() >= 1e15 {
            return write!(f, "{number:e}");
        }
        // A large number has fewer decimals than are asked for.
        let mut decimals = POW10.len().min(decimals as usize + 1);
        let mut scaled = f64::INFINITY;
        while scaled.abs() >= EXACT && decimals > 0 {
            decimals -= 1;
            scaled = (number * POW10[decimals]).round();
        }
        write_scaled(f, scaled as i64, decimals)
    }
}

/// `digits / 10^decimals` without trailing zeros; at most ten decimals.
fn write_scaled(f: &mut fmt::Formatter<'_>, digits: i64, mut decimals: usize) -> fmt::Result {
    let mut rest = digits.unsigned_abs();
    while decimals > 0 && rest.is_multiple_of(10) {
        rest /= 10;
        decimals -= 1;
    }
    // Sign, sixteen digits, ten decimals of a smaller number, point.
    let mut text = [b'0'; 28];
    let mut at = text.len();
    let mut place = 0;
    while rest > 0 || place <= decimals {
        if place == decimals && place > 0 {
            at -= 1;
            text[at] = b'.';
        }
        at -= 1;
        text[at] = b'0' + (rest % 10) as u8;
        rest /= 10;
        place += 1;
    }
    if digits < 0 {
        at -= 1;
        text[at] = b'-';
    }
    f.write_str(core::str::from_utf8(&text[at..]).unwrap_or_default())
}
