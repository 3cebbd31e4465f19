//! Numbers as people type them.

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
