//! How fast the spindle is told to turn: S and override within their limits, constant surface speed, gear stages.

use super::executor::{Exec, MEASURE};
use super::moves::Pace;
use super::orienting::Orienting;
use super::program::Program;
use super::signals::percent;
use super::spindle::{Ramp, SpindleMode, Told};
use super::state::{Once, Sim};
use crate::controls::spindle::RapidSpeed;
use crate::drives::speed::{SpeedLimit, limit_diameter, surface_rpm};
use crate::drives::{Bound, SpeedLimits};
use crate::interp::Canon;
use crate::msg;

/// A speed that stands for all that are too high for any spindle.
const FASTEST: f64 = 1e9;
/// A step of constant surface speed changes the diameter by this part at most.
const PART: f64 = 0.05;
/// Shortest step in seconds.
const LEAST: f64 = 1e-4;

/// Constant surface speed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Surface {
    /// m/min.
    speed: f64,
    /// The axis that measures the radius.
    axis: usize,
    /// Its place in mm where the radius is 0.
    zero: f64,
    /// Until when the axis moves by a cut.
    until: f64,
    /// When the spindle is told the next speed.
    again: f64,
}

/// What is commanded of the spindle.
#[derive(Debug, Clone)]
pub(super) struct Turning {
    /// r/min before override and limits.
    pub(super) speed: f64,
    pub(super) direction: i8,
    pub(super) surface: Option<Surface>,
    /// Setting data: lowest and highest speed in r/min.
    set: (f64, f64),
    /// Highest speed under constant surface speed in r/min.
    surface_high: f64,
    /// Where the turning centre lies on the axis square to the spindle, in mm.
    centre: Option<f64>,
    /// Gear stages are selected by S.
    pub(super) automatic: bool,
    /// The axis that is square to the spindle, and its place in mm where the diameter is 0.
    pub(super) square: Option<(u8, f64)>,
    /// End of the ramp, or of a part of a travel to an angle.
    pub(super) reached_at: f64,
    /// The way to an angle.
    pub(super) orienting: Option<Orienting>,
    /// The zero mark of the encoder was seen.
    pub(super) synced: bool,
    /// The builder's lock holds the spindle at its angle.
    pub(super) locked: bool,
    /// A driven tool turns.
    pub(super) driven: bool,
}

impl Turning {
    /// At power-on; the axis that counts diameters is square to the spindle.
    pub(super) fn new(square: Option<u8>) -> Turning {
        Turning {
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
        }
    }

    /// Sets a limit in r/min; what is no number is none.
    pub(super) fn limit(&mut self, limit: SpeedLimit, rpm: f64) {
        let rpm = if rpm > 0.0 { rpm } else { 0.0 };
        match limit {
            SpeedLimit::Lower => self.set.0 = rpm,
            SpeedLimit::Upper => self.set.1 = rpm,
            SpeedLimit::Surface => self.surface_high = rpm,
        }
    }

    /// When the spindle does something by itself.
    pub(super) fn next(&self) -> f64 {
        self.surface.map_or(self.reached_at, |surface| surface.again.min(self.reached_at))
    }
}

impl<P: Program> Sim<'_, P> {
    /// Something of the spindle's own was due.
    pub(super) fn spindle(&mut self, t: f64) {
        if self.s.turning.reached_at <= t {
            self.s.turning.reached_at = f64::INFINITY;
            self.travel_on(t);
        }
        if let Some(surface) = &mut self.s.turning.surface
            && surface.again <= t
        {
            surface.again = f64::INFINITY;
        }
        self.scan(t);
        self.pace(t);
    }

    /// Brings the spindle's command up to date, and lets the PLC see it.
    pub(super) fn follow(&mut self, t: f64) {
        if self.turn(t) {
            self.scan(t);
        }
    }

    /// Brings the spindle's command up to date; whether it changed.
    pub(super) fn turn(&mut self, t: f64) -> bool {
        if self.s.turning.orienting.is_some() {
            return false;
        }
        let (now, later, span) = match self.following(t) {
            Some((now, later, span)) => {
                self.s.turning.speed = later;
                if let Some(surface) = &mut self.s.turning.surface {
                    surface.again = if span > 0.0 { t + span } else { f64::INFINITY };
                }
                (now, later, span)
            }
            None => (self.s.turning.speed, self.s.turning.speed, 0.0),
        };
        let ((from, _), (to, bound)) = (self.held(now), self.held(later));
        let span = if from == to { 0.0 } else { span };
        let told = Told { from, to, span, sign: self.s.turning.direction, stage: self.gear(), bound };
        let last = self.out.timeline.ramps.last();
        if last
            .is_some_and(|last| last.told == told && last.control == SpindleMode::Speed && (span == 0.0 || last.t == t))
        {
            return false;
        }
        let limited = self.s.turning.surface.is_none() && told.sign != 0;
        if limited && bound.is_upper() {
            let wanted = now * self.override_share();
            let stage = told.stage;
            self.say(Once::SpindleClamp as u32, || match bound {
                Bound::Output => msg!("motion.output-full", wanted, f64::from(stage), (to, 3)),
                _ => msg!("motion.spindle-clamp", wanted, to),
            });
        }
        self.put_ramp(t, told);
        self.pace(t);
        true
    }

    /// The gear stage that the PLC reports; the first where there is none such.
    fn gear(&self) -> u8 {
        let gear = self.s.io.gear;
        if gear <= self.machine.spindle.stage_count { gear.max(1) } else { 1 }
    }

    /// The override as a factor.
    fn override_share(&self) -> f64 {
        let whole = self.s.exec.threads() && !self.machine.spindle.rules.thread_override;
        if whole { 1.0 } else { percent(self.s.io.spindle_override_out) / 100.0 }
    }

    /// A speed in r/min behind override and limits, and what holds it.
    fn held(&self, rpm: f64) -> (f64, Bound) {
        let (plant, turning) = (&self.machine.spindle, &self.s.turning);
        let (stage, analog) = (plant.stage(self.gear()), plant.analog(self.gear()));
        if let Some(volts) = self.s.io.gear_volts {
            return (analog.speed(volts).min(FASTEST), Bound::Shift);
        }
        let mut set = turning.set;
        if plant.rules.lower_wins {
            set.1 = set.1.max(set.0);
        }
        let mut limits = SpeedLimits { machine: plant.speed_clamp, gear: stage.range, set, ..SpeedLimits::NONE };
        if turning.surface.is_some() {
            limits.surface = (plant.surface_low, turning.surface_high);
            limits.gear.1 = limits.gear.1.min(analog.top_speed());
        } else if plant.rules.surface_limit_stays {
            limits.surface.1 = turning.surface_high;
        }
        let share = self.override_share();
        let (rpm, bound) = if plant.rules.override_last {
            let (rpm, bound) = limits.hold(rpm);
            let machine = SpeedLimits { machine: plant.speed_clamp, ..SpeedLimits::NONE }.hold(rpm * share);
            (machine.0, if bound == Bound::None { machine.1 } else { bound })
        } else {
            limits.hold(rpm * share)
        };
        // The output ends at full voltage, whatever is commanded.
        let top = analog.top_speed();
        if rpm > top { (top, Bound::Output) } else { (rpm, bound) }
    }

    /// Speed for where the axis of constant surface speed is, before override and limits.
    fn surface_rpm(&self, place: f64) -> Option<f64> {
        let surface = self.s.turning.surface?;
        Some(surface_rpm(surface.speed, 2.0 * (place - surface.zero)).min(FASTEST))
    }

    /// While a cut moves the axis of constant surface speed: the speed now, a little later, and how much later.
    fn following(&self, t: f64) -> Option<(f64, f64, f64)> {
        let surface = self.s.turning.surface.filter(|surface| t < surface.until)?;
        let plant = self.machine.axes.get(surface.axis)?;
        let end = match &self.s.exec {
            Exec::Moving(motion) => motion.end_time().min(surface.until),
            _ => surface.until,
        };
        let diameter = |t: f64| 2.0 * (self.out.timeline.path.commanded(surface.axis, plant, t) - surface.zero).abs();
        let rpm = |diameter: f64| surface_rpm(surface.speed, diameter).min(FASTEST);
        let mut span = MEASURE.min(end - t);
        let here = diameter(t);
        if span < LEAST * 1e-3 {
            return Some((rpm(here), rpm(here), 0.0));
        }
        let mut there = diameter(t + span);
        let rate = (there - here).abs() / span;
        let (bound, bound_later) = (self.held(rpm(here)).1, self.held(rpm(there)).1);
        if rate > 0.0 && (bound == Bound::None || bound != bound_later) {
            span = span.min((PART * here / rate).max(LEAST));
            // Where a limit begins or ends, a step does too.
            if bound != bound_later {
                let share = self.override_share();
                let edge = self.held(rpm(if bound == Bound::None { there } else { here })).0 / share;
                let to_edge = (limit_diameter(surface.speed, edge) - here).abs() / rate;
                span = span.min(to_edge.max(LEAST));
            }
            there = diameter(t + span);
        }
        Some((rpm(here), rpm(there), span))
    }

    /// Constant surface speed from now on.
    pub(super) fn begin_surface(&mut self, t: f64, speed: f64, axis: u8, zero: i64) {
        let (Some(scale), at) = (self.machine.scale.get(usize::from(axis)), usize::from(axis)) else { return };
        let zero = zero as f64 * scale;
        let before = self.s.turning.surface.filter(|before| before.axis == at);
        let until = before.map_or(f64::NEG_INFINITY, |before| before.until);
        self.s.turning.surface = Some(Surface { speed, axis: at, zero, until, again: f64::INFINITY });
        self.s.turning.square = Some((axis, zero));
        // Where nobody knows the turning centre, the first work zero is taken for it.
        let centre = *self.s.turning.centre.get_or_insert(self.machine.spindle.centre.unwrap_or(zero));
        if (centre - zero).abs() > 1e-9 {
            let letter = char::from(self.machine.axes[at].letter).to_string();
            self.say(Once::OffCentre as u32, || msg!("motion.off-centre", letter, ((zero - centre).abs(), 4)));
        }
        if self.machine.spindle.rules.surface_at_once || before.is_some_and(|before| before.until.is_finite()) {
            self.aim(self.s.position[at]);
        }
        self.follow(t);
    }

    /// Constant surface speed is over: the spindle keeps the speed that it has.
    pub(super) fn end_surface(&mut self, t: f64) {
        let (held, share) = (self.held(self.s.turning.speed).0, self.override_share());
        if self.s.turning.surface.take().is_some() && share > 0.0 {
            self.s.turning.speed = held / share;
        }
        self.follow(t);
    }

    /// Sets the speed of constant surface speed for a place of its axis.
    fn aim(&mut self, place: f64) {
        self.s.turning.speed = self.surface_rpm(place).unwrap_or(self.s.turning.speed);
    }

    /// A cut is about to begin: constant surface speed is that of where it begins.
    pub(super) fn aim_at_cut(&mut self, t: f64) {
        if let Some(surface) = self.s.turning.surface
            && t >= surface.until
        {
            self.aim(self.s.position[surface.axis]);
            self.follow(t);
        }
    }

    /// A block is read while a rapid runs: if it cuts, the rapid has the speed of its end from now on.
    pub(super) fn aim_ahead(&mut self, t: f64) {
        let rapid = || matches!(&self.s.exec, Exec::Moving(motion) if motion.pace == Pace::Rapid);
        if self.s.turning.surface.is_some()
            && self.machine.spindle.rules.rapid == RapidSpeed::BeforeCut
            && self.s.queue.back().is_some_and(|queued| queued.canon.is_cut() == Some(true))
            && rapid()
        {
            self.aim_at_motion(t);
            self.follow(t);
        }
    }

    /// A motion begins: constant surface speed looks at its axis.
    pub(super) fn aim_at_motion(&mut self, t: f64) {
        let (Exec::Moving(motion), Some(surface)) = (&self.s.exec, self.s.turning.surface) else { return };
        if motion.pace != Pace::Rapid {
            // A cut that follows a cut goes on from where the axis is on its way.
            let still = t >= surface.until;
            let place = self.s.position[surface.axis];
            self.watch(t);
            if still {
                self.aim(place);
            }
        } else {
            let end = motion.end[surface.axis];
            self.watch(t);
            let cut_next = || {
                let next = self.s.queue.iter().find_map(|queued| queued.canon.is_cut());
                next == Some(true)
            };
            if self.machine.spindle.rules.rapid == RapidSpeed::OfEnd || cut_next() {
                self.aim(end);
            }
        }
    }

    /// A new part of the path begins: until when does a cut move the axis of constant surface speed?
    pub(super) fn watch(&mut self, t: f64) {
        let Some(surface) = &mut self.s.turning.surface else { return };
        let settles = t + self.machine.axes.get(surface.axis).map_or(0.0, |axis| axis.time_constant);
        surface.until = match &self.s.exec {
            Exec::Moving(motion) if motion.pace == Pace::Rapid => f64::NEG_INFINITY,
            Exec::Moving(motion) if motion.moves(surface.axis) && motion.speed > 0.0 => f64::INFINITY,
            _ => surface.until.min(settles),
        };
        if surface.until <= t {
            surface.again = f64::INFINITY;
        } else if surface.again == f64::INFINITY {
            surface.again = t;
        }
    }

    /// Lets the spindle go from where it is to what it is told.
    pub(super) fn put_ramp(&mut self, t: f64, told: Told) {
        let plant = &self.machine.spindle;
        let last = self.out.timeline.ramps.last();
        let (mut start, turns) = last.map_or((0.0, 0.0), |ramp| (ramp.speed(t), ramp.turns(plant, t)));
        let sign = f64::from(told.sign);
        let (from, target) = (sign * told.from, sign * told.to);
        let mut rate = plant.acceleration(told.stage);
        if told.span > 0.0 {
            if rate == f64::INFINITY {
                start = from;
            }
            rate = rate.min((target - start).abs() / told.span);
        }
        self.s.io.spindle_command = target;
        let square = self.s.turning.square;
        let ramp = Ramp { t, start, target, rate, turns, told, control: SpindleMode::Speed, square };
        self.put(ramp);
    }

    /// Records a ramp; its end is something that happens.
    pub(super) fn put(&mut self, ramp: Ramp) {
        let reached = ramp.reached();
        self.s.turning.reached_at = if reached > ramp.t { reached } else { f64::INFINITY };
        self.out.timeline.ramps.put(ramp);
    }
}

impl Canon {
    /// Whether a motion cuts; `None` for what is no motion.
    pub(super) fn is_cut(&self) -> Option<bool> {
        match self {
            Canon::Rapid { .. } => Some(false),
            Canon::Linear { .. } | Canon::Arc { .. } | Canon::Thread { .. } => Some(true),
            _ => None,
        }
    }
}
