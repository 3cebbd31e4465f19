//! The regulator of a dancer: its trim of the unwinder's speed, and what it leaves of a slack rate.

use super::feeds::ribbon_per_revolution;
use crate::machines::ribbon_line::params::Params;
use crate::math;

/// Greatest trim of the unwinder's speed by the regulator of a dancer, as a fraction of the speed. Engineering choice.
pub(in crate::machines::ribbon_line) const TRIM: f64 = 0.1;

/// Time (s) in which the regulator of a dancer takes 63 % of a slack away at the highest speed: many of its samples and ramps, so that it
/// does not overshoot. Engineering choice.
const TIME: f64 = 10.0;

impl Params {
    /// Relative error of the unwinder's speed at 10 V and the running load, which a regulator trims away. The slip is the same at every speed.
    pub(in crate::machines::ribbon_line) fn error_at_10v(&self) -> f64 {
        self.induction().error(self.speed_at_10v)
    }

    /// Trim that a regulator has left for the loop, as a fraction of the speed: the greatest one less the error that it trims away; 0 without
    /// regulator. Source: ribbon line facts, 7.
    pub(in crate::machines::ribbon_line) fn loop_trim(&self) -> f64 {
        if self.is_regulated() { (TRIM - self.error_at_10v().abs()).max(0.0) } else { 0.0 }
    }

    /// Slack (mm) beyond the set point at which a regulator trims most: `λ · v_max · 10 s`, with the trim λ left for the loop and the highest
    /// speed of the ribbon. Source: ribbon line facts, 7.
    pub(in crate::machines::ribbon_line) fn loop_trim_range(&self) -> f64 {
        self.loop_trim() * ribbon_per_revolution(self) * self.top_speed() / 60.0 * TIME
    }

    /// The part of a slack rate (mm/min) that a regulator cannot trim away at an unwinding speed (mm/min); all of it without regulator.
    pub(in crate::machines::ribbon_line) fn beyond_trim(&self, rate: f64, unwound: f64) -> f64 {
        let most = self.loop_trim() * unwound.abs();
        rate - math::clamp(rate, -most, most)
    }
}
