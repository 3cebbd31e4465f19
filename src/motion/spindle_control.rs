//! Commands of the control to the spindle: speed, direction, limits, constant surface speed, orientation.

use crate::drives::orient::{Approach, Travel};
use crate::drives::speed::SpeedLimit;

/// Constant surface speed in force.
#[derive(Debug, Clone, Copy)]
pub(super) struct Surface {
    /// m/min.
    pub(super) speed: f64,
    /// The axis that measures the radius.
    pub(super) axis: usize,
    /// Its position in mm at radius 0.
    pub(super) zero: f64,
    /// End (s) of the cut that moves the axis.
    pub(super) until: f64,
    /// When the next speed is commanded (s).
    pub(super) again: f64,
    /// The moment (s) that was looked at last, and the diameter (mm) then: what is commanded at a moment moves the axis only after it.
    pub(super) seen: (f64, f64),
}

/// Travel of the spindle to an angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Orienting {
    /// Target in turns since the run began; a turn back to it comes first.
    pub(super) goal: f64,
    /// Direction.
    pub(super) way: i8,
    pub(super) travel: Travel,
    pub(super) part: TravelPart,
}

/// Parts of the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TravelPart {
    /// To standstill: the target lies the other way.
    TurnsBack(f64, Approach),
    ToPeak,
    Steady,
    ToRest,
    Held,
}

impl Orienting {
    /// The spindle is at its angle.
    pub(super) fn is_held(&self) -> bool {
        self.part == TravelPart::Held
    }
}

/// Commands to the spindle.
#[derive(Debug, Clone)]
pub(super) struct SpindleControl {
    /// r/min before override and limits.
    pub(super) speed: f64,
    pub(super) direction: i8,
    pub(super) surface: Option<Surface>,
    /// Setting data: lowest and highest speed in r/min.
    pub(super) set: (f64, f64),
    /// Highest speed under constant surface speed in r/min.
    pub(super) surface_high: f64,
    /// Position of the turning centre on the axis square to the spindle, mm.
    pub(super) centre: Option<f64>,
    /// Gear stages are selected by S.
    pub(super) automatic: bool,
    /// The axis square to the spindle, and its position in mm at diameter 0.
    pub(super) square: Option<(u8, f64)>,
    /// End of the ramp, or of a part of a travel to an angle.
    pub(super) reached_at: f64,
    /// Travel to an angle.
    pub(super) orienting: Option<Orienting>,
    /// The zero mark of the encoder was seen.
    pub(super) synced: bool,
    /// The builder's lock holds the spindle at its angle.
    pub(super) locked: bool,
    /// A driven tool turns.
    pub(super) driven: bool,
    /// The program has commanded a speed or a direction, and since then no motion began with the speed reached.
    pub(super) commanded: bool,
}

impl SpindleControl {
    /// At power-on; the axis that counts diameters is square to the spindle.
    pub(super) fn new(square: Option<u8>) -> SpindleControl {
        SpindleControl {
            speed: 0.0,
            direction: 0,
            surface: None,
            set: (0.0, f64::INFINITY),
            surface_high: f64::INFINITY,
            centre: None,
            automatic: false,
            square: square.map(|axis| (axis, 0.0)),
            reached_at: f64::INFINITY,
            orienting: None,
            synced: false,
            locked: false,
            driven: false,
            commanded: false,
        }
    }

    /// Sets a limit in r/min; NaN removes it.
    pub(super) fn limit(&mut self, limit: SpeedLimit, rpm: f64) {
        let rpm = if rpm > 0.0 { rpm } else { 0.0 };
        match limit {
            SpeedLimit::Lower => self.set.0 = rpm,
            SpeedLimit::Upper => self.set.1 = rpm,
            SpeedLimit::Surface => self.surface_high = rpm,
        }
    }

    /// Time (s) of the spindle's next own event.
    pub(super) fn next(&self) -> f64 {
        self.surface.map_or(self.reached_at, |surface| surface.again.min(self.reached_at))
    }
}
