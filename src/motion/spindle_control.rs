//! Commands of the control to the spindle: speed, direction, limits, constant surface speed, orientation.

use crate::drives::Rotation;
use crate::drives::orient::{Approach, Travel};
use crate::drives::speed::{SpeedLimit, SpeedRange};

/// Constant surface speed in force.
#[derive(Debug, Clone, Copy)]
pub(super) struct Surface {
    /// Cutting speed in m/min.
    pub(super) speed: f64,
    /// Index of the axis that measures the radius.
    pub(super) axis: usize,
    /// Position in mm of the axis at radius 0.
    pub(super) zero: f64,
    /// End (s) of the cut that moves the axis.
    pub(super) until: f64,
    /// Time (s) of the next speed command.
    pub(super) again: f64,
    /// Time (s) of the last computation, and the diameter (mm) then. A command at a time moves the axis only after it.
    pub(super) last_computed: (f64, f64),
}

/// Travel of the spindle to an angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Orienting {
    /// Target in turns since the start of the run, possibly after turning back.
    pub(super) goal: f64,
    /// Direction of the travel.
    pub(super) rotation: Rotation,
    pub(super) travel: Travel,
    pub(super) part: TravelPart,
}

/// Part of the travel to an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TravelPart {
    /// To standstill, because the target is in the other direction.
    TurnsBack(f64, Approach),
    ToPeak,
    Steady,
    ToRest,
    Held,
}

impl Orienting {
    /// Whether the spindle is at its angle.
    pub(super) fn is_held(&self) -> bool {
        self.part == TravelPart::Held
    }
}

/// Commands to the spindle.
#[derive(Debug, Clone)]
pub(super) struct SpindleControl {
    /// Speed in r/min before override and limits.
    pub(super) speed: f64,
    /// By M03, M04 or M05.
    pub(super) rotation: Rotation,
    pub(super) surface: Option<Surface>,
    /// Setting data: lowest and highest speed in r/min.
    pub(super) setting_limits: SpeedRange,
    /// Highest speed under constant surface speed in r/min.
    pub(super) surface_high: f64,
    /// Position of the turning centre on the axis perpendicular to the spindle, mm.
    pub(super) centre: Option<f64>,
    /// Gear stages are selected by S.
    pub(super) gear_by_s: bool,
    /// The axis perpendicular to the spindle, and its position in mm at diameter 0.
    pub(super) diameter_axis: Option<(u8, f64)>,
    /// End (s) of the ramp, or of a part of a travel to an angle.
    pub(super) reached_at: f64,
    /// Trim by the regulator of the web, as a fraction of the speed, and the time (s) of its next sample.
    pub(super) trim: f64,
    pub(super) sampled_at: f64,
    /// Travel to an angle.
    pub(super) orienting: Option<Orienting>,
    /// The encoder's zero mark was found.
    pub(super) synced: bool,
    /// The machine builder's lock holds the spindle at its angle.
    pub(super) locked: bool,
    /// A driven tool turns.
    pub(super) driven_tool_turns: bool,
    /// The program has commanded a speed or a direction since the last motion that began with the speed reached.
    pub(super) commanded: bool,
}

impl SpindleControl {
    /// State at power-on; `diameter_axis` is the axis perpendicular to the spindle.
    pub(super) fn new(diameter_axis: Option<u8>) -> SpindleControl {
        SpindleControl {
            speed: 0.0,
            rotation: Rotation::Stopped,
            surface: None,
            setting_limits: SpeedRange::ANY,
            surface_high: f64::INFINITY,
            centre: None,
            gear_by_s: false,
            diameter_axis: diameter_axis.map(|axis| (axis, 0.0)),
            reached_at: f64::INFINITY,
            trim: 0.0,
            sampled_at: f64::INFINITY,
            orienting: None,
            synced: false,
            locked: false,
            driven_tool_turns: false,
            commanded: false,
        }
    }

    /// Sets a speed limit in r/min; NaN removes it.
    pub(super) fn limit(&mut self, limit: SpeedLimit, rpm: f64) {
        let rpm = if rpm > 0.0 { rpm } else { 0.0 };
        match limit {
            SpeedLimit::Lower => self.setting_limits.low = rpm,
            SpeedLimit::Upper => self.setting_limits.high = rpm,
            SpeedLimit::Surface => self.surface_high = rpm,
        }
    }

    /// Time (s) of the spindle's next event.
    pub(super) fn next(&self) -> f64 {
        self.next_change().min(self.sampled_at)
    }

    /// The same without the samples of the web.
    pub(super) fn next_change(&self) -> f64 {
        self.surface.map_or(self.reached_at, |surface| surface.again.min(self.reached_at))
    }
}
