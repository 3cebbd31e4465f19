//! The machine at one time of a run; positions are travel of the slides, not diameters.

use super::plant::PMC_AXES;
use crate::drives::Bound;
use crate::interp::canon::AXES;
use crate::text::Place;

/// An axis at one time. Lengths in mm (or degrees), speeds in mm/min (or °/min).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AxisState {
    /// Commanded position after acceleration: the input of the drive.
    pub position: f64,
    /// Actual position, `speed / gain` behind the commanded one.
    pub actual: f64,
    /// Commanded speed after acceleration.
    pub feed: f64,
    /// Commanded acceleration in mm/s² (or °/s²).
    pub acceleration: f64,
}

/// The spindle at one time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpindleState {
    /// Commanded speed from S and override, after clamps, signed, r/min.
    pub command: f64,
    /// Motor speed after ramp and slip, signed, r/min.
    pub actual: f64,
    /// Analog command in volts before rounding to converter steps; its sign gives the direction on a signed output.
    pub volts_command: f64,
    /// Analog output of the converter in volts.
    pub volts: f64,
    /// Motor revolutions since the start of the run, signed.
    pub turns: f64,
    /// Angle in degrees, 0 to 360, clockwise from the zero mark.
    pub angle: f64,
    /// The spindle is held at its angle.
    pub held: bool,
    /// Engaged gear stage, from 1.
    pub stage: u8,
    /// Limit that reduces or raises the command.
    pub bound: Bound,
    /// Surface speed in m/min at the commanded tool position; `None` without an axis perpendicular to the spindle.
    pub surface_speed: Option<f64>,
}

/// Mode of the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mode {
    /// Runs the program.
    #[default]
    Running,
    /// Feed hold.
    Hold,
    /// Waits at M00, M01, `#3006` or in single block for cycle start.
    Stopped,
    /// Waits for FIN of an M, S or T code.
    WaitFin,
    /// Dwell.
    Dwell,
    /// The program has ended.
    Ended,
    /// Alarm.
    Alarm,
    /// Emergency stop.
    EmergencyStop,
}

/// The whole machine at one time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Snapshot {
    /// Machine time (s).
    pub t: f64,
    /// Axes in the control's order.
    pub axes: [AxisState; AXES],
    /// Axes moved by the PLC, in ° and °/min.
    pub pmc: [AxisState; PMC_AXES],
    /// The spindle.
    pub spindle: SpindleState,
    /// Mode of the control.
    pub mode: Mode,
    /// The executing block.
    pub block: Option<Place>,
}
