//! Edges of the turning spindle's operation: limits that stay, positioning, ramps beside the cut, heat, gears, offsets of the output.

use std::collections::BTreeSet;

use macroline::project::Project;
use macroline::text::catalog::sentence;
use macroline::view::{FieldEntry, Readout, Verdict};

use super::sheet;
use crate::queries::{readout, sized, value};

/// An example with other entries.
fn example(control: &str, name: &str, changes: &[(&'static str, &str)]) -> Project {
    let example = Project::named("turning-spindle", Some(control), Some(name)).unwrap();
    let entries: Vec<FieldEntry> = changes.iter().map(|(field, text)| FieldEntry::new(field, *text)).collect();
    example.with_entries(&entries).expect("entries that the form takes")
}

/// Text of the written program.
fn program(project: &Project) -> String {
    let files = project.written().files.0;
    files.into_iter().find(|file| file.name.contains("9201")).expect("the program").text
}

/// The result after its first advice with a button.
fn mended(project: &Project, id: &str) -> (Project, Readout) {
    let row = readout(project, id);
    let advice = row.advice.iter().find(|advice| advice.button.is_some()).unwrap_or_else(|| panic!("{row:?}"));
    let after = project.with_entries(&advice.entries).unwrap();
    let row = readout(&after, id);
    (after, row)
}

/// Ids of the findings.
fn findings(project: &Project) -> Vec<&'static str> {
    project.design().diagnostics.iter().map(|found| found.message.id).collect()
}

/// G25 stays in the control's setting data beyond the program's end.
#[test]
fn lowest_speed_of_a_part_replaces_that_of_the_one_before() {
    for lowest in ["0", "200"] {
        let lathe = example("sinumerik-802d", "shaft", &[("lower-limit", lowest)]);
        assert!(program(&lathe).contains(" G25 S=R"), "{lowest}");
    }
    let sheet = sheet("sinumerik-802d", &[("lower-limit", "1200")]);
    let minimum: Vec<&str> = sheet.lines().filter(|line| line.starts_with("MD35140")).collect();
    assert!(!minimum.is_empty() && minimum.iter().all(|line| !line.contains("1200")), "{minimum:?}");
}

#[test]
fn block_numbers_of_a_program_are_all_different() {
    let text = program(&example("sinumerik-802d", "keyway", &[]));
    let numbers = text.lines().filter_map(|line| line.strip_prefix('N')?.split_whitespace().next());
    let mut seen = BTreeSet::new();
    for number in numbers.filter(|number| number.bytes().all(|byte| byte.is_ascii_digit())) {
        assert!(seen.insert(number.to_owned()), "N{number} twice");
    }
    assert!(seen.len() > 30, "{}", seen.len());
}

/// The motor drives 2000 r/min per second and brakes with a tenth of that.
#[test]
fn positioning_is_judged_in_braking_and_against_the_ramp() {
    let weak_brake = [("positioning-acceleration", "2000"), ("motor-braking", "15"), ("spindle-ramp", "1.4")];
    let lathe = example("sinumerik-802d", "keyway", &weak_brake);
    let row = readout(&lathe, "positioning-torque");
    assert_eq!(row.verdict, Verdict::Fail, "{row:?}");
    assert!(sentence(&row.advice[0].message).contains("brakes it with"), "{row:?}");
    assert_eq!(mended(&lathe, "positioning-torque").1.verdict, Verdict::Ok);
    let steep = example("sinumerik-802d", "keyway", &[("positioning-acceleration", "2000"), ("spindle-ramp", "60")]);
    let row = readout(&steep, "positioning-torque");
    assert!(
        row.verdict == Verdict::Fail && sentence(&row.advice[0].message).contains("follows its ramp of 50"),
        "{row:?}"
    );
    let (after, row) = mended(&steep, "positioning-torque");
    assert!(row.verdict == Verdict::Ok && after.design().readouts.len() == steep.design().readouts.len());
}

#[test]
fn positioning_beyond_chuck_and_stage_is_reported() {
    let lathe = example("sinumerik-802d", "keyway", &[("positioning-speed", "5000")]);
    assert!(findings(&lathe).contains(&"turning.positioning-too-fast"));
    assert!(!findings(&example("sinumerik-802d", "keyway", &[])).contains(&"turning.positioning-too-fast"));
}

#[test]
fn encoder_with_several_zero_marks_per_turn_is_reported() {
    let marks = |motor: &str, spindle: &str| {
        let changes = [("encoder-turns", motor), ("spindle-turns", spindle)];
        findings(&example("sinumerik-802d", "keyway", &changes)).contains(&"turning.several-zero-marks")
    };
    assert_eq!(
        [("1", "1"), ("2", "2"), ("1", "2"), ("2", "1"), ("3", "2")].map(|(motor, spindle)| marks(motor, spindle)),
        [false, false, false, true, true]
    );
}

/// 11 kW, 0.2 kg m²: the run-up takes the motor's short-time torque, and the cut comes on top.
#[test]
fn ramp_beside_the_cut_is_judged_where_the_knob_may_turn() {
    let steep = [
        ("speed-mode", "fixed"),
        ("stock-diameter", "30"),
        ("finished-diameter", "26"),
        ("cutting-speed", "230"),
        ("upper-limit", "2440"),
        ("chuck-limit", "2440"),
        ("feed", "0.3"),
        ("depth", "1"),
        ("stage-1", "3000"),
        ("stage-2", "0"),
        ("motor-power", "11"),
        ("spindle-inertia", "0.2"),
        ("spindle-ramp", "1.55"),
        ("work-length", "60"),
        ("length", "30"),
        ("start-x", "120"),
    ];
    let lathe = example("sinumerik-802d", "shaft", &steep);
    let row = readout(&lathe, "peak-torque");
    assert_eq!(row.verdict, Verdict::Warn, "{row:?}");
    assert!(sentence(&row.advice[0].message).contains("accelerates over its ramp"), "{row:?}");
    let (after, row) = mended(&lathe, "peak-torque");
    assert_eq!(row.verdict, Verdict::Ok, "{row:?}");
    assert!(value(&after, "shortest-ramp") < 3.0);
}

/// A disc of 2.5 m whose spindle of 3000 kg m² follows the surface speed: a limit of the speed costs little, less feed eight times the time.
#[test]
fn lower_limit_is_offered_where_less_feed_takes_longer() {
    let disc = [
        ("stock-diameter", "2500"),
        ("finished-diameter", "50"),
        ("cutting-speed", "120"),
        ("feed", "0.4"),
        ("depth", "4"),
        ("allowance", "4"),
        ("upper-limit", "300"),
        ("chuck-limit", "300"),
        ("stage-1", "25"),
        ("stage-2", "100"),
        ("stage-3", "300"),
        ("motor-power", "55"),
        ("motor-base", "500"),
        ("motor-top", "2000"),
        ("spindle-inertia", "3000"),
        ("rotor-inertia", "1"),
        ("spindle-friction", "150"),
        ("spindle-ramp", "40"),
        ("start-x", "2600"),
        ("start-z", "200"),
        ("work-length", "400"),
        ("grip", "100"),
        ("screw-length-x", "2000"),
        ("rapid-x", "4000"),
    ];
    let lathe = example("gsk-980tdc", "facing", &disc);
    let (after, _) = mended(&lathe, "peak-torque");
    assert!(value(&after, "cutting-time") < 1.1 * value(&lathe, "cutting-time"));
}

#[test]
fn gear_that_comes_late_is_given_more_time() {
    let lathe = example("gsk-980tdc", "shaft", &[("gear-time", "12"), ("gear-patience", "5")]);
    let row = readout(&lathe, "stage");
    assert_eq!(row.verdict, Verdict::Fail);
    let fields: Vec<_> = row.advice.iter().flat_map(|advice| &advice.entries).map(|entry| entry.field).collect();
    assert_eq!(fields, ["gear-patience"]);
    assert_ne!(mended(&lathe, "stage").1.verdict, Verdict::Fail);
}

/// With 1.5 V more at 10 V the stage of 1000 r/min ends at 870.
#[test]
fn stage_is_chosen_by_the_speed_of_its_output() {
    let lathe = |full: &'static str| {
        let changes = [("offset-full", full), ("cutting-speed", "150"), ("upper-limit", "1000")];
        value(&example("gsk-980tdc", "shaft", &changes), "stage")
    };
    assert_eq!([lathe("0"), lathe("1500")], [1.0, 2.0]);
}

#[test]
fn output_that_ends_above_the_speed_fails() {
    let slow = [("offset-zero", "-500"), ("stage-1", "3000"), ("stage-2", "0"), ("cutting-speed", "15")];
    let row = readout(&example("gsk-980tdc", "shaft", &slow), "volts-largest");
    assert_eq!((row.value, row.verdict), (0.0, Verdict::Fail));
    assert!(sentence(&row.advice[0].message).contains("at 0 V the spindle turns 143 r/min"), "{row:?}");
}

#[test]
fn feed_clamp_above_rapid_traverse_is_lowered() {
    let lathe = example("gsk-980tdc", "shaft", &[("clamp-z", "8000"), ("rapid-z", "700")]);
    let (after, row) = mended(&lathe, "z-motor-speed");
    assert_eq!(row.verdict, Verdict::Ok);
    assert_eq!(readout(&after, "feed-top").limit.map(|limit| limit.value()), Some(700.0));
}

/// The run-up and the stop of a short part heat the motor more than its cut.
#[test]
fn motor_of_the_spindle_is_judged_by_its_heat_over_the_cycle() {
    let short = [
        ("stock-diameter", "60"),
        ("finished-diameter", "58"),
        ("length", "2"),
        ("work-length", "60"),
        ("feed", "0.4"),
        ("depth", "1"),
        ("start-x", "140"),
        ("start-z", "35"),
        ("stage-1", "1000"),
        ("stage-2", "0"),
        ("upper-limit", "1000"),
        ("chuck-limit", "1000"),
        ("motor-power", "7.5"),
        ("motor-base", "3000"),
        ("motor-top", "3000"),
        ("motor-peak", "200"),
        ("motor-braking", "200"),
        ("rotor-inertia", "0.0187"),
        ("spindle-inertia", "1.85"),
        ("spindle-ramp", "2.1"),
        ("pause", "0"),
    ];
    let sizing = sized(&example("gsk-980tdc", "shaft", &short));
    let heat =
        sizing.envelope.iter().find(|row| row.quantity.id() == "spindle-effective-torque").expect("a row of heat");
    assert_eq!(heat.verdict, Verdict::Fail, "{heat:?}");
    let spindle = sizing.axes.iter().find(|axis| axis.id == "spindle").expect("the spindle");
    // √(42.08² · 2.0 / 4.675) = 27.5 Nm of the run-up alone.
    assert!(spindle.demand.effective > 27.0 && heat.value > 27.0, "{} {}", spindle.demand.effective, heat.value);
}
