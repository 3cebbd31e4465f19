//! The formulas of the turning spindle, each once: results that need no run.

use super::params::{Direction, Gear, Output, Params, Path, SpeedMode};
use crate::controls::{AnalogOutput, SpindleRules};
use crate::drives::cutting::{self, Cut};
use crate::drives::speed::{SpeedLimits, limit_diameter, surface_rpm, surface_speed};
use crate::drives::spindle_motor;
use crate::drives::{Analog, Bound};
use crate::math;

/// Greatest number of passes.
pub(super) const PASSES: f64 = 2000.0;

/// Longest time (s) in which a motor may give its overload without a pause, and the share of the time that it is in all. Source: duty S6-40 %
/// of IEC 60034-1, 4 minutes in 10.
const OVERLOAD_TIME: f64 = 240.0;
const OVERLOAD_SHARE: f64 = 0.4;

/// Speed of the spindle over the diameter, as the control limits it.
#[derive(Debug, Clone, Default)]
pub(super) struct Held {
    limits: SpeedLimits,
    /// Surface speed after an override that acts before the limits, m/min.
    speed: f64,
    /// Factor of an override that acts after the limits.
    after: f64,
    /// Greatest speed of the analog output, r/min.
    top: f64,
}

impl Held {
    /// Speed (r/min) at a diameter (mm) under constant surface speed, and the limit that binds it.
    pub(super) fn at(&self, diameter: f64) -> (f64, Bound) {
        self.within(surface_rpm(self.speed, diameter))
    }

    /// Surface speed after every override, m/min.
    pub(super) fn surface(&self) -> f64 {
        self.speed * self.after
    }

    fn within(&self, rpm: f64) -> (f64, Bound) {
        let (rpm, bound) = self.limits.hold(rpm);
        let most = self.limits.machine;
        // An override that acts after the limits may exceed all of them except the machine's.
        let bound = if bound == Bound::None && rpm * self.after > most { Bound::Machine } else { bound };
        let rpm = (rpm * self.after).min(most);
        if rpm > self.top { (self.top, if bound == Bound::Gear { bound } else { Bound::Output }) } else { (rpm, bound) }
    }
}

/// The results. Speeds in r/min, diameters in mm, times in s, voltages in V.
#[derive(Debug, Clone, Default)]
pub(super) struct Derived {
    pub passes: f64,
    pub largest: f64,
    pub smallest: f64,
    /// Largest diameter of the tool tip in the stock with the whole depth of cut, and the speed there.
    pub largest_cut: f64,
    pub speed_largest_cut: f64,
    pub speed_largest: f64,
    pub speed_smallest: f64,
    /// The limit that binds the speed at the smallest diameter.
    pub bound: Bound,
    pub limit_diameter: f64,
    pub low_diameter: f64,
    pub limited_share: f64,
    pub surface_smallest: f64,
    pub fixed_speed: f64,
    pub fixed_surface_smallest: f64,
    pub surface_time: f64,
    pub fixed_time: f64,
    pub cutting_time: f64,
    pub saved: f64,
    /// Number of the gear stage, from 1.
    pub stage: u8,
    pub stage_speed: f64,
    /// Greatest speed of the analog output in this stage, offsets included.
    pub stage_top: f64,
    /// Speed below the limit diameter.
    pub high: f64,
    pub volts_largest: f64,
    pub volts_smallest: f64,
    pub analog_step: f64,
    /// Greatest power of cut and friction, kW.
    pub power: f64,
    pub power_available: f64,
    /// Torque of cut and friction at the largest diameter of the cut, Nm.
    pub torque: f64,
    /// Continuous torque of the motor at the spindle there, Nm.
    pub torque_available: f64,
    pub acceleration_needed: f64,
    pub acceleration: f64,
    pub feed_top: f64,
    /// Commanded speed at the stock's diameter, at one speed for the whole cut.
    pub asked: f64,
    pub held: Held,
}

impl Derived {
    /// Speed of the spindle (r/min) that the program has at a diameter in mm.
    pub(super) fn speed_at(&self, p: &Params, diameter: f64) -> f64 {
        if p.speed_mode == SpeedMode::Fixed { self.fixed_speed } else { self.held.at(diameter).0 }
    }

    /// Rating over the cutting time: `rated · overload` up to 240 s where the cuts are two fifths of the time with the pause, else `rated`.
    pub(super) fn for_the_cut(&self, p: &Params, rated: f64) -> f64 {
        let is_rare = self.cutting_time <= OVERLOAD_TIME && p.pause >= self.pause_for_overload();
        if is_rare { rated * p.motor_overload / 100.0 } else { rated }
    }

    /// Pause (s) to the next part with which the cuts take two fifths of the time (S6-40 %), whatever the rest of the part takes.
    pub(super) fn pause_for_overload(&self) -> f64 {
        self.cutting_time * (1.0 / OVERLOAD_SHARE - 1.0)
    }

    /// Diameters (mm) one of which asks most of a motor with the base speed `base` at the spindle, r/min. Above base speed the demand of
    /// power, `F v / 60 + ω (M_f + J dω/dt)`, falls with the diameter; below, torque of cut and acceleration have no greatest value between
    /// both ends.
    pub(super) fn hardest_diameters(&self, base: f64) -> [f64; 3] {
        let largest = self.largest_cut;
        let least = self.limit_diameter.max(self.smallest).min(largest);
        let bend = limit_diameter(self.held.surface(), base);
        [largest, if bend > least && bend < largest { bend } else { largest }, least]
    }

    /// Greatest power (kW) of cut and friction.
    pub(super) fn steady_power(&self, p: &Params) -> f64 {
        let power = |diameter: f64| spindle_motor::power(p.steady_torque(diameter), self.speed_at(p, diameter));
        self.hardest_diameters(f64::INFINITY).map(power).into_iter().fold(0.0, f64::max)
    }
}

impl Params {
    /// Torque (Nm) of cut and friction with the tool tip at a diameter in mm: `F d_m / 2000 + M_f`, with d_m the middle of the edge in the
    /// stock. In front of the stock it is that of friction. Source: turning spindle facts, 4.
    pub(super) fn steady_torque(&self, diameter: f64) -> f64 {
        let cut = if diameter > self.stock_diameter { 0.0 } else { self.cutting_force };
        cutting::torque(cut, self.middle_of_edge(diameter)) + self.spindle.friction
    }

    /// Diameter (mm) at the middle of the edge in the stock, with its tip at a diameter: across the axis the edge reaches over the depth of cut.
    pub(super) fn middle_of_edge(&self, tip: f64) -> f64 {
        let reach = if self.path == Path::Facing { 0.0 } else { 2.0 * self.depth };
        0.5 * (tip + (tip + reach).min(self.stock_diameter).max(tip))
    }

    /// The largest diameter (mm) of the tip, among those of the cuts up to `largest`, at which the edge cuts over its whole depth.
    fn largest_cut(&self, (largest, smallest): (f64, f64)) -> f64 {
        let whole = self.stock_diameter - if self.path == Path::Facing { 0.0 } else { 2.0 * self.depth };
        // A single pass may be less deep.
        largest.min(whole.max(smallest))
    }

    /// Passes from stock to finished part.
    pub(super) fn passes(&self) -> f64 {
        let depth = match self.path {
            Path::Facing => self.allowance,
            Path::Turning => 0.5 * (self.stock_diameter - self.finished_diameter),
            Path::Taper => 0.5 * (self.stock_diameter - self.finished_diameter.min(self.large_diameter)),
        };
        // Nine decimals: 0.3 / 0.1 is three passes.
        math::clamp(math::whole_up(depth / self.depth), 0.0, PASSES)
    }

    /// Stock that remains after pass `pass` (from 1), mm: along Z on a face, else in diameter.
    pub(super) fn left(&self, pass: f64) -> f64 {
        match self.path {
            Path::Facing => (self.allowance - pass * self.depth).max(0.0),
            Path::Turning => (self.stock_diameter - self.finished_diameter - 2.0 * pass * self.depth).max(0.0),
            Path::Taper => {
                let small = self.finished_diameter.min(self.large_diameter);
                (self.stock_diameter - small - 2.0 * pass * self.depth).max(0.0)
            }
        }
    }

    /// The cuts of a pass (from 1), one or two. They begin at the clearance.
    pub(super) fn cuts(&self, pass: f64) -> impl Iterator<Item = Cut> {
        let (feed, clear) = (self.feed, self.clearance);
        let along = |diameter: f64, length: f64| Cut { diameters: (diameter, diameter), length, feed };
        let cuts = match self.path {
            Path::Facing => {
                let from = self.stock_diameter + 2.0 * clear;
                let length = (0.5 * (from - self.finished_diameter)).max(0.0);
                [Some(Cut { diameters: (from, self.finished_diameter), length, feed }), None]
            }
            Path::Turning => [Some(along(self.finished_diameter + self.left(pass), self.length + clear)), None],
            Path::Taper => {
                let offset = self.left(pass);
                let (face, end) = (self.finished_diameter + offset, self.large_diameter + offset);
                // A pass begins and ends where its line is clear of the stock.
                let most = self.stock_diameter + 2.0 * clear;
                let (from, to) = (face.min(most), end.min(most));
                let share = if face == end { 1.0 } else { (to - from) / (end - face) };
                let length = share * math::hypot(self.length, 0.5 * (end - face));
                [Some(along(from, clear)), Some(Cut { diameters: (from, to), length, feed })]
            }
        };
        cuts.into_iter().flatten()
    }

    /// Largest and smallest diameter at which anything is cut, the way in from the clearance included.
    pub(super) fn diameters(&self) -> (f64, f64) {
        let ends = [1.0, self.passes().max(1.0)].map(|pass| {
            self.cuts(pass).fold((0.0_f64, f64::INFINITY), |(large, small), Cut { diameters: (from, to), .. }| {
                (large.max(from).max(to), small.min(from).min(to))
            })
        });
        (ends[0].0.max(ends[1].0), ends[0].1.min(ends[1].1))
    }

    /// The converter of the analog output in a gear stage that has `stage_speed` r/min at 10 V.
    pub(super) fn analog(&self, stage_speed: f64, output: &AnalogOutput) -> Analog {
        Analog {
            offset_zero: self.offset_zero / 1000.0,
            offset_rated: self.offset_full / 1000.0,
            bipolar: self.output == Output::Bipolar,
            ..output.with_speed(stage_speed)
        }
    }

    /// Number of the gear stage, from 1, and its speed at full output: the chosen one where it is fitted, else the lowest that reaches
    /// `top` r/min, else the fastest.
    pub(super) fn stage(&self, top: f64) -> (u8, f64) {
        let stages = || (1..).zip(self.stages());
        let chosen = stages().find(|(number, _)| self.gear != Gear::Best && *number == self.gear as u8);
        let reaches = || stages().filter(|(_, speed)| *speed >= top).fold(None, slower);
        let fastest = || stages().fold((1, self.stage_1), |a, b| if b.1 > a.1 { b } else { a });
        chosen.or_else(reaches).unwrap_or_else(fastest)
    }
}

fn slower(best: Option<(u8, f64)>, next: (u8, f64)) -> Option<(u8, f64)> {
    Some(best.filter(|best| best.1 <= next.1).unwrap_or(next))
}

impl Derived {
    /// Computes the results for the analog output of a control with these rules of the spindle.
    pub(super) fn new(p: &Params, output: &AnalogOutput, rules: &SpindleRules) -> Derived {
        let (largest, smallest) = p.diameters();
        let largest_cut = p.largest_cut((largest, smallest));
        let fixed = p.speed_mode == SpeedMode::Fixed;
        let knob = p.override_percent / 100.0;
        let (before, after) = if rules.override_last { (1.0, knob) } else { (knob, 1.0) };
        // Commanded surface speed and its limits; an override after the limits is bound by the output alone.
        let v = p.cutting_speed * before;
        let machine = p.chuck_limit.min(p.upper_limit);
        let low = if fixed && !rules.low_always { 0.0 } else { p.lower_limit };
        let top = if fixed { surface_rpm(p.cutting_speed, p.stock_diameter) * knob } else { surface_rpm(v, smallest) };
        let top = top.max(low);
        let (stage, stage_speed) = p.stage(top.min(if fixed { p.chuck_limit } else { machine }));
        let analog = p.analog(stage_speed, output);
        let limits = |surface: bool| SpeedLimits {
            machine: p.chuck_limit,
            gear: (
                if rules.low_always { p.lower_limit } else { 0.0 },
                if surface { analog.top_speed() } else { f64::INFINITY },
            ),
            surface: if surface { (p.lower_limit, p.upper_limit) } else { (0.0, f64::INFINITY) },
            ..SpeedLimits::NONE
        };
        let held = |surface: bool| Held { limits: limits(surface), speed: v, after, top: analog.top_speed() };
        let (surface, constant) = (held(true), held(false));
        // S is a whole number, and at most the operator's limit.
        let s = surface_rpm(p.cutting_speed, p.stock_diameter).min(p.upper_limit).floor();
        let (fixed_speed, fixed_bound) = constant.within(s * before);
        let speed = |diameter: f64| if fixed { fixed_speed } else { surface.at(diameter).0 };
        let high = machine.min(analog.top_speed());
        let highest = (high * after).min(p.chuck_limit);
        let limit = limit_diameter(v, high);
        let passes = p.passes();
        let all = || (1..=passes as u32).flat_map(|pass| p.cuts(f64::from(pass)));
        let within = (p.lower_limit.min(high) * after, highest.min(analog.top_speed()));
        let surface_time = all().map(|cut| cut.surface_time(v * after, within)).sum::<f64>();
        let fixed_time = all().map(|cut| cut.time_at(fixed_speed)).sum::<f64>();
        let span = largest - smallest;
        let sign = if p.direction == Direction::CounterClockwise { -1.0 } else { 1.0 };
        let middle = 0.5 * output.volts;
        let motor = p.continuous(stage_speed);
        let derived = Derived {
            passes,
            largest,
            smallest,
            largest_cut,
            speed_largest_cut: speed(largest_cut),
            speed_largest: speed(largest),
            speed_smallest: speed(smallest),
            bound: if fixed { fixed_bound } else { surface.at(smallest).1 },
            limit_diameter: limit,
            low_diameter: if low > 0.0 { limit_diameter(v, low) } else { 0.0 },
            limited_share: if span > 0.0 && !fixed { math::clamp((limit - smallest) / span, 0.0, 1.0) } else { 0.0 },
            surface_smallest: surface_speed(speed(smallest), smallest),
            fixed_speed,
            fixed_surface_smallest: surface_speed(fixed_speed, smallest),
            surface_time,
            fixed_time,
            cutting_time: if fixed { fixed_time } else { surface_time },
            // 100 % if the fixed speed is 0: the cut would never end.
            saved: if fixed_time > 0.0 && surface_time.is_finite() {
                100.0 * (1.0 - surface_time / fixed_time)
            } else {
                0.0
            },
            stage,
            stage_speed,
            stage_top: analog.top_speed(),
            high: highest,
            volts_largest: analog.output(sign * speed(largest)),
            volts_smallest: analog.output(sign * speed(smallest)),
            analog_step: analog.speed(middle + output.volts / f64::from(analog.steps())) - analog.speed(middle),
            power: 0.0,
            power_available: motor.power,
            torque: p.steady_torque(largest_cut),
            torque_available: motor.torque(speed(largest_cut)),
            acceleration_needed: if fixed { 0.0 } else { acceleration(p, v, limit.max(smallest)) },
            acceleration: if p.spindle.ramp > 0.0 { stage_speed / p.spindle.ramp } else { f64::INFINITY },
            feed_top: p.feed * speed(smallest).max(speed(largest)),
            asked: s * before,
            held: surface,
        };
        Derived { power: derived.steady_power(p), ..derived }
    }
}

/// Acceleration of the spindle (r/min per second) at a diameter in mm, with a surface speed in m/min.
fn acceleration(p: &Params, v: f64, diameter: f64) -> f64 {
    let cuts = p.cuts(1.0).filter(|cut| cut.length > 0.0);
    let slope = cuts.map(|cut| (cut.diameters.1 - cut.diameters.0).abs() / cut.length).fold(0.0, f64::max);
    cutting::speed_gradient(surface_rpm(v, diameter), p.feed, slope, diameter)
}
