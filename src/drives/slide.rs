//! A slide on a ball screw, reduced to the shaft of its motor. Kilograms, metres, newtons, newton metres, radians.

use super::inertia::{self, Cylinder};
use super::load::{Load, through_gear};
use crate::math::{self, PI, RPM};

/// Eigenvalue of a bar's first bending between a fixed bearing and a supporting one.
const FIXED_SUPPORTED: f64 = 3.9266;
/// Root diameter of a ball screw over its nominal one. Engineering choice.
const ROOT: f64 = 0.85;
/// Share of the critical speed that a screw may reach. Source: sizing facts 2.13, from memory.
const BELOW_CRITICAL: f64 = 0.8;
/// Modulus of elasticity of steel, N/m².
const ELASTICITY: f64 = 206e9;

/// Standard acceleration of gravity, m/s². Source: ISO 80000-3.
const GRAVITY: f64 = 9.80665;

/// A slide with its screw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slide {
    /// Mass that moves along the way, kg.
    pub mass: f64,
    /// Friction of guideways, covers and nut along the way, N.
    pub friction: f64,
    /// Angle of its positive direction above the horizontal, rad.
    pub inclination: f64,
    /// The screw.
    pub screw: Cylinder,
    /// Travel per turn of the screw, m.
    pub lead: f64,
    /// Speed of the motor over that of the screw.
    pub gear: f64,
    /// Efficiency of screw and gear, 0 to 1.
    pub efficiency: f64,
}

impl Slide {
    /// Speed (r/min) that its screw may reach: 0.8 of the first critical speed of bending, `0.8 · 30 / π · λ² d / (4 L²) · √(E / ρ)`, with the root
    /// diameter d, the whole length L between a fixed bearing and a supporting one. Source: sizing facts 2.13.
    pub fn highest_screw_speed(&self) -> f64 {
        let Cylinder { outer, length, density, .. } = self.screw;
        let bending = FIXED_SUPPORTED * FIXED_SUPPORTED * ROOT * outer / (4.0 * length * length);
        BELOW_CRITICAL * bending * (ELASTICITY / density).sqrt() / RPM
    }

    /// Load at the motor's shaft: `(J_S + m (h / 2π)²) / i²`, and the torque of the friction. Source: a slide of mass m moves with the
    /// screw as a mass on the radius h / 2π.
    pub fn load(&self) -> Load {
        let at_screw = self.screw.inertia() + inertia::at_radius(self.mass, self.lead / (2.0 * PI));
        Load {
            inertia: inertia::through_gear(at_screw, self.gear),
            torque: self.torque(self.friction),
            efficiency: self.efficiency,
        }
    }

    /// Torque at the motor's shaft by a force against the motion: `F h / (2π i η)`. Source: work of the force over a turn.
    pub fn torque(&self, force: f64) -> f64 {
        through_gear(force * self.lead / (2.0 * PI), self.gear, self.efficiency)
    }

    /// Torque at the motor's shaft while the slide moves down its way against a force: the weight helps. Negative where it drives the
    /// motor.
    pub fn downhill(&self, force: f64) -> f64 {
        self.torque(force + self.friction - self.mass * GRAVITY * math::sin(self.inclination))
    }

    /// Torque at the motor's shaft by which it holds the weight at rest, without the losses of the screw: `m g sin α · h / (2π i)`.
    pub fn weight(&self) -> f64 {
        self.mass * GRAVITY * math::sin(self.inclination) * self.lead / (2.0 * PI * self.gear)
    }

    /// Speed of the motor (r/min) at a speed of the slide in m/min.
    pub fn motor_speed(&self, speed: f64) -> f64 {
        speed / self.lead * self.gear
    }
}
