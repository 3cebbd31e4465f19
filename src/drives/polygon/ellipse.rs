//! Ratio 2, where every pass is an ellipse: the sides in closed form. Lengths in mm, polygon turning facts 3.3.

use crate::math::{self, PI};

/// Ratio of the half axes of the ellipse: `ε = (a - r) / (a + r) = d / (2 r + d)`.
fn flattening(apothem: f64, radius: f64) -> f64 {
    apothem / (2.0 * radius + apothem)
}

fn half_angle_tangent(sides: u32) -> f64 {
    math::tan(PI / f64::from(sides))
}

/// Distance of the side from the centre of the work at an angle from its normal: `ρ = d / √(cos² φ + ε² sin² φ)`.
pub fn reach(apothem: f64, radius: f64, angle: f64) -> f64 {
    let (sin, cos) = math::sin_cos(angle);
    apothem / math::hypot(cos, flattening(apothem, radius) * sin)
}

/// Depth of the corners below the ideal side, with `T = tan(π/N)`: `δ = d [1 - 1/√(1 + ε² T²)]`. For 3 sides or more.
pub fn sag(apothem: f64, radius: f64, sides: u32) -> f64 {
    // 1 - 1/h is (h² - 1) / (h² + h), without the loss of digits.
    let rise = flattening(apothem, radius) * half_angle_tangent(sides);
    let root = math::hypot(1.0, rise);
    apothem * rise * rise / (root * (root + 1.0))
}

/// Least tip circle with corners at most `sag` below the ideal side: the formula of [`sag`] solved for r. 0 if every radius does.
pub fn radius_for(apothem: f64, sides: u32, sag: f64) -> f64 {
    let root = apothem / (apothem - sag);
    let e = (root * root - 1.0).sqrt() / half_angle_tangent(sides);
    (0.5 * apothem * (1.0 / e - 1.0)).max(0.0)
}
