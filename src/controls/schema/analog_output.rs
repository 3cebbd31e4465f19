//! Analog output of a control for the speed of its spindle.

use crate::drives::Analog;
use crate::text::Citation;

/// The converter of the analog output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnalogOutput {
    /// Full output in volts.
    pub volts: f64,
    /// Bits of the converter from 0 V to full output (12: 0 to 4095).
    pub bits: u8,
    /// Source and grade.
    pub cite: Citation,
}

impl AnalogOutput {
    /// The output with a speed (r/min) at its full voltage, without offsets and without a sign.
    pub const fn with_speed(self, speed: f64) -> Analog {
        Analog { bits: self.bits, ..Analog::unipolar(speed, self.volts) }
    }
}
