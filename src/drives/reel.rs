//! A reel of web with changing diameter: length, inertia, speed, brake, and its pull on the web when the line speed changes.
//!
//! Metres, kg, kg m², N.

use super::inertia::Cylinder;
use crate::math::PI;

/// A reel: web of one thickness, wound without gaps on a core.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reel {
    /// Outer diameter of the full reel, m.
    pub full: f64,
    /// Diameter of the core, m.
    pub core: f64,
    /// Width of the web, m.
    pub width: f64,
    /// Thickness of the web, m.
    pub thickness: f64,
    /// Density of the web, kg/m³.
    pub density: f64,
    /// Moment of inertia of core, flanges and shaft, kg m².
    pub core_inertia: f64,
}

/// Radius of a winding after a length was added (positive) or removed (negative), all in one unit. The face of the winding has the area of
/// the web's edge: `π R² = π R0² + t L`. Source: sizing facts 2.9.
pub fn radius_after(radius: f64, thickness: f64, length: f64) -> f64 {
    (radius * radius + thickness * length / PI).max(0.0).sqrt()
}

/// Turns of a reel for a length and the radii before and after, in one unit: `L / (π (R0 + R))`, by the mean circumference.
/// Source: sizing facts 2.9.
pub fn turns((from, to): (f64, f64), length: f64) -> f64 {
    length.abs() / (PI * (from + to))
}

impl Reel {
    /// Length of web in m on the full reel: `π (D² - d²) / (4 t)`; 0 if the core is not smaller. Source: sizing facts 2.9.
    pub fn length(&self) -> f64 {
        (PI * (self.full * self.full - self.core * self.core) / (4.0 * self.thickness)).max(0.0)
    }

    /// Diameter in m of a full reel with a length in m: `√(d² + 4 t L / π)`. Source: sizing facts 2.9.
    pub fn full_for(&self, length: f64) -> f64 {
        2.0 * radius_after(0.5 * self.core, self.thickness, length)
    }

    /// Mass of the web in kg at a diameter in m, as a hollow cylinder. Source: sizing facts 2.1.
    pub fn web_mass(&self, diameter: f64) -> f64 {
        self.web(diameter).mass()
    }

    /// Moment of inertia in kg m² at a diameter in m: `m (D² + d²) / 8`, plus core and flanges. Source: sizing facts 2.1.
    pub fn inertia(&self, diameter: f64) -> f64 {
        self.web(diameter).inertia() + self.core_inertia
    }

    fn web(&self, diameter: f64) -> Cylinder {
        Cylinder { outer: diameter.max(self.core), inner: self.core, length: self.width, density: self.density }
    }

    /// Equivalent mass in kg of the reel at the web, at a diameter in m: `J / r²`. A change of speed pulls the web with
    /// `J α / r = (J / r²) a`, with `α = a / r`. Source: sizing facts 2.1.
    pub fn mass_at_web(&self, diameter: f64) -> f64 {
        self.inertia(diameter) / (0.25 * diameter * diameter)
    }

    /// Diameter in m, full or core, with the greater equivalent mass. With `A = π b ρ / 2` the mass is `A r² + (J_core - A r_core⁴) / r²`:
    /// it grows with r, or has one minimum between both ends. Source: sizing facts 2.9.
    pub fn worst(&self) -> f64 {
        let full = self.full.max(self.core);
        if self.mass_at_web(self.core) > self.mass_at_web(full) { self.core } else { full }
    }

    /// Pull in N on the web, in addition to the brake's, during a change of speed by `acceleration` m/s²: `J α / r`, at a diameter in m. A
    /// reel decelerated only by its brake overruns and slackens the web if the brake's pull is less. Source: sizing facts 2.1.
    pub fn pull(&self, diameter: f64, acceleration: f64) -> f64 {
        self.mass_at_web(diameter) * acceleration
    }
}

/// Speed in rad/s of a reel of a diameter in m at a web speed of `speed` m/s: `2 v / D`.
pub fn speed(diameter: f64, speed: f64) -> f64 {
    2.0 * speed / diameter
}

/// Torque in Nm of a tension in N at a diameter in m: `T D / 2`. At constant brake torque a smaller reel has more tension.
pub fn torque(diameter: f64, tension: f64) -> f64 {
    0.5 * tension * diameter
}

/// Mean acceleration in m/s² of a web to `speed` m/s in `seconds`.
pub fn acceleration(speed: f64, seconds: f64) -> f64 {
    speed / seconds
}
