//! Cutting by the inserts: speed over the work, angle of engagement, required relief, and twisted polygons.

use super::curve::Curve;
use super::ratio::Ratio;
use crate::math::{self, PI};

/// Load of one pass of the slide, or of all passes, on the inserts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InsertLoad {
    /// Relief angle in radians that the inserts have to exceed.
    pub relief: f64,
    /// Least and greatest cutting speed in m/min per r/min of the work.
    pub speeds: (f64, f64),
}

/// Load of every pass of the slide, each to its distance across flats, the first one into round stock of a radius. An insert meets no more
/// material than the preceding pass has left, so the passes together need less relief than the whole depth at once, if adjacent sides meet
/// in the stock before the last pass.
pub fn passes(sizes: &[f64], radius: f64, ratio: Ratio, sides: u32, stock: f64) -> impl Iterator<Item = InsertLoad> {
    let curve = move |size: f64| Curve::new(0.5 * size + radius, radius, ratio.value());
    let pitch = 2.0 * PI / f64::from(sides.max(1));
    let before = [None].into_iter().chain(sizes.iter().copied().map(curve));
    sizes.iter().copied().map(curve).zip(before).filter_map(move |(curve, before)| {
        let curve = curve?;
        let edge = before.map_or_else(|| curve.sigma_at(stock), |before| curve.edge(&before, pitch, stock));
        Some(InsertLoad { relief: curve.relief_needed(edge), speeds: curve.speeds(1.0, edge) })
    })
}

impl InsertLoad {
    /// The greater load of both.
    pub fn worst(self, other: InsertLoad) -> InsertLoad {
        let speeds = (self.speeds.0.min(other.speeds.0), self.speeds.1.max(other.speeds.1));
        InsertLoad { relief: self.relief.max(other.relief), speeds }
    }
}

impl Curve {
    /// Lever of the relative motion along the tool, `m = (k - 1) r`.
    fn arm(&self) -> f64 {
        (self.ratio() - 1.0) * self.radius()
    }

    /// Largest σ from the middle of its side at which the insert meets material, after `before` has passed on all sides, `pitch` apart: at
    /// the remaining corners, or at the stock's surface if adjacent sides do not meet in it.
    pub(super) fn edge(&self, before: &Curve, pitch: f64, stock: f64) -> f64 {
        let [near, _] = before.branches(stock);
        let meets = near.angle.1 > 0.5 * pitch;
        self.sigma_at(if meets { before.reach(before.sigma(&near, 0.5 * pitch, near.sigma.1)) } else { stock })
    }

    /// Cutting speed in m/min at a work speed in r/min and σ from the middle of the side: `v = 2π n |V|`, `|V|² = a² + m² + 2 a m cos σ`,
    /// `m = (k-1) r`. Source: polygon turning facts 3.3.
    pub fn speed(&self, rpm: f64, sigma: f64) -> f64 {
        let (sin, cos) = math::sin_cos(sigma);
        let along = self.distance() * cos + self.arm();
        2.0 * PI * rpm.abs() * math::hypot(along, self.distance() * sin) / 1000.0
    }

    /// Least and greatest cutting speed in m/min from the middle of the side to σ; the speed is monotonic in between.
    pub fn speeds(&self, rpm: f64, sigma: f64) -> (f64, f64) {
        let (middle, edge) = (self.speed(rpm, 0.0), self.speed(rpm, sigma));
        (middle.min(edge), middle.max(edge))
    }

    /// Whether the inserts face as on a cutter that turns in the direction of the work; otherwise they have to face the other way. The tip
    /// moves over the middle of the side by `a + (k-1) r = d + k r` per radian of the work.
    pub fn faces_forward(&self) -> bool {
        self.distance() + self.arm() > 0.0
    }

    /// Angle between the motion of the tip over the work and the tangent of the cutter at σ: `ψ = atan[a sin σ / (a cos σ + (k-1) r)]`. At
    /// positive σ (after the middle if the tool turns in the positive direction) it reduces the relief and increases the rake by ψ, at
    /// negative σ the reverse. At a right angle or more the insert cannot cut. Source: polygon turning facts 3.4.
    pub fn engagement(&self, sigma: f64) -> f64 {
        let (sin, cos) = math::sin_cos(sigma);
        let along = self.distance() * cos + self.arm();
        math::atan2(self.distance() * sin, if self.faces_forward() { along } else { -along })
    }

    /// Relief angle that an insert has to exceed for a cut that reaches to σ on both sides of the middle: the greatest
    /// [`Curve::engagement`]. It rises with σ; for `|m| > a` it is greatest at `cos σ = -a/m`.
    pub fn relief_needed(&self, sigma: f64) -> f64 {
        let (a, m) = (self.distance(), self.arm());
        let peak = if m.abs() > a { math::acos(-a / m) } else { PI };
        self.engagement(sigma.min(peak))
    }
}

/// Tool speed in r/min for a polygon with one turn of twist in `lead` mm, while the slide moves at `feed` mm/min along the work axis:
/// `n_tool = k (n_work + F/K)`. A positive lead turns the section counter-clockwise in the direction of positive `feed`; the twist is
/// right-handed if angles are seen from the end that positive `feed` leads to. Source: polygon turning facts 3.5.
pub fn helical_tool_speed(ratio: Ratio, work: f64, feed: f64, lead: f64) -> f64 {
    ratio.value() * (work + feed / lead)
}

/// Twist in radians of the section at `z` against the section at the origin: `2π z / K`.
pub fn twist(z: f64, lead: f64) -> f64 {
    2.0 * PI * z / lead
}

/// Distance in mm between the marks of two cuts on the same flat, at a feed in mm per turn of the work. Source: polygon turning facts 3.2.
pub fn mark_pitch(ratio: Ratio, inserts: u32, feed_per_turn: f64) -> f64 {
    feed_per_turn / ratio.passes_per_turn(inserts)
}
