//! Interrupted cut of a pass: depth of the layer at an insert, and the levers of its force about work and tool.

use super::curve::Curve;
use super::ratio::Ratio;
use crate::math::{self, PI};

/// Depth of the layer times the lever of the cutting force about an axis, mm². Times a force per mm of depth it is a torque.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Moment {
    /// Greatest moment of the pass, the sum over all inserts in the cut.
    pub peak: f64,
    /// Mean over a turn of the tool.
    pub mean: f64,
}

/// Load of a pass on work and tool per newton of force per mm of depth.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PassLoad {
    /// Moment about the axis of the work.
    pub work: Moment,
    /// Moment about the axis of the tool.
    pub tool: Moment,
    /// Greatest depth of the layer across the motion of the tip, mm.
    pub depth: f64,
    /// Greatest number of inserts in the cut at once.
    pub at_once: u32,
    /// Mean number of inserts in the cut: less than 1 for an interrupted cut.
    pub engaged: f64,
}

/// Intervals from the middle of a side to its corner.
const INTERVALS: u32 = 48;

/// The load of every pass of the slide, each to its distance across flats, the first one into round stock of a radius; tips at `radius`.
///
/// The depth of the layer at an angle of the work is the height left by the preceding pass, `a_p = (ρ_before - ρ) cos ψ`, with ψ between
/// the motion of the tip and the circle about the work. Inserts are `2π/n` apart on the tool, each in the cut from -σ to σ, so at most
/// `1 + ⌊n σ / π⌋` at once. The mean is over the pass up to half of the pitch; beyond it the neighbour cuts. A deep layer is a sector of a
/// ring: in the mean its depth counts `(ρ_before + ρ) / (2 ρ)` times, so that the energy is that of the removed area.
pub fn passes(sizes: &[f64], radius: f64, ratio: Ratio, inserts: u32, stock: f64) -> impl Iterator<Item = PassLoad> {
    let curve = move |size: f64| Curve::new(0.5 * size + radius, radius, ratio.value());
    let pitch = 2.0 * PI / f64::from(ratio.sides(inserts).max(1));
    let before = [None].into_iter().chain(sizes.iter().copied().map(curve));
    let pairs = sizes.iter().copied().map(curve).zip(before);
    pairs.map(move |(curve, before)| {
        curve.map_or_else(PassLoad::default, |curve| curve.load(before.as_ref(), pitch, stock, inserts))
    })
}

impl Curve {
    /// Levers in mm of the cutting force about the work and about the tool, with the tip at σ, `m = (k - 1) r` and
    /// `V = √(a² + m² + 2 a m cos σ)`: `l_w = [a (a + (m - r) cos σ) - r m] / V`, `l_t = r (m + a cos σ) / V`. At σ = 0 they are a - r and
    /// r.
    ///
    /// The force is opposite to the motion of the tip over the work, so `l_w + k l_t = V` (power of both axes). Source: polygon turning
    /// facts 3.9.
    fn levers(&self, sigma: f64) -> (f64, f64) {
        let (sin, cos) = math::sin_cos(sigma);
        let (a, r) = (self.distance(), self.radius());
        let m = (self.ratio() - 1.0) * r;
        let speed = math::hypot(a * cos + m, a * sin);
        if speed <= 0.0 {
            return (0.0, 0.0);
        }
        ((a * (a + (m - r) * cos) - r * m) / speed, r * (m + a * cos) / speed)
    }

    /// The load of one pass after another one, or into round stock.
    fn load(&self, before: Option<&Curve>, pitch: f64, stock: f64, inserts: u32) -> PassLoad {
        let edge = before.map_or_else(|| self.sigma_at(stock), |before| self.edge(before, pitch, stock));
        let [near, _] = self.branches(stock);
        let last = self.sigma(&near, near.angle.1.min(0.5 * pitch), near.sigma.1);
        let layers = before.map(|before| (before, before.branches(stock)[0]));
        let surface = |angle: f64| match layers {
            Some((before, branch)) if angle < branch.angle.1 => {
                before.reach(before.sigma(&branch, angle, branch.sigma.0)).min(stock)
            }
            _ => stock,
        };
        // Ends and middles of the intervals: the peak is over all, the mean over the middles, because the layer may end abruptly.
        let step = 0.5 * last / f64::from(INTERVALS);
        let (mut peak, mut sum, mut depth) = ((0.0_f64, 0.0_f64), (0.0, 0.0), 0.0_f64);
        for at in 0..=2 * INTERVALS {
            let sigma = step * f64::from(at);
            let (work, tool) = self.levers(sigma);
            let reach = self.reach(sigma);
            let surface = surface(self.angle(&near, sigma));
            let layer = (surface - reach).max(0.0) * (work / reach).abs();
            depth = depth.max(layer);
            peak = (peak.0.max(layer * work.abs()), peak.1.max(layer * tool.abs()));
            if at % 2 == 1 {
                let mean_depth = layer * 0.5 * (surface + reach) / reach.abs();
                sum = (sum.0 + mean_depth * work, sum.1 + mean_depth * tool);
            }
        }
        let n = f64::from(inserts);
        let mean = |sum: f64| (n / PI * sum * 2.0 * step).abs();
        let at_once = 1 + (n * edge / PI).floor() as u32;
        let all = f64::from(at_once);
        PassLoad {
            work: Moment { peak: all * peak.0, mean: mean(sum.0) },
            tool: Moment { peak: all * peak.1, mean: mean(sum.1) },
            depth,
            at_once,
            engaged: n * edge / PI,
        }
    }
}
