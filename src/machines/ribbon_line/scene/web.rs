//! The ribbon as a path of lines and arcs in the plane of the drawing, and its band in depth.

use crate::math;
use crate::text::number::fill;

/// A path of lines and arcs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Web {
    start: (f64, f64),
    parts: Vec<Part>,
}

/// A line (radius 0) or an arc to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Part {
    to: (f64, f64),
    radius: f64,
    /// The arc turns with the clock on the screen.
    clockwise: bool,
}

impl Web {
    /// A path that begins at a point.
    pub(crate) fn from(start: (f64, f64)) -> Web {
        Web { start, parts: Vec::new() }
    }

    /// A line to a point.
    pub(crate) fn line(&mut self, to: (f64, f64)) {
        self.parts.push(Part { to, radius: 0.0, clockwise: false });
    }

    /// An arc of less than half a turn to a point, clockwise on the screen.
    pub(crate) fn clockwise(&mut self, to: (f64, f64), radius: f64) {
        self.parts.push(Part { to, radius, clockwise: true });
    }

    /// An arc of less than half a turn to a point, counter-clockwise on the screen.
    pub(crate) fn counter_clockwise(&mut self, to: (f64, f64), radius: f64) {
        self.parts.push(Part { to, radius, clockwise: false });
    }

    /// The path shifted by `by`, as `d`, up to a length.
    pub(crate) fn path(&self, by: (f64, f64), length: f64) -> String {
        let mut d = String::new();
        fill(&mut d, "M# #", &[self.start.0 + by.0, self.start.1 + by.1]);
        let (mut from, mut left) = (self.start, length);
        for part in &self.parts {
            let own = part.length(from);
            if left <= 0.0 {
                break;
            }
            let to = if own > left { part.point(from, left / own) } else { part.to };
            part.write(&mut d, to, by, part.clockwise);
            (from, left) = (part.to, left - own);
        }
        d
    }

    /// The surface that the path sweeps from `near` to `far`, as `d`.
    pub(crate) fn band(&self, near: (f64, f64), far: (f64, f64)) -> String {
        let mut d = self.path(near, f64::INFINITY);
        let points: Vec<(f64, f64)> =
            core::iter::once(self.start).chain(self.parts.iter().map(|part| part.to)).collect();
        let end = points.last().copied().unwrap_or(self.start);
        fill(&mut d, "L# #", &[end.0 + far.0, end.1 + far.1]);
        for (part, from) in self.parts.iter().zip(&points).rev() {
            part.write(&mut d, *from, far, !part.clockwise);
        }
        d.push('Z');
        d
    }
}

impl Part {
    /// Angle of the arc, rad: `2 asin(chord / 2 r)`.
    fn angle(&self, from: (f64, f64)) -> f64 {
        let chord = math::hypot(self.to.0 - from.0, self.to.1 - from.1);
        2.0 * math::asin((0.5 * chord / self.radius).min(1.0))
    }

    fn length(&self, from: (f64, f64)) -> f64 {
        if self.radius > 0.0 {
            self.radius * self.angle(from)
        } else {
            math::hypot(self.to.0 - from.0, self.to.1 - from.1)
        }
    }

    /// The point at a share of the length.
    fn point(&self, from: (f64, f64), share: f64) -> (f64, f64) {
        let (dx, dy) = (self.to.0 - from.0, self.to.1 - from.1);
        if self.radius <= 0.0 {
            return (from.0 + share * dx, from.1 + share * dy);
        }
        // The chord of the part turns away from that of the whole by half of the angle that is missing.
        let angle = self.angle(from);
        let chord = math::sin(0.5 * share * angle) / math::sin(0.5 * angle).max(1e-12);
        let side = if self.clockwise { -1.0 } else { 1.0 };
        let (s, c) = math::sin_cos(side * 0.5 * (1.0 - share) * angle);
        (from.0 + chord * (dx * c - dy * s), from.1 + chord * (dx * s + dy * c))
    }

    fn write(&self, d: &mut String, to: (f64, f64), by: (f64, f64), clockwise: bool) {
        let (x, y) = (to.0 + by.0, to.1 + by.1);
        if self.radius > 0.0 {
            fill(d, "A# # 0 0 # # #", &[self.radius, self.radius, f64::from(u8::from(clockwise)), x, y]);
        } else {
            fill(d, "L# #", &[x, y]);
        }
    }
}
