//! Analog spindle output: conversion of a speed into a voltage by a converter with few bits.

/// Least voltage (V) of a speed command at which offsets and noise are small beside it, and an inverter's input accurate. Engineering choice.
pub const FEW_VOLTS: f64 = 0.5;

/// A stepped output on a straight line through two points: standstill and rated speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Analog {
    /// Speed (r/min) at `rated_volts`.
    pub rated_speed: f64,
    /// Volts at rated speed: the gain of the output.
    pub rated_volts: f64,
    /// Offset at standstill, V.
    pub offset_zero: f64,
    /// Offset at rated speed, V.
    pub offset_rated: f64,
    /// Maximum output of the converter, V.
    pub volts_max: f64,
    /// Bits of the converter from 0 V to `volts_max` (12: 0 to 4095).
    pub bits: u8,
    /// The sign of the voltage gives the direction (±10 V); otherwise contacts give it and the voltage is never negative.
    pub bipolar: bool,
    /// The output is 0 V at standstill, without the offset.
    pub rests_at_zero: bool,
}

impl Analog {
    /// An output of 0 V to `volts` at `speed` on 12 bits, without offsets, with direction by contacts.
    pub const fn unipolar(speed: f64, volts: f64) -> Analog {
        Analog {
            rated_speed: speed,
            rated_volts: volts,
            offset_zero: 0.0,
            offset_rated: 0.0,
            volts_max: volts,
            bits: 12,
            bipolar: false,
            rests_at_zero: false,
        }
    }

    /// Commanded volts for a speed in r/min, within the range of the converter:
    /// `V = c₀ + (V_rated + c₁ - c₀) · n / n_rated`; on a bipolar output everything but c₀ has the sign of n.
    /// At speed 0 it is 0 V where the output [rests at zero](Analog::rests_at_zero).
    ///
    /// Source: `docs/reference/gsk-980tdc.md` section 1.1 (c₀ is No.036, c₁ No.021), `docs/reference/mitsubishi-e60.md` section 3.1 (10 V at
    /// `slimt`), `docs/reference/sinumerik-802d.md` section 4 (rated volts: RATED_OUTVAL, rated speed: RATED_VELO).
    pub fn command(&self, rpm: f64) -> f64 {
        if self.rests_at_zero && rpm == 0.0 {
            return 0.0;
        }
        let volts = self.offset_zero + self.slope() * if self.bipolar { rpm } else { rpm.abs() };
        let least = if self.bipolar { -self.volts_max } else { 0.0 };
        crate::math::clamp(volts, least, self.volts_max)
    }

    /// The converter's value for a speed in r/min, to the nearest step: 1200 of 1480 r/min on 12 bits is 3320 of 4095.
    pub fn code(&self, rpm: f64) -> i32 {
        let share = if self.volts_max > 0.0 { self.command(rpm) / self.volts_max } else { 0.0 };
        (share * f64::from(self.steps())).round() as i32
    }

    /// Output of the converter in volts for a speed in r/min.
    pub fn output(&self, rpm: f64) -> f64 {
        self.volts_max * f64::from(self.code(rpm)) / f64::from(self.steps())
    }

    /// Largest value of the converter, at least 1.
    pub fn steps(&self) -> i32 {
        (1 << self.bits.clamp(1, 24)) - 1
    }

    /// Highest speed in r/min of the output: the speed at `volts_max`.
    pub fn top_speed(&self) -> f64 {
        self.speed(self.volts_max)
    }

    /// Highest speed in r/min of a gear stage under constant surface speed: that of the full output, and not above that without
    /// offsets, by which the control limits it. Source: `docs/reference/gsk-980tdc.md` section 1.1, row "n > n_max(gear)".
    pub fn stage_maximum(&self) -> f64 {
        let volts = self.rated_volts;
        let nominal = if volts > 0.0 { self.rated_speed * self.volts_max / volts } else { f64::INFINITY };
        self.top_speed().min(nominal)
    }

    /// Speed in r/min for a voltage; infinite if the voltage does not depend on the speed.
    pub fn speed(&self, volts: f64) -> f64 {
        let slope = self.slope();
        if slope > 0.0 { ((volts - self.offset_zero) / slope).max(0.0) } else { f64::INFINITY }
    }

    /// Volts per r/min; 0 unless `rated_speed` is above 0.
    fn slope(&self) -> f64 {
        let volts = self.rated_volts + self.offset_rated - self.offset_zero;
        if self.rated_speed > 0.0 { volts.max(0.0) / self.rated_speed } else { 0.0 }
    }
}
