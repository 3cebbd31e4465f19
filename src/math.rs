//! The only access to transcendental functions: libm, so that native and wasm give the same bits.
//!
//! `sqrt`, `abs`, `floor`, `ceil`, `trunc`, `round`, `min` and `max` are exact in IEEE 754 and may be called on `f64`.

/// The circle constant, the only π of the core.
pub const PI: f64 = core::f64::consts::PI;

/// Radians per second of one revolution per minute.
pub const RPM: f64 = PI / 30.0;

/// `x` limited to `low..=high`. Total: `f64::clamp` panics if the bounds cross; here the low bound wins for `x` below it.
pub fn clamp(x: f64, low: f64, high: f64) -> f64 {
    if x < low {
        low
    } else if x > high {
        high
    } else {
        x
    }
}

/// Rounds up to a whole number; an excess within rounding errors (below 5e-10) is ignored.
pub fn whole_up(x: f64) -> f64 {
    ((x * 1e9).round() / 1e9).ceil()
}

/// The greatest of 1, 2 or 5 times a power of ten that is not above a positive number; 1 for any other number.
pub fn step_at_most(x: f64) -> f64 {
    if !(x.is_finite() && x > 0.0) {
        return 1.0;
    }
    let decade = pow(10.0, log10(x).floor());
    [10.0, 5.0, 2.0].into_iter().find(|times| times * decade <= x).unwrap_or(1.0) * decade
}

/// Bisection of the interval between a value at which a condition holds and a value, above or below it, at which it fails: the ends after
/// so many halvings. The condition is taken to hold at the first end and to fail at the second one.
pub fn bisect(holds: f64, fails: f64, halvings: u32, mut condition: impl FnMut(f64) -> bool) -> (f64, f64) {
    let halved = |(holds, fails): (f64, f64), _| {
        let middle = 0.5 * (holds + fails);
        if condition(middle) { (middle, fails) } else { (holds, middle) }
    };
    (0..halvings).fold((holds, fails), halved)
}

/// The last value, from `holds` towards `fails`, at which a condition holds, by [`bisect`].
pub fn last_holding(holds: f64, fails: f64, halvings: u32, condition: impl FnMut(f64) -> bool) -> f64 {
    bisect(holds, fails, halvings, condition).0
}

/// Halvings by which [`greatest_share`] is found.
const SHARE_HALVINGS: u32 = 20;

/// The greatest share from `least` to 1 with which a condition holds that does not hold with more; none if it does not hold with the least.
pub fn greatest_share(least: f64, holds: impl Fn(f64) -> bool) -> Option<f64> {
    holds(least).then(|| last_holding(least, 1.0, SHARE_HALVINGS, &holds))
}

/// Sine of an angle in radians.
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// Cosine of an angle in radians.
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// Sine and cosine of an angle in radians.
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// Tangent of an angle in radians.
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

/// Arc sine in radians.
pub fn asin(x: f64) -> f64 {
    libm::asin(x)
}

/// Arc cosine in radians.
pub fn acos(x: f64) -> f64 {
    libm::acos(x)
}

/// Arc tangent in radians.
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// Angle of the point (x, y) in radians, -π to π.
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// e to the power x.
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// e to the power x, less 1; precise for small x.
pub fn expm1(x: f64) -> f64 {
    libm::expm1(x)
}

/// Natural logarithm.
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// Decimal logarithm.
pub fn log10(x: f64) -> f64 {
    libm::log10(x)
}

/// x to the power y.
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Radians per degree: the nearest double and its rounding error.
const DEGREE: (f64, f64) = (PI / 180.0, 2.948_652_270_870_168_7e-19);

/// Degrees per radian: the nearest double and its rounding error.
const RADIAN: (f64, f64) = (180.0 / PI, -1.987_849_567_057_628_4e-15);

/// Product of two numbers: the nearest double and its rounding error. (Halves of 26 bits have exact products; T. J. Dekker 1971. `fma`
/// would be a slow subroutine in the browser.)
fn product(x: f64, y: f64) -> (f64, f64) {
    let half = |x: f64| f64::from_bits(x.to_bits() & !0x7ff_ffff);
    let (x_half, y_half) = (half(x), half(y));
    let (x_rest, y_rest) = (x - x_half, y - y_half);
    let nearest = x * y;
    (nearest, x_half * y_half - nearest + x_half * y_rest + x_rest * y_half + x_rest * y_rest)
}

/// Sum of a number and a smaller one: the nearest double and its rounding error.
fn sum(large: f64, small: f64) -> (f64, f64) {
    let nearest = large + small;
    (nearest, small - (nearest - large))
}

/// Coefficients of the series of sine and cosine, the last first, without the two largest of each.
const SERIES: [(f64, f64); 7] = [
    (1.0 / 355_687_428_096_000.0, 1.0 / 20_922_789_888_000.0),
    (-1.0 / 1_307_674_368_000.0, -1.0 / 87_178_291_200.0),
    (1.0 / 6_227_020_800.0, 1.0 / 479_001_600.0),
    (-1.0 / 39_916_800.0, -1.0 / 3_628_800.0),
    (1.0 / 362_880.0, 1.0 / 40_320.0),
    (-1.0 / 5_040.0, -1.0 / 720.0),
    (1.0 / 120.0, 1.0 / 24.0),
];

/// Sine and cosine of an angle in degrees, each the nearest double and its rounding error.
///
/// Degrees are reduced to -45 to 45 without an error, and only the small parts of a sum are rounded: the result is the nearest double,
/// except for a few hundredths of its last place. So `sin 30` is 0.5.
fn both_of_degrees(x: f64) -> [(f64, f64); 2] {
    let turn = x % 360.0;
    let quadrant = (turn / 90.0).round();
    let rest = turn - 90.0 * quadrant;
    let (a, error) = product(rest, DEGREE.0);
    let error = error + rest * DEGREE.1;
    let square = a * a;
    let (sin, cos) = SERIES.iter().fold((0.0, 0.0), |(sin, cos), term| (sin * square + term.0, cos * square + term.1));
    let (half, lost) = product(0.5 * a, a);
    // sin(a + e) = sin a + e cos a, cos(a + e) = cos a - e sin a.
    let sin = sum(a, a * square * (sin * square - 1.0 / 6.0) + error * (1.0 - half));
    let one = sum(1.0, -half);
    let cos = sum(one.0, one.1 + (square * square * cos - lost - a * error));
    let minus = |(x, low): (f64, f64)| (0.0 - x, -low);
    match quadrant as i32 & 3 {
        0 => [sin, cos],
        1 => [cos, minus(sin)],
        2 => [minus(sin), minus(cos)],
        _ => [minus(cos), sin],
    }
}

/// Sine and cosine of an angle in degrees.
pub fn sin_cos_degrees(x: f64) -> (f64, f64) {
    let [sin, cos] = both_of_degrees(x);
    (sin.0, cos.0)
}

/// Tangent of an angle in degrees; `None` where the cosine is 0.
pub fn tan_degrees(x: f64) -> Option<f64> {
    let [sin, cos] = both_of_degrees(x);
    let tan = sin.0 / cos.0;
    let (back, error) = product(tan, cos.0);
    (cos.0 != 0.0).then(|| tan + (sin.0 - back - error + sin.1 - tan * cos.1) / cos.0)
}

/// Converts an angle to degrees; gives the exact whole degree beside it if `of` confirms that angle.
fn degrees(radians: f64, of: impl Fn(f64) -> bool) -> f64 {
    let (nearest, error) = product(radians, RADIAN.0);
    let angle = nearest + (error + radians * RADIAN.1);
    let whole = angle.round();
    if (angle - whole).abs() < 1e-9 && of(whole) { whole } else { angle }
}

/// Arc sine in degrees, -90 to 90; exact for the sine of a whole degree.
pub fn asin_degrees(x: f64) -> f64 {
    degrees(asin(x), |angle| sin_cos_degrees(angle).0 == x)
}

/// Arc cosine in degrees, 0 to 180; exact for the cosine of a whole degree.
pub fn acos_degrees(x: f64) -> f64 {
    degrees(acos(x), |angle| sin_cos_degrees(angle).1 == x)
}

/// Angle of the point (x, y) in degrees, -180 to 180; exact for the tangent of a whole degree.
pub fn atan2_degrees(y: f64, x: f64) -> f64 {
    degrees(atan2(y, x), |angle| tan_degrees(angle) == Some(y / x))
}

/// Length of the vector (x, y).
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}
