//! One block of a single servo axis: linear acceleration after interpolation, servo lag, and the time of an exact stop.

use crate::math;

/// A single block under acceleration with a constant time constant (a moving average after interpolation).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisBlock {
    /// Interpolation time in seconds: length over speed.
    pub interpolation: f64,
    /// Commanded speed in mm/s.
    pub speed: f64,
    /// Time constant in seconds.
    pub time_constant: f64,
    /// Position gain in 1/s.
    pub position_gain: f64,
}

impl AxisBlock {
    /// Seconds from the first to the last commanded motion: `T + τ`. Source: sizing facts, section 4, F1.
    pub fn duration(&self) -> f64 {
        self.interpolation + self.time_constant
    }

    /// Highest commanded speed in mm/s: `v · min(1, T / τ)`. Source: sizing facts, section 4, F2.
    pub fn peak_speed(&self) -> f64 {
        if self.time_constant > self.interpolation {
            self.speed * self.interpolation / self.time_constant
        } else {
            self.speed
        }
    }

    /// Lag of the axis in mm at the end of its command: a first-order servo of gain K follows the trapezoid of [`AxisBlock::duration`],
    /// computed in its three parts. Source: sizing facts, section 4, F3 (there checked against an integration).
    pub fn lag_at_end(&self) -> f64 {
        let (t, tau, gain) = (self.interpolation, self.time_constant, self.position_gain);
        let (flank, flat, peak) = (t.min(tau), (tau - t).abs(), self.peak_speed());
        if flank <= 0.0 {
            // Without acceleration: the lag of the constant speed.
            return self.speed / gain * (1.0 - math::exp(-gain * t));
        }
        let fall = math::exp(-gain * flank);
        let rise = peak / gain * (1.0 - (1.0 - fall) / (gain * flank));
        let held = peak / gain + (rise - peak / gain) * math::exp(-gain * flat);
        held * fall + peak * (1.0 - fall * (1.0 + gain * flank)) / (gain * gain * flank)
    }

    /// Seconds until the axis is within `width` millimetres of its end: `ln(lag / width) / K`. Source: sizing facts, section 4, F4.
    pub fn settling(&self, width: f64) -> f64 {
        (math::ln(self.lag_at_end() / width) / self.position_gain).max(0.0)
    }

    /// Time (s) of a block with exact stop: duration and settling. Source: sizing facts, section 4, F5.
    pub fn exact_stop(&self, width: f64) -> f64 {
        self.duration() + self.settling(width)
    }
}

/// Seconds of the ramp of an axis: its time constant; without one the servo itself rounds a step off, as a first-order lag of `1 / K`.
pub fn ramp(time_constant: f64, position_gain: f64) -> f64 {
    time_constant.max(1.0 / position_gain)
}

/// Greatest acceleration (mm/s² or °/s²) of an axis that reaches rapid traverse and its greatest feed (mm/min or °/min) in the same ramp
/// (s): `max(v_rapid, v_feed) / t`.
pub fn greatest_acceleration(rapid: f64, clamp: f64, ramp: f64) -> f64 {
    rapid.max(clamp) / 60.0 / ramp
}

/// Amplitude ratio (0 to 1) between an axis and a commanded motion with a period in seconds, after a moving average of `time_constant`
/// seconds and a first-order servo of gain K: `|sin x| / x · K / √(K² + ω²)` with `ω = 2π / T`, `x = ω τ / 2`. Source: sizing facts 3.5.
pub fn response(period: f64, time_constant: f64, position_gain: f64) -> f64 {
    let turning = 2.0 * math::PI / period;
    let x = 0.5 * turning * time_constant;
    let averaged = if x > 0.0 { math::sin(x).abs() / x } else { 1.0 };
    averaged * position_gain / math::hypot(position_gain, turning)
}
