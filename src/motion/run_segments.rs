//! A run as segments of constant acceleration: exact motor loads without a sampling step.

use super::path::Path;
use super::plant::AxisPlant;
use super::spindle::InverterRamp;
use super::timeline::Timeline;

/// An axis or the spindle of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mover {
    /// The axis with this index in the control's order; speeds in mm/s or °/s.
    Axis(usize),
    /// The axis with this index among the axes moved by the PLC; speeds in °/s.
    Turned(usize),
    /// The spindle after its inverter; speeds in r/min.
    Spindle,
}

/// A part of a run with a linear change of speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunSegment {
    /// Start, s.
    pub t: f64,
    /// Duration, s.
    pub seconds: f64,
    /// Speed at the start, signed.
    pub from: f64,
    /// Speed at the end, signed.
    pub to: f64,
}

/// Shortest time (s) between two different moments.
const MOMENT: f64 = 1e-9;

impl Timeline {
    /// The segments from `from` to `to` seconds, without gaps.
    ///
    /// The speed of an axis is the commanded one after acceleration. The lag of its position loop is left out; an axis without time
    /// constant gets one of 1 / gain instead. On an arc the acceleration is the mean over each piece of the path.
    pub fn run_segments(&self, of: Mover, from: f64, to: f64) -> Vec<RunSegment> {
        let from = from.max(self.start);
        match of {
            Mover::Axis(axis) => match self.axes.get(axis) {
                Some(plant) => self.path.run_segments(axis, plant, (from, to)),
                None => Vec::new(),
            },
            Mover::Turned(axis) => match self.pmc_axes.get(axis) {
                Some(plant) => self.pmc.run_segments(axis, plant, (from, to)),
                None => Vec::new(),
            },
            Mover::Spindle => self.spindle_segments(from, to, |_| true),
        }
    }

    /// The segments from `from` to `to` seconds in which the inverter of the spindle supplies current.
    pub fn run_segments_of_driven_spindle(&self, from: f64, to: f64) -> Vec<RunSegment> {
        self.spindle_segments(from.max(self.start), to, |ramp| !ramp.command.coasts)
    }

    fn spindle_segments(&self, from: f64, to: f64, counts: impl Fn(&InverterRamp) -> bool) -> Vec<RunSegment> {
        let ramps = self.ramps.until(to);
        let mut out = Vec::new();
        for (at, ramp) in ramps.iter().enumerate() {
            let end = ramps.get(at + 1).map_or(to, |next| next.t).min(to);
            let begin = ramp.t.max(from);
            if end <= begin || !counts(ramp) {
                continue;
            }
            let mut moments: Vec<f64> =
                ramp.bends(&self.spindle).into_iter().filter(|t| *t > begin && *t < end).collect();
            moments.extend([begin, end]);
            put(&mut out, moments, |t| ramp.actual(&self.spindle, t));
        }
        out
    }
}

impl Path {
    /// The segments of one axis.
    fn run_segments(&self, k: usize, plant: &AxisPlant, (from, to): (f64, f64)) -> Vec<RunSegment> {
        let lag = if plant.position_gain > 0.0 { 1.0 / plant.position_gain } else { 0.0 };
        // The slower of ramp and servo loop: a shorter ramp lasts as long as the loop takes to follow it.
        let tau = plant.time_constant.max(lag);
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

/// Relative difference below which two speeds are equal.
const ALIKE: f64 = 1e-9;

/// Whether two speeds differ only by rounding.
fn same(one: f64, other: f64) -> bool {
    (one - other).abs() <= ALIKE * one.abs().max(other.abs())
}

impl RunSegment {
    /// Whether the speed is constant.
    fn is_even(&self) -> bool {
        same(self.from, self.to)
    }
}

/// Adds the segments between the given moments (s), in any order.
fn put(out: &mut Vec<RunSegment>, mut moments: Vec<f64>, speed: impl Fn(f64) -> f64) {
    moments.sort_by(f64::total_cmp);
    let Some(mut t) = moments.first().copied() else { return };
    let mut from = speed(t);
    for next in moments {
        if next - t > MOMENT {
            let to = speed(next);
            match out.last_mut() {
                // Consecutive blocks of equal constant speed are one segment.
                Some(last) if last.is_even() && same(last.to, from) && same(from, to) => {
                    (last.seconds, last.to) = (next - last.t, to);
                }
                _ => out.push(RunSegment { t, seconds: next - t, from, to }),
            }
            (t, from) = (next, to);
        }
    }
}

impl InverterRamp {
    /// Moments (s) of changes of acceleration: the end of the ramp, and the speeds at which slip starts or stops to grow.
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
