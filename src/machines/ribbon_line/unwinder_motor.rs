//! Torque of the unwinder's motor over its frequency: continuous, for a short time, and the shortest ramp that follows.

use super::params::UnwindingParams;
use super::resolved::RibbonLine;
use crate::drives::cage_motor::{RATED_FREQUENCY, field_weakening_share, shaft_fan_torque_share};

/// Short-time torque of a motor on an inverter as a share of its rated torque. Source: parts, FREQROL-E800, 150 % for 60 s.
pub(super) const SHORT_TIME: f64 = 1.5;

impl UnwindingParams {
    /// Continuous torque (Nm) of its motor at a frequency in Hz, derated for the site, for a fan on its shaft, and above its rated frequency.
    pub(super) fn continuous(&self, frequency: f64) -> f64 {
        let x = frequency / RATED_FREQUENCY;
        let cooled = if self.forced_cooling { 1.0 } else { shaft_fan_torque_share(x) };
        self.torque * self.site_share / 100.0 * cooled * field_weakening_share(x)
    }

    /// Torque (Nm) of its motor for a short time at a frequency in Hz, `share` times the rated one at most.
    pub(super) fn short_time(&self, share: f64, frequency: f64) -> f64 {
        share * self.torque * field_weakening_share(frequency / RATED_FREQUENCY)
    }
}

/// Shortest ramp (s, to the speed at 10 V) that the torque of the unwinder's motor allows for start and stop, with the
/// knob at its highest position; infinite if the load needs all of the torque.
pub(super) fn shortest_ramp(line: &RibbonLine) -> f64 {
    let (p, mechanics) = (&line.params, &line.mechanics);
    let (steady, rise) = (mechanics.unwinder, mechanics.unwinder_ramp - mechanics.unwinder);
    let motor = |share: f64| p.unwinding.short_time(share, line.fast.unwinder.frequency);
    let left = (motor(SHORT_TIME) - steady).min(motor(p.unwinding.motor_braking / 100.0) + steady);
    if left > 0.0 { p.inverter_ramp * rise / left } else { f64::INFINITY }
}
