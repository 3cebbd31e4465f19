//! Axes that run in one direction without end: the control stops where one leaves its range, and parameters or the program prevent it.

use macroline::controls::options::{CoordinateRange, Diameter, SwitchChoice};
use macroline::machines::form::Value;
use macroline::motion::{Action, Event, RunEnd};
use macroline::project::Project;
use macroline::text::Severity;
use macroline::view::{Readout, Row, Verdict};

use super::each_control::{ended, over_time, project};
use super::{controls, values};

/// A line whose F every control takes, whose print roller runs 100 mm for each pitch of 10 mm, and whose nip holds a taut ribbon.
const LINE: [(&str, &str); 8] = [
    ("spindle-speed", "60"),
    ("speed-clamp", "60"),
    ("pitch", "10"),
    ("heads", "4"),
    ("print-roller-diameter", "127.324"),
    ("pitches-per-block", "10"),
    ("inverter-ramp", "0.1"),
    ("pinch-force", "2000"),
];

fn line(control: &str, more: &[(&str, &str)]) -> Project {
    project(control, &[&LINE, more].concat())
}

fn range(project: &Project) -> Readout {
    project.design().readouts.into_iter().find(|row| row.id == "range-time").unwrap()
}

/// Rows of the parameter sheet for a number of the control.
fn parameter(project: &Project, number: &str) -> Vec<Row> {
    let sheets = project.prepared().sheets();
    let sheet = sheets.into_iter().find(|sheet| sheet.id == "parameters").unwrap();
    sheet.rows.into_iter().filter(|row| row.cells[0] == number).collect()
}

/// Pitches that the faster axis takes to the end of the range, and some more.
fn too_many(control: &macroline::controls::Control) -> String {
    let per_pitch = if control.axes[0].diameter { 100.0_f64.max(20.0) } else { 100.0 };
    ((control.limits.coordinate_max / per_pitch).ceil() + 1.0).to_string()
}

#[test]
fn control_stops_where_an_axis_leaves_its_range() {
    let mut short = 0;
    for control in controls().filter(|control| control.limits.coordinate_max < 1e5) {
        short += 1;
        let count = too_many(control);
        let endless = |way: &str| line(control.id, &[("pitch-count", &count), ("endless", way)]);
        let mut run = over_time(&endless("nothing"), vec![]);
        // A control without a code that takes coordinates back, and without parameters, cannot do otherwise.
        let resolved = range(&endless("nothing"));
        assert_eq!(resolved.verdict, Verdict::Fail, "{}", control.id);
        match ended(&mut run) {
            RunEnd::Alarm(alarm) => assert_eq!(alarm.message.id, "interp.coordinate-range", "{}", control.id),
            end => panic!("{}: {end:?}", control.id),
        }
        // Heads are found by the position of the print roller: it rolls over without a remainder in degrees.
        let in_degrees = [("pitch-count", count.as_str()), ("endless", "roll-over"), ("y-unit", "degrees")];
        let mut rolls = line(control.id, &in_degrees);
        let verdict = range(&rolls).verdict;
        let known = verdict == Verdict::Ok;
        assert_eq!(known, control.id != "gsk-980tdc", "{}", control.id);
        if known {
            assert_eq!(ended(&mut over_time(&rolls, vec![])), RunEnd::ProgramEnd, "{}", control.id);
        } else {
            rolls.values.extend(values(&[("pitch-count", "500")]));
            assert_eq!(range(&rolls).verdict, Verdict::None, "{}", control.id);
        }
    }
    assert!(short > 2, "{short} controls");
}

#[test]
fn coordinates_taken_back_let_products_follow_for_ever() {
    let three = |more: &[(&str, &str)], frame: CoordinateRange| {
        let mut project = line("mitsubishi-e60", &[&[("pitch-count", "600")], more].concat());
        let row = project.control.switch(CoordinateRange::SWITCH).unwrap();
        project.switches.set(row, frame.option().id);
        let start = |n: u32| Event { t: 700.0 * f64::from(n), action: Action::Start };
        ended(&mut over_time(&project, vec![start(1), start(2)]))
    };
    let is_alarm = |end: RunEnd| matches!(end, RunEnd::Alarm(_));
    // 60 m a product: the second one ends at 120 m from machine zero.
    assert_eq!(three(&[("endless", "shift")], CoordinateRange::Program), RunEnd::ProgramEnd);
    assert!(is_alarm(three(&[("endless", "shift")], CoordinateRange::Machine)));
    assert!(is_alarm(three(&[("endless", "nothing")], CoordinateRange::Program)));
    for frame in [CoordinateRange::Program, CoordinateRange::Machine] {
        assert_eq!(three(&[("endless", "roll-over"), ("y-unit", "degrees")], frame), RunEnd::ProgramEnd);
    }
    assert_eq!(three(&[("endless", "nothing")], CoordinateRange::NoAlarm), RunEnd::ProgramEnd);
}

#[test]
fn heads_keep_their_place_over_many_products() {
    // A stroke of 10.0007 mm, 200.0147 mm a product: what is left of a micrometre each time would add up.
    let entries = [
        ("pitch", "10"),
        ("heads", "36"),
        ("print-roller-diameter", "114.6"),
        ("pitches-per-block", "1"),
        ("pitch-count", "20"),
        ("loop-capacity", "3000"),
        ("endless", "shift"),
    ];
    let project = project("mitsubishi-e60", &entries);
    let starts = (1..60).map(|n| Event { t: 30.0 * f64::from(n), action: Action::Start }).collect();
    let mut run = over_time(&project, starts);
    assert_eq!(ended(&mut run), RunEnd::ProgramEnd);
    let turned = run.timeline().at(run.timeline().end()).axes[1].position;
    let wanted = 60.0 * 20.0 * std::f64::consts::PI * 114.6 / 36.0;
    assert!((turned - wanted).abs() < 0.001, "{turned} of {wanted}");
}

#[test]
fn shift_of_the_coordinates_keeps_the_place_of_a_head() {
    // 45 m a product: from the second on each start shifts.
    let project = line("mitsubishi-e60", &[("pitch-count", "450"), ("endless", "shift")]);
    let start = |n: u32| Event { t: 500.0 * f64::from(n), action: Action::Start };
    let mut run = over_time(&project, (1..4).map(start).collect());
    assert_eq!(ended(&mut run), RunEnd::ProgramEnd);
    let turned = run.timeline().at(run.timeline().end()).axes[1].position;
    let wanted = 4.0 * 450.0 * std::f64::consts::PI * 127.324 / 4.0;
    assert!((turned - wanted).abs() < 0.003, "{turned} of {wanted}");
}

#[test]
fn advice_about_the_range_ends_it() {
    let mut ended = 0;
    for control in controls() {
        let count = if control.limits.coordinate_max > 1e5 { "10001" } else { "1001" };
        let long = line(control.id, &[("pitch-count", count), ("endless", "nothing")]);
        let before = range(&long);
        assert_eq!(before.verdict, Verdict::Fail, "{}", control.id);
        let taken = |field: &str| {
            let advice = before.advice.iter().find(|advice| advice.entries.iter().any(|entry| entry.field == field))?;
            let sets: Vec<_> = advice.entries.iter().map(|entry| (entry.field, entry.text.as_str())).collect();
            let mut after = long.clone();
            after.values.extend(values(&sets));
            Some(after)
        };
        // The longest product that fits: one pitch more does not.
        let shorter = taken("pitch-count").unwrap();
        assert_eq!(range(&shorter).verdict, Verdict::Warn, "{}", control.id);
        let Some(Value::Number(most)) = shorter.values.get("pitch-count").cloned() else { panic!() };
        let mut beyond = shorter.clone();
        beyond.values.insert("pitch-count".to_owned(), Value::Number(most + 1.0));
        assert_eq!(range(&beyond).verdict, Verdict::Fail, "{}", control.id);
        let Some(after) = taken("endless") else {
            let advised = before.advice.iter().any(|advice| advice.message.id == "ribbon.range-roll-over-in-radius");
            assert!(control.id == "gsk-980tdc" || advised, "{}", control.id);
            continue;
        };
        assert_eq!(range(&after).verdict, Verdict::Ok, "{}", control.id);
        assert!(range(&after).value.is_infinite());
        ended += 1;
    }
    assert!(ended > 0, "no axis can be endless");
    // If each product fits the range, the program alone is a remedy.
    let short = line("gsk-980tdc", &[("endless", "shift")]);
    assert_eq!(range(&short).verdict, Verdict::None);
}

#[test]
fn parameters_of_endless_axes_are_on_the_sheet() {
    let cases: [(&str, &[(&str, &str)]); 4] = [
        ("mitsubishi-e60", &[("#1017", "1"), ("#1090", "0"), ("#1089", "0")]),
        ("sinumerik-802d", &[("MD30300", "1"), ("MD30310", "1"), ("MD30320", "1"), ("MD30330", "360")]),
        ("fanuc-0i-tf", &[("1006#0", "1"), ("1008#0", "1"), ("1008#2", "1"), ("1260", "360000")]),
        ("knd-k2000t", &[("1006#0", "1"), ("1008#0", "1"), ("1260", "360000")]),
    ];
    for (control, rows) in cases {
        let rolls = line(control, &[("endless", "roll-over"), ("y-unit", "degrees")]);
        let nothing = line(control, &[("endless", "nothing")]);
        for (number, value) in rows {
            let found = parameter(&rolls, number);
            let axes: Vec<&str> = found.iter().map(|row| row.cells[2].as_str()).collect();
            assert_eq!(axes, ["X", "Y"], "{control} {number}");
            assert!(found.iter().all(|row| row.cells[3] == *value && !row.source.is_empty()), "{control} {number}");
            assert!(parameter(&nothing, number).iter().all(|row| row.cells[3] == "0"), "{control} {number}");
        }
    }
    // An axis that counts degrees rolls over independently of X.
    let degrees = parameter(&line("mitsubishi-e60", &[("y-unit", "degrees"), ("endless", "nothing")]), "#1090");
    assert_eq!(degrees.iter().map(|row| row.cells[2].as_str()).collect::<Vec<_>>(), ["Y"]);
}

#[test]
fn pull_axis_in_diameters_cannot_roll_over() {
    for control in ["sinumerik-802d", "sinumerik-808d", "fanuc-0i-tf", "knd-k2000t"] {
        let errors = |words: Diameter| {
            let mut project = line(control, &[("endless", "roll-over"), ("y-unit", "degrees")]);
            let row = project.control.switch(Diameter::SWITCH).unwrap();
            project.switches.set(row, words.option().id);
            let found = project.design().diagnostics;
            found.iter().filter(|found| found.message.id == "ribbon.rolls-in-diameters").count()
        };
        assert_eq!((errors(Diameter::Diameter), errors(Diameter::Radius)), (1, 0), "{control}");
    }
    // A new line on a control whose axes can only roll over has them so.
    let new = Project::named("ribbon-line", Some("sinumerik-802d"), None).unwrap();
    assert!(new.design().diagnostics.iter().all(|found| found.severity != Severity::Error));
    assert!(parameter(&new, "MD20100").iter().all(|row| row.cells[3] != "X"));
}

#[test]
fn print_roller_with_found_heads_rolls_over_in_degrees() {
    for (control, number, finds) in
        [("mitsubishi-e60", "#1017", true), ("knd-k2000t", "1006#0", true), ("sinumerik-802d", "MD30300", false)]
    {
        let rolls = |unit: &str| {
            let project = line(control, &[("endless", "roll-over"), ("y-unit", unit)]);
            parameter(&project, number).iter().any(|row| row.cells[2] == "Y" && row.cells[3] == "1")
        };
        assert_eq!((rolls("degrees"), rolls("mm")), (true, !finds), "{control}");
    }
}
