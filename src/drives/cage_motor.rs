//! Standard cage induction motors at an inverter: the highest speed that rotor and bearings bear.

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
