//! The error budget of a dot: its parts against the formulas, and what each adds to the whole.

use macroline::machines::form::Value;
use macroline::view::Verdict;
use proptest::prelude::*;

use super::{line, same};
use crate::queries::readout;

#[test]
fn parts_of_the_dot_error_follow_the_formulas() {
    // 6 N on 0.5 mm · 20 mm of 20 N/mm² strain it by 3 %: 0.3 mm of a pitch of 10 mm, 30 mm of a metre.
    let stretched = line(&[("tension-before", 6.0), ("tension-behind", 3.0)]);
    same("strain", readout(&stretched, "dot-strain").value, 0.3, 1e-9);
    same("shortening", readout(&stretched, "strain-per-metre").value, 30.0, 1e-9);
    // Half of 0.04 mm at each of two rollers.
    same("run-out", readout(&line(&[("roller-run-out", 0.04)]), "dot-run-out").value, 0.02 * 2f64.sqrt(), 1e-9);
    let fine = line(&[("encoder-resolution-x", 10_000.0), ("encoder-resolution-y", 10_000.0)]);
    let [x, y] = ["x-resolution", "y-resolution"].map(|id| readout(&fine, id).value / 2e3);
    same("encoders", readout(&fine, "dot-encoders").value, (x * x + y * y).sqrt(), 1e-9);
}

#[test]
fn backlash_counts_only_where_the_torque_changes_its_sign() {
    // The brake in front of the pull rollers loads their gear, the force of the heads that of the print roller.
    assert_eq!(readout(&line(&[("gear-backlash", 3.0)]), "dot-backlash").value, 0.0);
    // A web tension behind X that exceeds brake and friction loads the other tooth flank, and keeps its direction too.
    assert_eq!(readout(&line(&[("gear-backlash", 3.0), ("tension-behind", 200.0)]), "dot-backlash").value, 0.0);
    // Nothing loads the print roller: 3′ at its radius.
    let play = |diameter: f64| 3.0 / 60.0 * std::f64::consts::PI / 180.0 * diameter / 2.0;
    let idle = line(&[("gear-backlash", 3.0), ("printing-force", 0.0), ("friction-y", 0.0)]);
    same("idle", readout(&idle, "dot-backlash").value, play(114.6), 1e-9);
    // Each exact stop brakes the heavy print roller against its load.
    let mut stopping = line(&[("gear-backlash", 3.0), ("head-mass", 2.0)]);
    stopping.values.insert("path-mode".to_owned(), Value::Text("exact-stop".to_owned()));
    assert!(readout(&stopping, "dot-backlash").value >= play(114.6) - 1e-9);
}

#[test]
fn dot_error_is_judged_by_the_tolerance() {
    let slack = ("tension-before", 0.5);
    assert_eq!(readout(&line(&[slack]), "dot-error").verdict, Verdict::Ok);
    let worn = line(&[slack, ("roller-run-out", 0.2)]);
    let row = readout(&worn, "dot-error");
    assert_eq!(row.verdict, Verdict::Warn);
    let sets = row.advice[0].entries.clone();
    assert_eq!(sets[0].field, "roller-run-out");
    assert_eq!(readout(&worn.with_entries(&sets).unwrap(), "dot-error").verdict, Verdict::Ok);
}

proptest! {
    /// Lasting parts add up, varying ones as the root of the sum of squares.
    #[test]
    fn dot_error_is_the_sum_of_its_parts(
        run_out in 0.0..0.5, tension in 0.0..300.0, backlash in 0.0..30.0, pulses in 100.0f64..1e6, gain in 10.0..60.0,
    ) {
        let line = line(&[
            ("roller-run-out", run_out), ("tension-before", tension), ("gear-backlash", backlash),
            ("encoder-resolution-x", pulses.round()), ("encoder-resolution-y", pulses.round()), ("position-gain-y", gain),
        ]);
        let part = |id: &str| readout(&line, id).value;
        let varying = ["dot-encoders", "dot-run-out", "dot-backlash"].map(|id| part(id) * part(id)).iter().sum::<f64>().sqrt();
        same("total", part("dot-error"), part("register-error").abs() + part("dot-strain") + varying, 1e-9);
    }
}
