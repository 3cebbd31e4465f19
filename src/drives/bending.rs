//! Bending of a clamped bar under the force of a cut: free at its end, or held there by a tailstock. Newtons, mm, N/mm².

use crate::math::PI;

/// Modulus of elasticity of steel, N/mm². Source: memory.
pub const STEEL: f64 = 210_000.0;

/// Deflection (mm) from which a slender work deserves attention. Source: engineering choice.
pub const NOTABLE: f64 = 0.1;

/// Second moment of area (mm⁴) of a round bar: `π D⁴ / 64`.
fn second_moment(diameter: f64) -> f64 {
    PI * cube(diameter) * diameter / 64.0
}

fn cube(x: f64) -> f64 {
    x * x * x
}

/// Deflection (mm) of a bar in steps under a force across its free end: `F / 3E · Σ (b³ - a³) / I`, with each step from a to b away from the
/// force; `steps` are lengths and diameters from the force to the jaws. At most the
/// length of the bar, far beyond small deflections. Source: polygon turning facts 3.13.
pub fn cantilever(force: f64, elasticity: f64, steps: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let mut from = 0.0;
    let mut sum = 0.0;
    for (length, diameter) in steps {
        let to: f64 = from + length.max(0.0);
        sum += (cube(to) - cube(from)) / second_moment(diameter);
        from = to;
    }
    (force / (3.0 * elasticity) * sum).min(from)
}

/// Greatest deflection (mm) under a force across a bar that a tailstock holds: `F L³ / (102 E I)`, the force at 0.586 L from the jaws.
/// Source: polygon turning facts 3.13.
pub fn supported(force: f64, elasticity: f64, length: f64, diameter: f64) -> f64 {
    (force * cube(length) / (102.0 * elasticity * second_moment(diameter))).min(length)
}
