//! Products by length: the length entered on the screen holds at any pitch, and its remainder follows the chosen rule.

use macroline::interp::Interp;
use macroline::motion::{Action, Event, Planner, RunEnd};
use macroline::project::Project;
use macroline::view::{Readout, Verdict};

use super::each_control::{ended, over_time, project};
use super::{controls, values};

/// A line whose F every control takes, with a length of 40 pitches and a quarter.
const LINE: [(&str, &str); 7] = [
    ("spindle-speed", "100"),
    ("heads", "60"),
    ("job", "product-length"),
    ("product-length", "322"),
    ("pitches-per-block", "3"),
    ("inverter-ramp", "0.1"),
    ("dwell", "0.2"),
];

fn line(control: &str, more: &[(&str, &str)]) -> Project {
    project(control, &[&LINE, more].concat())
}

/// Ribbon that the pull axis has moved, mm.
fn pulled(project: &Project, planner: &Planner<Interp>) -> f64 {
    let x = project.control.axis(macroline::controls::Address::X).unwrap();
    let end = planner.timeline().end();
    planner.timeline().at(end).axes[x].position - planner.timeline().at(0.0).axes[x].position
}

fn error(project: &Project) -> Readout {
    project.design().readouts.into_iter().find(|row| row.id == "length-error").unwrap()
}

/// Length of the product with the pitch changed at `t`; `None` where the program stops with an alarm.
fn run(project: &Project, pitch: Option<(f64, f64)>) -> Option<f64> {
    let number = project.control.variable(107)[1..].parse().unwrap();
    let event = |(t, pitch)| Event { t, action: Action::Variable(number, Some(pitch)) };
    let mut planner = over_time(project, pitch.map(event).into_iter().collect());
    match ended(&mut planner) {
        RunEnd::ProgramEnd => Some(pulled(project, &planner)),
        RunEnd::Alarm(_) | RunEnd::Stop => None,
        end => panic!("{end:?}"),
    }
}

#[test]
fn rest_of_a_length_is_settled_by_its_rule() {
    for control in controls() {
        for variant in ["ready-made", "published", "precomputed"] {
            let by = |rest: &str| line(control.id, &[("rest", rest), ("variant", variant)]);
            for (rest, length, verdict) in [
                ("round", Some(320.0), Verdict::Warn),
                ("shorten", Some(322.0), Verdict::Ok),
                ("alarm", None, Verdict::Fail),
            ] {
                let project = by(rest);
                assert_eq!(error(&project).verdict, verdict, "{} {variant} {rest}", control.id);
                let ran = run(&project, None);
                assert_eq!(ran.is_some(), length.is_some(), "{} {variant} {rest}: {ran:?}", control.id);
                if let (Some(ran), Some(length)) = (ran, length) {
                    assert!((ran - length).abs() < 2e-3, "{} {variant} {rest}: {ran}", control.id);
                }
            }
            let whole = line(control.id, &[("rest", "alarm"), ("variant", variant), ("product-length", "320")]);
            assert!((run(&whole, None).unwrap() - 320.0).abs() < 1e-6, "{} {variant}", control.id);
            let none = line(control.id, &[("variant", variant), ("product-length", "3")]);
            assert_eq!((error(&none).verdict, run(&none, None)), (Verdict::Fail, None), "{} {variant}", control.id);
        }
    }
}

#[test]
fn length_stays_when_the_pitch_changes() {
    for control in controls() {
        for (t, variant) in [(0.0, "ready-made"), (8.0, "ready-made"), (0.0, "precomputed"), (8.0, "precomputed")] {
            let shorten = line(control.id, &[("rest", "shorten"), ("variant", variant)]);
            let round = line(control.id, &[("rest", "round"), ("product-length", "320"), ("variant", variant)]);
            // Before the start, and in the running product.
            let ran = run(&shorten, Some((t, 7.0))).unwrap();
            assert!((ran - 322.0).abs() < 5e-3, "{} at {t}: {ran}", control.id);
            let ran = run(&round, Some((t, 7.0))).unwrap();
            assert!((ran - 320.0).abs() <= 3.5 + 1e-3, "{} at {t}: {ran}", control.id);
        }
    }
}

#[test]
fn advice_about_a_length_settles_it() {
    for rest in ["round", "alarm"] {
        let project = line("mitsubishi-e60", &[("rest", rest)]);
        let advice = error(&project).advice;
        assert_eq!(advice.iter().filter(|advice| !advice.entries.is_empty()).count(), 2, "{rest}");
        for advice in advice {
            let mut after = project.clone();
            let sets: Vec<_> = advice.entries.iter().map(|entry| (entry.field, entry.text.as_str())).collect();
            after.values.extend(values(&sets));
            assert_eq!(error(&after).verdict, Verdict::Ok, "{rest} {sets:?}");
        }
    }
}

/// 40 heads and a quarter per product: a program that reads the position turns the roller to head 41 first, the other leaves the dots shifted.
#[test]
fn product_after_a_shorter_pitch_begins_as_the_help_says() {
    for (control, heads) in [("mitsubishi-e60", 41.0 + 40.25), ("sinumerik-802d", 2.0 * 40.25)] {
        let project = line(control, &[("rest", "shorten")]);
        let end = over_time(&project, vec![]).ended_at().expect("the end of a product");
        let mut planner = over_time(&project, vec![Event { t: end + 2.0, action: Action::Start }]);
        assert_eq!(ended(&mut planner), RunEnd::ProgramEnd, "{control}");
        let y = project.control.axis(macroline::controls::Address::Y).unwrap();
        let turned = planner.timeline().at(planner.timeline().end()).axes[y].position;
        let turned = turned / (std::f64::consts::PI * 120.0 / 60.0);
        assert!((turned - heads).abs() < 0.01, "{control}: {turned} heads, expected {heads}");
    }
}
