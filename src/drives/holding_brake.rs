//! Brake at the motor of a weight, which closes without current: its torque, and the turn of the motor until it has closed.

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
