//! Test bench for programs without a machine: axes, clamps and spindle, and no PLC logic but an echo of the spindle override.

use super::Address;
use crate::drives::Positioning;

/// An axis of the bench, in the control's axis order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BenchAxis {
    /// Address letter.
    pub letter: Address,
    /// Rapid traverse in mm/min or °/min.
    pub rapid: f64,
    /// Cutting feed clamp in mm/min or °/min.
    pub clamp: f64,
    /// Time constant of linear acceleration in seconds.
    pub time_constant: f64,
    /// Position gain in 1/s.
    pub position_gain: f64,
}

/// A gear change, in volts and seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BenchShift {
    /// Analog output (V) while the gear shifts.
    pub volts: f64,
    /// Time (s) until the old gear disengages.
    pub before: f64,
    /// Time (s) until the new gear engages.
    pub meshing: f64,
    /// Time (s) from the new gear to the voltage of the commanded speed.
    pub after: f64,
}

/// Axes, spindle and PLC of the bench.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bench {
    /// Axes.
    pub axes: &'static [BenchAxis],
    /// Spindle speed at full output in r/min, gear by gear.
    pub gears: &'static [f64],
    /// Voltage and times of a gear change.
    pub shift: BenchShift,
    /// Spindle clamp in r/min.
    pub speed_clamp: f64,
    /// In-position width of the axes in mm.
    pub in_position: f64,
    /// Seconds from 0 to full speed.
    pub ramp: f64,
    /// Data of spindle positioning; `None` if the control cannot position its spindle.
    pub positioning: Option<Positioning>,
    /// Variable number of the input word into which the bench's PLC copies the spindle override in percent.
    pub override_echo: Option<u32>,
    /// Seconds until the PLC answers an M or S code with FIN.
    pub fin_delay: f64,
}
