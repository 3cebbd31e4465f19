//! Slides of the lathes at the edges of their operation: screws near their critical speed, loads that burn a dynamic brake.

use macroline::view::Verdict;

use super::turning::project;
use crate::asked::readout;

/// 0.8 of the first critical speed of a steel bar of 27.2 mm between a fixed bearing and a supporting one, 3 m apart (sizing facts 2.13).
#[test]
fn screw_near_its_critical_speed_fails() {
    let long = project("gsk-980tdc", &[("screw-diameter-z", "32"), ("screw-length-z", "3000"), ("rapid-z", "10000")]);
    let screw = readout(&long, "z-screw-speed");
    assert_eq!((screw.value, screw.verdict), (2000.0, Verdict::Fail));
    let by_hand =
        0.8 * 30.0 / std::f64::consts::PI * 3.9266 * 3.9266 * 0.0272 / 4.0 / 9.0 * (206e9_f64 / 7850.0).sqrt();
    assert!((screw.limit.unwrap().value() - by_hand).abs() < 1e-6 && (by_hand - 455.9).abs() < 0.05, "{by_hand}");
    let slower = long.with_entries(&screw.advice[0].sets).unwrap();
    assert_eq!(readout(&slower, "z-screw-speed").verdict, Verdict::Ok);
    // A longer lead turns it more slowly.
    let steep = long.with_entries(&[("lead-z", "40".to_owned())]).unwrap();
    assert_eq!(readout(&steep, "z-screw-speed").verdict, Verdict::Ok);
}

#[test]
fn load_that_burns_a_dynamic_brake_fails() {
    let at = |rotor: &'static str| readout(&project("gsk-980tdc", &[("motor-rotor-z", rotor)]), "z-inertia-ratio");
    // 21.3 kg cm² of the slide.
    for (rotor, verdict) in [("11.6", Verdict::Ok), ("2", Verdict::Warn), ("0.5", Verdict::Fail)] {
        assert_eq!(at(rotor).verdict, verdict, "{} : 1", at(rotor).value);
    }
}
