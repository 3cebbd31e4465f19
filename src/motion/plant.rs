//! The machine as motion sees it: axes with clamps and time constants, one spindle with ramps and analog output.

/// An axis of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisPlant {
    /// Address letter.
    pub letter: u8,
    /// Turns: degrees instead of millimetres.
    pub rotary: bool,
    /// Words of this axis count diameters, twice what it moves. All else about it is what it moves.
    pub diameter: bool,
    /// Rapid traverse in mm/min or °/min.
    pub rapid: f64,
    /// Cutting feed clamp in mm/min or °/min: above it the whole vector is slowed.
    pub clamp: f64,
    /// Time constant of linear acceleration for cutting feed (and rapid), seconds.
    pub time_constant: f64,
    /// Position gain in 1/s: the axis lags `speed / gain` behind its command.
    pub position_gain: f64,
}

impl AxisPlant {
    /// What words count for each millimetre that the axis moves.
    pub fn words_per_unit(&self) -> f64 {
        if self.diameter { 2.0 } else { 1.0 }
    }
}

/// A spindle on an analog output, through an inverter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpindlePlant {
    /// Speed at full output in r/min.
    pub speed_at_full: f64,
    /// Clamp in r/min.
    pub speed_clamp: f64,
    /// Full output in volts.
    pub volts_full: f64,
    /// Bits of the output (12: 0 to 4095).
    pub output_bits: u8,
    /// Seconds from 0 to `speed_at_full`, and back.
    pub ramp: f64,
    /// Speed of the unloaded motor per commanded speed: an induction motor at 50 Hz turns 1500 where 1480 is asked for.
    pub gain: f64,
    /// Speed lost under load as a fraction of the speed at full output: actual = gain × command - slip × `speed_at_full` while
    /// turning (constant at any speed, as for V/f control).
    pub slip: f64,
}

/// The whole plant.
#[derive(Debug, Clone, PartialEq)]
pub struct Plant {
    /// Axes, found by their letters. Axes of the control that the machine lacks are not here.
    pub axes: Vec<AxisPlant>,
    /// The spindle.
    pub spindle: SpindlePlant,
    /// Seconds a block with NC words costs the control.
    pub block_time: f64,
    /// Seconds a macro block costs the control.
    pub macro_time: f64,
    /// Blocks read ahead.
    pub preread: u8,
    /// In-position width for exact stop in mm.
    pub in_position: f64,
}
