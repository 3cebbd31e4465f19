//! Arc geometry: centre from I/J/K, radius, intermediate point or tangent, and checks for impossible arcs. Lengths in command increments.

use crate::math;

/// Start to end of an arc in its plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    /// End minus start.
    pub(super) end: (f64, f64),
    /// Clockwise.
    pub(super) clockwise: bool,
}

impl Chord {
    /// Signed radius of an arc with a swept angle in degrees, `c / (2 sin(a/2))`; negative for the longer arc, as in [`center_by_radius`].
    pub(super) fn radius(&self, turn: f64) -> f64 {
        let radius = math::hypot(self.end.0, self.end.1) / (2.0 * math::sin_cos((turn / 2.0).to_radians()).0);
        if turn > 180.0 { -radius } else { radius }
    }
}

/// Reason for refusing an arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Impossible {
    /// Centre on the start, or no centre at all.
    NoCenter,
    /// Distances of start and end from the centre.
    Deviation(f64, f64),
    /// Programmed radius, and the smallest radius that reaches the end.
    Radius(f64, f64),
}

/// Checks a centre given by I, J, K (relative to the start). The distances of start and end from it may differ by `tolerance`.
pub(super) fn checked_center(chord: Chord, center: (f64, f64), tolerance: f64) -> Result<(f64, f64), Impossible> {
    let start = math::hypot(center.0, center.1);
    let end = math::hypot(chord.end.0 - center.0, chord.end.1 - center.1);
    if start == 0.0 {
        Err(Impossible::NoCenter)
    } else if (start - end).abs() > tolerance {
        Err(Impossible::Deviation(start, end))
    } else {
        Ok(center)
    }
}

/// Centre of an arc on controls that take the radius from the start alone and move the centre: of the two centres at that radius from start
/// and end, the one nearer to the programmed centre.
pub(super) fn moved_center(chord: Chord, center: (f64, f64), tolerance: f64) -> Result<(f64, f64), Impossible> {
    let radius = math::hypot(center.0, center.1);
    if radius == 0.0 || chord.end == (0.0, 0.0) {
        return checked_center(chord, center, tolerance);
    }
    let far = |other: (f64, f64)| math::hypot(other.0 - center.0, other.1 - center.1);
    let (short, long) = (center_by_radius(chord, radius, tolerance)?, center_by_radius(chord, -radius, tolerance)?);
    Ok(if far(short) <= far(long) { short } else { long })
}

/// Centre from a radius, relative to the start: the shorter arc for a positive radius, the longer for a negative one.
///
/// With the chord `c` from start to end, the centre lies `sqrt(r² - (c/2)²)` beside the middle of the chord.
pub(super) fn center_by_radius(chord: Chord, radius: f64, tolerance: f64) -> Result<(f64, f64), Impossible> {
    let (x, y) = chord.end;
    let length = math::hypot(x, y);
    if length == 0.0 || radius == 0.0 {
        return Err(Impossible::NoCenter);
    }
    let half = length / 2.0;
    if half > radius.abs() + tolerance {
        return Err(Impossible::Radius(radius.abs(), half));
    }
    let beside = (radius * radius - half * half).max(0.0).sqrt();
    // Left of the chord for the shorter counter-clockwise arc.
    let side = if chord.clockwise == (radius > 0.0) { -beside } else { beside };
    Ok((x / 2.0 - y / length * side, y / 2.0 + x / length * side))
}

/// Swept angle of an arc in radians, counter-clockwise positive. Start and end are relative to the centre; `closed`: they are one point, so
/// that the arc is a full circle.
pub(crate) fn sweep((from, to): ((f64, f64), (f64, f64)), closed: bool, clockwise: bool) -> f64 {
    let turn = 2.0 * math::PI;
    let mut sweep = if closed { 0.0 } else { math::atan2(to.1, to.0) - math::atan2(from.1, from.0) };
    if clockwise {
        while sweep >= 0.0 {
            sweep -= turn;
        }
    } else {
        while sweep <= 0.0 {
            sweep += turn;
        }
    }
    sweep
}

/// A centre relative to the start, and whether the arc is clockwise; `None` for a straight line.
type Placed = Result<Option<((f64, f64), bool)>, Impossible>;

/// Distance (increments) of a point from the line below which an arc is replaced by a straight line.
const STRAIGHT: f64 = 0.5;

fn dot(a: (f64, f64), b: (f64, f64)) -> f64 {
    a.0 * b.0 + a.1 * b.1
}

/// Cross product of two vectors, positive if the second is to the left of the first.
fn cross(a: (f64, f64), b: (f64, f64)) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

/// Arc through an intermediate point. All points relative to the start; the centre `c` solves `2 c·p = p²` for the point and for the end.
pub(super) fn center_by_point(end: (f64, f64), point: (f64, f64)) -> Placed {
    let (turn, ends, points) = (cross(end, point), dot(end, end), dot(point, point));
    if turn.abs() <= STRAIGHT * ends.sqrt() {
        let between = (0.0..ends).contains(&dot(end, point));
        return if between && points > 0.0 { Ok(None) } else { Err(Impossible::NoCenter) };
    }
    let center = (ends * point.1 - points * end.1, points * end.0 - ends * point.0);
    Ok(Some(((center.0 / (2.0 * turn), center.1 / (2.0 * turn)), turn > 0.0)))
}

/// Arc with a given start direction: the centre is on the normal through the start, equally far from start and end.
pub(super) fn center_by_tangent(end: (f64, f64), along: (f64, f64)) -> Placed {
    let length = math::hypot(along.0, along.1).max(f64::MIN_POSITIVE);
    let beside = cross(along, end) / length;
    if beside.abs() <= STRAIGHT {
        return if dot(along, end) > 0.0 { Ok(None) } else { Err(Impossible::NoCenter) };
    }
    let radius = dot(end, end) / (2.0 * beside);
    Ok(Some(((-along.1 / length * radius, along.0 / length * radius), radius < 0.0)))
}

/// Whether an arc crosses a direction seen from its centre. Start and end are relative to the centre; if they coincide, the arc is a full
/// circle.
pub(super) fn passes((start, end): ((f64, f64), (f64, f64)), clockwise: bool, direction: (f64, f64)) -> bool {
    let (from, to) = if clockwise { (end, start) } else { (start, end) };
    let (turn, behind, before) = (cross(from, to), cross(from, direction), cross(direction, to));
    if turn == 0.0 {
        return dot(from, to) > 0.0 || behind >= 0.0;
    }
    if turn > 0.0 { behind >= 0.0 && before >= 0.0 } else { behind >= 0.0 || before >= 0.0 }
}
