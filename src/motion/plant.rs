//! The machine as motion sees it: axes with clamps and time constants, one spindle with gear stages, ramps and analog output.

use crate::controls::{Address, Code, Control, SpindleRules};
use crate::drives::speed::STAGES;
use crate::drives::{Analog, Positioning, Stage};

/// The most axes that a PLC turns.
pub const PMC_AXES: usize = 2;

/// An axis of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisPlant {
    /// Address letter; `None` for an axis that programs cannot name.
    pub letter: Option<Address>,
    /// Turns: degrees instead of millimetres.
    pub rotary: bool,
    /// Coordinates begin anew with each turn: the axis has no range.
    pub endless: bool,
    /// Words of this axis are diameters, twice its travel. All other values are its travel.
    pub diameter: bool,
    /// Rapid traverse in mm/min or °/min.
    pub rapid: f64,
    /// Cutting feed clamp in mm/min or °/min: above it the whole vector is slowed.
    pub clamp: f64,
    /// Time constant of linear acceleration for cutting feed (and rapid), seconds.
    pub time_constant: f64,
    /// Position gain in 1/s: the axis lags `speed / gain` behind its command.
    pub position_gain: f64,
    /// Position at power-on, in mm or ° of the slide, machine frame.
    pub home: f64,
}

impl AxisPlant {
    /// An axis that the PLC turns, and that follows at once.
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

    /// What words count for each millimetre that the axis moves.
    pub fn words_per_unit(&self) -> f64 {
        if self.diameter { 2.0 } else { 1.0 }
    }
}

/// A spindle on an analog output, through an inverter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpindlePlant {
    /// The analog output; its rated speed is that of the gear stage.
    pub analog: Analog,
    /// Gear stages.
    pub stages: [Stage; STAGES],
    /// How many of them there are.
    pub stage_count: u8,
    /// Clamp in r/min: of spindle or chuck.
    pub speed_clamp: f64,
    /// Lowest speed in r/min under constant surface speed (No.043).
    pub surface_low: f64,
    /// Seconds from 0 to the rated speed of a stage, and back.
    pub ramp: f64,
    /// Seconds in which it coasts from the rated speed of each stage to rest without current; where that is not known it slows down over its ramp.
    pub coasting: Option<[f64; STAGES]>,
    /// Speed of the unloaded motor per commanded speed: an induction motor at 50 Hz turns 1500 where 1480 is asked for.
    pub gain: f64,
    /// Speed lost under load as a fraction of the rated speed: actual = gain × command - slip × rated speed while
    /// turning (constant at any speed, as for V/f control).
    pub slip: f64,
    /// An encoder measures the speed; without one, nothing moves by feed per revolution.
    pub encoder: bool,
    /// What positioning needs, where the spindle can be positioned.
    pub positioning: Option<Positioning>,
    /// Delay (s) between a new speed command and the speed-reached check, where cuts wait for it (No.072).
    pub reached_delay: f64,
    /// Where the turning centre lies on the axis that is square to it, in mm in the machine frame; `None` where it is unknown.
    pub centre: Option<f64>,
    /// A driven tool turns whenever something is cut at an angle.
    pub driven_tool: bool,
    /// The spindle turns work or tool: motion before it has reached its speed is a finding.
    pub drives_cut: bool,
    /// Rules of the control for the spindle.
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
            reached_delay: 0.0,
            centre: None,
            driven_tool: false,
            drives_cut: true,
            rules,
        }
    }

    /// The spindle of a control's bench, under these rules.
    pub fn bench(control: &Control, rules: SpindleRules) -> SpindlePlant {
        let bench = &control.bench;
        let first = bench.gears.first().copied().unwrap_or(0.0);
        let analog = Analog { bits: bench.output_bits, ..Analog::unipolar(first, bench.volts_full) };
        // Where no code makes the present position a work zero, axes count from the turning centre until a program shifts them.
        let centre = (!control.can(Code::SetCoordinates)).then_some(0.0);
        let spindle = SpindlePlant::new(analog, bench.speed_clamp, bench.ramp, rules);
        SpindlePlant { positioning: bench.positioning, centre, ..spindle }
            .with_stages(bench.gears.iter().copied().map(Stage::new))
    }

    /// The same with these stages, as many as a spindle can have; with none it keeps its first one.
    pub fn with_stages(mut self, stages: impl IntoIterator<Item = Stage>) -> SpindlePlant {
        let mut count = 0;
        for (place, stage) in self.stages.iter_mut().zip(stages) {
            *place = stage;
            count += 1;
        }
        self.stage_count = count.max(1);
        self
    }

    /// The stages that there are.
    pub fn stages(&self) -> &[Stage] {
        self.stages.get(..usize::from(self.stage_count)).unwrap_or(&self.stages)
    }

    /// A stage by its number from 1; the first where there is none such.
    pub fn stage(&self, number: u8) -> &Stage {
        &self.stages[self.place(number)]
    }

    /// Where a stage stands in the tables, by its number from 1; the first where there is none such.
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

    /// Loss of speed in a stage without current, r/min per second.
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
    /// Axes, found by their letters. Axes of the control that the machine lacks are not here.
    pub axes: Vec<AxisPlant>,
    /// Axes that the PLC turns by itself, [`PMC_AXES`](super::PMC_AXES) at most. Of each, time constant and gain count.
    pub pmc: Vec<AxisPlant>,
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
    /// Radius in mm of the round work behind Z0, into which no cut may feed while the spindle is at rest, and no return to the program's
    /// reference point may go; 0 where it is unknown.
    pub stock: f64,
}
