//! The builder's PMC of the polygon lathe: takes speed, ratios and start angles from the macro program, turns both axes, answers in bits.
//!
//! From the paper: the variables of speed and ratios, and that each axis turns at their product. The rest is ours, as in the ladder list:
//! reset and emergency stop end polygon turning (in ratio, or coasting with the drives off), and only a new request starts it again. Feed
//! hold stops the slide alone.

use super::program::{
    AT_ANGLE, AT_SPEED, IDLE, INDEX, ON, SPEED, TOOL_ANGLE, TOOL_RATIO, TURN, WORK_ANGLE, WORK_RATIO,
};
use super::resolved::{PolygonLathe, TOOL, WORK};
use crate::motion::{BenchPlc, Io, PMC_AXES, Plc};

/// Seconds from a strobe to FIN: a few scans of the ladder.
const FIN_DELAY: f64 = 0.05;
/// The word of the inputs, whose bits are `#1000` to `#1015`.
const INPUTS: u32 = 1032;
/// Seconds between two speeds of an axis that coasts.
const STEP: f64 = 0.01;
/// Turns that count as zero.
const NOTHING: f64 = 1e-9;

/// State of polygon turning.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Stage {
    /// Nothing turns.
    Off,
    /// Each axis turns to its start angle until then.
    Indexing([f64; PMC_AXES]),
    /// Both stand at their angles, at rest from then on.
    Indexed(f64),
    /// Both turn, at speed from then on.
    Turning(f64),
    /// Both come to rest until then.
    Stopping(f64),
    /// Both coast since then, from these speeds in r/min.
    Coasting(f64, [f64; PMC_AXES]),
}

/// The ladder.
#[derive(Debug, Clone)]
pub(super) struct PolygonPlc {
    /// FIN for S, M and T.
    codes: BenchPlc,
    stage: Stage,
    /// The request was ended by reset; it is ignored until it falls.
    spent: bool,
    /// Settling time of an axis, s.
    settle: f64,
    /// Speed to the start angles in r/min.
    index_speed: f64,
    /// The feed override acts.
    overrides: bool,
    /// Deceleration (r/min per second) of each axis after an emergency stop that switches the drives off.
    coasting: Option<[f64; PMC_AXES]>,
}

impl PolygonPlc {
    pub(super) fn new(lathe: &PolygonLathe) -> PolygonPlc {
        let p = &lathe.p;
        PolygonPlc {
            codes: BenchPlc::new(FIN_DELAY, None),
            stage: Stage::Off,
            spent: false,
            settle: p.settling(),
            index_speed: p.index_speed,
            overrides: lathe.overrides(),
            coasting: p.coasts(lathe.control).then(|| p.coasting()),
        }
    }

    /// Sets the speeds of the stage, or enters the next one; returns the time of the next scan.
    fn run(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let out = |variable: u32| io.outputs.get(&variable).copied().unwrap_or(0.0);
        let (index, turn) = (out(INDEX) != 0.0, out(TURN) != 0.0);
        let angles = [out(WORK_ANGLE), out(TOOL_ANGLE)].map(|thousandths| thousandths / 360_000.0);
        let speeds = [WORK_RATIO, TOOL_RATIO].map(|ratio| out(SPEED) * out(ratio));
        let share = if self.overrides { io.feed_override / 100.0 } else { 1.0 };
        self.spent &= index || turn;
        if io.stops.reset && !matches!(self.stage, Stage::Off | Stage::Coasting(..)) {
            let off = io.stops.emergency && self.coasting.is_some();
            self.stage = if off { Stage::Coasting(t, io.pmc_speed) } else { Stage::Stopping(t + self.settle) };
            self.spent = true;
        }
        match self.stage {
            Stage::Off if index && !self.spent => {
                let ways: [f64; PMC_AXES] = core::array::from_fn(|k| way(io.pmc_turns[k], angles[k]));
                io.pmc_speed = ways.map(|way| self.index_speed * f64::from(i8::from(way > 0.0) - i8::from(way < 0.0)));
                self.stage = Stage::Indexing(ways.map(|way| t + way.abs() * 60.0 / self.index_speed));
            }
            Stage::Indexed(at) if turn && t >= at => self.stage = Stage::Turning(t + self.settle),
            Stage::Indexed(_) | Stage::Indexing(_) if !index => self.stage = Stage::Stopping(t + self.settle),
            Stage::Turning(_) if !turn => self.stage = Stage::Stopping(t + self.settle),
            Stage::Stopping(until) if t >= until => (self.stage, self.spent) = (Stage::Off, index || turn),
            _ => {}
        }
        match self.stage {
            Stage::Indexing(until) => {
                for (speed, until) in io.pmc_speed.iter_mut().zip(until) {
                    if t >= until {
                        *speed = 0.0;
                    }
                }
                if io.pmc_speed == [0.0; PMC_AXES] {
                    self.stage = Stage::Indexed(t + self.settle);
                    return Some(t + self.settle);
                }
                until.into_iter().filter(|until| *until > t).reduce(f64::min)
            }
            Stage::Indexed(at) => (t < at).then_some(at),
            Stage::Turning(at) => {
                io.pmc_speed = [WORK, TOOL].map(|k| speeds[k] * share);
                (t < at).then_some(at)
            }
            Stage::Coasting(since, from) => {
                let slows = self.coasting.unwrap_or([f64::INFINITY; PMC_AXES]);
                // In steps, each at the speed of its middle.
                let gone = t + 0.5 * STEP - since;
                io.pmc_speed = core::array::from_fn(|k| (from[k].abs() - slows[k] * gone).max(0.0).copysign(from[k]));
                if io.pmc_speed == [0.0; PMC_AXES] {
                    self.stage = Stage::Stopping(t + self.settle);
                    return Some(t + self.settle);
                }
                Some(t + STEP)
            }
            Stage::Off | Stage::Stopping(_) => {
                io.pmc_speed = [0.0; PMC_AXES];
                if let Stage::Stopping(until) = self.stage { Some(until) } else { None }
            }
        }
    }

    /// Writes the bits that the program reads.
    fn answer(&self, t: f64, io: &mut Io) {
        let asked = [INDEX, TURN].iter().any(|bit| io.outputs.get(bit).is_some_and(|value| *value != 0.0));
        let due = |at: f64| t >= at;
        let bits = [
            (AT_ANGLE, matches!(self.stage, Stage::Indexed(at) if due(at)) || matches!(self.stage, Stage::Turning(_))),
            (AT_SPEED, matches!(self.stage, Stage::Turning(at) if due(at))),
            (ON, self.stage != Stage::Off),
            (IDLE, self.stage == Stage::Off && !asked),
        ];
        let word = bits.iter().filter(|(_, on)| *on).map(|(bit, _)| f64::from(1_u32 << (bit - AT_ANGLE))).sum();
        io.inputs.insert(INPUTS, word);
    }
}

/// Travel of an axis to an angle, in turns: forward, or backward to a negative angle.
fn way(now: f64, angle: f64) -> f64 {
    let left = angle - now;
    let whole = if angle < 0.0 { (left + NOTHING).ceil() } else { (left - NOTHING).floor() };
    // At the angle already.
    if (left - left.round()).abs() <= NOTHING { left - left.round() } else { left - whole }
}

impl Plc for PolygonPlc {
    fn scan(&mut self, t: f64, io: &mut Io) -> Option<f64> {
        let codes = self.codes.scan(t, io);
        let run = self.run(t, io);
        self.answer(t, io);
        [codes, run].into_iter().flatten().reduce(f64::min)
    }

    fn boxed(&self) -> Box<dyn Plc> {
        Box::new(self.clone())
    }
}
