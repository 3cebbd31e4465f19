//! Slides of the lathes at the edges of their operation: screws near their critical speed, loads that burn a dynamic brake.

use macroline::project::Project;
use macroline::view::Verdict;

use super::turning::project;
use crate::queries::{near, readout, value};

/// 0.8 of the first critical speed of a steel bar of 27.2 mm between a fixed bearing and a supporting one, 3 m apart (sizing facts 2.13).
#[test]
fn screw_near_its_critical_speed_fails() {
    let long = project("gsk-980tdc", &[("screw-diameter-z", "32"), ("screw-length-z", "3000"), ("rapid-z", "10000")]);
    let screw = readout(&long, "z-screw-speed");
    assert_eq!((screw.value, screw.verdict), (2000.0, Verdict::Fail));
    let by_hand =
        0.8 * 30.0 / std::f64::consts::PI * 3.9266 * 3.9266 * 0.0272 / 4.0 / 9.0 * (206e9_f64 / 7850.0).sqrt();
    assert!((screw.limit.unwrap().value() - by_hand).abs() < 1e-6 && (by_hand - 455.9).abs() < 0.05, "{by_hand}");
    let slower = long.with_entries(&screw.advice[0].entries).unwrap();
    assert_eq!(readout(&slower, "z-screw-speed").verdict, Verdict::Ok);
    // A longer lead turns it more slowly.
    let steep = long.with_entries(&[("lead-z", "40")]).unwrap();
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

/// The sheet of a control that has an acceleration instead of a time constant: as sizing and run assume it.
#[test]
fn sheet_acceleration_reaches_rapid_in_the_ramp() {
    let acceleration = |machine: &str, changes: &[(&'static str, &str)], axis: &str| {
        let project = Project::named(machine, Some("sinumerik-802d"), None).unwrap();
        let sets: Vec<_> = changes.iter().map(|(id, typed)| (*id, (*typed).to_owned())).collect();
        let sheets = project.with_entries(&sets).unwrap().prepared().sheets();
        let rows = sheets.iter().flat_map(|sheet| &sheet.rows);
        let row = rows.map(|row| &row.cells).find(|cells| cells[0] == "MD32300" && cells[2] == axis);
        row.expect("an acceleration")[3].parse::<f64>().unwrap()
    };
    let at = |rapid, clamp| {
        let changes = [("rapid-x", rapid), ("clamp-x", clamp), ("time-constant", "80")];
        acceleration("turning-spindle", &changes, "X")
    };
    // The largest velocity of the axis is that of rapid traverse and feed: a clamp of the feed has no parameter here.
    near(at("9000", "3000"), 9000.0 / 60.0 / 0.08 / 1000.0, 1e-3);
    near(at("3000", "6000"), 3000.0 / 60.0 / 0.08 / 1000.0, 1e-3);
    // The axes of the ribbon line reach the speed of the line in the ramp of the results, rapid traverse in a longer one. X is a modulo axis
    // in turns of 360 units, and the knob is locked.
    let line = Project::named("ribbon-line", Some("sinumerik-802d"), None).unwrap();
    let speed = value(&line, "line-speed");
    let of_line = |rapid| acceleration("ribbon-line", &[("rapid-x", rapid), ("time-constant-x", "80")], "X");
    near(of_line("9000"), speed / 60.0 / 0.08 / 360.0, 1e-3);
    near(of_line("20000"), of_line("9000"), 1e-9);
    // Without a time constant the servo lag of its position gain is the ramp.
    for (machine, constant) in [("turning-spindle", "time-constant"), ("ribbon-line", "time-constant-x")] {
        let step = [("rapid-x", "6000"), ("clamp-x", "6000"), (constant, "0")];
        assert!(acceleration(machine, &step, "X").is_finite(), "{machine}");
    }
}
