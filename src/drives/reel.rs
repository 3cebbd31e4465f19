//! A reel of web whose diameter changes: length, inertia, speed, brake, and what it pulls at the web when the line changes its speed.
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

/// Radius of a winding after a length came (positive) or left (negative), in the unit of all three: the face of the winding is what the web
/// is from the side, `π R² = π R0² + t L`. Source: sizing facts 2.9.
pub fn radius_after(radius: f64, thickness: f64, length: f64) -> f64 {
    (radius * radius + thickness * length / PI).max(0.0).sqrt()
}

/// Turns of a reel whose radius went from one value to another by a length, in one unit: `L / (π (R0 + R))`, the mean circumference.
/// Source: sizing facts 2.9.
pub fn turns((from, to): (f64, f64), length: f64) -> f64 {
    length.abs() / (PI * (from + to))
}

impl Reel {
    /// Length of web in m on the full reel: `π (D² - d²) / (4 t)`; 0 where the core is not smaller. Source: sizing facts 2.9.
    pub fn length(&self) -> f64 {
        (PI * (self.full * self.full - self.core * self.core) / (4.0 * self.thickness)).max(0.0)
    }

    /// Diameter in m of a full reel that holds a length in m: `√(d² + 4 t L / π)`. Source: sizing facts 2.9.
    pub fn full_for(&self, length: f64) -> f64 {
        2.0 * radius_after(0.5 * self.core, self.thickness, length)
    }

    /// Diameter in m when a length in m has left the full reel: `√(D² - 4 t L / π)`, the core at least. Source: sizing facts 2.9.
    pub fn diameter_after(&self, length: f64) -> f64 {
        (2.0 * radius_after(0.5 * self.full, self.thickness, -length)).max(self.core)
    }

    /// Mass of the web in kg at a diameter in m: that of a hollow cylinder. Source: sizing facts 2.1.
    pub fn web_mass(&self, diameter: f64) -> f64 {
        self.web(diameter).mass()
    }

    /// Moment of inertia in kg m² at a diameter in m: `m (D² + d²) / 8`, and the core with its flanges. Source: sizing facts 2.1.
    pub fn inertia(&self, diameter: f64) -> f64 {
        self.web(diameter).inertia() + self.core_inertia
    }

    fn web(&self, diameter: f64) -> Cylinder {
        Cylinder { outer: diameter.max(self.core), inner: self.core, length: self.width, density: self.density }
    }

    /// Mass in kg by which the web feels the reel at a diameter in m: `J / r²`, so that a change of speed pulls `J α / r = (J / r²) a` at the
    /// web, with `α = a / r`. Source: sizing facts 2.1.
    pub fn mass_at_web(&self, diameter: f64) -> f64 {
        self.inertia(diameter) / (0.25 * diameter * diameter)
    }

    /// The diameter in m, full or at the core, at which the web feels the greater mass. With `A = π b ρ / 2` the mass is
    /// `A r² + (J_core - A r_core⁴) / r²`: it grows with r, or has one least value between both ends. Source: sizing facts 2.9.
    pub fn worst(&self) -> f64 {
        let full = self.full.max(self.core);
        if self.mass_at_web(self.core) > self.mass_at_web(full) { self.core } else { full }
    }

    /// Pull in N at the web, besides the brake's, while its speed changes by `acceleration` m/s²: `J α / r`, with the reel at a diameter in m.
    /// A reel that is slowed down by its brake alone runs on into slack web where the brake holds less. Source: sizing facts 2.1.
    pub fn pull(&self, diameter: f64, acceleration: f64) -> f64 {
        self.mass_at_web(diameter) * acceleration
    }
}

/// Speed in rad/s of a reel of a diameter in m whose web runs at `speed` m/s: `2 v / D`.
pub fn speed(diameter: f64, speed: f64) -> f64 {
    2.0 * speed / diameter
}

/// Torque in Nm of a tension in N at a diameter in m: `T D / 2`. A brake of one torque pulls the more the smaller its reel is.
pub fn torque(diameter: f64, tension: f64) -> f64 {
    0.5 * tension * diameter
}

/// Mean acceleration in m/s² of a web that reaches `speed` m/s in `seconds`; 0 where its drive has no ramp, whose time is not known then.
pub fn acceleration(speed: f64, seconds: f64) -> f64 {
    if seconds > 0.0 { speed / seconds } else { 0.0 }
}
