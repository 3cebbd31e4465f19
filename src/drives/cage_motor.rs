//! Standard cage induction motors on an inverter: poles, the highest speed that rotor and bearings bear, cooling by the fan on the shaft.

use crate::math;

/// Highest safe speeds (r/min) of motors with 2, 4 and 6 or more poles, by rated power in W: frames up to 112, up to 180, and larger ones.
const HIGHEST: [(f64, [f64; 3]); 3] = [
    (4_000.0, [5_200.0, 3_600.0, 2_400.0]),
    (22_000.0, [4_500.0, 2_700.0, 2_400.0]),
    (f64::INFINITY, [3_600.0, 2_300.0, 1_800.0]),
];

/// Rated speeds at 50 Hz above which a motor has 2 and 4 poles, r/min.
const POLES: [f64; 2] = [1_500.0, 1_000.0];

/// Highest safe speed in r/min of a standard cage motor whose maker gives none, by its rated power in W and its rated speed at 50 Hz in
/// r/min. Source: sizing facts 2.10; the frame follows from the power.
pub fn highest_speed(power: f64, rated_speed: f64) -> f64 {
    let poles = POLES.iter().take_while(|above| rated_speed <= **above).count();
    let of_frame = HIGHEST.iter().find(|(most, _)| power <= *most);
    of_frame.map_or(0.0, |(_, speeds)| speeds[poles.min(2)])
}

/// Frequency of the rated speeds of motors, Hz.
pub const RATED_FREQUENCY: f64 = 50.0;

/// Speed in r/min without load at a frequency in Hz, of a motor with this rated speed at 50 Hz: `60 f / p`, with the most pairs of poles
/// p that turn no slower than rated. Source: sizing facts 2.6.
pub fn no_load_speed(rated_speed: f64, frequency: f64) -> f64 {
    60.0 * frequency / (60.0 * RATED_FREQUENCY / rated_speed).floor().max(1.0)
}

/// Share (0 to 1) of its torque that a motor gives at `x` times its rated frequency: `1 / x` above it, where the inverter has no more voltage
/// and the power stays. Source: sizing facts 2.10.
pub fn field_weakening_share(x: f64) -> f64 {
    if x > 1.0 { 1.0 / x } else { 1.0 }
}

/// Share (0.5 to 1) of its continuous torque that a motor with a fan on its shaft gives at `x` times its rated speed or frequency:
/// `0.5 + 0.5 x`, because the fan turns with the rotor (IC 411). Source: sizing facts 2.10, from memory.
pub fn shaft_fan_torque_share(x: f64) -> f64 {
    math::clamp(0.5 + 0.5 * x, 0.5, 1.0)
}
