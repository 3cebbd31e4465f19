//! The point of the cut with the greatest short-time demand on the spindle's motor: cut, friction and acceleration together.

use super::derive::Derived;
use super::params::{Params, SpeedMode};
use crate::drives::cutting;
use crate::math::RPM;

/// Relative step of the diameter for the numerical derivative of the speed.
const CLOSE: f64 = 1e-6;

/// The spindle at a diameter of the cut.
#[derive(Debug, Clone, Copy, PartialEq)]
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

/// The points of the cut where the short-time demand may be greatest, with a torque (Nm) by the diameter (mm).
fn points(p: &Params, d: &Derived, torque: impl Fn(f64) -> f64) -> [CutPoint; 3] {
    let motor = p.main_spindle(d.stage.speed).driving_motor();
    let at = |diameter: f64| {
        let speed = d.speeds.at(p, diameter);
        CutPoint { diameter, speed, torque: torque(diameter), most: motor.torque(speed) }
    };
    d.limits.hardest(&d.cut, &d.speeds, motor.base).map(at)
}

/// The point with the greatest fraction of the short-time torque.
fn worst(all: [CutPoint; 3]) -> CutPoint {
    all.into_iter()
        .fold(all[0], |worst, next| if next.torque * worst.most > worst.torque * next.most { next } else { worst })
}

/// The point of the cut with the greatest fraction of the short-time torque.
pub(super) fn worst_cut_point(p: &Params, d: &Derived) -> CutPoint {
    worst(points(p, d, |diameter| torque_at(p, d, diameter)))
}

/// The same point while the inverter accelerates over its whole ramp: `J · 2π n10 / (60 t) + M_cut + M_f`. Source:
/// turning spindle facts, 5.
pub(super) fn worst_ramp_point(p: &Params, d: &Derived) -> CutPoint {
    let spindle = p.main_spindle(d.stage.speed);
    let ramp = if spindle.ramp > 0.0 { spindle.ramp_torque() - spindle.load_at_spindle.torque } else { 0.0 };
    worst(points(p, d, |diameter| p.steady_torque(diameter) + ramp))
}

/// Least torque (Nm) over the cut that cut and friction leave to accelerate the spindle.
pub(super) fn left_beside_the_cut(p: &Params, d: &Derived) -> f64 {
    let all = points(p, d, |diameter| p.steady_torque(diameter));
    all.iter().map(|point| point.most - point.torque).fold(f64::INFINITY, f64::min).max(0.0)
}

/// Torque (Nm) at the spindle with the tool tip at a diameter (mm): `F d_m / 2000 + M_f + J · 2π / 60 · dn/dt`. Source: turning spindle facts, 4.
fn torque_at(p: &Params, d: &Derived, diameter: f64) -> f64 {
    let inertia = p.main_spindle(d.stage.speed).load_at_spindle.inertia;
    p.steady_torque(diameter) + inertia * acceleration_at(p, d, diameter) * RPM
}

/// Acceleration of the spindle (r/min per second) at a diameter (mm) of a cut towards smaller ones, at most that of the ramp; 0 where the
/// speed does not change with the diameter.
fn acceleration_at(p: &Params, d: &Derived, diameter: f64) -> f64 {
    let n = d.speeds.at(p, diameter);
    let changes = p.speed_mode == SpeedMode::Surface && d.speeds.at(p, diameter * (1.0 + CLOSE)) < n;
    let cuts = p.cuts(1.0).filter(|cut| cut.length > 0.0);
    let slope = cuts.map(|cut| (cut.diameters.0 - cut.diameters.1) / cut.length).fold(0.0, f64::max);
    if changes { cutting::speed_gradient(n, p.feed, slope, diameter).min(d.acceleration.ramp) } else { 0.0 }
}
