//! Brake at a motor, which closes without current: its torque for a weight, and the turns and the time until the motor is at rest.

use super::load::coasting;
use crate::text::{Citation, Grade};

/// Torque of the brake over that of the weight. The source has 1.5 to 3 against wear, 1.5 behind a screw.
pub const SERVICE_FACTOR: f64 = 1.5;

/// Source of the service factor.
pub const SERVICE: Citation = Citation::new("Machine Design, Hold it steady: service factor 1.5 to 3", Grade::Inferred);

/// Time (s) from the end of its current until the brake has closed: 80 to 100 ms at motors of one maker, taken for those of all.
pub const CLOSING_TIME: f64 = 0.1;

/// Source of the closing time.
pub const CLOSING: Citation =
    Citation::new("Sigma-V user's manual, p.8-12: holding brakes close within 0.1 s", Grade::Inferred);

/// Least torque (Nm) of the brake for the torque of a weight (Nm) at the motor's shaft. Source: sizing facts 2.14.
pub fn torque(weight: f64) -> f64 {
    SERVICE_FACTOR * weight
}

/// Greatest turn (rad) of a shaft that a weight turns from rest until the brake has closed: `T t² / (2 (J_L + J_M))`, without friction;
/// torque of the weight in Nm, inertia of load and rotor in kg m². Source: sizing facts 2.14.
pub fn turn_until_closed(weight: f64, inertia: f64) -> f64 {
    0.5 * weight / inertia * CLOSING_TIME * CLOSING_TIME
}

/// The stop of a drive without current, whose brake closes after [`CLOSING_TIME`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BrakedStop {
    /// Time (s) to rest.
    pub seconds: f64,
    /// Time (s) of a linear ramp in which the drive turns as far.
    pub ramp: f64,
}

impl BrakedStop {
    /// From `speed` rad/s, with the inertia (kg m²) of all rotating parts: `torque` (Nm) slows them down from the start, `brake` (Nm) too when
    /// it has closed; 0 without a brake. With the speed ω1 that is left then, the way is `(ω + ω1) t1 / 2 + ω1 t2 / 2`, and the ramp twice
    /// the way over ω.
    pub fn new(inertia: f64, speed: f64, torque: f64, brake: f64) -> BrakedStop {
        let free = coasting(inertia, speed, torque);
        if brake <= 0.0 || free <= CLOSING_TIME {
            return BrakedStop { seconds: free, ramp: free };
        }
        let left = speed - torque / inertia * CLOSING_TIME;
        let braked = coasting(inertia, left, torque + brake);
        let share = left / speed;
        BrakedStop { seconds: CLOSING_TIME + braked, ramp: CLOSING_TIME * (1.0 + share) + braked * share }
    }
}
