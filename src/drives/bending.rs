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

/// Places along a bar at which the force is tried.
const PLACES: u32 = 200;

/// Greatest deflection (mm) under a force across a bar in steps that a tailstock holds, wherever the force is up to `reach` (mm) from the tailstock.
/// At s from there it is `F (∫ (x - s)² / EI - (∫ (x - s) x / EI)² / ∫ x² / EI)`, the first two integrals from s to the jaws, the last one from
/// the tailstock: unit loads, with the force of the tailstock that leaves no deflection there. `steps` are lengths and diameters from the
/// tailstock to the jaws. Source: polygon turning facts 3.13.
pub fn supported_in_steps(force: f64, elasticity: f64, steps: impl IntoIterator<Item = (f64, f64)>, reach: f64) -> f64 {
    let mut length = 0.0;
    let mut bars = Vec::new();
    for (step, diameter) in steps {
        let to: f64 = length + step.max(0.0);
        bars.push((length, to, 1.0 / second_moment(diameter)));
        length = to;
    }
    let hinge: f64 = bars.iter().map(|(from, to, soft)| soft * (cube(*to) - cube(*from)) / 3.0).sum();
    let bends = |s: f64| {
        let (mut own, mut mutual) = (0.0, 0.0);
        for (from, to, soft) in bars.iter().filter(|(_, to, _)| *to > s) {
            let from = from.max(s);
            own += soft * (cube(to - s) - cube(from - s)) / 3.0;
            mutual += soft * ((cube(*to) - cube(from)) / 3.0 - s * (to * to - from * from) / 2.0);
        }
        own - mutual * mutual / hinge
    };
    let places = (1..=PLACES).map(|at| reach * f64::from(at) / f64::from(PLACES));
    (force / elasticity * places.map(bends).fold(0.0, f64::max)).min(length)
}
