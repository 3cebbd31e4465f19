//! Derating of a servo motor by its site: continuous torque in thin or warm air.

/// Site of a motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Site {
    /// Height above sea level, m.
    pub height: f64,
    /// Temperature of the air, °C.
    pub temperature: f64,
}

/// Heights of the rows of [`SHARES`], m.
const HEIGHTS: [f64; 5] = [1000.0, 2000.0, 3000.0, 4000.0, 5000.0];

/// Temperatures of the columns of [`SHARES`], °C.
const TEMPERATURES: [f64; 4] = [30.0, 40.0, 45.0, 50.0];

/// Remaining continuous torque of a motor, in percent. Source: sizing facts 2.7.
const SHARES: [[f64; 4]; 5] = [
    [108.0, 100.0, 96.0, 91.0],
    [102.0, 93.0, 89.0, 84.0],
    [95.0, 86.0, 81.0, 75.0],
    [88.0, 77.0, 72.0, 66.0],
    [80.0, 68.0, 62.0, 55.0],
];

/// Greatest height and temperature for which a data sheet holds. Source: sizing facts 2.7.
pub const DATA_SHEET: Site = Site { height: 1000.0, temperature: 40.0 };

impl Site {
    /// Whether the site is higher or warmer than a data sheet allows.
    pub fn is_beyond_data_sheet(self) -> bool {
        self.height > DATA_SHEET.height || self.temperature > DATA_SHEET.temperature
    }

    /// Remaining share of the data sheet's continuous torque, which is valid to 1000 m and 40 °C. Linear between the entries of the table,
    /// constant beyond them, and 1 at most: a cool site gives no more than the data sheet. Source: sizing facts 2.7.
    pub fn share(self) -> f64 {
        let (row, up) = place(&HEIGHTS, self.height);
        let (column, right) = place(&TEMPERATURES, self.temperature);
        let entry =
            |row: usize, column: usize| SHARES.get(row).and_then(|row| row.get(column)).copied().unwrap_or_default();
        let along = |row: usize| between(entry(row, column), entry(row, column + 1), right);
        (between(along(row), along(row + 1), up) / 100.0).min(1.0)
    }
}

fn between(from: f64, to: f64, part: f64) -> f64 {
    from + (to - from) * part
}

/// Index of the interval of a value between marks, and its position in it, 0 to 1; values beyond the marks are at the ends.
fn place(marks: &[f64], value: f64) -> (usize, f64) {
    let last = marks.len().saturating_sub(2);
    let found = marks.iter().skip(1).position(|mark| value <= *mark).unwrap_or(last).min(last);
    match marks.get(found..) {
        Some([from, to, ..]) => (found, crate::math::clamp((value - from) / (to - from), 0.0, 1.0)),
        _ => (found, 0.0),
    }
}
