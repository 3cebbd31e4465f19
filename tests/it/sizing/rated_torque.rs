//! The continuous torque of a motor at its speed, in the form and in an electronic cam, and the encoder of each axis.

use macroline::project::size::{SizingRuns, size_without_envelope};
use macroline::text::catalog::sentence;
use macroline::view::{FieldEntry, Limit, Verdict};

use super::{line, same};
use crate::queries::readout;

#[test]
fn effective_torque_is_limited_by_the_curve_at_speed() {
    let warm = line(&[("dwell", 0.7), ("gear-y", 100.0), ("friction-y", 209.0)]);
    let effective = readout(&warm, "y-effective-torque");
    let Some(Limit::AtMost(limit)) = effective.limit else { panic!("{effective:?}") };
    assert!((effective.value - 2.185).abs() < 0.001 && effective.verdict == Verdict::Fail, "{effective:?}");
    // HC53: 2.94 Nm at rest, 1.59 at 3000 r/min. With the knob at its highest position it turns at 2596 r/min, a little less in the mean.
    let at = |speed: f64| 0.8 * (2.94 - (2.94 - 1.59) * speed / 3000.0);
    assert!(limit > at(2596.0) && limit < at(2300.0), "{limit}");
    assert!(sentence(&effective.advice[0].message).contains("at a mean speed of"));
    // The same figures without a fall of the curve pass, as they did.
    let flat = line(&[("dwell", 0.7), ("gear-y", 100.0), ("friction-y", 209.0), ("motor-rated-torque-y", 2.94)]);
    assert_eq!(readout(&flat, "y-effective-torque").verdict, Verdict::Ok);
    // The list refuses the motor with these figures for the same reason.
    let sizing = size_without_envelope(&warm, &SizingRuns::new(&warm, &warm.written()));
    let print = sizing.axes.iter().find(|axis| axis.id == "y").unwrap();
    let motor = print.candidates.iter().find(|motor| motor.part.model == "HC53").unwrap();
    let refusal = sentence(&motor.refusal.as_ref().unwrap().message);
    assert!(refusal.starts_with("Too hot"), "{refusal}");
    assert!(motor.entries.contains(&FieldEntry::new("motor-rated-torque-y", "1.59")), "{:?}", motor.entries);
}

#[test]
fn cam_is_limited_by_the_power_above_rated_speed() {
    let mut fast = line(&[
        ("heads", 30.0),
        ("motor-rated-y", 1000.0),
        ("motor-max-y", 6000.0),
        ("gear-y", 150.0),
        ("speed-clamp", 1200.0),
    ]);
    fast.values.insert("cam-law".to_owned(), macroline::machines::form::Value::Text("modified-sine".to_owned()));
    let value = |id: &str| readout(&fast, id).value;
    let peak = readout(&fast, "cam-peak-torque");
    let Some(Limit::AtMost(limit)) = peak.limit else { panic!("{peak:?}") };
    // 0.8 of 8.82 Nm up to 1000 r/min, the same power above.
    same("limit", limit, 0.8 * 8.82 * 1000.0 / value("cam-motor-speed"), 1e-9);
    assert!((value("cam-motor-speed") - 4546.5).abs() < 0.1 && (limit - 1.552).abs() < 0.001, "{limit}");
    assert_eq!(peak.verdict, Verdict::Fail);
    // At the reported speed the torque, which grows with the square of the speed, equals that limit.
    let share = value("cam-speed-by-peak") / value("line-speed");
    let steady = value("y-load-torque");
    let torque = (peak.value - steady) * share * share + steady;
    same("speed by peak", torque, limit / share, 1e-6);
    assert!(share < 1.0);
}

#[test]
fn each_axis_has_the_encoder_of_its_motor() {
    let project = line(&[]);
    let sizing = size_without_envelope(&project, &SizingRuns::new(&project, &project.written()));
    let pull = sizing.axes.iter().find(|axis| axis.id == "x").unwrap();
    let motor = pull.candidates.iter().find(|motor| motor.part.model == "HG-KN43J").unwrap();
    assert!(motor.entries.contains(&FieldEntry::new("encoder-resolution-x", "131072")), "{:?}", motor.entries);
    let taken = project.with_entries(&motor.entries).unwrap();
    // 131 072 counts per turn of X, 100 000 of the print roller.
    same("X", readout(&taken, "x-resolution").value * 131_072.0, readout(&project, "x-resolution").value * 1e5, 1e-9);
    same("Y", readout(&taken, "y-resolution").value, readout(&project, "y-resolution").value, 1e-12);
}
