//! Where the centre of an arc lies, and which arcs cannot be. Lengths in command increments.

use crate::math;

/// An arc in its plane, seen from its start.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    /// End minus start.
    pub(super) end: (f64, f64),
    /// Clockwise.
    pub(super) clockwise: bool,
}

impl Chord {
    /// The radius with which it goes round by some degrees, `c / (2 sin(a/2))`; negative for the longer arc, as [`by_radius`] has it.
    pub(super) fn radius(&self, turn: f64) -> f64 {
        let radius = math::hypot(self.end.0, self.end.1) / (2.0 * math::sin_cos((turn / 2.0).to_radians()).0);
        if turn > 180.0 { -radius } else { radius }
    }
}

/// Why an arc cannot be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Impossible {
    /// Centre on the start, or no centre at all.
    NoCenter,
    /// Distances of start and end from the centre.
    Deviation(f64, f64),
    /// Radius, and the smallest that reaches the end.
    Radius(f64, f64),
}

/// Checks a centre given by I, J, K (relative to the start); start and end may differ in radius by `tolerance`.
pub(super) fn by_center(chord: Chord, center: (f64, f64), tolerance: f64) -> Result<(f64, f64), Impossible> {
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

/// The centre of an arc whose start alone counts for its radius: of the two centres from which the end is as far, the one that lies nearer
/// to what was given.
pub(super) fn by_moved_center(chord: Chord, center: (f64, f64), tolerance: f64) -> Result<(f64, f64), Impossible> {
    let radius = math::hypot(center.0, center.1);
    if radius == 0.0 || chord.end == (0.0, 0.0) {
        return by_center(chord, center, tolerance);
    }
    let far = |other: (f64, f64)| math::hypot(other.0 - center.0, other.1 - center.1);
    let (short, long) = (by_radius(chord, radius, tolerance)?, by_radius(chord, -radius, tolerance)?);
    Ok(if far(short) <= far(long) { short } else { long })
}

/// The centre of an arc by its radius, relative to the start: the shorter arc for a positive radius, the longer for a negative one.
///
/// With the chord `c` from start to end, the centre lies `sqrt(r² - (c/2)²)` beside the middle of the chord.
pub(super) fn by_radius(chord: Chord, radius: f64, tolerance: f64) -> Result<(f64, f64), Impossible> {
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

/// A centre relative to the start, and whether the arc is clockwise; nothing for a straight line.
type Placed = Result<Option<((f64, f64), bool)>, Impossible>;

/// Half an increment from the line, and a way is a line.
const STRAIGHT: f64 = 0.5;

fn dot(a: (f64, f64), b: (f64, f64)) -> f64 {
    a.0 * b.0 + a.1 * b.1
}

/// Twice the area between two vectors, positive where the second lies left of the first.
fn cross(a: (f64, f64), b: (f64, f64)) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

/// The arc through a point on its way, from the start: `2 c·p = p²` holds for the point and for the end.
pub(super) fn by_point(end: (f64, f64), point: (f64, f64)) -> Placed {
    let (turn, ends, points) = (cross(end, point), dot(end, end), dot(point, point));
    if turn.abs() <= STRAIGHT * ends.sqrt() {
        let between = (0.0..ends).contains(&dot(end, point));
        return if between && points > 0.0 { Ok(None) } else { Err(Impossible::NoCenter) };
    }
    let center = (ends * point.1 - points * end.1, points * end.0 - ends * point.0);
    Ok(Some(((center.0 / (2.0 * turn), center.1 / (2.0 * turn)), turn > 0.0)))
}

/// The arc that starts in a direction: its centre lies square to it, as far from the end as from the start.
pub(super) fn by_tangent(end: (f64, f64), along: (f64, f64)) -> Placed {
    let length = math::hypot(along.0, along.1).max(f64::MIN_POSITIVE);
    let beside = cross(along, end) / length;
    if beside.abs() <= STRAIGHT {
        return if dot(along, end) > 0.0 { Ok(None) } else { Err(Impossible::NoCenter) };
    }
    let radius = dot(end, end) / (2.0 * beside);
    Ok(Some(((-along.1 / length * radius, along.0 / length * radius), radius < 0.0)))
}

/// Whether an arc between two points around its centre, a full circle where they are the same, passes in a direction from there.
pub(super) fn passes((start, end): ((f64, f64), (f64, f64)), clockwise: bool, direction: (f64, f64)) -> bool {
    let (from, to) = if clockwise { (end, start) } else { (start, end) };
    let (turn, behind, before) = (cross(from, to), cross(from, direction), cross(direction, to));
    if turn == 0.0 {
        return dot(from, to) > 0.0 || behind >= 0.0;
    }
    if turn > 0.0 { behind >= 0.0 && before >= 0.0 } else { behind >= 0.0 || before >= 0.0 }
}
