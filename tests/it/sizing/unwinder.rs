//! The unwinder's motor: braking over the ramp, the fan on its shaft, and a motor with other poles.

use std::f64::consts::PI;

use macroline::machines::driven::devices::BillItem;
use macroline::machines::form::Value;
use macroline::project::Project;
use macroline::project::size::{Candidate, Sizing, SizingRuns, size_without_envelope};
use macroline::text::catalog::sentence;
use macroline::view::{FieldEntry, Limit, Verdict};

use super::{line, same};
use crate::queries::readout;

/// The sizing without the envelope, of a short product.
fn sized(project: &Project) -> Sizing {
    let short = project.with_entries(&[("pitch-count", "10")]).unwrap();
    size_without_envelope(&short, &SizingRuns::new(&short, &short.written()))
}

fn unwinder(sizing: &Sizing) -> &[Candidate] {
    &sizing.axes.iter().find(|axis| axis.id == "unwinder").unwrap().candidates
}

/// Requirement of the brake resistor, as its row of the bill has it.
fn resistor(project: &Project) -> Option<String> {
    let rows = sized(project).bill.into_iter();
    rows.filter(|row| row.item == BillItem::Resistor).map(|row| row.asked).next()
}

/// Torque in Nm that web and friction of the first example ask of the motor: 20 N at 100.5 mm and 1 Nm, through a gear of 50 : 1 with 70 %.
const STEADY: f64 = (20.0 * 0.1005 / 2.0 + 1.0) / (50.0 * 0.7);

#[test]
fn stop_beyond_the_braking_power_of_the_inverter_fails() {
    let heavy = line(&[("unwinder-inertia", 400.0), ("unwinder-motor-brake", 5.0), ("unwinder-load", 1.146)]);
    let braking = readout(&heavy, "unwinder-braking-torque");
    // 0.04 kg m² from 1480 r/min in 2 s: 3.10 Nm, less 0.06 of web and friction; the reel adds a little.
    let own = 0.04 * 1480.0 * 2.0 * PI / 60.0 / 2.0 - STEADY;
    assert!((own - 3.042).abs() < 0.001 && (own..own + 0.02).contains(&braking.value), "{} {own}", braking.value);
    // 20 % of 5 Nm without a resistor.
    assert_eq!((braking.verdict, braking.limit), (Verdict::Fail, Some(Limit::AtMost(1.0))));
    // Others are notes about results that the longer ramp makes fail.
    let sets: Vec<_> = braking.advice.iter().map(|advice| &advice.entries).filter(|sets| !sets.is_empty()).collect();
    for set in &sets {
        let after = heavy.with_entries(set).unwrap();
        assert_eq!(readout(&after, "unwinder-braking-torque").verdict, Verdict::Ok, "{set:?}");
    }
    let ramp: f64 = sets[0][0].text.parse().unwrap();
    same("ramp", ramp, 2.0 * (braking.value + STEADY) / (1.0 + STEADY), 1e-3);
    assert_eq!(*sets[1], [FieldEntry::new("unwinder-motor-braking", "61")]);
    // The energy of the stop, half of torque, speed and time.
    let joules = 0.5 * braking.value * 1480.0 * PI / 30.0 * 2.0;
    let text = resistor(&heavy).unwrap();
    assert!((joules - 472.0).abs() < 2.0 && text.contains(&format!("{joules:.0} J")), "{joules}: {text}");
    let light = line(&[]);
    assert_eq!(readout(&light, "unwinder-braking-torque").verdict, Verdict::Ok);
    assert_eq!(resistor(&light), None);
}

#[test]
fn motor_with_a_shaft_fan_is_derated_at_low_frequency() {
    let slow = line(&[
        ("spindle-speed", 160.0),
        ("reduction-ratio", 7.0),
        ("speed-clamp", 200.0),
        ("reel-brake", 460.0),
        ("unwinder-load", 98.0),
        ("tensile-strength", 200.0),
        ("dwell", 0.2),
        ("override", 100.0),
    ]);
    let torque = readout(&slow, "unwinder-torque");
    same("torque", torque.value, (460.0 * 0.1005 / 2.0 + 1.0) / (7.0 * 0.7), 1e-9);
    let Some(Limit::AtMost(limit)) = torque.limit else { panic!("{torque:?}") };
    // At 5.4 Hz and below a fan on the shaft leaves about 55 % of 5 Nm.
    let now: f64 = 5.0 * (0.5 + 0.5 * 160.0 / 1480.0);
    assert!((now - 2.77).abs() < 0.01 && limit >= 2.5 && limit <= now + 1e-9, "{limit}");
    assert_eq!(torque.verdict, Verdict::Fail);
    let cooled = slow.with_entries(&torque.advice[0].entries).unwrap();
    let cooled = readout(&cooled, "unwinder-torque");
    assert_eq!((cooled.verdict, cooled.limit), (Verdict::Ok, Some(Limit::AtMost(5.0))));
}

#[test]
fn list_derates_motors_with_a_shaft_fan() {
    let slow = line(&[
        ("spindle-speed", 160.0),
        ("reduction-ratio", 7.0),
        ("speed-clamp", 200.0),
        ("reel-brake", 460.0),
        ("inverter-ramp", 60.0),
    ]);
    let mut cooled = slow.clone();
    cooled.values.insert("unwinder-forced-cooling".to_owned(), Value::Flag(true));
    let passing = |project: &Project| {
        let sizing = sized(project);
        let passing = unwinder(&sizing).iter().filter(|motor| motor.refusal.is_none());
        passing.map(|motor| motor.part.model.clone()).collect::<Vec<_>>()
    };
    let (own, forced) = (passing(&slow), passing(&cooled));
    assert!(!own.is_empty() && own.len() < forced.len(), "{own:?} {forced:?}");
    assert!(own.iter().all(|model| forced.contains(model)), "{own:?} {forced:?}");
}

#[test]
fn motor_with_other_poles_takes_its_frequency_into_the_form() {
    let heavy = line(&[
        ("unwinder-inertia", 1500.0),
        ("unwinder-torque-rated", 20.0),
        ("unwinder-load", 0.286),
        ("unwinder-motor-brake", 20.0),
        ("unwinder-motor-braking", 100.0),
    ]);
    let sizing = sized(&heavy);
    let two_poles = unwinder(&sizing)
        .iter()
        .find(|motor| motor.part.model == "MT3 100 LB/2")
        .or_else(|| unwinder(&sizing).iter().find(|motor| motor.part.model.ends_with("/2") && motor.refusal.is_none()));
    let motor = two_poles.unwrap();
    let entry = |id: &str| motor.entries.iter().find(|entry| entry.field == id).unwrap().text.parse::<f64>().unwrap();
    // 3000 r/min at 50 Hz: the form's 1500 r/min without load need 25 Hz, and the slip of the name plate stays.
    let macroline::drives::parts::Ratings::Induction(of) = motor.part.ratings else { panic!("{motor:?}") };
    assert_eq!(entry("frequency-at-10v"), 25.0);
    same("rated", entry("rated-load-speed"), 1500.0 - (3000.0 - of.rated_speed.unwrap()), 1e-9);
    let taken = heavy.with_entries(&motor.entries).unwrap();
    assert_eq!(readout(&taken, "frequency").value, 25.0 * 1200.0 / 1480.0);
    assert_eq!(readout(&taken, "unwinder-torque").verdict, Verdict::Ok);
    let again = |project: &Project| {
        let sizing = sized(project);
        let same = unwinder(&sizing).iter().find(|other| other.part == motor.part).unwrap().clone();
        same.refusal.map(|refusal| sentence(&refusal.message))
    };
    assert_eq!(again(&taken), None);
    // The name alone, at the frequency of four poles: the line would run twice as fast.
    let named = heavy.with_entries(&[motor.entries[0].clone()]).unwrap();
    assert!(again(&named).is_some_and(|text| text.contains("3000 r/min")), "{:?}", again(&named));
    let four = unwinder(&sizing).iter().find(|motor| motor.part.model.ends_with("/4")).unwrap();
    let frequency = four.entries.iter().find(|entry| entry.field == "frequency-at-10v").unwrap();
    assert_eq!(frequency.text, "50");
}

#[test]
fn no_load_speed_below_rated_speed_is_an_error() {
    let errors = |no_load: f64| {
        let design = line(&[("no-load-speed", no_load), ("rated-load-speed", 1430.0)]).design();
        design.diagnostics.into_iter().filter(|found| found.field == Some("no-load-speed")).count()
    };
    assert_eq!([1000.0, 1429.0, 1430.0, 1500.0].map(errors), [1, 1, 0, 0]);
}
