//! Motor of a main spindle with a gear: constant torque up to base speed, constant power above.

use super::cage_motor::shaft_fan_torque_share;
use crate::math::{self, RPM};

/// Newton metres times r/min per kilowatt: `60 000 / 2π`.
const TORQUE: f64 = 9_549.296_585_513_72;

/// Share of the power below which a load counts as small.
const SMALL: f64 = 1e-3;

/// A motor on its gear: the data of both from which a [`MotorCurve`] at the spindle follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearedMotor {
    /// Power of the motor, kW.
    pub power: f64,
    /// Base speed of the motor, r/min.
    pub base: f64,
    /// Top speed of the motor, r/min.
    pub top: f64,
    /// Speed of the spindle at the top speed of the motor, r/min.
    pub spindle_top: f64,
    /// Efficiency of the gear, 0 to 1.
    pub efficiency: f64,
}

/// Torque and power at the spindle in one gear stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotorCurve {
    /// Power at the spindle above base speed, kW.
    pub power: f64,
    /// Spindle speed up to which the torque is constant, r/min.
    pub base: f64,
    /// Whether a fan on the motor's shaft cools it: a continuous torque that falls with the speed below base speed.
    pub has_shaft_fan: bool,
}

impl MotorCurve {
    /// Curve of a motor through its gear: `P = P_m η`, `n_b = n_bm · n_top / n_mtop`, with the speeds of motor and spindle at the top speed
    /// of the motor. With a base speed above the top speed the torque is constant up to the top speed, and the motor never reaches its power.
    ///
    /// Source: `docs/reference/turning-spindle.md` section 4.
    pub fn through_gear(motor: GearedMotor) -> MotorCurve {
        let GearedMotor { power, base, top, spindle_top, efficiency } = motor;
        MotorCurve { power: power * efficiency, base: spindle_top * base / top, has_shaft_fan: false }
    }

    /// Curve of a motor of `power` kW with a rated torque in Nm: base speed `n_b = 9549.3 P / M`.
    pub fn with_torque(power: f64, torque: f64) -> MotorCurve {
        MotorCurve { power, base: TORQUE * power / torque, has_shaft_fan: false }
    }

    /// Curve of a motor of `power` kW with base speed `base` r/min at its own shaft.
    pub fn at_shaft(power: f64, base: f64) -> MotorCurve {
        MotorCurve { power, base, has_shaft_fan: false }
    }

    /// The curve with a fan on the motor's shaft (IC 411), or with forced cooling (IC 416).
    pub fn with_shaft_fan(&self, has_shaft_fan: bool) -> MotorCurve {
        MotorCurve { has_shaft_fan, ..*self }
    }

    /// Torque in Nm at base speed, without the loss of a shaft fan: `M_b = 9549.3 P / n_b`.
    pub fn base_torque(&self) -> f64 {
        TORQUE * self.power / self.base
    }

    /// Torque in Nm at a spindle speed in r/min: `M = 9549.3 P / max(n, n_b)`, with a fan on the motor's shaft `M · (0.5 + 0.5 n / n_b)`
    /// below base speed. Source: `docs/reference/turning-spindle.md` section 4.
    pub fn torque(&self, rpm: f64) -> f64 {
        let speed = rpm.abs();
        let cooled = if self.has_shaft_fan { shaft_fan_torque_share(speed / self.base) } else { 1.0 };
        cooled * TORQUE * self.power / speed.max(self.base)
    }

    /// Mean square of a torque (Nm) as a fraction of the curve, while the speed changes linearly from one value (r/min) to another:
    /// `mean of (T / M(n))²`, with `M` inversely proportional to `max(n, n_b)`; with a fan on the motor's shaft
    /// `∫ (T / M(n))² dn = (T / M_b)² · 4 (n_2 - n_1) / ((1 + n_1 / n_b) (1 + n_2 / n_b))` below base speed.
    ///
    /// Source: `docs/reference/turning-spindle.md` section 4.
    pub fn mean_square(&self, torque: f64, (from, to): (f64, f64)) -> f64 {
        let (low, high) = (from.abs().min(to.abs()), from.abs().max(to.abs()));
        let share = torque / self.base_torque();
        let bend = self.base.max(low).min(high);
        if high - low <= SMALL * high {
            let share = torque / self.torque(high);
            return share * share;
        }
        let cube = |speed: f64| speed * speed * speed;
        let cooled = if self.has_shaft_fan { 4.0 / ((1.0 + low / self.base) * (1.0 + bend / self.base)) } else { 1.0 };
        let mean = (cooled * (bend - low) + (cube(high) - cube(bend)) / (3.0 * self.base * self.base)) / (high - low);
        share * share * mean
    }

    /// The curve with a share of its torque at every speed.
    pub fn share(&self, share: f64) -> MotorCurve {
        MotorCurve { power: self.power * share, ..*self }
    }

    /// Run-up time (s) from standstill to a speed in r/min with full torque, for an inertia in kg m² against a steady torque `load` in Nm
    /// (negative if it helps, as in braking): `J ω_b / (M - T)` up to base speed, above it `J ∫ ω / (P - T ω) dω` =
    /// `J / T² · (P ln((P - T ω_b) / (P - T ω)) - T (ω - ω_b))`. Infinite if the load uses the full torque.
    ///
    /// Source: `docs/reference/turning-spindle.md` section 5.
    pub fn seconds_to(&self, rpm: f64, inertia: f64, load: f64) -> f64 {
        let (speed, power) = (rpm.abs() * RPM, 1000.0 * self.power);
        let base = (self.base * RPM).min(speed);
        let (over, left) = (self.base_torque() - load, power - load * speed);
        if speed == 0.0 {
            return 0.0;
        }
        if over <= 0.0 || left <= 0.0 {
            return f64::INFINITY;
        }
        let part = load / power;
        let above = if (part * speed).abs() < SMALL {
            // First terms of the series in T; the logarithm would lose digits.
            let term = |power: f64| (math::pow(speed, power) - math::pow(base, power)) / power;
            (term(2.0) + part * term(3.0) + part * part * term(4.0)) / power
        } else {
            (math::ln((1.0 - part * base) / (1.0 - part * speed)) / part - (speed - base)) / load
        };
        inertia * (base / over + above)
    }
}

/// Power in kW of a torque in Nm at a speed in r/min: `P = M n / 9549.3`.
pub fn power(torque: f64, rpm: f64) -> f64 {
    torque * rpm.abs() / TORQUE
}

/// Torque in Nm for accelerating an inertia in kg·m² to a speed in r/min by a linear ramp of `tau` s: `M = J · 2π n / (60 τ)`, without a ramp
/// by the position loop of gain `gain` 1/s, `J · 2π n / 60 · K`. The lag of the servo takes a little off on a short ramp; it is left out, as in
/// the run.
///
/// Source: `docs/reference/turning-spindle.md` section 5, run-up by a ramp.
pub fn run_up_torque(inertia: f64, rpm: f64, tau: f64, gain: f64) -> f64 {
    inertia * rpm.abs() * RPM * if tau > 0.0 { 1.0 / tau } else { gain }
}

/// Shortest ramp in s with a run-up torque of at most `torque` Nm.
pub fn shortest_ramp(inertia: f64, rpm: f64, torque: f64) -> f64 {
    inertia * rpm.abs() * RPM / torque
}
