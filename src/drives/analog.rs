//! The analog spindle output: a speed becomes a voltage through a converter with few bits.

/// An output of 0 V to `volts_full` in steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Analog {
    /// Speed at full output in r/min.
    pub speed_at_full: f64,
    /// Full output in volts.
    pub volts_full: f64,
    /// Bits of the converter (12: 0 to 4095).
    pub bits: u8,
}

impl Analog {
    /// Volts that a speed in r/min of either direction asks for: `V = volts_full · |n| / speed_at_full`, at most `volts_full`.
    ///
    /// Source: `reference/mitsubishi-e60.md` section 3.1 (10 V at `slimt`).
    pub fn command(&self, rpm: f64) -> f64 {
        self.volts_full * self.share(rpm)
    }

    /// The converter's value for a speed in r/min, to the nearest step: 1200 of 1480 r/min on 12 bits is 3320 of 4095.
    pub fn code(&self, rpm: f64) -> u32 {
        (self.share(rpm) * f64::from(self.steps())).round() as u32
    }

    /// Volts as they leave the converter for a speed in r/min.
    pub fn output(&self, rpm: f64) -> f64 {
        self.volts_full * f64::from(self.code(rpm)) / f64::from(self.steps())
    }

    /// Largest value of the converter, at least 1.
    pub fn steps(&self) -> u32 {
        (1 << self.bits.clamp(1, 24)) - 1
    }

    /// Fraction of full output, 0 to 1; 0 where `speed_at_full` is not above 0.
    fn share(&self, rpm: f64) -> f64 {
        if self.speed_at_full > 0.0 { (rpm.abs() / self.speed_at_full).min(1.0) } else { 0.0 }
    }
}
