//! The choice of gear units: by the torque at their output and the speed of their input, in the run of the program.

use macroline::drives::gear::{GearDuty, GearRefusal};
use macroline::drives::load::Load;
use macroline::drives::parts::GearRatings;
use macroline::drives::shaft_motion::{Motion, SpeedSegment};
use macroline::machines::driven::devices::BillItem;
use macroline::machines::form::Value;
use macroline::math::{self, PI, RPM};
use macroline::project::size::{BillRow, GearCandidate, SizedGear, Sizing};
use macroline::project::{Project, parts};
use macroline::text::catalog::sentence;
use macroline::view::FieldEntry;
use proptest::prelude::*;

use super::{SAME, same};
use crate::queries::sized;

fn line(ratio: f64) -> Project {
    super::line(&[("pitch-count", 100.0), ("gear-x", ratio), ("gear-y", 5.0)])
}

fn gear<'a>(sizing: &'a Sizing, axis: &str) -> Option<&'a SizedGear> {
    sizing.axes.iter().find(|row| row.id == axis).unwrap().gear.as_ref()
}

fn row<'a>(sizing: &'a Sizing, axis: &str) -> Option<&'a BillRow> {
    sizing.bill.iter().find(|row| row.item == BillItem::Gear && row.axis == Some(axis))
}

/// A table of one gear unit of the user.
fn own(project: &mut Project, ratio: f64, rated: f64, peak: f64, speed: f64, backlash: f64) {
    let table = format!(
        "kind,maker,model,ratio,rated_torque_nm,peak_torque_nm,rated_speed_rpm,max_speed_rpm,backlash_arcmin,efficiency,inertia_kgm2\n\
         gear,Works,G1,{ratio},{rated},{peak},{speed},{speed},{backlash},0.9,0.0001\n"
    );
    let (parts, found) = parts::read(&table, "own.csv");
    assert!(found.is_empty(), "{found:?}");
    project.add_parts(parts);
}

fn own_of<'a>(sizing: &'a Sizing, axis: &str) -> &'a GearCandidate {
    let all = &gear(sizing, axis).unwrap().candidates;
    all.iter().find(|candidate| candidate.part.model == "G1").unwrap()
}

#[test]
fn gear_unit_is_refused_by_the_first_limit_that_it_breaks() {
    // Demand of X on a gear of 10 : 1: some Nm, 290 r/min and 340 at the highest position of the knob.
    for ((rated, peak, speed), wanted) in [
        ((50.0, 100.0, 3000.0), ""),
        ((0.5, 0.6, 3000.0), "Too weak: "),
        ((0.2, 100.0, 3000.0), "Too weak: "),
        ((50.0, 100.0, 100.0), "Too slow: "),
    ] {
        let mut project = line(10.0);
        own(&mut project, 10.0, rated, peak, speed, 1.0);
        let sizing = sized(&project);
        let refusal = own_of(&sizing, "x").refusal().map(|refusal| sentence(&refusal)).unwrap_or_default();
        assert!(refusal.starts_with(wanted), "{rated}, {peak}, {speed}: {refusal}");
        assert_eq!(refusal.is_empty(), wanted.is_empty(), "{rated}, {peak}, {speed}: {refusal}");
    }
}

#[test]
fn play_counts_where_the_torque_changes_its_sign() {
    let ratings = GearRatings {
        rated_torque: Some(10.0),
        peak_torque: Some(20.0),
        rated_speed: Some(3000.0),
        top_speed: Some(6000.0),
        backlash: Some(8.0),
        ..GearRatings::default()
    };
    let duty = GearDuty { peak: 1.0, mean: 1.0, speed: 100.0, mean_speed: 100.0 };
    assert_eq!(ratings.refuses(&duty, None), None);
    assert_eq!(ratings.refuses(&duty, Some(8.0)), None);
    assert_eq!(ratings.refuses(&duty, Some(3.0)), Some(GearRefusal::Backlash(8.0, 3.0)));
    assert_eq!(GearRatings { rated_torque: None, ..ratings }.refuses(&duty, None), Some(GearRefusal::Unknown));
}

#[test]
fn gear_units_that_pass_come_first_the_smallest_of_them_first() {
    let sizing = sized(&line(10.0));
    for axis in ["x", "y"] {
        let all = &gear(&sizing, axis).unwrap().candidates;
        let passing = all.iter().take_while(|candidate| candidate.reason.is_none()).count();
        assert!(passing > 0, "{axis}");
        assert!(all[passing..].iter().all(|candidate| candidate.reason.is_some()), "{axis}");
        assert!(all[..passing].is_sorted_by_key(|candidate| candidate.ratings.rated_torque), "{axis}");
        assert!(all.iter().all(|candidate| candidate.ratings.ratio == Some(gear(&sizing, axis).unwrap().ratio)));
    }
}

#[test]
fn smallest_gear_unit_that_passes_is_proposed_in_the_bill() {
    let sizing = sized(&line(10.0));
    let row = row(&sizing, "ribbon.drive.pull").unwrap();
    assert!(row.proposed);
    assert_eq!(Some(row.model.as_str()), gear(&sizing, "x").unwrap().least().map(|part| part.model.as_str()));
}

#[test]
fn ratio_without_a_gear_unit_is_an_open_row_with_its_demand() {
    let sizing = sized(&line(11.3));
    let row = row(&sizing, "ribbon.drive.pull").unwrap();
    assert!(!row.proposed && row.maker.is_empty() && row.asked.contains("11.3 : 1"), "{row:?}");
    assert_eq!(gear(&sizing, "x").unwrap().next_ratios, [11.0, 15.0]);
}

#[test]
fn motor_on_the_roller_itself_has_no_gear_unit() {
    let sizing = sized(&line(1.0));
    assert_eq!((gear(&sizing, "x"), row(&sizing, "ribbon.drive.pull")), (None, None));
}

#[test]
fn gear_unit_of_the_list_is_taken_into_the_form() {
    let mut project = line(10.0);
    own(&mut project, 10.0, 50.0, 100.0, 3000.0, 1.0);
    let entries = own_of(&sized(&project), "x").entries.clone();
    assert_eq!(entries, [FieldEntry::new("efficiency-x", "90"), FieldEntry::new("gear-inertia-x", "1")]);
}

#[test]
fn gear_unit_with_more_play_is_taken_with_its_play() {
    // Without a steady torque it changes its sign with each ramp.
    let light = [("friction-y", "0".to_owned()), ("printing-force", "0".to_owned())];
    let mut project = line(10.0).with_entries(&light).unwrap();
    own(&mut project, 5.0, 50.0, 100.0, 3000.0, 8.0);
    let refused = own_of(&sized(&project), "y").clone();
    assert_eq!(refused.reason, Some(GearRefusal::Backlash(8.0, 3.0)));
    let taken = project.with_entries(&refused.entries).unwrap();
    assert_eq!(taken.values["gear-backlash"], Value::Number(8.0));
    assert_eq!(own_of(&sized(&taken), "y").reason, None);
}

#[test]
fn gear_unit_whose_ratings_are_unknown_sets_nothing() {
    // Their inertia is that of motor and reducer together.
    let sizing = sized(&line(5.0));
    let unknown: Vec<_> = gear(&sizing, "x")
        .unwrap()
        .candidates
        .iter()
        .filter(|candidate| candidate.reason == Some(GearRefusal::Unknown))
        .collect();
    assert!(!unknown.is_empty() && unknown.iter().all(|candidate| candidate.entries.is_empty()));
}

/// Torque at the output is that of the roller: the motor's torque, less the torques that accelerate its rotor and the
/// gear's input, times ratio and efficiency.
#[test]
fn torque_at_the_output_agrees_with_that_at_the_motor() {
    let (ratio, efficiency, rotor, input) = (10.0, 0.9, 2e-5, 6e-5);
    let output = Load { inertia: 0.02, torque: 1.2, efficiency: 1.0 };
    let load = Load { inertia: 0.02 / 100.0 + input, torque: 1.2 / (ratio * efficiency), efficiency };
    let rise = |speed: f64| [SpeedSegment { t: 0.0, seconds: 0.1, from: 0.0, to: speed }];
    let motor = Motion::new(rise(30.0), load, 0.0);
    let behind = Motion::new(rise(30.0 / ratio), output, 0.0);
    let at_motor = motor.motor_load(rotor).peak.torque;
    // The form's load counts the gear's own inertia at the output, after its efficiency.
    let of_rotors = (rotor + input / efficiency) * 300.0;
    same("torque", behind.motor_load(0.0).peak.torque, (at_motor - of_rotors) * ratio * efficiency, SAME);
}

proptest! {
    /// At a steady speed the mean torque is that of the load, and input turns as often as the ratio has it.
    #[test]
    fn lasting_torque_of_a_steady_motion_is_its_torque(torque in 0.1_f64..50.0, speed in 1.0_f64..300.0, ratio in 1.0_f64..50.0) {
        let segment = SpeedSegment { t: 0.0, seconds: 2.0, from: speed, to: speed };
        let duty = GearDuty::new(&Motion::new([segment], Load { inertia: 1.0, torque, efficiency: 1.0 }, 0.0), ratio);
        for (own, wanted) in [(duty.mean, torque), (duty.peak, torque), (duty.speed, speed / RPM * ratio), (duty.mean_speed, speed / RPM * ratio)] {
            prop_assert!((own - wanted).abs() <= 1e-9 * wanted);
        }
    }

    /// Two ramps of one acceleration: the cubic mean over the angle in closed form.
    #[test]
    fn lasting_torque_of_ramps_agrees_with_the_closed_form(inertia in 1e-4_f64..1.0, speed in 1.0_f64..100.0, ramp in 0.05_f64..2.0) {
        let load = Load { inertia, torque: 0.0, efficiency: 1.0 };
        let up = SpeedSegment { t: 0.0, seconds: ramp, from: 0.0, to: speed };
        let down = SpeedSegment { t: ramp, seconds: 2.0 * ramp, from: speed, to: 0.0 };
        let duty = GearDuty::new(&Motion::new([up, down], load, 0.0), 1.0);
        let torque = inertia * speed / ramp;
        // Ways v t / 2 and v t, with the whole torque and half of it.
        let wanted = torque * math::pow((1.0 + 2.0 / 8.0) / 3.0, 1.0 / 3.0);
        prop_assert!((duty.mean - wanted).abs() <= 1e-9 * wanted);
        prop_assert!((duty.peak - torque).abs() <= 1e-9 * torque);
        prop_assert!((duty.mean_speed - speed / 2.0 * 60.0 / (2.0 * PI)).abs() <= 1e-9 * duty.mean_speed);
    }
}
