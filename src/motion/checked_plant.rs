//! The plant with checked numbers: one entry for each possible axis of a control.

use super::plant::{AxisPlant, Plant, SpindlePlant, WebRegulator};
use super::plc::{PlcSignals, WordPart};
use super::setup::Budget;
use crate::controls::vars::HALF_RANGE;
use crate::controls::{Address, Alarm, Control, VarRange};
use crate::drives::Positioning;
use crate::drives::speed::STAGES;
use crate::interp::canon::AXES;
use crate::text::Phrase;

/// Largest distance of a home position from machine zero, in mm or °.
const HOME: f64 = 1e6;

/// Least time (s) per block, so that time passes even in a waiting loop.
const LEAST_BLOCK_TIME: f64 = 1e-4;

/// Coasting time (s) of a spindle without friction: 30 years, longer than any run.
const ENDLESS_COAST: f64 = 1e9;

/// Constants of a run.
#[derive(Debug, Clone)]
pub(super) struct CheckedPlant {
    pub(super) axes: [AxisPlant; AXES],
    pub(super) spindle: SpindlePlant,
    /// Travel in millimetres or degrees of each axis per command increment.
    pub(super) scale: [f64; AXES],
    pub(super) block_time: f64,
    pub(super) macro_time: f64,
    pub(super) preread: usize,
    pub(super) in_position: f64,
    pub(super) stock: f64,
    /// Seconds from the end of the unfiltered path to standstill of the slowest axis.
    pub(super) standstill: f64,
    pub(super) limits: Budget,
    pub(super) emergency: Option<(&'static str, Phrase)>,
    pub(super) no_positioning: Option<(&'static str, Phrase)>,
    pub(super) reversal: Option<(&'static str, Phrase)>,
    pub(super) gear_timeout: Option<(&'static str, Phrase)>,
    pub(super) inverter_fault: Option<(&'static str, Phrase)>,
    /// Time (s) of the power failure; infinite without one.
    pub(super) power_fails: f64,
    /// The control has program zero return.
    pub(super) zero_return: bool,
    vars: &'static [VarRange],
    /// Bit `k`: the machine has axis `k`.
    pub(super) fitted: u8,
    pub(super) log: bool,
}

/// Coasting time (s) within the limits of a run: infinity becomes [`ENDLESS_COAST`], NaN and negative values 0.
fn coasting(seconds: f64) -> f64 {
    if seconds > 0.0 { seconds.min(ENDLESS_COAST) } else { 0.0 }
}

impl CheckedPlant {
    /// Replaces NaN and values out of range, so that no plant can stop a run.
    pub(super) fn new(control: &Control, plant: &Plant, limits: Budget, log: bool) -> CheckedPlant {
        let positive = |x: f64, otherwise: f64| if x > 0.0 && x.is_finite() { x } else { otherwise };
        let mut fitted = 0;
        let axes: [AxisPlant; AXES] = core::array::from_fn(|k| {
            let letter = control.axes.get(k).map(|axis| axis.letter);
            // An axis that the machine lacks moves without inertia, so that the program can be watched; a diagnostic reports it.
            let missing = AxisPlant {
                letter,
                rotary: false,
                endless: false,
                diameter: false,
                rapid: 1e6,
                clamp: 1e6,
                time_constant: 0.0,
                position_gain: 0.0,
                home: 0.0,
            };
            let found = plant.axes.iter().find(|axis| axis.letter.is_some() && axis.letter == letter).copied();
            fitted |= u8::from(found.is_some()) << k;
            let axis = found.unwrap_or(missing);
            AxisPlant {
                rapid: positive(axis.rapid, missing.rapid),
                clamp: positive(axis.clamp, missing.clamp),
                time_constant: positive(axis.time_constant, 0.0),
                position_gain: positive(axis.position_gain, 0.0),
                home: if axis.home.abs() <= HOME { axis.home } else { 0.0 },
                ..axis
            }
        });
        let mut spindle = SpindlePlant {
            speed_clamp: positive(plant.spindle.speed_clamp, 0.0),
            ramp: positive(plant.spindle.ramp, 0.0),
            coasting: plant.spindle.coasting.map(|all| all.map(coasting)),
            gain: positive(plant.spindle.gain, 1.0),
            slip: if plant.spindle.slip.is_finite() { plant.spindle.slip } else { 0.0 },
            stage_count: plant.spindle.stage_count.clamp(1, STAGES as u8),
            surface_low: positive(plant.spindle.surface_low, 0.0),
            regulator: plant.spindle.regulator.and_then(WebRegulator::checked),
            ..plant.spindle
        };
        for stage in &mut spindle.stages {
            stage.rated = positive(stage.rated, 1.0);
        }
        spindle.positioning = spindle.positioning.filter(|positioning| positioning.speed > 0.0).map(|positioning| {
            let speed = positioning.speed.min(spindle.speed_clamp).max(1e-3);
            Positioning { speed, acceleration: positive(positioning.acceleration, 1e9), ..positioning }
        });
        CheckedPlant {
            standstill: axes.iter().map(|axis| axis.time_constant).fold(0.0, f64::max),
            scale: axes.map(|axis| control.limits.increment / axis.words_per_unit()),
            axes,
            spindle,
            block_time: positive(plant.block_time, 0.0).max(LEAST_BLOCK_TIME),
            macro_time: positive(plant.macro_time, 0.0).max(LEAST_BLOCK_TIME),
            preread: usize::from(plant.preread.max(1)),
            in_position: positive(plant.in_position, 1e-6),
            stock: plant.stock,
            limits,
            emergency: control.alarm_shown(Alarm::EmergencyStop),
            no_positioning: control.alarm_shown(Alarm::NoPositioning),
            reversal: control.alarm_shown(Alarm::SpindleReversal),
            gear_timeout: control.alarm_shown(Alarm::GearTimeout),
            inverter_fault: control.alarm_shown(Alarm::InverterFault),
            power_fails: f64::INFINITY,
            zero_return: control.zero_return.is_some(),
            vars: control.vars,
            fitted,
            log,
        }
    }

    /// Index of the diameter axis, which is perpendicular to the spindle.
    pub(super) fn diameter_axis(&self) -> Option<u8> {
        self.axes.iter().position(|axis| axis.diameter).map(|at| at as u8)
    }

    /// Whether the spindle's drive supplies no current at `t`.
    pub(super) fn is_without_current(&self, t: f64, signals: &PlcSignals) -> bool {
        self.spindle.coasting.is_some() && (signals.inverter_fault || t >= self.power_fails)
    }

    /// Least and largest value of an input, or of one of its halves.
    pub(super) fn input_range(&self, number: u32, part: WordPart) -> (f64, f64) {
        let row = self.vars.iter().find(|row| (row.first..=row.last).contains(&number));
        let whole = row.filter(|_| part == WordPart::Whole).and_then(|row| row.input_range(number));
        whole.unwrap_or(HALF_RANGE)
    }

    /// Positions (mm or °) of the axis with a letter at the start and the end of a move; 0 without this axis.
    pub(super) fn travel_of(&self, letter: Address, start: &[f64; AXES], end: &[f64; AXES]) -> (f64, f64) {
        let axis = self.axes.iter().position(|axis| axis.letter == Some(letter));
        axis.map_or((0.0, 0.0), |k| (start[k], end[k]))
    }

    /// Whether a variable is written by the PLC.
    pub(super) fn is_input(&self, number: u32) -> bool {
        let row = self.vars.iter().find(|row| (row.first..=row.last).contains(&number));
        row.is_some_and(|row| row.input_range(number).is_some())
    }
}
