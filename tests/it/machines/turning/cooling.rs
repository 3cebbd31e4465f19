//! Cooling of the turning spindle's motor: a fan on its shaft leaves less torque at low speed, forced cooling all of it.

use macroline::drives::spindle_motor::MotorCurve;
use macroline::machines::driven::devices::BillItem;
use macroline::project::Project;
use macroline::text::catalog::sentence;
use macroline::view::{FieldEntry, Readout, Verdict};

use super::project;
use crate::queries::{near, sized_without_envelope, value};

/// Ø 400, 40 m/min, 700 N in a stage of 300 r/min at 10 V: the motor turns at about a tenth of its base speed.
const SLOW: [(&str, &str); 10] = [
    ("path", "turning"),
    ("stock-diameter", "400"),
    ("finished-diameter", "390"),
    ("depth", "2"),
    ("cutting-speed", "40"),
    ("cutting-force", "700"),
    ("stage-1", "300"),
    ("stage-2", "0"),
    ("start-x", "500"),
    ("override", "100"),
];

fn slow(control: &str, changes: &[(&str, &str)]) -> Project {
    project(control, &[&SLOW, changes].concat())
}

fn torque(project: &Project) -> Readout {
    project.design().readouts.into_iter().find(|row| row.id == "torque").unwrap()
}

#[test]
fn shaft_fan_derates_the_spindle_motor_at_low_speed() {
    for control in ["gsk-980tdc", "sinumerik-802d", "knd-k2000t", "mitsubishi-e60"] {
        let own = slow(control, &[]);
        let row = torque(&own);
        assert_eq!(row.verdict, Verdict::Fail, "{control}");
        // 9549.3 · 7.5 · 0.8 / 300 Nm at the spindle, and the motor at n · 1500 / 300 of its base speed of 1500 r/min.
        let share = 0.5 + 0.5 * value(&own, "speed-largest") / 300.0;
        near(row.limit.unwrap().value(), 190.986 * share, 0.01);
        near(value(&own, "torque-available"), 190.986 * share, 0.01);
        let advice = sentence(&row.advice[0].message);
        let motor = 5.0 * value(&own, "speed-largest");
        assert!(
            (150.0..165.0).contains(&motor) && advice.contains(&format!("{motor:.0} r/min")),
            "{control}: {advice}"
        );
        assert_eq!(row.advice[0].entries, [FieldEntry::new("motor-forced-cooling", "true")], "{control}");
        let forced = own.with_entries(&row.advice[0].entries).unwrap();
        let row = torque(&forced);
        // At the feed of the form it holds; at 150 % of it on some controls not.
        assert!(row.verdict < Verdict::Fail, "{control}");
        near(row.limit.unwrap().value(), 190.986, 0.01);
    }
}

/// The lower stage turns the motor three times as fast, in which it has more torque by the gear and by its fan.
#[test]
fn stage_with_a_faster_motor_is_offered_beside_the_fan() {
    let own = slow("gsk-980tdc", &[("stage-2", "100"), ("gear", "1")]);
    let row = torque(&own);
    assert_eq!(row.advice[0].entries, [FieldEntry::new("motor-forced-cooling", "true")]);
    assert_eq!(row.advice[1].entries, [FieldEntry::new("gear", "2")]);
    assert_eq!(torque(&own.with_entries(&row.advice[1].entries).unwrap()).verdict, Verdict::Ok);
}

#[test]
fn forced_cooling_is_not_offered_where_the_motor_is_too_weak() {
    let weak = slow("gsk-980tdc", &[("cutting-force", "1500")]);
    let row = torque(&weak);
    assert_eq!(row.verdict, Verdict::Fail);
    assert!(
        row.advice.iter().all(|advice| advice.entries.iter().all(|set| set.field != "motor-forced-cooling")),
        "{row:?}"
    );
}

/// The knob of the 980TDc ends at 50 %: the same torque at half the speed.
#[test]
fn shaft_fan_at_the_slow_end_of_the_knob_is_a_warning() {
    let at = |force: &'static str, control| torque(&slow(control, &[("cutting-force", force)]));
    let row = at("510", "gsk-980tdc");
    assert_eq!(row.verdict, Verdict::Warn, "{row:?}");
    assert_eq!(row.advice[0].entries, [FieldEntry::new("motor-forced-cooling", "true")]);
    assert!(sentence(&row.advice[0].message).contains("50 %"), "{row:?}");
    // 450 N with the feed override at 150 %: 91.6 of 100.6 Nm.
    assert_eq!(at("300", "gsk-980tdc").verdict, Verdict::Ok);
}

#[test]
fn fan_of_the_spindle_motor_is_in_bill_and_terminals() {
    for (forced, count) in [("true", 1), ("false", 0)] {
        let sizing = sized_without_envelope(&project("gsk-980tdc", &[("motor-forced-cooling", forced)]));
        assert_eq!(sizing.bill.iter().filter(|row| row.item == BillItem::Fan).count(), count);
        let wires = sizing.terminals.iter().filter(|row| row.to.item == BillItem::Fan).count();
        assert_eq!(wires, 2 * count);
    }
}

#[test]
fn list_derates_spindle_motors_with_a_shaft_fan() {
    let passing = |forced| {
        let sizing =
            sized_without_envelope(&slow("gsk-980tdc", &[("motor-forced-cooling", forced), ("cutting-force", "300")]));
        let axis = sizing.axes.iter().find(|axis| axis.id == "spindle").unwrap();
        let passing = axis.candidates.iter().filter(|motor| motor.refusal.is_none());
        passing.map(|motor| motor.part.model.clone()).collect::<Vec<_>>()
    };
    let (own, forced) = (passing("false"), passing("true"));
    assert!(!own.is_empty() && own.len() < forced.len(), "{own:?} {forced:?}");
    assert!(own.iter().all(|model| forced.contains(model)), "{own:?} {forced:?}");
}

#[test]
fn project_without_the_entry_has_a_motor_with_a_shaft_fan() {
    let text = slow("gsk-980tdc", &[]).to_json().replace("    \"motor-forced-cooling\": false,\n", "");
    assert!(!text.contains("motor-forced-cooling"), "{text}");
    let opened = Project::from_json(&text);
    assert!(opened.diagnostics.is_empty(), "{:?}", opened.diagnostics);
    assert_eq!(torque(&opened.project.unwrap()).verdict, Verdict::Fail);
}

/// `∫ (T / M(n))² dn` over a ramp from standstill to twice the base speed, by 100 000 steps.
#[test]
fn mean_square_counts_the_shaft_fan() {
    let curve = MotorCurve { power: 6.0, base: 1500.0, has_shaft_fan: true };
    for (from, to) in [(0.0, 3000.0), (0.0, 1500.0), (300.0, 900.0), (1800.0, 2500.0), (200.0, 200.0)] {
        let steps = 100_000;
        let step = (to - from) / f64::from(steps);
        let at = |at: u32| {
            let share = 20.0 / curve.torque(from + step * (f64::from(at) + 0.5));
            share * share
        };
        let mean = (0..steps).map(at).sum::<f64>() / f64::from(steps);
        near(curve.mean_square(20.0, (from, to)), mean, 1e-8);
    }
    assert_eq!(curve.with_shaft_fan(false).torque(150.0), curve.base_torque());
    near(curve.torque(150.0), 0.55 * curve.base_torque(), 1e-9);
}
