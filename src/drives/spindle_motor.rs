//! The motor of a main spindle behind a gear: torque constant up to base speed, power constant above.

use crate::math::{self, RPM};

/// Newton metres times r/min per kilowatt: `60 000 / 2π`.
const TORQUE: f64 = 9_549.296_585_513_72;

/// Torque and power at the spindle in one gear stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotorCurve {
    /// Power at the spindle above base speed, kW.
    pub power: f64,
    /// Spindle speed up to which the torque is constant, r/min.
    pub base: f64,
}

impl MotorCurve {
    /// A motor of `power` kW with base speed `base` r/min, whose top speed `top` r/min turns the spindle at `stage` r/min, by an efficiency
    /// of the gear: `P = P_m η`, `n_b = n_bm · stage / top`.
    ///
    /// Source: `reference/turning-spindle.md` 4.
    pub fn new(power: f64, efficiency: f64, (base, top): (f64, f64), stage: f64) -> MotorCurve {
        MotorCurve { power: power * efficiency, base: stage * (base / top).min(1.0) }
    }

    /// Torque in Nm at a spindle speed in r/min: `M = 9549.3 P / max(n, n_b)`.
    pub fn torque(&self, rpm: f64) -> f64 {
        TORQUE * self.power / rpm.abs().max(self.base)
    }
}

/// Power in kW of a torque in Nm at a speed in r/min: `P = M n / 9549.3`.
pub fn power(torque: f64, rpm: f64) -> f64 {
    torque * rpm.abs() / TORQUE
}

/// Torque in Nm that accelerates an inertia in kg·m² to a speed in r/min by a ramp of `tau` s behind a position loop of gain `gain` 1/s:
/// `M = J · 2π n / 60 · (1 - e^(-K τ)) / τ`, without a ramp `J · 2π n / 60 · K`.
///
/// Source: `reference/operation.md` F, run-up by a ramp; the gain by the servo lag of first order.
pub fn run_up(inertia: f64, rpm: f64, tau: f64, gain: f64) -> f64 {
    inertia * rpm.abs() * RPM * if tau > 0.0 { -math::expm1(-gain * tau) / tau } else { gain }
}

/// The shortest ramp in s whose run-up takes a torque at most; 0 where none is needed.
pub fn shortest_ramp(inertia: f64, rpm: f64, gain: f64, torque: f64) -> f64 {
    let plain = inertia * rpm.abs() * RPM / torque;
    if plain * gain <= 1.0 {
        return 0.0;
    }
    // From above: each round is nearer to τ = plain · (1 - e^(-K τ)), and none is below it.
    (0..64).fold(plain, |tau, _| plain * -math::expm1(-gain * tau))
}
