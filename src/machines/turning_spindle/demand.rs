//! Demand on the spindle's motor, once for rules, charts and sizing: cut, friction and acceleration together, by the formulas and in a run.

use super::derive::Derived;
use super::driven;
use super::params::{Params, Path, SpeedMode};
use super::program::cut_block;
use super::resolved::TurningSpindle;
use crate::drives::cutting;
use crate::drives::load::through_gear;
use crate::drives::shaft_motion::{CutSpan, Motion};
use crate::drives::spindle_motor::MotorCurve;
use crate::machines::driven::{SpindleRun, speed_segments};
use crate::machines::machine::Samples;
use crate::math::{self, RPM};
use crate::motion::Stretch;

/// Relative change of a diameter by which a change of the speed with it is found.
const CLOSE: f64 = 1e-6;

/// Least and greatest number of pieces of a cut with one torque each, and that of all cuts of a run.
const PIECES: (usize, usize) = (4, 48);
const ALL_PIECES: usize = 2000;

/// Halvings of the time in which the tool enters the stock.
const HALVINGS: u32 = 20;

/// The spindle at a diameter of the cut.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct CutPoint {
    /// Diameter, mm.
    pub diameter: f64,
    /// Speed, r/min.
    pub speed: f64,
    /// Torque of cut, friction and acceleration, Nm.
    pub torque: f64,
    /// Torque (Nm) that the motor gives there for a short time.
    pub most: f64,
}

impl Derived {
    /// Acceleration of the spindle (r/min per second) at a diameter (mm) of a cut towards smaller ones, at most that of the ramp; 0
    /// where the speed does not change with the diameter.
    fn acceleration_at(&self, p: &Params, diameter: f64) -> f64 {
        let n = self.speed_at(p, diameter);
        let changes = p.speed_mode == SpeedMode::Surface && self.speed_at(p, diameter * (1.0 + CLOSE)) < n;
        let cuts = p.cuts(1.0).filter(|cut| cut.length > 0.0);
        let slope = cuts.map(|cut| (cut.diameters.0 - cut.diameters.1) / cut.length).fold(0.0, f64::max);
        if changes { cutting::speed_gradient(n, p.feed, slope, diameter).min(self.acceleration) } else { 0.0 }
    }

    /// Torque (Nm) at the spindle with the tool tip at a diameter (mm): `F d_m / 2000 + M_f + J · 2π / 60 · dn/dt`. Source: turning spindle facts, 4.
    pub(super) fn torque_at(&self, p: &Params, diameter: f64) -> f64 {
        let inertia = p.main_spindle(self.stage_speed).load_at_spindle.inertia;
        p.steady_torque(diameter) + inertia * self.acceleration_at(p, diameter) * RPM
    }

    /// The point of the cut with the greatest fraction of a curve of the motor, by its torque at a diameter.
    fn worst_point(&self, p: &Params, motor: MotorCurve, torque: impl Fn(f64) -> f64) -> CutPoint {
        let at = |diameter: f64| {
            let speed = self.speed_at(p, diameter);
            CutPoint { diameter, speed, torque: torque(diameter), most: motor.torque(speed) }
        };
        let all = self.hardest_diameters(motor.base).map(at);
        all.into_iter()
            .fold(all[0], |worst, next| if next.torque * worst.most > worst.torque * next.most { next } else { worst })
    }

    /// The point of the cut that asks most of the short-time torque: cut, friction and acceleration together.
    pub(super) fn worst_cut_point(&self, p: &Params) -> CutPoint {
        let motor = p.main_spindle(self.stage_speed).driving_motor();
        self.worst_point(p, motor, |diameter| self.torque_at(p, diameter))
    }
}

/// The spindle's motor in stretches of a run: chuck and work against friction and cut, at its shaft.
pub(super) fn in_run(lathe: &TurningSpindle, run: &dyn Samples, stretches: &[Stretch]) -> SpindleRun {
    let (p, gear) = (&lathe.p, driven::gear(lathe));
    let idle = Motion::new(speed_segments(stretches, gear * RPM), driven::load_at_motor(lathe), 0.0);
    p.spindle.run(driven::NAME, idle, cuts(lathe, run, stretches))
}

/// The spans of a run in which the tool cuts, up to a time.
pub(super) fn working(lathe: &TurningSpindle, run: &dyn Samples, until: f64) -> Vec<(f64, f64)> {
    let whole = Stretch { t: 0.0, seconds: until, from: 0.0, to: 0.0 };
    let mut works: Vec<(f64, f64)> = Vec::new();
    for cut in cuts(lathe, run, &[whole]) {
        match works.last_mut() {
            Some((_, end)) if *end == cut.begin => *end = cut.end,
            _ => works.push((cut.begin, cut.end)),
        }
    }
    works
}

/// The spans in which the tool cuts, each so short that its mean torque holds.
fn cuts(lathe: &TurningSpindle, run: &dyn Samples, stretches: &[Stretch]) -> Vec<CutSpan> {
    let (p, gear) = (&lathe.p, driven::gear(lathe));
    let Some((from, to)) = stretches.first().zip(stretches.last()).map(|(a, b)| (a.t, b.t + b.seconds)) else {
        return Vec::new();
    };
    let spans = run.execution_spans(cut_block(p.path), to);
    let count = (ALL_PIECES / spans.len().max(1)).clamp(PIECES.0, PIECES.1);
    let mut cuts = Vec::new();
    for (begin, end) in spans {
        let (begin, end) = (begin.max(from), end.min(to));
        if begin >= end {
            continue;
        }
        let tips: Vec<Tip> =
            (0..=count).map(|at| Tip::at(lathe, run, begin + (end - begin) * at as f64 / count as f64)).collect();
        for pair in tips.windows(2) {
            if let [a, b] = pair
                && let Some((a, b)) = within_stock(lathe, run, *a, *b)
            {
                let torque = cutting::torque(p.cutting_force, 0.5 * (a.diameter + b.diameter));
                cuts.push(CutSpan { begin: a.t, end: b.t, torque: through_gear(torque, gear, p.efficiency / 100.0) });
            }
        }
    }
    cuts
}

/// The tool at a time in a run.
#[derive(Clone, Copy)]
struct Tip {
    /// Seconds.
    t: f64,
    /// Diameter at the middle of the edge, mm.
    diameter: f64,
    /// Whether the tool moves in the stock.
    cuts: bool,
}

impl Tip {
    fn at(lathe: &TurningSpindle, run: &dyn Samples, t: f64) -> Tip {
        let p = &lathe.p;
        let now = run.at(t);
        let (diameter, (_, z)) = (lathe.diameter(&now), lathe.tool(&now));
        let moves =
            [lathe.cross(), lathe.along()].iter().any(|axis| now.axes.get(*axis).is_some_and(|axis| axis.feed != 0.0));
        let along = p.path == Path::Facing || (-p.length..0.0).contains(&z);
        let cuts = moves && along && diameter.abs() < p.stock_diameter;
        Tip { t, diameter: p.middle_of_edge(diameter), cuts }
    }
}

/// The part of a span of a cutting block in which the tool moves in the stock, from the tool at its ends.
fn within_stock(lathe: &TurningSpindle, run: &dyn Samples, a: Tip, b: Tip) -> Option<(Tip, Tip)> {
    let edge = |inside: Tip, outside: Tip| {
        let cuts = |t: f64| Tip::at(lathe, run, t).cuts;
        Tip::at(lathe, run, math::last_holding(inside.t, outside.t, HALVINGS, cuts))
    };
    match (a.cuts, b.cuts) {
        (true, true) => Some((a, b)),
        (true, false) => Some((a, edge(a, b))),
        (false, true) => Some((edge(b, a), b)),
        (false, false) => {
            let middle = Tip::at(lathe, run, 0.5 * (a.t + b.t));
            middle.cuts.then(|| (edge(middle, a), edge(middle, b)))
        }
    }
}
