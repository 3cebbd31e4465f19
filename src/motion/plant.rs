//! The machine for the simulation: axes with clamps and time constants, one spindle with gear stages, ramps and analog output.

use crate::controls::{Address, Code, Control, SpindleRules};
use crate::drives::speed::STAGES;
use crate::drives::{Analog, Positioning, Stage};
use crate::math;

/// Maximum number of axes moved by the PLC.
pub const PMC_AXES: usize = 2;

/// An axis of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisPlant {
    /// Address letter; `None` for an axis without an address in programs.
    pub letter: Option<Address>,
    /// Rotary axis: degrees instead of millimetres.
    pub rotary: bool,
    /// The coordinates restart with each turn, so the axis has no range.
    pub endless: bool,
    /// Words of this axis are diameters, twice its travel. All other values of the axis are travel.
    pub diameter: bool,
    /// Rapid traverse in mm/min or °/min.
    pub rapid: f64,
    /// Cutting feed clamp in mm/min or °/min; a faster feed slows all axes of the movement.
    pub clamp: f64,
    /// Time constant of linear acceleration for cutting feed (and rapid), seconds.
    pub time_constant: f64,
    /// Position gain in 1/s: the axis lags `speed / gain` behind its command.
    pub position_gain: f64,
    /// Position at power-on, in mm or ° of the slide, machine frame.
    pub home: f64,
}

impl AxisPlant {
    /// An axis moved by the PLC, without inertia or lag.
    pub const PMC: AxisPlant = AxisPlant {
        letter: None,
        rotary: true,
        endless: true,
        diameter: false,
        rapid: 0.0,
        clamp: 0.0,
        time_constant: 0.0,
        position_gain: 0.0,
        home: 0.0,
    };

    /// The letter in messages.
    pub(super) fn name(&self) -> String {
        self.letter.map_or_else(|| "?".to_owned(), |letter| letter.to_string())
    }

    /// Units of words per millimetre of travel: 2 for diameters, otherwise 1.
    pub fn words_per_unit(&self) -> f64 {
        if self.diameter { 2.0 } else { 1.0 }
    }
}

/// Regulator in the inverter of a spindle that unwinds a web: it trims the speed by the position of a dancer between spindle and axis.
///
/// `trim = -limit · clamp(w / range, -1, 1)` with the web `w` (mm) beyond the set point, so that it falls by `e^(-t / T)` with
/// `T = range / (limit · v)` at the speed `v` of the web. Source: ribbon line facts, 7.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WebRegulator {
    /// Index of the axis that takes the web, in the control's order.
    pub axis: usize,
    /// Web (mm) per turn of the spindle.
    pub per_turn: f64,
    /// Web (mm) beyond the set point at which the trim reaches its limit.
    pub range: f64,
    /// Greatest trim, as a fraction of the speed.
    pub limit: f64,
    /// Time (s) between two samples of the dancer's position.
    pub interval: f64,
}

impl WebRegulator {
    /// Step of the trim, as a fraction of its limit: smaller changes give no new ramp.
    const STEP: f64 = 0.01;

    /// The regulator, if its numbers are usable.
    pub(super) fn checked(self) -> Option<WebRegulator> {
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        let usable = is_positive(self.range) && self.limit > 0.0 && self.limit < 1.0 && self.per_turn.is_finite();
        (usable && self.interval >= 1e-3).then_some(self)
    }

    /// Trim for `web` mm beyond the set point, in whole steps. The last one stays until it is wrong by a step.
    pub(super) fn trim(&self, web: f64, last: f64) -> f64 {
        let wanted = -self.limit * math::clamp(web / self.range, -1.0, 1.0);
        let step = self.limit * WebRegulator::STEP;
        if (wanted - last).abs() < step { last } else { step * (wanted / step).trunc() }
    }
}

/// A spindle on an analog output, through an inverter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpindlePlant {
    /// The analog output; the gear stage replaces its rated speed.
    pub analog: Analog,
    /// Gear stages.
    pub stages: [Stage; STAGES],
    /// Number of gear stages.
    pub stage_count: u8,
    /// Clamp in r/min of spindle or chuck.
    pub speed_clamp: f64,
    /// Lowest speed in r/min under constant surface speed (GSK 980TDc: No.043).
    pub surface_low: f64,
    /// Seconds from 0 to the rated speed of a stage, and back.
    pub ramp: f64,
    /// Coasting time (s) without current from the rated speed of each stage to rest; `None`: unknown, the spindle slows down over its ramp.
    pub coasting: Option<[f64; STAGES]>,
    /// Motor speed without load per commanded speed: an induction motor at 50 Hz turns at 1500 r/min for a command of 1480.
    pub gain: f64,
    /// Speed loss under load as a fraction of the rated speed: actual = gain × command - slip × rated speed while turning (constant at any
    /// speed, as for V/f control).
    pub slip: f64,
    /// An encoder measures the speed; without one, movements by feed per revolution wait.
    pub encoder: bool,
    /// Data of spindle positioning; `None` if the spindle cannot be positioned.
    pub positioning: Option<Positioning>,
    /// Turning centre on the axis perpendicular to the spindle, in mm in the machine frame; `None` if unknown.
    pub centre: Option<f64>,
    /// A driven tool turns during every cut at a spindle angle.
    pub driven_tool: bool,
    /// The spindle turns work or tool: motion before its speed is reached is a finding.
    pub drives_cut: bool,
    /// Regulator of the web that the spindle unwinds, if a dancer is fitted.
    pub regulator: Option<WebRegulator>,
    /// Spindle rules of the control.
    pub rules: SpindleRules,
}

impl SpindlePlant {
    /// A spindle with one stage, an encoder, and neither slip nor positioning.
    pub fn new(analog: Analog, speed_clamp: f64, ramp: f64, rules: SpindleRules) -> SpindlePlant {
        SpindlePlant {
            analog,
            stages: [Stage::new(analog.rated_speed); STAGES],
            stage_count: 1,
            speed_clamp,
            surface_low: 0.0,
            ramp,
            coasting: None,
            gain: 1.0,
            slip: 0.0,
            encoder: true,
            positioning: None,
            centre: None,
            driven_tool: false,
            drives_cut: true,
            regulator: None,
            rules,
        }
    }

    /// The spindle of a control's test bench, under these rules.
    pub fn bench(control: &Control, rules: SpindleRules) -> SpindlePlant {
        let bench = &control.bench;
        let first = bench.gears.first().copied().unwrap_or(0.0);
        let analog = control.analog_output.with_speed(first);
        // On controls without a code for presetting coordinates, axes count from the turning centre until a program shifts them.
        let centre = (!control.can(Code::SetCoordinates)).then_some(0.0);
        let spindle = SpindlePlant::new(analog, bench.speed_clamp, bench.ramp, rules);
        SpindlePlant { positioning: bench.positioning, centre, ..spindle }
            .with_stages(bench.gears.iter().copied().map(Stage::new))
    }

    /// The spindle with other gear stages, up to the maximum number; without any it keeps its first stage.
    pub fn with_stages(mut self, stages: impl IntoIterator<Item = Stage>) -> SpindlePlant {
        let mut count = 0;
        for (place, stage) in self.stages.iter_mut().zip(stages) {
            *place = stage;
            count += 1;
        }
        self.stage_count = count.max(1);
        self
    }

    /// The fitted stages.
    pub fn stages(&self) -> &[Stage] {
        self.stages.get(..usize::from(self.stage_count)).unwrap_or(&self.stages)
    }

    /// A stage by its number from 1; the first for an unknown number.
    pub fn stage(&self, number: u8) -> &Stage {
        &self.stages[self.place(number)]
    }

    /// Index of a stage by its number from 1; the first for an unknown number.
    fn place(&self, number: u8) -> usize {
        let place = usize::from(number).wrapping_sub(1);
        if place < self.stages().len() { place } else { 0 }
    }

    /// The analog output in a stage.
    pub fn analog(&self, stage: u8) -> Analog {
        let rests_at_zero = !self.rules.offset_at_rest;
        Analog { rated_speed: self.stage(stage).rated, rests_at_zero, ..self.analog }
    }

    /// Acceleration by the inverter's ramp in a stage, r/min per second; infinite without ramp.
    pub fn acceleration(&self, stage: u8) -> f64 {
        self.rate(stage, self.ramp)
    }

    /// Deceleration in a stage without current, r/min per second.
    pub fn coasting_rate(&self, stage: u8) -> f64 {
        let place = self.place(stage);
        self.rate(stage, self.coasting.map_or(self.ramp, |seconds| seconds[place]))
    }

    fn rate(&self, stage: u8, seconds: f64) -> f64 {
        if seconds > 0.0 { self.stage(stage).rated / seconds } else { f64::INFINITY }
    }
}

/// The whole plant.
#[derive(Debug, Clone, PartialEq)]
pub struct Plant {
    /// Axes, identified by their letters. Axes of the control that the machine lacks are omitted.
    pub axes: Vec<AxisPlant>,
    /// Axes moved by the PLC, at most [`PMC_AXES`](super::PMC_AXES). Only their time constant and gain are used.
    pub pmc: Vec<AxisPlant>,
    /// The spindle.
    pub spindle: SpindlePlant,
    /// Time (s) per block with NC words.
    pub block_time: f64,
    /// Time (s) per macro block.
    pub macro_time: f64,
    /// Blocks read ahead.
    pub preread: u8,
    /// In-position width for exact stop in mm.
    pub in_position: f64,
    /// Radius in mm of the round work, which lies at negative Z. Cuts into it with the spindle at rest, and returns to the program's
    /// reference point through it, are reported; 0 if unknown.
    pub stock: f64,
}
