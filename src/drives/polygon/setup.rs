//! A cutter over the work: positions of its tips, and normals of the sides they cut.

use super::curve::Curve;
use super::ratio::Ratio;
use crate::math::{self, PI};

/// The tip of an insert on the cutter disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tip {
    /// Distance from the axis of the tool in mm.
    pub radius: f64,
    /// Angle on the disc in radians.
    pub angle: f64,
}

/// Work and cutter at the start of the cut.
#[derive(Debug, Clone, PartialEq)]
pub struct CutterSetup {
    /// Distance of the two axes in mm, a.
    pub distance: f64,
    /// Nominal radius of the tip circle, r.
    pub radius: f64,
    /// Tool to work speed.
    pub ratio: Ratio,
    /// Start angle of the work, A.
    pub work_start: f64,
    /// Start angle of the tool, E: at 0 insert 0 points at the work.
    pub tool_start: f64,
    /// The inserts in their order on the disc.
    pub tips: Vec<Tip>,
}

/// Maximum inserts of a cutter.
const MOST_INSERTS: u32 = 100;

/// A pass of the pattern: its insert, its side and its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pass {
    /// Index of the insert.
    pub insert: usize,
    /// Index of the side, counter-clockwise.
    pub side: usize,
    /// Angle of the normal on the work.
    pub normal: f64,
}

impl CutterSetup {
    /// A cutter with evenly spaced inserts on one tip circle, at half of a distance across flats from the centre of the work:
    /// `a = AF/2 + r`. (A slide with X in diameters shows `X = 2 (a - r)` with an offset of `2 r`.) Source: polygon turning facts 3.1.
    pub fn even(across_flats: f64, radius: f64, ratio: Ratio, inserts: u32) -> CutterSetup {
        let inserts = inserts.min(MOST_INSERTS);
        let tips = (0..inserts).map(|j| Tip { radius, angle: spacing(j, inserts) }).collect();
        CutterSetup { distance: 0.5 * across_flats + radius, radius, ratio, work_start: 0.0, tool_start: 0.0, tips }
    }

    /// Number of inserts, n.
    pub fn inserts(&self) -> u32 {
        u32::try_from(self.tips.len()).unwrap_or(u32::MAX).min(MOST_INSERTS)
    }

    /// Number of sides with about evenly spaced inserts.
    pub fn sides(&self) -> u32 {
        self.ratio.sides(self.inserts())
    }

    /// Nominal distance across flats in mm, `2 (a - r)`; for an odd number of sides, twice the distance of a side from the centre.
    pub fn across_flats(&self) -> f64 {
        2.0 * (self.distance - self.radius)
    }

    /// Position error of an insert: radius in mm, angle in radians. A longer insert cuts its sides deeper by the same length; an angle δ
    /// ahead turns its sides by δ/k (see [`CutterSetup::normal`]).
    pub fn error(&self, insert: usize) -> (f64, f64) {
        let Some(tip) = self.tips.get(insert) else { return (0.0, 0.0) };
        (tip.radius - self.radius, tip.angle - spacing(insert as u32, self.inserts()))
    }

    /// Whether every insert is in its nominal place.
    pub fn is_even(&self) -> bool {
        let none = |(radius, angle): (f64, f64)| radius.abs() <= 1e-12 && angle.abs() <= 1e-12;
        (0..self.tips.len()).all(|insert| none(self.error(insert)))
    }

    /// The pass of an insert; `None` if it reaches the centre of the work.
    pub fn curve(&self, insert: usize) -> Option<Curve> {
        Curve::new(self.distance, self.tips.get(insert)?.radius, self.ratio.value())
    }

    /// Position of an insert tip in the frame of the work, in mm, with work and tool at their angles θ and τ in radians:
    /// `e^(-iθ) · (a - r e^(i(τ+φ)))`. Source: polygon turning facts 3.1; mirrored, these are the paper's equations (1) and (2).
    pub fn tip_on_work(&self, insert: usize, work: f64, tool: f64) -> Option<(f64, f64)> {
        let tip = self.tips.get(insert)?;
        let ((s, c), (sin, cos)) = (math::sin_cos(work), math::sin_cos(tool + tip.angle));
        let (x, y) = (self.distance - tip.radius * cos, -tip.radius * sin);
        Some((x * c + y * s, y * c - x * s))
    }

    /// Normal of the side that an insert at an angle φ on the disc cuts in its first pass: `ψ = -A + (E + φ)/k`. The work's start angle
    /// turns the polygon back by the same angle, the tool's turns it forward by E/k. Source: polygon turning facts 3.1.
    pub fn normal(&self, on_disc: f64) -> f64 {
        (self.tool_start + on_disc) / self.ratio.value() - self.work_start
    }

    /// The work's start angle for the normal of a side at `normal`, with the present start angle of the tool. A normal a whole number of
    /// sides away gives the same polygon.
    pub fn work_start_for(&self, normal: f64) -> f64 {
        self.tool_start / self.ratio.value() - normal
    }

    /// All passes until the pattern closes, n |p| of them. Several cut the same side if n and the work's turns have a common divisor.
    pub fn passes(&self) -> impl Iterator<Item = Pass> + '_ {
        let (p, q) = (i64::from(self.ratio.tool()), i64::from(self.ratio.work()));
        let n = i64::from(self.inserts()).max(1);
        let (all, sides) = (n * p.abs(), i64::from(self.sides()).max(1));
        (0..self.tips.len().min(MOST_INSERTS as usize)).flat_map(move |insert| {
            (0..p.abs()).map(move |turn| {
                // Normal as a fraction of a turn: (j - m n) q / (n p), exact in integers.
                let part = ((insert as i64 - turn * n) * q * p.signum()).rem_euclid(all);
                let normal =
                    self.normal(0.0) + 2.0 * PI * part as f64 / all as f64 + self.error(insert).1 / self.ratio.value();
                Pass { insert, side: (part / (all / sides)) as usize, normal }
            })
        })
    }
}

/// Angle of insert j of n evenly spaced inserts.
fn spacing(insert: u32, inserts: u32) -> f64 {
    2.0 * PI * f64::from(insert) / f64::from(inserts.max(1))
}
