//! Round bodies on the turning axis, seen by the operator a little from the right: circles about the axis are ellipses.

use crate::math;
use crate::text::number::{fill, filled};

/// Height of the turning axis.
pub(super) const AXIS: f64 = 350.0;
/// Half the width of a circle about the axis over its radius: the sine of the angle by which the operator looks from the right.
pub(super) const SLANT: f64 = 0.28;

/// A corner at `x` along the axis, `out` from the axis in the direction `angle` (radians, from the top towards the operator), and `aside`
/// square to that direction.
pub(super) fn corner(x: f64, out: f64, angle: f64, aside: f64) -> (f64, f64) {
    let (s, c) = math::sin_cos(angle);
    let (near, up) = (out * s + aside * c, out * c - aside * s);
    (x - SLANT * near, AXIS - up)
}

/// A circle about the axis.
pub(super) fn circle(x: f64, radius: f64) -> String {
    let (flat, top) = (SLANT * radius, AXIS - radius);
    filled("M# #a# # 0 1 1 0 #a# # 0 1 1 0 #Z", &[x, top, flat, radius, 2.0 * radius, flat, radius, -2.0 * radius])
}

/// A flat ring about the axis between two radii.
pub(super) fn ring(x: f64, radius: f64, bore: f64) -> String {
    let mut path = circle(x, radius);
    // Drawn the other way round, so that the bore stays open.
    let (flat, top) = (SLANT * bore, AXIS - bore);
    fill(&mut path, "M# #a# # 0 1 0 0 #a# # 0 1 0 0 #Z", &[x, top, flat, bore, 2.0 * bore, flat, bore, -2.0 * bore]);
    path
}

/// The part of a circle about the axis between two angles, as an open path.
pub(in super::super) fn arc(out: &mut String, x: f64, radius: f64, from: f64, to: f64) {
    let ((ax, ay), (bx, by)) = (corner(x, radius, from, 0.0), corner(x, radius, to, 0.0));
    let large = f64::from(u8::from((to - from).abs() > math::PI));
    let sweep = f64::from(u8::from(to < from));
    fill(out, "M# #A# # 0 # # # #", &[ax, ay, SLANT * radius, radius, large, sweep, bx, by]);
}

/// The side of a turned body: its profile (x, radius) from left to right. At its left the near half of the circle bulges out, at its right
/// the near half is left to the face that covers it.
pub(super) fn body(profile: &[(f64, f64)]) -> String {
    let (Some(first), Some(last)) = (profile.first(), profile.last()) else { return String::new() };
    let mut path = String::new();
    for (at, (x, radius)) in profile.iter().enumerate() {
        fill(&mut path, if at == 0 { "M# #" } else { "L# #" }, &[*x, AXIS - radius]);
    }
    fill(&mut path, "A# # 0 0 0 # #", &[SLANT * last.1, last.1, last.0, AXIS + last.1]);
    for (x, radius) in profile.iter().rev().skip(1) {
        fill(&mut path, "L# #", &[*x, AXIS + radius]);
    }
    fill(&mut path, "A# # 0 0 1 # #Z", &[SLANT * first.1, first.1, first.0, AXIS - first.1]);
    path
}

/// A block on a face: from `x.0` to `x.1` along the axis, from `out.0` to `out.1` away from the axis, `half` to both sides of `angle`.
pub(super) struct FaceBlock {
    pub(super) x: (f64, f64),
    pub(super) out: (f64, f64),
    pub(super) half: f64,
    pub(super) angle: f64,
}

/// A corner of a block on a face.
struct Corner {
    /// At the end to the right of the axis.
    right: bool,
    /// At the end away from the axis.
    outer: bool,
    /// At the side towards greater angles.
    ahead: bool,
}

impl FaceBlock {
    fn corner(&self, Corner { right, outer, ahead }: Corner) -> (f64, f64) {
        let pick = |(low, high): (f64, f64), upper: bool| if upper { high } else { low };
        corner(pick(self.x, right), pick(self.out, outer), self.angle, if ahead { self.half } else { -self.half })
    }

    fn quad(out: &mut String, [a, b, c, d]: [(f64, f64); 4]) {
        fill(out, "M# #L# #L# #L# #Z", &[a.0, a.1, b.0, b.1, c.0, c.1, d.0, d.1]);
    }

    /// The sides that the operator sees: one flank, and the outer or the inner end.
    pub(super) fn sides(&self, out: &mut String) {
        let (s, c) = math::sin_cos(self.angle);
        let (ahead, outer) = (c > 0.0, s > 0.0);
        let flank = [(false, false), (true, false), (true, true), (false, true)];
        FaceBlock::quad(out, flank.map(|(right, outer)| self.corner(Corner { right, outer, ahead })));
        FaceBlock::quad(out, flank.map(|(right, ahead)| self.corner(Corner { right, outer, ahead })));
    }

    /// The end to the right.
    pub(super) fn end(&self, out: &mut String) {
        let around = [(false, false), (true, false), (true, true), (false, true)];
        FaceBlock::quad(out, around.map(|(outer, ahead)| self.corner(Corner { right: true, outer, ahead })));
    }
}
