//! A web (ribbon, film, paper) between two driven rollers: slack, tension, and the slip of a roller that prints on it.

/// Length that piles up (positive) or is missing (negative) after both drives have started, in the unit of `speed` times seconds.
///
/// The feeding drive rises linearly for `feed_ramp` seconds, the pulling drive follows `wait` seconds later with its own linear
/// rise of `pull_ramp`: `speed · (wait - feed_ramp / 2 + pull_ramp / 2)`. With `wait = 0` both start together, with
/// `wait = feed_ramp` the pull waits for the speed. Source: sizing facts 2.6, checked as D23 and D24.
pub fn slack_after_start(speed: f64, feed_ramp: f64, pull_ramp: f64, wait: f64) -> f64 {
    speed * (wait - feed_ramp / 2.0 + pull_ramp / 2.0)
}

/// Length laid down while both drives stop: the pull falls linearly in `pull_ramp`, the feed begins `delay` seconds after it and falls
/// in `feed_ramp`: `speed · (delay + feed_ramp / 2 - pull_ramp / 2)`. Source: sizing facts 2.6, checked as D25 (`delay = 0`).
pub fn slack_after_stop(speed: f64, feed_ramp: f64, pull_ramp: f64, delay: f64) -> f64 {
    speed * (delay + feed_ramp / 2.0 - pull_ramp / 2.0)
}

/// Most that a short stop and its restart lay down, where the pull waits `wait` seconds from the restart of the feed: the feed has not come to
/// rest after a pause p and is back at speed after another p, so that it lays `speed · (wait + p - p² / ramp)`, most at `p = ramp / 2`:
/// `speed · (wait + ramp / 4)`. From a pause of the whole ramp on it is `speed · wait`. Source: sizing facts 2.6, ribbon line facts, 7.
pub fn slack_of_short_stop(speed: f64, feed_ramp: f64, wait: f64) -> f64 {
    speed * (wait + feed_ramp / 4.0)
}

/// Steady tension in newtons that a draw (relative speed difference) adds to a web: `E · A · draw`, with the modulus in N/mm² and the
/// cross-section in mm². Source: sizing facts 2.6, checked as D11 and D12.
pub fn draw_tension(modulus: f64, area: f64, draw: f64) -> f64 {
    modulus * area * draw
}

/// Slip of a printing head against the web while it crosses a contact zone of length `contact` that stands in space:
/// `|1 - 1 / ratio| · contact`, `ratio` being roller surface speed to web speed. Source: sizing facts 3.2, derived there.
pub fn smear(ratio: f64, contact: f64) -> f64 {
    (1.0 - 1.0 / ratio).abs() * contact
}

/// Length of a dot, in the unit of `head`: the length of the head on the roller as the web sees it, and the smear: `l / r + |1 - 1 / r| · c`.
/// Source: sizing facts 3.2, checked as E9.
pub fn mark_length(head: f64, ratio: f64, contact: f64) -> f64 {
    head / ratio + smear(ratio, contact)
}

/// Length in which a roller of radius `radius` that is pressed `depth` into a flat counter surface touches it: `2 √(2 R δ)`, in their unit.
/// Source: sizing facts 3.2, checked as E10.
pub fn contact_length(radius: f64, depth: f64) -> f64 {
    2.0 * (2.0 * radius * depth).sqrt()
}

/// Share of the holding force of a nip that is used by what pulls at it: `|T₁ - T₂ + m a| / (μ N)`, at most a half for a web that does not slip.
/// Newtons, kg, m/s². Source: sizing facts 2.2, checked as the reciprocal of B19.
pub fn nip_use((friction, force): (f64, f64), pull: f64, (mass, acceleration): (f64, f64)) -> f64 {
    (pull + mass * acceleration).abs() / (friction * force)
}
