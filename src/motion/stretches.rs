//! A run as stretches of constant acceleration: what the motors do, without the steps of a sampling.

use super::path::Path;
use super::plant::AxisPlant;
use super::spindle::Ramp;
use super::timeline::Timeline;

/// An axis or the spindle of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mover {
    /// The axis with this index in the control's order; speeds in mm/s or °/s.
    Axis(usize),
    /// The axis with this index among those that the PLC turns; speeds in °/s.
    Turned(usize),
    /// The spindle behind its inverter; speeds in r/min.
    Spindle,
}

/// A part of a run in which the speed changes evenly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// When it begins, s.
    pub t: f64,
    /// How long it is, s.
    pub seconds: f64,
    /// Speed at its begin, signed.
    pub from: f64,
    /// Speed at its end, signed.
    pub to: f64,
}

/// Seconds below which two moments are one.
const MOMENT: f64 = 1e-9;

impl Timeline {
    /// The stretches from `from` to `to` seconds, without gaps.
    ///
    /// Of an axis the speed is the commanded one behind acceleration; the lag of its position loop is left out, but where there is no time
    /// constant, a time constant of one over the gain stands for it. On an arc the acceleration is the mean of each piece of the path.
    pub fn stretches(&self, of: Mover, from: f64, to: f64) -> Vec<Stretch> {
        let from = from.max(self.start);
        match of {
            Mover::Axis(axis) => match self.axes.get(axis) {
                Some(plant) => self.path.stretches(axis, plant, (from, to)),
                None => Vec::new(),
            },
            Mover::Turned(axis) => match self.pmc_axes.get(axis) {
                Some(plant) => self.pmc.stretches(axis, plant, (from, to)),
                None => Vec::new(),
            },
            Mover::Spindle => self.spindle_stretches(from, to),
        }
    }

    fn spindle_stretches(&self, from: f64, to: f64) -> Vec<Stretch> {
        let ramps = self.ramps.until(to);
        let mut out = Vec::new();
        for (at, ramp) in ramps.iter().enumerate() {
            let end = ramps.get(at + 1).map_or(to, |next| next.t).min(to);
            let begin = ramp.t.max(from);
            let mut moments: Vec<f64> =
                ramp.bends(&self.spindle).into_iter().filter(|t| *t > begin && *t < end).collect();
            moments.extend([begin, end]);
            put(&mut out, moments, |t| ramp.actual(&self.spindle, t));
        }
        out
    }
}

impl Path {
    /// The stretches of one axis.
    fn stretches(&self, k: usize, plant: &AxisPlant, (from, to): (f64, f64)) -> Vec<Stretch> {
        let lag = if plant.position_gain > 0.0 { 1.0 / plant.position_gain } else { 0.0 };
        let tau = if plant.time_constant > 0.0 { plant.time_constant } else { lag };
        let segments = self.segments.until(to);
        let first = segments.partition_point(|segment| segment.t < from - tau);
        let bends = segments[first..].iter().flat_map(|segment| [segment.t, segment.t + tau]);
        let mut moments: Vec<f64> = bends.filter(|t| *t > from && *t < to).collect();
        moments.extend([from, to]);
        let mut out = Vec::new();
        put(&mut out, moments, |t| self.mean_speed(k, t, tau));
        out
    }
}

/// Part of a speed below which two speeds are one.
const ALIKE: f64 = 1e-9;

/// Whether two speeds differ by rounding alone.
fn same(one: f64, other: f64) -> bool {
    (one - other).abs() <= ALIKE * one.abs().max(other.abs())
}

impl Stretch {
    /// Whether the speed stays.
    fn is_even(&self) -> bool {
        same(self.from, self.to)
    }
}

/// Adds the stretches between some moments, in any order.
fn put(out: &mut Vec<Stretch>, mut moments: Vec<f64>, speed: impl Fn(f64) -> f64) {
    moments.sort_by(f64::total_cmp);
    let Some(mut t) = moments.first().copied() else { return };
    let mut from = speed(t);
    for next in moments {
        if next - t > MOMENT {
            let to = speed(next);
            match out.last_mut() {
                // Blocks that follow each other at one speed are one stretch.
                Some(last) if last.is_even() && same(last.to, from) && same(from, to) => {
                    (last.seconds, last.to) = (next - last.t, to);
                }
                _ => out.push(Stretch { t, seconds: next - t, from, to }),
            }
            (t, from) = (next, to);
        }
    }
}

impl Ramp {
    /// Moments at which the speed bends: the end of the ramp, and where slip begins or ends to grow with the speed.
    fn bends(&self, plant: &super::plant::SpindlePlant) -> Vec<f64> {
        let slip = self.slip(plant);
        let edge = if slip.gain > 0.0 { slip.lost.abs() / slip.gain } else { 0.0 };
        let change = self.target - self.start;
        let crossed = [-edge, 0.0, edge].into_iter().map(|speed| (speed - self.start) / change);
        let within = crossed.filter(|part| *part > 0.0 && *part < 1.0);
        let span = self.reached() - self.t;
        within.map(|part| self.t + part * span).chain([self.reached()]).collect()
    }
}
