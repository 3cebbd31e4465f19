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

/// The point of the cut with the greatest fraction of the short-time torque.
pub(super) fn worst_cut_point(p: &Params, d: &Derived) -> CutPoint {
    let motor = p.main_spindle(d.stage.speed).driving_motor();
    let at = |diameter: f64| {
        let speed = d.speeds.at(p, diameter);
        CutPoint { diameter, speed, torque: torque_at(p, d, diameter), most: motor.torque(speed) }
    };
    let all = d.limits.hardest(&d.cut, &d.speeds, motor.base).map(at);
    all.into_iter()
        .fold(all[0], |worst, next| if next.torque * worst.most > worst.torque * next.most { next } else { worst })
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
