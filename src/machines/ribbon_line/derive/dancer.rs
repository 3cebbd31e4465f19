//! The regulator of a dancer: its trim of the unwinder's speed, and what it leaves of a slack rate.

use super::feeds::ribbon_per_revolution;
use crate::machines::ribbon_line::params::Params;
use crate::math::{self, PI};

/// Greatest trim of the unwinder's speed by the regulator of a dancer, as a fraction of the speed. Engineering choice.
pub(in crate::machines::ribbon_line) const TRIM: f64 = 0.1;

/// Time (s) in which the regulator of a dancer takes 63 % of a slack away at the highest speed: many of its samples and ramps, so that it
/// does not overshoot. Engineering choice.
const TIME: f64 = 10.0;

impl Params {
    /// Ribbon laid over ribbon counted by the program with a motor that turns as commanded: `(1 + t / D - t / Dx) · π / π_program`. Source:
    /// ribbon line facts, 7.
    pub(in crate::machines::ribbon_line) fn laid_over_counted(&self) -> f64 {
        (1.0 + self.share_of_thickness()) * PI / self.program_pi()
    }

    /// Relative error of the unwound ribbon's speed at the running load and a commanded speed (r/min):
    /// `(1 + e) · (1 + t / D - t / Dx) · π / π_program - 1`, with the error e of the motor. Source: ribbon line facts, 7.
    fn unwinding_error(&self, speed: f64) -> f64 {
        (1.0 + self.induction().error(speed)) * self.laid_over_counted() - 1.0
    }

    /// Lowest speed (r/min) that the knob commands of the unwinder's motor.
    pub(in crate::machines::ribbon_line) fn lowest_speed(&self) -> f64 {
        self.speed_at(if self.knob_is_locked() { self.override_stepped() } else { self.knob_lowest })
    }

    /// Commanded speed (r/min) at which a regulator trims most, and the relative error that it trims away there: at 10 V, or at the lowest
    /// position of the knob, where the same slip is a greater share.
    pub(in crate::machines::ribbon_line) fn greatest_trimmed(&self) -> (f64, f64) {
        let [full, low] = [self.speed_at_10v, self.lowest_speed()].map(|speed| (speed, self.unwinding_error(speed)));
        if low.0 > 0.0 && low.1.abs() > full.1.abs() { low } else { full }
    }

    /// Trim that a regulator has left for the loop, as a fraction of the speed: the greatest one less the error that it trims away; 0 without
    /// regulator. Source: ribbon line facts, 7.
    pub(in crate::machines::ribbon_line) fn loop_trim(&self) -> f64 {
        if self.is_regulated() { (TRIM - self.greatest_trimmed().1.abs()).max(0.0) } else { 0.0 }
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
