//! Turning in closed form: time of a straight cut at constant surface speed or constant speed, and its load on the motor.

use super::speed::{limit_diameter, surface_rpm};
use crate::math::{self, PI};

/// Least depth of cut (mm) that an advice names: below it an edge rubs. Engineering choice.
pub const LEAST_DEPTH: f64 = 0.1;

/// A straight cut: along the part, across its face, or a taper. The diameter changes linearly along the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Diameters in mm at start and end; negative beyond the centre.
    pub diameters: (f64, f64),
    /// Length of the path in mm; half the difference of the diameters on a face.
    pub length: f64,
    /// Feed in mm per revolution.
    pub feed: f64,
}

impl Cut {
    /// Time (s) at a constant speed in r/min: `t = 60 L / (f n)`; 0 for a path without length, infinite at standstill.
    pub fn time_at(&self, rpm: f64) -> f64 {
        if self.length > 0.0 { 60.0 * self.length / (self.feed * rpm) } else { 0.0 }
    }

    /// Time (s) at a surface speed in m/min, with the spindle speed limited to `low` to `high` r/min. Without limits
    /// `t = 60 π L d / (1000 v f)` with the mean diameter d, on a face `60 π (r₁² - r₂²) / (1000 v f)`; the parts under a limit take
    /// `60 L / (f n)`.
    ///
    /// Source: `docs/reference/sinumerik-802d.md` section 7 (10.019832 s for the face there).
    pub fn surface_time(&self, speed: f64, (low, high): (f64, f64)) -> f64 {
        let (from, to) = self.diameters;
        if from * to < 0.0 {
            let share = from / (from - to);
            let part = |diameters, share| Cut { diameters, length: self.length * share, feed: self.feed };
            return part((from, 0.0), share).surface_time(speed, (low, high))
                + part((0.0, to), 1.0 - share).surface_time(speed, (low, high));
        }
        let (small, large) = (from.abs().min(to.abs()), from.abs().max(to.abs()));
        if speed <= 0.0 {
            return self.time_at(0.0);
        }
        if small == large {
            return self.time_at(surface_rpm(speed, small).max(low).min(high));
        }
        // Below the diameter of the upper limit, between the two, and above that of the lower one.
        let within = |d: f64| d.max(small).min(large);
        let (first, last) = (within(limit_diameter(speed, high)), within(limit_diameter(speed, low)).max(small));
        let per_diameter = self.length / (large - small);
        let length = |a: f64, b: f64| (b - a).max(0.0) * per_diameter;
        let at = |rpm: f64, length: f64| if length > 0.0 { 60.0 * length / (self.feed * rpm) } else { 0.0 };
        let free = 60.0 * PI * length(first, last) * 0.5 * (first + last) / (1000.0 * speed * self.feed);
        at(high, length(small, first)) + free + at(low, length(last.max(first), large))
    }
}

/// Specific cutting force of a material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kienzle {
    /// At a chip of 1 mm by 1 mm and a rake angle of 0°, N/mm².
    pub unit_force: f64,
    /// Exponent of the chip thickness.
    pub exponent: f64,
}

/// Depth and feed of a cut; the edge angle makes width and thickness of the chip from them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chip {
    /// Depth of cut, mm.
    pub depth: f64,
    /// Feed, mm per revolution or per insert.
    pub feed: f64,
}

/// Angles of a cutting edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CuttingEdge {
    /// Edge angle between edge and feed, degrees.
    pub angle: f64,
    /// Rake angle, degrees.
    pub rake: f64,
}

impl Kienzle {
    /// Cutting force in N after Kienzle: `F = k_c1.1 · b · h^(1 - m_c) · (1 - γ / 100)` with `h = f sin κ`, `b = a_p / sin κ`.
    ///
    /// Source: `docs/reference/turning-spindle.md` section 4 (1760.9 N for C45, 3 mm, 0.3 mm, 95°).
    pub fn force(&self, chip: Chip, edge: CuttingEdge) -> f64 {
        let sine = math::sin(edge.angle.to_radians());
        self.unit_force * chip.depth / sine
            * math::pow(chip.feed * sine, 1.0 - self.exponent)
            * (1.0 - edge.rake / 100.0)
    }
}

/// Share of the feed at which a cut has a share of its force: `s^(1 / (1 - m_c))`, by the same law.
pub fn feed_share(force_share: f64, exponent: f64) -> f64 {
    math::pow(force_share, 1.0 / (1.0 - exponent))
}

/// Torque in Nm of a cutting force in N at a diameter in mm: `M = F d / 2000`.
pub fn torque(force: f64, diameter: f64) -> f64 {
    force * diameter.abs() / 2000.0
}

/// Acceleration of a spindle (r/min per second) at constant surface speed: `dn/dt = n² f s / (60 d)`, where n is its speed in r/min, f the
/// feed in mm per revolution, d the diameter in mm and s the change of the diameter for each millimetre of path (2 on a face). 0 at the centre.
///
/// Source: derivative of `n = 1000 v / (π d)` along the path.
pub fn speed_gradient(rpm: f64, feed: f64, slope: f64, diameter: f64) -> f64 {
    if diameter > 0.0 { rpm * rpm * feed * slope / (60.0 * diameter) } else { 0.0 }
}
