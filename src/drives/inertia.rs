//! Masses and moments of inertia of rotating parts. Kilograms, metres, kg m².

use crate::math::PI;

/// Square metres per square centimetre: data sheets and forms give moments of inertia in kg cm².
pub const CM2: f64 = 1e-4;

/// Density of steel, kg/m³. Source: sizing facts 2.1.
pub const STEEL: f64 = 7850.0;

/// A cylinder rotating about its axis, solid or hollow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// Outer diameter, m.
    pub outer: f64,
    /// Inner diameter, m; 0 if solid.
    pub inner: f64,
    /// Length, m.
    pub length: f64,
    /// Density, kg/m³.
    pub density: f64,
}

impl Cylinder {
    /// Mass in kg: `π / 4 · (D² - d²) · L · ρ`. Source: sizing facts 2.1, checked as B1 and C1.
    pub fn mass(&self) -> f64 {
        PI / 4.0 * (self.outer * self.outer - self.inner * self.inner) * self.length * self.density
    }

    /// Moment of inertia in kg m²: `m (D² + d²) / 8`. Source: sizing facts 2.1, checked as B2 and C2.
    pub fn inertia(&self) -> f64 {
        self.mass() * (self.outer * self.outer + self.inner * self.inner) / 8.0
    }
}

/// Moment of inertia of a solid cylinder of a known mass: `m D² / 8`. Source: sizing facts 2.1.
pub fn solid(mass: f64, diameter: f64) -> f64 {
    mass * diameter * diameter / 8.0
}

/// Moment of inertia of a mass on a circle, or of a mass moving with the web around a roller: `m R²`. Source: sizing facts 2.1, checked as
/// C3.
pub fn at_radius(mass: f64, radius: f64) -> f64 {
    mass * radius * radius
}

/// Moment of inertia of a roller, reduced to another roller on the same web: `J (D / d)²`, with its diameter `own` (d) and the other
/// roller's diameter `seen` (D). Source: sizing facts 2.1, checked as B3.
pub fn across_web(inertia: f64, own: f64, seen: f64) -> f64 {
    let ratio = seen / own;
    inertia * ratio * ratio
}

/// Moment of inertia at the output of a gear, reduced to the motor shaft: `J / i²`, with i = motor speed / load speed. Source: sizing facts
/// 2.1.
pub fn through_gear(inertia: f64, ratio: f64) -> f64 {
    inertia / (ratio * ratio)
}

/// Gear ratio for the fastest acceleration of a load: `√(J / J_M)`, with J_M of the rotor and all parts turning with it.
/// Source: sizing facts 2.1, checked as C20.
pub fn best_ratio(inertia: f64, rotor: f64) -> f64 {
    (inertia / rotor).sqrt()
}
