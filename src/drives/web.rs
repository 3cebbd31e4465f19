//! A web (ribbon, film, paper) between two driven rollers: slack, tension, and the slip of a print roller on it.

/// Slack (positive) or missing length (negative) after the start of both drives, in the unit of `speed` times seconds.
///
/// The feeding drive rises linearly for `feed_ramp` seconds, the pulling drive follows `wait` seconds later with its own linear
/// rise of `pull_ramp`: `speed · (wait - feed_ramp / 2 + pull_ramp / 2)`. With `wait = 0` both start together, with
/// `wait = feed_ramp` the pull waits for the speed. Source: sizing facts 2.6, checked as D23 and D24.
pub fn slack_after_start(speed: f64, feed_ramp: f64, pull_ramp: f64, wait: f64) -> f64 {
    speed * (wait - feed_ramp / 2.0 + pull_ramp / 2.0)
}

/// Slack after the stop of both drives: the pull decelerates linearly in `pull_ramp`, the feed starts to decelerate `delay` seconds later,
/// in `feed_ramp`: `speed · (delay + feed_ramp / 2 - pull_ramp / 2)`. Source: sizing facts 2.6, checked as D25 (`delay = 0`).
pub fn slack_after_stop(speed: f64, feed_ramp: f64, pull_ramp: f64, delay: f64) -> f64 {
    speed * (delay + feed_ramp / 2.0 - pull_ramp / 2.0)
}

/// Greatest slack of a short stop and restart, with the pull `wait` seconds after the restart of the feed. After a pause p the feed has not
/// yet come to rest and is back at speed after another p: slack `speed · (wait + p - p² / ramp)`, greatest at `p = ramp / 2` with
/// `speed · (wait + ramp / 4)`. From a pause of the whole ramp on it is `speed · wait`. Source: sizing facts 2.6, ribbon line facts, 7.
pub fn slack_of_short_stop(speed: f64, feed_ramp: f64, wait: f64) -> f64 {
    speed * (wait + feed_ramp / 4.0)
}

/// Steady web tension in newtons from a draw (relative speed difference): `E · A · draw`, with the modulus in N/mm² and the cross-section
/// in mm². Source: sizing facts 2.6, checked as D11 and D12.
pub fn draw_tension(modulus: f64, area: f64, draw: f64) -> f64 {
    modulus * area * draw
}

/// Slip of a printing head against the web while it crosses a stationary contact zone of length `contact`: `|1 - 1 / ratio| · contact`,
/// with `ratio` = roller surface speed / web speed. Source: sizing facts 3.2, derived there.
pub fn smear(ratio: f64, contact: f64) -> f64 {
    (1.0 - 1.0 / ratio).abs() * contact
}

/// Length of a dot, in the unit of `head`: length of the head on the roller, projected onto the web, and the smear:
/// `l / r + |1 - 1 / r| · c`.
/// Source: sizing facts 3.2, checked as E9.
pub fn mark_length(head: f64, ratio: f64, contact: f64) -> f64 {
    head / ratio + smear(ratio, contact)
}

/// A driven roller and the roller that presses the web onto it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nip {
    /// Coefficient of friction μ between web and rollers.
    pub friction: f64,
    /// Force N of the pressing roller, N.
    pub force: f64,
}

impl Nip {
    /// Used share of the holding force over start, steady run and stop: `(|T₁ - T₂| + m a) / (μ N)`, at most one half for a web that does
    /// not slip, with the `pull` `T₁ - T₂` of the web and the force `m a` (`accelerating`), in newtons. A start loads the nip if the pull
    /// brakes the web, a stop if it drives the web. Source: sizing facts 2.2, checked as the reciprocal of B19.
    pub fn used_share(&self, pull: f64, accelerating: f64) -> f64 {
        (pull.abs() + accelerating) / (self.friction * self.force)
    }
}
