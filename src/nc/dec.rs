//! An exact decimal number that keeps whether its point was written: `X8` and `X8.` differ on real controls.

use core::fmt;

/// `mantissa / 10^scale`; `scale` is the number of written decimals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Dec {
    /// All digits as one signed integer.
    pub mantissa: i64,
    /// Digits after the point, 0 to 18.
    pub scale: u8,
    /// The point is written.
    pub point: bool,
}

/// Powers of ten that fit an `i64`.
pub(crate) const POW10: [i64; 19] = {
    let mut table = [1; 19];
    let mut i = 1;
    while i < 19 {
        table[i] = table[i - 1] * 10;
        i += 1;
    }
    table
};

impl Dec {
    /// A whole number without a point.
    pub const fn int(value: i64) -> Dec {
        Dec { mantissa: value, scale: 0, point: false }
    }

    /// `mantissa / 10^scale` with a point; `Dec::new(8, 0)` is `8.`.
    pub const fn new(mantissa: i64, scale: u8) -> Dec {
        Dec { mantissa, scale, point: true }
    }

    /// The decimal nearest to a float, with a point and at most `decimals` decimals, without trailing zeros; `None` for more than 18
    /// digits, NaN or infinity.
    pub fn from_f64(value: f64, decimals: u8) -> Option<Dec> {
        let scaled = (value * POW10[decimals.min(18) as usize] as f64).round();
        if !scaled.is_finite() || scaled.abs() >= 1e18 {
            return None;
        }
        let (mut mantissa, mut scale) = (scaled as i64, decimals.min(18));
        while scale > 0 && mantissa % 10 == 0 {
            mantissa /= 10;
            scale -= 1;
        }
        Some(Dec { mantissa, scale, point: true })
    }

    /// The nearest float.
    #[inline]
    pub fn to_f64(self) -> f64 {
        if self.scale == 0 {
            self.mantissa as f64
        } else {
            // Exact for mantissas below 2^53 and scales to 22: one correctly rounded division.
            self.mantissa as f64 / POW10[self.scale.min(18) as usize] as f64
        }
    }
}

impl fmt::Display for Dec {
    /// Writes the number as in a program: `8`, `8.`, `-0.05`, `1.50`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = self.mantissa.unsigned_abs();
        let unit = POW10[self.scale.min(18) as usize] as u64;
        if self.mantissa < 0 {
            f.write_str("-")?;
        }
        write!(f, "{}", digits / unit)?;
        if self.scale > 0 {
            write!(f, ".{:0width$}", digits % unit, width = self.scale as usize)
        } else if self.point {
            f.write_str(".")
        } else {
            Ok(())
        }
    }
}
