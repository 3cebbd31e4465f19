//! Exact curve of one insert tip over the work in one pass, relative to the normal of its side.

use crate::math::{self, PI};

/// One pass in the frame of its side. The tool angle σ goes from -π to π; at σ = 0 the tip points at the centre of the work. Angles in
/// radians, lengths in mm. The curve is symmetric to the normal, so its formulas are for σ ≥ 0.
///
/// In the work frame `P(σ) = e^(-iσ/k) (a - r e^(iσ))`, turned by the angle of the normal. Source: polygon turning facts 3.1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    distance: f64,
    radius: f64,
    ratio: f64,
}

/// A part of a pass in which the angle from the normal rises with σ, and the radius with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Branch {
    /// +1 or -1: the factor that makes [`Curve::turn`] rise.
    sign: f64,
    /// σ at the start and end.
    pub(super) sigma: (f64, f64),
    /// Angle from the normal at the start and end.
    pub(super) angle: (f64, f64),
}

impl Curve {
    /// The pass of a tip at `radius` about a tool axis at `distance` from the work axis; `ratio` is tool speed over work speed. `None` if
    /// the tip reaches the centre of the work, or if work or tool does not turn.
    pub fn new(distance: f64, radius: f64, ratio: f64) -> Option<Curve> {
        let sound = radius > 0.0 && distance > radius && distance < 1e6 && ratio.abs() > 1e-6 && ratio.abs() < 1e6;
        sound.then_some(Curve { distance, radius, ratio })
    }

    /// Distance of the tool axis from the work axis, a.
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// Radius of the tip circle, r.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Tool speed over work speed, k.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// Least distance of the tip from the centre of the work, for any ratio: `d = a - r`, half of the distance across flats. Source:
    /// polygon turning facts 3.1.
    pub fn apothem(&self) -> f64 {
        self.distance - self.radius
    }

    /// Distance of the tip from the centre of the work: `ρ² = a² + r² - 2 a r cos σ = d² + 4 a r sin²(σ/2)`.
    /// Source: polygon turning facts 3.1.
    pub fn reach(&self, sigma: f64) -> f64 {
        let half = math::sin(0.5 * sigma);
        let d = self.apothem();
        (d * d + 4.0 * self.distance * self.radius * half * half).sqrt()
    }

    /// The σ (0 to π) for a distance of the tip from the centre of the work.
    pub fn sigma_at(&self, reach: f64) -> f64 {
        let d = self.apothem();
        let square = (reach - d) * (reach + d) / (4.0 * self.distance * self.radius);
        if reach > d { 2.0 * math::asin(square.min(1.0).sqrt()) } else { 0.0 }
    }

    /// Angle of the tip from the normal, in the frame of the work: `b = σ/k + atan2(r sin σ, a - r cos σ)`, from polygon turning facts 3.1.
    pub fn turn(&self, sigma: f64) -> f64 {
        self.turning(sigma).0
    }

    /// [`Curve::turn`] and db/dσ = `1/k - 1/2 + (a² - r²) / (2 ρ²)`, which changes its sign at one radius at most.
    fn turning(&self, sigma: f64) -> (f64, f64) {
        let (sin, cos) = math::sin_cos(sigma);
        let (x, y) = (self.distance - self.radius * cos, self.radius * sin);
        let slope = 1.0 / self.ratio - 0.5 + 0.5 * self.squares() / (x * x + y * y);
        (sigma / self.ratio + math::atan2(y, x), slope)
    }

    /// dρ/dσ = `a r sin σ / ρ`.
    pub(super) fn climb(&self, sigma: f64) -> f64 {
        self.distance * self.radius * math::sin(sigma) / self.reach(sigma)
    }

    fn squares(&self) -> f64 {
        (self.distance - self.radius) * (self.distance + self.radius)
    }

    /// Area between the centre of the work and the curve from the normal to σ, negative where b falls: `½ ∫ ρ² b' dσ` =
    /// `½ [(1/k - 1/2) ((a² + r²) σ - 2 a r sin σ) + (a² - r²) σ / 2]`.
    pub(super) fn area(&self, sigma: f64) -> f64 {
        let (a, r) = (self.distance, self.radius);
        let squares = (a * a + r * r) * sigma - 2.0 * a * r * math::sin(sigma);
        0.5 * ((1.0 / self.ratio - 0.5) * squares + 0.5 * self.squares() * sigma)
    }

    /// Curvature at the middle of the side in 1/mm: `κ = [a - r (k-1)²] / [a + r (k-1)]²`; positive if the side is convex, negative if
    /// concave. Infinite if the tip is at rest on the work. Source: polygon turning facts 3.3.
    pub fn curvature(&self) -> f64 {
        let k = self.ratio - 1.0;
        let (speed, bend) = (self.distance + self.radius * k, self.distance - self.radius * k * k);
        // A speed within rounding errors counts as rest.
        if speed.abs() < 1e-9 * self.distance { f64::INFINITY.copysign(bend) } else { bend / (speed * speed) }
    }

    /// The branches of the pass within a radius of the work and half a turn from the normal. The second is empty unless the path turns back
    /// and its far end, on the other side of the normal, passes the turning point.
    pub(super) fn branches(&self, within: f64) -> [Branch; 2] {
        let last = self.sigma_at(within);
        // ρ² = (a² - r²) / (1 - 2/k) at the turning point of b.
        let square = self.squares() / (1.0 - 2.0 / self.ratio);
        let apothem = self.apothem();
        let back = if square > apothem * apothem { self.sigma_at(square.sqrt()) } else { PI };
        let sign = if 1.0 / self.ratio + self.radius / apothem > 0.0 { 1.0 } else { -1.0 };
        let near = self.branch(sign, (0.0, last.min(back)), 0.0);
        let far = self.branch(-sign, (back.min(last), last), near.angle.1);
        [near, far]
    }

    /// The part of a branch at angles from `begin` to half a turn.
    fn branch(&self, sign: f64, sigma: (f64, f64), begin: f64) -> Branch {
        let whole = Branch { sign, sigma, angle: (sign * self.turn(sigma.0), sign * self.turn(sigma.1)) };
        let (from, to) = (begin.max(whole.angle.0), whole.angle.1.min(PI));
        let angle = (from, to.max(from));
        Branch { sigma: (self.sigma(&whole, angle.0, sigma.0), self.sigma(&whole, angle.1, sigma.1)), angle, ..whole }
    }

    /// The σ at an angle from the normal. A close `guess` makes the search short.
    pub(super) fn sigma(&self, branch: &Branch, angle: f64, guess: f64) -> f64 {
        let (mut low, mut high) = branch.sigma;
        if angle <= branch.angle.0 || angle >= branch.angle.1 {
            return if angle <= branch.angle.0 { low } else { high };
        }
        let inside = |x: f64, low: f64, high: f64| x > low && x < high;
        let mut sigma = if inside(guess, low, high) { guess } else { 0.5 * (low + high) };
        for _ in 0..64 {
            let (turn, slope) = self.turning(sigma);
            let off = branch.sign * turn - angle;
            *(if off > 0.0 { &mut high } else { &mut low }) = sigma;
            let step = off / (branch.sign * slope);
            // Newton's step if it stays in the bracket. It squares the error, so a step this small is the last.
            if !inside(sigma - step, low, high) {
                if off == 0.0 || high - low <= 1e-15 {
                    break;
                }
                sigma = 0.5 * (low + high);
                continue;
            }
            sigma -= step;
            if step.abs() <= 1e-8 {
                break;
            }
        }
        sigma
    }

    /// Angle from the normal at σ along a branch.
    pub(super) fn angle(&self, branch: &Branch, sigma: f64) -> f64 {
        branch.sign * self.turn(sigma)
    }

    /// Derivative of that angle with respect to σ.
    pub(super) fn angle_slope(&self, branch: &Branch, sigma: f64) -> f64 {
        branch.sign * self.turning(sigma).1
    }
}

impl Branch {
    /// Whether the branch is empty.
    pub(super) fn is_empty(&self) -> bool {
        self.angle.1 <= self.angle.0
    }
}

/// Ratio with flat middles of the sides, for a distance of the axes and a tip circle: `k = 1 + √(a/r)`. Source: polygon turning facts 3.3.
pub fn flat_ratio(distance: f64, radius: f64) -> f64 {
    1.0 + (distance / radius).sqrt()
}
