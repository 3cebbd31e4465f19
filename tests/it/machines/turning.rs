//! The turning spindle: its closed forms against the run, its programs, its drawing, its verdicts.

use std::path::PathBuf;

use expect_test::{expect, expect_file};
use macroline::drives::speed::surface_speed;
use macroline::interp::Interp;
use macroline::machines::form::{Origins, Values};
use macroline::machines::{self, AnyMachine, Frame, Samples};
use macroline::motion::{Keep, Limits, Planner};
use macroline::project::run::{self, Begin};
use macroline::project::{Project, open};
use macroline::text::Severity;
use macroline::text::catalog::{Language, sentence};
use macroline::view::Verdict;

const PATHS: [&str; 3] = ["facing", "turning", "taper"];

fn machine() -> &'static dyn AnyMachine {
    machines::find("turning-spindle").unwrap()
}

fn values(changes: &[(&str, &str)]) -> Values {
    let fields = machine().fields();
    let field = |id: &str| fields.iter().find(|field| field.id == id).unwrap_or_else(|| panic!("no field {id}"));
    changes.iter().map(|(id, typed)| ((*id).to_owned(), field(id).read(typed).unwrap())).collect()
}

fn project(control: &str, changes: &[(&str, &str)]) -> Project {
    let mut project = Project::of("turning-spindle", Some(control)).unwrap();
    project.values.extend(values(changes));
    project
}

/// A lathe whose spindle and slides follow at once.
const IDEAL: [(&str, &str); 6] = [
    ("spindle-ramp", "0"),
    ("time-constant", "0"),
    ("position-gain", "1000"),
    ("clamp-x", "100000"),
    ("clamp-z", "100000"),
    ("chuck-limit", "6000"),
];

fn ideal(control: &str, changes: &[(&str, &str)]) -> Project {
    project(control, &[&IDEAL, changes].concat())
}

fn over_time(project: &Project) -> Planner<Interp> {
    let limits = Limits { blocks: 1_000_000, seconds: 3600.0 };
    let begin = Begin { start: None, settings: &[], limits, keep: Keep::Timeline };
    let mut planner = run::of_project(project, &project.written(), &begin);
    assert_eq!(planner.advance(f64::INFINITY, usize::MAX).ended, Some(macroline::motion::RunEnd::ProgramEnd));
    planner
}

fn result(project: &Project, id: &str) -> f64 {
    project.design().readouts.iter().find(|row| row.id == id).unwrap().value
}

/// From when to when blocks cut.
fn cuts(project: &Project, planner: &Planner<Interp>) -> Vec<(f64, f64)> {
    let (files, timeline) = (project.written().files, planner.timeline());
    let taper = values(&[("path", "taper")]).get("path") == project.values.get("path");
    let (mut t, mut found) = (0.0, Vec::new());
    while let Some(from) = timeline.next_block(t) {
        t = from;
        let place = timeline.block_at(from).unwrap();
        let text = &files.0[place.file.0 as usize].text[place.span.start as usize..place.span.end as usize];
        if text.starts_with("N36 ") || taper && text.starts_with("N37 ") {
            found.push((from, timeline.next_block(from).unwrap_or(timeline.end())));
        }
    }
    found
}

#[test]
fn the_run_cuts_as_long_as_the_closed_form_says() {
    let limits = [("2500", "0"), ("60000", "0"), ("900", "700"), ("1200", "0")];
    for control in ["gsk-980tdc", "sinumerik-802d", "knd-k2000t"] {
        for path in PATHS {
            for (upper, lower) in limits {
                for mode in ["surface", "fixed"] {
                    let upper = if upper == "60000" && control == "gsk-980tdc" { "9999" } else { upper };
                    let changes = [
                        ("path", path),
                        ("upper-limit", upper),
                        ("lower-limit", lower),
                        ("speed-mode", mode),
                        ("depth", "7"),
                    ];
                    let project = ideal(control, &changes);
                    let planner = over_time(&project);
                    let took: f64 = cuts(&project, &planner).iter().map(|(from, to)| to - from).sum();
                    let asked = result(&project, "cutting-time");
                    assert!((took / asked - 1.0).abs() < 1e-4, "{control} {changes:?}: {took} for {asked}");
                }
            }
        }
    }
}

#[test]
fn the_surface_speed_is_held_wherever_nothing_binds() {
    for path in PATHS {
        let project = ideal("gsk-980tdc", &[("path", path), ("depth", "7")]);
        let planner = over_time(&project);
        let limit = result(&project, "limit-diameter");
        let x = project.control.axis(b'X').unwrap();
        let mut seen = 0;
        for (from, to) in cuts(&project, &planner) {
            for at in 1..200 {
                let now = planner.timeline().at(from + (to - from) * f64::from(at) / 200.0);
                let diameter = 2.0 * now.axes[x].position;
                if diameter > limit + 0.1 {
                    let speed = surface_speed(now.spindle.actual, diameter);
                    assert!((speed / 180.0 - 1.0).abs() < 1e-3, "{path} at {diameter}: {speed}");
                    seen += 1;
                }
            }
        }
        assert!(seen > 100, "{path}: {seen}");
    }
}

#[test]
fn the_programs() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/machines/turning-spindle");
    type Case = (&'static str, &'static str, &'static [(&'static str, &'static str)]);
    let cases: [Case; 7] = [
        ("sinumerik-802d", "facing", &[("keyway", "true"), ("keyway-angle", "90")]),
        ("sinumerik-802d", "taper", &[("path", "taper"), ("speed-mode", "fixed")]),
        ("gsk-980tdc", "facing", &[]),
        (
            "gsk-980tdc",
            "fixed",
            &[("path", "turning"), ("speed-mode", "fixed"), ("direction", "ccw"), ("customer", "ACME")],
        ),
        ("knd-k2000t", "taper", &[("path", "taper"), ("gear", "1")]),
        ("knd-k2000t", "one-stage", &[("path", "turning"), ("stage-2", "0")]),
        ("mitsubishi-e60", "turning", &[("path", "turning")]),
    ];
    for (control, name, changes) in cases {
        for file in project(control, changes).written().files.0 {
            expect_file![folder.join(control).join(name).join(&file.name)].assert_eq(&file.text);
        }
    }
}

#[test]
fn a_dropped_program_restores_the_form() {
    let changes = [("path", "taper"), ("cutting-speed", "95.5"), ("gear", "2"), ("output", "+-10"), ("product", "PIN")];
    for control in machine().controls() {
        let saved = project(control, &changes);
        let present = Project::of("ribbon-line", None).unwrap();
        for file in saved.written().files.0 {
            let opened = open::open(&present, &file.name, &file.text).project.unwrap();
            let written =
                |project: &Project| project.written().files.0.into_iter().map(|file| file.text).collect::<Vec<_>>();
            assert_eq!((opened.machine.id(), opened.control.id), ("turning-spindle", *control));
            assert_eq!(written(&opened), written(&saved));
            assert!(opened.edited.is_none());
        }
    }
}

/// Area of a closed path of straight lines.
fn area(path: &str) -> f64 {
    let numbers: Vec<f64> =
        path.split(['M', 'L', 'Z', ' ']).filter(|part| !part.is_empty()).map(|part| part.parse().unwrap()).collect();
    let points: Vec<&[f64]> = numbers.chunks(2).collect();
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>().abs() / 2.0
}

#[test]
fn the_part_is_cut_and_never_grows_again() {
    for (path, finished) in [("facing", "0"), ("facing", "20"), ("turning", "20"), ("taper", "20"), ("taper", "70")] {
        for depth in ["0.7", "3", "40"] {
            let project = ideal(
                "gsk-980tdc",
                &[("path", path), ("finished-diameter", finished), ("depth", depth), ("preread", "3")],
            );
            let planner = over_time(&project);
            let end = planner.timeline().end();
            let frame = Frame { step: 0.01, strobe: false };
            let outline = |t: f64| {
                let now = Samples::at(&planner, t);
                area(&machine().pose(&project.values, project.on(), &planner, &now, frame).paths[0].1)
            };
            let whole = outline(0.0);
            let mut left = whole;
            for at in 0..=2000 {
                let now = outline(end * f64::from(at) / 2000.0);
                assert!(now < left + 0.5, "{path} {finished} {depth}: {left} to {now} at {at}");
                left = now;
            }
            assert!(left < whole - 1.0, "{path}");
        }
    }
}

#[test]
fn what_the_design_says() {
    let said = |changes: &[(&str, &str)]| {
        let design = machine().design(&values(changes), &Origins::default(), project("gsk-980tdc", &[]).on());
        let verdicts = design.readouts.iter().filter(|row| row.verdict > Verdict::Ok).map(|row| {
            let advice: Vec<_> = row.advice.iter().map(|advice| sentence(Language::English, advice)).collect();
            format!("{:?} {}: {}\n", row.verdict, row.id, advice.join(" "))
        });
        let errors = design.diagnostics.iter().filter(|d| d.severity != Severity::Info);
        let errors = errors.map(|d| {
            format!("{:?} {}: {}\n", d.severity, d.field.unwrap_or(""), sentence(Language::English, &d.message))
        });
        verdicts.chain(errors).collect::<String>()
    };
    expect![[""]].assert_eq(&said(&[("spindle-ramp", "1")]));
    expect![[r#"
        Fail speed-smallest: The speed limit of 3500 r/min lies above the 3000 r/min of chuck and spindle: set it to 3000 or less.
        Warn acceleration-needed: The spindle would have to gain 3142 r/min each second, it can 1000: the surface speed lags behind near the limit. A lower cutting speed, feed or speed limit mends it.
    "#]].assert_eq(&said(&[("upper-limit", "3500"), ("finished-diameter", "0")]));
    expect![[r#"
        Error finished-diameter: The finished part reaches 80 mm, the stock has 80 mm: there is nothing to cut.
        Error start-x: The tool would start at 80 mm, inside the stock or its clearance: start at more than 84 mm.
    "#]]
    .assert_eq(&said(&[("finished-diameter", "80"), ("start-x", "80")]));
    expect![[r#"
        Warn limit-diameter: Below 57.296 mm the speed limit holds: the surface speed falls to 62.8 m/min, over 58 % of the diameter.
        Warn stage-speed: Stage 1 ends at 1000 r/min, below the speed limit of 2500 r/min: the surface speed falls from there on. Take a faster stage.
        Warn acceleration-needed: The spindle would have to gain 1164 r/min each second, it can 333: the surface speed lags behind near the limit. A lower cutting speed, feed or speed limit mends it.
        Fail power: The cut takes 12 kW, 6 kW reach it: cut at 90 m/min or less, or with less depth.
    "#]].assert_eq(&said(&[("cutting-force", "4000"), ("gear", "1"), ("feed", "2")]));
    expect![[r#"
        Warning lower-limit: The lower limit of 3000 r/min lies above the upper one of 2500 r/min: the upper one holds.
    "#]]
    .assert_eq(&said(&[("cutting-speed", "20"), ("lower-limit", "3000")]));
}
