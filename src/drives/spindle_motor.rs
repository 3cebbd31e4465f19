//! The motor of a main spindle behind a gear: torque constant up to base speed, power constant above.

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
