//! Axis scaling: fractions of whole numbers, and the parameters of each control.

use macroline::controls::{Control, ParamRole, find};
use macroline::drives::scaling::Fraction;
use macroline::machines::driven::scaling::{AxisDrive, GearTurns, parameters};
use macroline::machines::sheets::ParamValue;
use macroline::math::{self, PI};

/// A pull roller of 100 mm on a gear of 10 : 1.
const ROLLER: AxisDrive = AxisDrive {
    axis: "X",
    lead: PI * 100.0,
    gear: GearTurns { motor: 10.0, load: 1.0 },
    encoder: 131_072.0,
    rotary: false,
    words: 1.0,
};

fn control(id: &str) -> &'static Control {
    find(id).unwrap()
}

fn values(drive: &AxisDrive, id: &str) -> Vec<(ParamRole, f64)> {
    let rows = parameters(control(id), &[*drive]);
    let value = |value: &ParamValue| match value {
        ParamValue::Fine(value) => *value,
        _ => panic!("a number with decimals"),
    };
    rows.iter().flat_map(|(role, values)| values.iter().map(move |(_, found)| (*role, value(found)))).collect()
}

fn nearest(ratio: f64, limit: u64) -> (u64, u64) {
    Fraction::nearest(ratio, limit).map_or((0, 0), |found| (found.over, found.under))
}

#[test]
fn fraction_is_the_nearest_of_all() {
    assert_eq!(nearest(PI, 32_767), (355, 113));
    assert_eq!(nearest(0.5, 32_767), (1, 2));
    assert_eq!(nearest(25.0 / 7.0, 32_767), (25, 7));
    assert_eq!(nearest(1.0 / 32_767.0, 32_767), (1, 32_767));
    for none in [0.0, -1.0, f64::NAN, f64::INFINITY, 32_768.0, 1.0 / 32_768.0] {
        assert_eq!(nearest(none, 32_767), (0, 0), "{none}");
    }
    // Against all denominators.
    let mut ratio = 0.013_7;
    for _ in 0..400 {
        ratio = (ratio * 7.31 + 0.123_456_7) % 17.0 + 0.01;
        let (over, under) = nearest(ratio, 500);
        let found = (over as f64 / under as f64 - ratio).abs();
        let best = (1..=500u32)
            .map(f64::from)
            .map(|under| (math::clamp((ratio * under).round(), 1.0, 500.0) / under - ratio).abs())
            .fold(f64::INFINITY, f64::min);
        assert!(found <= best * (1.0 + 1e-9), "{ratio}: {over}/{under} misses by {found}, {best} is possible");
    }
}

#[test]
fn roller_of_the_facts_has_its_parameters_on_each_control() {
    use ParamRole::*;
    let drift = |id: &str| ROLLER.error(control(id)).unwrap() * 15_079.644_7 * 60.0;
    let e60 = values(&ROLLER, "mitsubishi-e60");
    assert_eq!(e60[..3], [(LoadTurns, 355.0), (MotorTurns, 113.0), (WholeLead, 10.0)]);
    assert!((drift("mitsubishi-e60") + 0.0768).abs() < 1e-3, "{}", drift("mitsubishi-e60"));
    let fanuc = values(&ROLLER, "fanuc-0i-tf");
    assert_eq!(fanuc[0], (CommandMultiplier, 2.0));
    // 1 000 000 · 71/2260 detection units per turn of the motor.
    assert_eq!(fanuc[1..3], [(ReferenceCounts, 3_550_000.0), (ReferenceCountsUnder, 113.0)]);
    assert_eq!(fanuc[3..], [(FeedGearOver, 71.0), (FeedGearUnder, 2260.0)]);
    assert_eq!(values(&ROLLER, "gsk-980tdc"), [(CountsOver, 18_637.0), (CountsUnder, 4467.0)]);
    assert!((drift("gsk-980tdc") + 0.0018).abs() < 1e-4, "{}", drift("gsk-980tdc"));
    let siemens = values(&ROLLER, "sinumerik-802d");
    assert_eq!(siemens[..2], [(LoadTurns, 1.0), (MotorTurns, 10.0)]);
    assert_eq!(siemens[3], (Lead, 314.159_265));
    assert!(drift("sinumerik-802d").abs() < 2e-3);
}

#[test]
fn scaling_writes_parameters_that_the_control_has() {
    for control in macroline::controls::ALL {
        let roles = control.scaling.map_or(&[][..], |row| row.kind.roles());
        for role in roles {
            assert!(control.param(*role).is_some(), "{} {role:?}", control.id);
        }
        let written: Vec<ParamRole> = values(&ROLLER, control.id).into_iter().map(|(role, _)| role).collect();
        assert!(written.iter().all(|role| roles.contains(role)), "{} {written:?}", control.id);
        assert_eq!(written.len(), roles.len(), "{}", control.id);
    }
}

#[test]
fn screws_and_tables_leave_no_remainder() {
    let screw = AxisDrive { lead: 4.0, gear: GearTurns { motor: 1.0, load: 1.0 }, ..ROLLER };
    assert_eq!(
        values(&screw, "gsk-980tdc"),
        [(ParamRole::CountsOver, 4096.0), (ParamRole::CountsUnder, 125.0)],
        "the manual's own example"
    );
    let table = AxisDrive { lead: 360.0, gear: GearTurns { motor: 10.0, load: 1.0 }, rotary: true, ..ROLLER };
    assert_eq!(values(&table, "fanuc-0i-tf")[2..], [(ParamRole::FeedGearOver, 9.0), (ParamRole::FeedGearUnder, 250.0)]);
    assert_eq!(values(&table, "mitsubishi-e60")[2], (ParamRole::WholeLead, 360.0));
    for control in macroline::controls::ALL {
        for (driven, driving, lead) in [(1.0, 1.0, 5.0), (30.0, 20.0, 6.0), (7.0, 25.0, 10.0)] {
            let gear = GearTurns { motor: driven, load: driving };
            let drive = AxisDrive { lead, gear, encoder: 10_000.0, ..ROLLER };
            assert_eq!(drive.error(control), Some(0.0), "{} {gear:?} {lead}", control.id);
        }
        assert_eq!(table.error(control), Some(0.0), "{}", control.id);
    }
}

#[test]
fn gear_beyond_the_parameters_has_no_scaling() {
    let slow = AxisDrive { lead: 1.0, gear: GearTurns { motor: 1_000_000.0, load: 1.0 }, ..ROLLER };
    assert_eq!(slow.error(control("fanuc-0i-tf")), None);
    assert_eq!(slow.error(control("mitsubishi-e60")), None);
}
