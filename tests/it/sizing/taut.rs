//! A ribbon pulled taut, and a nip at start, run and stop: grip of the nip and torque of X.

use std::f64::consts::PI;

use macroline::project::parts;
use macroline::project::size::{EnvelopeRow, OperatingEvent, Sizing, SizingRuns, size, size_without_envelope};
use macroline::text::catalog::sentence;
use macroline::view::{FieldEntry, Limit, Verdict};

use super::{line, same};
use crate::queries::readout;

/// A dwell too short for the unwinder's ramp: with the knob at its highest position X is 119.9 mm ahead.
const SHORT_DWELL: (&str, f64) = ("dwell", 0.1);

/// The pinch force of the form, with which the nip slips first.
const WEAK_NIP: (&str, f64) = ("pinch-force", 100.0);

/// Tension in N of the ribbon with that dwell and a modulus in N/mm²: `T1 + E A s / L`, by hand.
fn tautest(modulus: f64) -> f64 {
    // 1480 r/min with a roller of 100.5 mm on a gear of 50 : 1, mm/s; FIN takes 0.05 s, the ramp 2 s, the time constant 0.1 s, the lag 1/33
    // s.
    let speed = PI * 100.5 / 50.0 * 1480.0 / 60.0;
    let ahead = -speed * (0.1 + 0.05 - 1.0 + 0.1 / 2.0 + 1.0 / 33.0);
    15.0 + modulus * 20.0 * 0.5 * ahead / 2000.0
}

#[test]
fn taut_ribbon_beyond_the_grip_fails_the_nip() {
    let project = line(&[SHORT_DWELL, WEAK_NIP, ("youngs-modulus", 80.0), ("loop-capacity", 600.0)]);
    let (tension, nip) = (readout(&project, "tension"), readout(&project, "nip-use"));
    same("tension", tension.value, tautest(80.0), 1e-9);
    assert!((tension.value - 62.96).abs() < 0.01 && tension.limit == Some(Limit::AtMost(20.0)), "{tension:?}");
    // The tension switch opens at half of what the nip holds.
    assert_eq!(tension.verdict, Verdict::Fail);
    // 63 N at a nip that holds 0.4 · 100 N.
    same("nip", nip.value, 100.0 * tautest(80.0) / 40.0, 1e-9);
    assert!((nip.value - 157.4).abs() < 0.05, "{}", nip.value);
    assert_eq!((nip.verdict, nip.limit), (Verdict::Fail, Some(Limit::AtMost(50.0))));
    let sets: Vec<_> = nip.advice.iter().map(|advice| advice.entries.clone()).collect();
    // 0.87 s of dwell miss no ribbon; more force would stretch it further, and comes second.
    assert_eq!(sets[0], [FieldEntry::new("wait", "dwell"), FieldEntry::new("dwell", "0.87")]);
    assert_eq!(sets[1], [FieldEntry::new("pinch-force", "314.8")]);
    for set in sets {
        assert_eq!(readout(&project.with_entries(&set).unwrap(), "nip-use").verdict, Verdict::Ok, "{set:?}");
    }
}

#[test]
fn taut_ribbon_drives_the_gear_unit_of_the_unwinder() {
    let peak = |changes: &[(&'static str, f64)]| {
        let project =
            line(&[&[("loop-capacity", 600.0), ("reel-brake", 4.0), ("unwinder-friction", 0.0)], changes].concat());
        let unwinder = size(&project, &project.written()).axes.into_iter().find(|axis| axis.id == "unwinder").unwrap();
        unwinder.gear.expect("a gear of 50 : 1").duty.peak
    };
    // At the press roller of 100.5 mm, against the 4 N of the reel's brake; more than the run-up takes.
    let pulled = (tautest(2000.0) - 4.0) * 0.100_5 / 2.0;
    assert!(pulled > 2.0 * peak(&[("youngs-modulus", 2000.0)]));
    same("taut", peak(&[SHORT_DWELL, ("youngs-modulus", 2000.0)]), pulled, 1e-9);
}

#[test]
fn nip_holds_the_draw_of_the_unwinder_too() {
    // A motor that loses 1 % under load draws 2 N beside the 15 N that the ribbon has (D11); 200 N/mm² make it 20 N. Slower it loses more.
    let draws = [("speed-at-10v", 1500.0), ("speed-clamp", 1500.0), ("rated-load-speed", 1488.0)];
    let mut project = line(
        &[
            &draws[..],
            &[WEAK_NIP, ("knob-lowest", 100.0), ("dwell", 1.0), ("youngs-modulus", 200.0), ("loop-capacity", 800.0)],
        ]
        .concat(),
    );
    let without = readout(&project, "nip-use").value;
    assert!((without - 100.0 * 15.0 / 40.0).abs() < 0.5, "a dancer leaves 15 N: {without}");
    project.values.insert("dancer".to_owned(), macroline::machines::form::Value::Flag(false));
    let tension = 15.0 + 200.0 * 10.0 * 0.01;
    same("nip", readout(&project, "nip-use").value, 100.0 * tension / 40.0, 1e-9);
}

#[test]
fn stop_asks_more_of_the_nip_where_the_ribbon_drives() {
    let wide = [("ribbon-width", 300.0), ("ribbon-thickness", 1.0), ("web-span", 40_000.0), ("youngs-modulus", 60.0)];
    let nip = |before: f64, behind: f64| {
        let tensions = [WEAK_NIP, ("tension-before", before), ("tension-behind", behind)];
        readout(&line(&[&wide[..], &tensions].concat()), "nip-use")
    };
    // 0.3 · 0.001 · 40 · 1300 kg to 126.3 mm/s in 0.1 s.
    let mass = 0.3 * 0.001 * 40.0 * 1300.0;
    let pull = mass * (PI * 0.1005 / 50.0 * 1200.0 / 60.0) / 0.1;
    let driven = nip(0.0, 25.0);
    same("stop", driven.value, 100.0 * (25.0 + pull) / 40.0, 1e-9);
    assert!((driven.value - 111.75).abs() < 0.05 && driven.verdict == Verdict::Fail, "{driven:?}");
    // The knob at its highest position leaves less: 50 % there.
    let fast = 100.0 * (25.0 + pull * 1480.0 / 1200.0) / 40.0;
    let Some(Limit::AtMost(limit)) = driven.limit else { panic!("{:?}", driven.limit) };
    same("limit", limit, 50.0 * driven.value / fast, 1e-9);
    same("start", nip(25.0, 0.0).value, driven.value, 1e-9);
}

#[test]
fn taut_ribbon_counts_in_the_torque_of_x_in_form_and_list() {
    let stiff = [SHORT_DWELL, ("youngs-modulus", 2000.0), ("tensile-strength", 2000.0), ("pinch-force", 10_000.0)];
    let project = line(&[&stiff[..], &[("pitch-count", 20.0), ("loop-capacity", 600.0)]].concat());
    // 1214 N at a roller of 100 mm with 0.3 Nm of friction, through a gear of 50 : 1 with 95 %.
    let torque = (tautest(2000.0) * 0.05 + 0.3) / (50.0 * 0.95);
    let peak = readout(&project, "x-peak-torque");
    same("torque", peak.value, torque, 1e-9);
    assert!((peak.value - 1.284).abs() < 0.001 && peak.verdict == Verdict::Ok, "{peak:?}");
    // 0.8 of 1.6 Nm are too little, and no ramp is a remedy.
    let weak = project.with_entries(&[("motor-peak-x", "1.6")]).unwrap();
    let peak = readout(&weak, "x-peak-torque");
    assert_eq!(peak.verdict, Verdict::Fail);
    assert_eq!(peak.advice[0].entries, [FieldEntry::new("wait", "dwell"), FieldEntry::new("dwell", "0.87")]);
    let mut listed = project.clone();
    for (model, most) in [("WEAK", 1.6), ("STRONG", 1.61)] {
        let table = format!(
            "kind,maker,model,rated_speed_rpm,max_speed_rpm,stall_torque_nm,peak_torque_nm,inertia_kgm2,grade\n\
             servo,Works,{model},3000,3000,1,{most},1e-4,entered\n"
        );
        listed.add_parts(parts::read(&table, "own.csv").0);
    }
    let sizing = size_without_envelope(&listed, &SizingRuns::new(&listed, &listed.written()));
    let pull = sizing.axes.iter().find(|axis| axis.id == "x").unwrap();
    let refusal = |model: &str| {
        let found = pull.candidates.iter().find(|candidate| candidate.part.model == model).unwrap();
        found.refusal.as_ref().map(|refusal| sentence(&refusal.message))
    };
    assert!(refusal("WEAK").is_some_and(|text| text.starts_with("Too weak")), "{:?}", refusal("WEAK"));
    assert_eq!(refusal("STRONG"), None);
}

#[test]
fn taut_ribbon_counts_in_the_gear_unit_and_in_operation() {
    let stiff = [SHORT_DWELL, ("youngs-modulus", 2000.0), ("tensile-strength", 2000.0), ("pinch-force", 10_000.0)];
    let project = line(&[&stiff[..], &[("pitch-count", 20.0), ("loop-capacity", 600.0)]].concat());
    let at_roller = tautest(2000.0) * 0.05 + 0.3;
    let sizing = size(&project, &project.written());
    let pull = sizing.axes.iter().find(|axis| axis.id == "x").unwrap();
    let duty = pull.gear.as_ref().unwrap().duty;
    same("gear", duty.peak, at_roller, 1e-9);
    // Not for long enough for its life.
    assert!(duty.mean < 0.1 * at_roller, "{duty:?}");
    let run = |sizing: &Sizing| {
        let of_run = |row: &&EnvelopeRow| row.quantity.id() == "x-torque" && row.event == OperatingEvent::Run;
        sizing.envelope.iter().find(of_run).unwrap().clone()
    };
    let row = run(&sizing);
    same("envelope", row.value, at_roller / (50.0 * 0.95), 1e-9);
    assert_eq!(row.verdict, Verdict::Ok);
    // 0.8 of 1.6 Nm are too little, as in the form.
    let weak = project.with_entries(&[("motor-peak-x", "1.6")]).unwrap();
    assert_eq!(run(&size(&weak, &weak.written())).verdict, Verdict::Fail);
    // The ribbon pulls at X alone.
    let print = |sizing: &Sizing| sizing.axes.iter().find(|axis| axis.id == "y").unwrap().gear.as_ref().unwrap().duty;
    assert!(print(&sizing).peak < 0.1 * at_roller, "{:?}", print(&sizing));
}
