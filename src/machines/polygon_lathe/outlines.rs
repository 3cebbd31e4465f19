//! Closed lines of the section, the ideal polygon, and the deviation of the finished section from it.

use crate::drives::polygon::{SAME_LENGTH, Section};
use crate::math::{self, PI};
use crate::text::number::filled;

/// A closed line through points about a centre; y goes up in millimetres and down in the drawing.
pub(super) fn closed(points: impl IntoIterator<Item = (f64, f64)>, (x, y): (f64, f64), scale: f64) -> String {
    let mut d = String::new();
    for (at, point) in points.into_iter().enumerate() {
        d += &filled(if at == 0 { "M# #" } else { "L# #" }, &[x + scale * point.0, y - scale * point.1]);
    }
    d.push('Z');
    d
}

/// The ideal polygon: corner after corner.
pub(super) fn ideal(sides: u32, apothem: f64, normal: f64) -> Vec<(f64, f64)> {
    let pitch = 2.0 * PI / f64::from(sides.max(1));
    let radius = apothem / math::cos(0.5 * pitch);
    let corner = |at: u32| {
        let (s, c) = math::sin_cos(normal + pitch * (f64::from(at) + 0.5));
        (radius * c, radius * s)
    };
    (0..sides).map(corner).collect()
}

/// Angle from the nearest normal.
fn from_normal(section: &Section, angle: f64, pitch: f64) -> f64 {
    let off = (angle - section.begin()) / pitch;
    pitch * (off - off.round())
}

/// Deviation (mm) of the finished section from the plane of the nearest side, at `count` evenly spaced angles (rad), as
/// (angle, deviation); NaN where stock is left.
pub(super) fn deviations(section: &Section, apothem: f64, sides: u32, count: usize) -> Vec<(f64, f64)> {
    let pitch = 2.0 * PI / f64::from(sides.max(1));
    let at = |(i, radius): (usize, f64)| {
        let angle = section.begin() + 2.0 * PI * i as f64 / count as f64;
        let off = from_normal(section, angle, pitch);
        (angle, if radius >= section.stock() - SAME_LENGTH { f64::NAN } else { radius * math::cos(off) - apothem })
    };
    section.radii(count).into_iter().enumerate().map(at).collect()
}
