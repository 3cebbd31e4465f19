//! The trial of many motors on one motion: a segment that is left out is never decisive.

use macroline::drives::load::{Load, Regeneration};
use macroline::drives::motor_trial::MotorTrial;
use macroline::drives::servo::Servo;
use macroline::drives::shaft_motion::{CutSpan, Motion, SpeedSegment, Strikes};
use proptest::collection::vec;
use proptest::prelude::*;

/// A motion from speeds (rad/s) and the times (s) between them; every third is a steady one.
fn segments(points: &[(f64, f64)]) -> Vec<SpeedSegment> {
    let (mut t, mut from) = (0.0, 0.0);
    let mut all = Vec::new();
    for (at, &(speed, seconds)) in points.iter().enumerate() {
        let to = if at % 3 == 1 { from } else { speed };
        all.push(SpeedSegment { t, seconds, from, to });
        (t, from) = (t + seconds, to);
    }
    all
}

fn servo(rotor: f64, rated_speed: f64) -> Servo {
    Servo { rated: 1.0, stall: 1.2, peak: 3.5, rated_speed, top_speed: 6000.0, rotor }
}

/// The work ends where the acceleration begins, but for the rounding of their times.
#[test]
fn acceleration_after_the_work_does_not_count_with_it() {
    let steady = SpeedSegment { t: 0.0, seconds: 1.0, from: 10.0, to: 10.0 };
    let rise = SpeedSegment { t: 1.0, seconds: 0.1, from: 10.0, to: 110.0 };
    let peak = |end: f64| {
        let motion = Motion::new([steady, rise], Load { inertia: 1e-3, torque: 0.5, efficiency: 1.0 }, 0.0);
        motion.with_loaded_spans(vec![(0.0, end)]).motor_load(0.0).peak.torque
    };
    let [exact, rounded] = [1.0, 1.0 + f64::EPSILON].map(peak);
    assert_eq!((exact, rounded), (1.0, 1.0));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn trial_of_a_motor_gives_the_figures_of_the_whole_motion(
        points in vec((prop_oneof![Just(0.0), -300.0..300.0, Just(120.0)], 0.01..3.0_f64), 1..60),
        (inertia, torque, efficiency) in (0.0..3e-3_f64, -0.3..2.0_f64, 0.5..1.0_f64),
        (weight, pause, peak) in (prop_oneof![Just(0.0), -1.0..1.0], 0.0..30.0_f64, prop_oneof![Just(0.0), 0.0..4.0]),
        cuts in prop::option::of((0.0..0.5_f64, 0.5..1.0_f64, 0.0..3.0_f64)),
        rotors in vec(1e-6..1e-2_f64, 1..5),
        rated_speed in 200.0..3000.0_f64,
    ) {
        let all = segments(&points);
        let end = all.last().map_or(0.0, |last| last.t + last.seconds);
        let motion = Motion::new(all, Load { inertia, torque, efficiency }, 0.2)
            .with_weight(weight)
            .with_strikes(Strikes::new(peak, 0.5 * peak))
            .with_pause(pause);
        let motion = match cuts {
            Some((from, to, torque)) => motion.with_cuts(vec![CutSpan { begin: from * end, end: to * end, torque }]),
            None => motion.with_loaded_spans(vec![(0.2 * end, 0.7 * end)]),
        };
        let trial = MotorTrial::new(&motion);
        for rotor in rotors {
            let load = motion.motor_load(rotor);
            prop_assert_eq!(trial.peak(rotor), load.peak);
            prop_assert_eq!(trial.speed(), load.speed);
            prop_assert!((trial.effective(rotor) - load.effective).abs() <= 1e-9 * load.effective);
            let motor = servo(rotor, rated_speed);
            prop_assert_eq!(trial.worst_point(&motor), motion.worst_point(&motor));
            for capacitor in [0.0, 2.0] {
                let back = Regeneration { efficiency: 0.9, capacitor };
                prop_assert_eq!(trial.to_resistor(rotor, &back), motion.to_resistor(rotor, &back));
            }
        }
    }
}

/// A thousand equal passes, each a little slower than the one before: one of them may decide.
#[test]
fn trial_looks_at_few_segments_of_many_alike() {
    let passes: Vec<(f64, f64)> =
        (0..1000).flat_map(|at| [(200.0 - 0.1 * f64::from(at), 0.1), (0.0, 1.0), (0.0, 0.1)]).collect();
    let motion = Motion::new(segments(&passes), Load { inertia: 1e-3, torque: 0.3, efficiency: 0.9 }, 0.0);
    let trial = MotorTrial::new(&motion);
    assert!(trial.hardest_segments() < 20, "{}", trial.hardest_segments());
    assert_eq!(trial.peak(1e-4), motion.motor_load(1e-4).peak);
}
