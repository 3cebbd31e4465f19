//! The machine at one moment of a run; positions are those of the slides, not diameters.

use super::plant::PMC_AXES;
use crate::drives::Bound;
use crate::interp::canon::AXES;
use crate::text::Place;

/// An axis at one moment. Lengths in mm (or degrees), speeds in mm/min (or °/min).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AxisState {
    /// Commanded position behind acceleration, as the drive gets it.
    pub position: f64,
    /// Position of the axis itself, which lags its command by `speed / gain`.
    pub actual: f64,
    /// Commanded speed behind acceleration.
    pub feed: f64,
    /// Commanded acceleration in mm/s² (or °/s²).
    pub acceleration: f64,
}

/// The spindle at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpindleState {
    /// Commanded speed from S and override, after clamps, signed, r/min.
    pub command: f64,
    /// Speed of the motor behind ramp and slip, signed, r/min.
    pub actual: f64,
    /// Analog command in volts before rounding to steps; its sign is the direction where the output has one.
    pub volts_command: f64,
    /// Analog output in volts as it leaves the converter.
    pub volts: f64,
    /// Revolutions of the motor since the run began, signed.
    pub turns: f64,
    /// Angle in degrees, 0 to 360, clockwise from the zero mark.
    pub angle: f64,
    /// It is held at its angle.
    pub held: bool,
    /// Gear stage that is engaged, from 1.
    pub stage: u8,
    /// Limit that acts on the command.
    pub bound: Bound,
    /// Surface speed in m/min at the commanded tool position, where the machine has an axis square to the spindle.
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
    /// The program is over.
    Ended,
    /// Alarm.
    Alarm,
    /// Emergency stop.
    EmergencyStop,
}

/// Everything at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Snapshot {
    /// Machine time (s).
    pub t: f64,
    /// Axes in the control's order.
    pub axes: [AxisState; AXES],
    /// Axes that the PLC turns, in ° and °/min.
    pub pmc: [AxisState; PMC_AXES],
    /// The spindle.
    pub spindle: SpindleState,
    /// Mode of the control.
    pub mode: Mode,
    /// The block that is executing.
    pub block: Option<Place>,
}
