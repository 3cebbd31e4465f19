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
