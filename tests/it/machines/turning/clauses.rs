//! Clauses of the makers' pages in the turning spindle's program: speed limits, positioning, keyway.

use std::rc::Rc;

use expect_test::expect;
use macroline::motion::{Budget, Panel, Planner, Retention};
use macroline::nc::{self, Files};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::text::Severity;
use macroline::text::catalog::sentence;

use super::{ideal, over_time, project, run_set, sheet};
use crate::queries::value;

/// The control with words for limits and angles, and its sister.
const NAMED: [&str; 2] = ["sinumerik-802d", "sinumerik-808d"];

/// The text of all programs of a project.
fn text(project: &Project) -> String {
    project.written().files.0.iter().map(|file| file.text.as_str()).collect()
}

/// Largest commanded speed without sign of a run.
fn top<P: macroline::motion::RunningProgram>(planner: &Planner<P>) -> f64 {
    let end = planner.timeline().end();
    (0..=2000).map(|k| planner.timeline().at(end * f64::from(k) / 2000.0).spindle.command.abs()).fold(0.0, f64::max)
}

#[test]
fn program_limits_the_speed_by_the_machine_data() {
    for control in NAMED {
        let limited = text(&project(control, &[("chuck-limit", "2200"), ("lower-limit", "40")]));
        for line in ["G26 S=R16", "G25 S=R17"] {
            // Each in a block of its own.
            assert!(limited.lines().any(|written| written.trim_start_matches(|c| c != 'G') == line), "{limited}");
        }
        assert!(limited.contains("R115=2200 ") && limited.contains("R116=40 "), "{limited}");
        let alone = text(&project(control, &[("chuck-limit", "2200")]));
        // A lowest speed of 0 replaces that of the part before.
        assert!(alone.contains("G26 S=R16") && alone.contains("G25 S=R17") && alone.contains("R116=0 "), "{alone}");
        // The operator lowers the limit of the chuck for an unbalanced part.
        let part = ideal(control, &[("upper-limit", "1500")]);
        let mut planner = run_set(&part, 115, 900.0);
        planner.advance(f64::INFINITY, usize::MAX);
        assert!((top(&over_time(&part)) - 1500.0).abs() < 1e-9 && (top(&planner) - 900.0).abs() < 1e-9);
    }
    for control in ["gsk-980tdc", "knd-k2000t", "fanuc-0i-tf", "mitsubishi-e60"] {
        let written = text(&project(control, &[("lower-limit", "40")]));
        assert!(!written.contains("G26") && !written.contains("G25"), "{control}");
    }
}

#[test]
fn machine_data_say_how_the_spindle_comes_to_its_angle() {
    // From power-on: greatest speeds clockwise and counter-clockwise, and the turns, which go over the zero mark.
    let travel = |changes: &[(&str, &str)]| {
        let machine = project("sinumerik-802d", &[&[("keyway", "true")], changes].concat());
        let parsed = nc::parse(&Files::one("SPOS.MPF", "%_N_SPOS_MPF\nSPOS=90\nM0\n"), machine.control);
        let options = RunOptions {
            start: None,
            settings: &[],
            limits: Budget { blocks: 100, seconds: 600.0 },
            keep: Retention::Timeline,
        };
        let mut run = run::of_programs(Rc::new(parsed), Some(&machine), Panel::default(), &options);
        run.advance(600.0, 1000);
        let timeline = run.timeline();
        let speeds = || (0..=5000).map(|k| timeline.at(timeline.end() * f64::from(k) / 5000.0).spindle.actual.round());
        let turns = timeline.at(timeline.end()).spindle.turns;
        (speeds().fold(0.0, f64::max), speeds().fold(0.0, f64::min), turns)
    };
    assert_eq!(travel(&[]), (100.0, 0.0, 1.25));
    assert_eq!(travel(&[("positioning-speed", "40")]), (40.0, 0.0, 1.25));
    assert_eq!(travel(&[("positioning-direction", "ccw")]), (0.0, -100.0, -1.75));
    // At 50 r/min per second the angle is too short for 100 r/min.
    assert!(travel(&[("positioning-acceleration", "50")]).0 < 70.0);
    let rows = |changes: &[(&str, &str)]| {
        let sheet = sheet("sinumerik-802d", &[&[("keyway", "true")], changes].concat());
        let data = ["MD35210", "MD35300", "MD35350"];
        sheet.lines().filter(|line| data.iter().any(|row| line.starts_with(row))).collect::<Vec<_>>().join("\n")
    };
    expect![[r#"
        MD35210 GEAR_STEP_POSCTRL_ACCEL 8.333 rev/s² Sister
        MD35300 SPIND_POSCTRL_VELO 100 r/min Sister
        MD35350 SPIND_POSITIONING_DIR 3 Open"#]]
    .assert_eq(&rows(&[]));
    let changed = [("positioning-acceleration", "600"), ("positioning-speed", "40"), ("positioning-direction", "ccw")];
    expect![[r#"
        MD35210 GEAR_STEP_POSCTRL_ACCEL 10 rev/s² Sister
        MD35300 SPIND_POSCTRL_VELO 40 r/min Sister
        MD35350 SPIND_POSITIONING_DIR 4 Open"#]]
    .assert_eq(&rows(&changed));
}

/// A shaft with a keyway 14 mm wide and 5.5 mm deep, from 5 to 55 mm from the face.
fn shaft(changes: &[(&str, &str)]) -> Project {
    let all = [
        ("path", "turning"),
        ("stock-diameter", "60"),
        ("finished-diameter", "50"),
        ("length", "80"),
        ("depth", "5"),
        ("keyway", "true"),
        ("keyway-angle", "90"),
        ("lock-code", "81"),
        ("release-code", "82"),
        ("driven-tool", "true"),
        ("keyway-width", "14"),
        ("keyway-depth", "5.5"),
        ("keyway-length", "50"),
    ];
    ideal("sinumerik-802d", &[&all, changes].concat())
}

/// Findings of form and run, by id.
fn finding_ids(project: &Project) -> Vec<&'static str> {
    let mut run = run_set(project, 113, 90.0);
    run.advance(f64::INFINITY, usize::MAX);
    let design = project.prepared().results().diagnostics;
    let all = design.iter().chain(run.diagnostics()).filter(|finding| finding.severity != Severity::Info);
    all.map(|finding| finding.message.id).collect()
}

#[test]
fn driven_tool_cuts_the_keyway_at_the_locked_angle() {
    let project = shaft(&[]);
    assert_eq!(finding_ids(&project), [""; 0]);
    let planner = over_time(&project);
    let at = |number: u32| {
        let (timeline, block) = (planner.timeline(), planner.program().numbered(number).unwrap());
        let mut t = 0.0;
        while timeline.block_at(t) != Some(block) {
            t = timeline.next_block(t).unwrap();
        }
        t
    };
    // Infeed at 50 mm/min from the clearance, 36 mm along at 100 mm/min, and out.
    let (plunge, along, out) = (at(60), at(61), at(62));
    let (cut, formula) = (out - plunge, 60.0 * (7.5 / 50.0 + 36.0 / 100.0));
    assert!((cut - formula).abs() < 0.05, "{cut} {formula}");
    assert!((value(&project, "keyway-time") - formula).abs() < 1e-9);
    let place = |t: f64| planner.timeline().at(t).axes.map(|axis| axis.position);
    let near = |t: f64, x: f64, z: f64| {
        let [across, z_at] = [place(t)[0], place(t)[2]];
        assert!((across - x).abs() < 1e-3 && (z_at - z).abs() < 1e-3, "{t}: {across} {z_at}, not {x} {z}");
    };
    near(plunge, 27.0, -12.0);
    near(along, 19.5, -12.0);
    near(out, 19.5, -48.0);
    for t in [plunge, along, out] {
        let spindle = planner.timeline().at(t).spindle;
        assert!(spindle.held && (spindle.angle - 90.0).abs() < 1e-9);
    }
    let end = place(planner.timeline().end());
    assert!((end[0] - 75.0).abs() < 1e-6 && (end[2] - 100.0).abs() < 1e-6);
}

#[test]
fn keyway_without_means_stops_with_its_reason() {
    let no_tool = shaft(&[("driven-tool", "false")]);
    assert!(text(&no_tool).contains("M0 ;NO DRIVEN TOOL TO CUT THE KEYWAY"));
    assert_eq!(finding_ids(&no_tool), ["turning.keyway-no-tool"]);
    // Projects before the keyway had a depth.
    let no_depth = shaft(&[("keyway-depth", "0")]);
    assert!(text(&no_depth).contains("M0 ;NO DEPTH OF THE KEYWAY IS GIVEN") && !text(&no_depth).contains("T2"));
    assert_eq!(finding_ids(&no_depth), ["turning.keyway-no-depth"]);
    let taper = shaft(&[("path", "taper"), ("large-diameter", "55")]);
    assert!(text(&taper).contains("M0 ;NO KEYWAY ON A TAPER"));
    assert_eq!(finding_ids(&taper), ["turning.keyway-on-taper"]);
    // Without a code that locks, a person does.
    let by_hand = shaft(&[("lock-code", "0"), ("release-code", "0")]);
    assert!(text(&by_hand).contains("N54 M0 ;LOCK THE SPINDLE BY HAND"));
    // A control that cannot position the spindle has none of it.
    let lathe = project("gsk-980tdc", &[("keyway", "true"), ("driven-tool", "true"), ("keyway-depth", "4")]);
    assert!(
        !text(&lathe).contains("T0202")
            && lathe.prepared().results().diagnostics.iter().all(|d| d.message.id != "turning.keyway-no-tool")
    );
}

#[test]
fn keyway_that_cannot_be_cut_is_an_error() {
    let errors = |changes: &[(&str, &str)]| {
        let found = shaft(changes).prepared().results().diagnostics;
        let errors = found.iter().filter(|finding| finding.severity == Severity::Error);
        errors.map(|finding| finding.message.id).collect::<Vec<_>>()
    };
    assert_eq!(errors(&[]), [""; 0]);
    assert_eq!(errors(&[("keyway-depth", "25")]), ["turning.keyway-too-deep"]);
    assert_eq!(errors(&[("keyway-length", "13")]), ["turning.keyway-too-short"]);
    assert_eq!(errors(&[("keyway-length", "76")]), ["turning.keyway-beyond-shoulder"]);
    assert_eq!(errors(&[("release-code", "3")]), ["turning.lock-is-taken"]);
    assert_eq!(errors(&[("release-code", "100")]), ["turning.code-without-bit"], "the PLC has bits up to M99");
    assert_eq!(finding_ids(&shaft(&[("release-code", "0")])), ["turning.keyway-stays-locked"]);
    assert_eq!(finding_ids(&shaft(&[("keyway-width", "4")])), ["turning.keyway-deeper-than-wide"]);
    // The builder's own codes start and stop the tool.
    let own = shaft(&[("driven-code", "24"), ("driven-stop", "25")]);
    assert!(text(&own).contains("S2=R22 M24") && text(&own).contains("N65 M25"));
    assert_eq!(finding_ids(&own), [""; 0]);
}

#[test]
fn keyway_grows_in_the_drawing_while_it_is_cut() {
    let project = shaft(&[]);
    let planner = over_time(&project);
    let prepared = project.prepared();
    let frame = macroline::machines::Frame { step: 0.02, drawing_option: false };
    // Node 21: the corners of the groove.
    let groove = |t: f64| {
        let pose = prepared.pose(&planner, &planner.timeline().at(t), frame);
        pose.paths.iter().find(|(node, _)| *node == 21).map(|(_, path)| path.clone()).unwrap()
    };
    let end = planner.timeline().end();
    let shapes: Vec<String> = (0..400).map(|k| groove(end * f64::from(k) / 400.0)).collect();
    assert!(shapes[0].is_empty() && !shapes[399].is_empty());
    let changes = shapes.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!(changes > 20, "{changes}");
}

#[test]
fn driven_tool_is_drawn_while_it_has_the_work() {
    let project = shaft(&[]);
    let planner = over_time(&project);
    let prepared = project.prepared();
    let frame = macroline::machines::Frame { step: 0.02, drawing_option: false };
    // Groups 20 and 21: the turning tool and the driven tool, of which one is there at each moment.
    let end = planner.timeline().end();
    let moments: Vec<(bool, bool)> = (0..=800)
        .map(|k| {
            let now = planner.timeline().at(end * f64::from(k) / 800.0);
            let pose = prepared.pose(&planner, &now, frame);
            let shown = |group: u16| pose.placements.iter().any(|place| place.group == group && place.opacity == 1.0);
            assert_ne!(shown(20), shown(21), "{}", now.t);
            let mills =
                prepared.activity(&planner, &now).is_some_and(|message| sentence(&message) == "Milling the keyway");
            // It mills only while it is there, with the spindle at rest.
            assert!(!mills || shown(21) && now.spindle.actual == 0.0, "{}", now.t);
            (shown(21), mills)
        })
        .collect();
    let changes = moments.windows(2).filter(|pair| pair[0].0 != pair[1].0).count();
    let milled = moments.iter().filter(|(_, mills)| *mills).count();
    assert!(changes == 1 && milled > 50, "{changes} {milled}");
}

#[test]
fn entries_that_cut_too_deep_or_too_far_are_refused() {
    for control in super::machine().controls() {
        for (path, number, value, wanted) in [
            ("turning", 103, 0.0, "MUST BE ABOVE ZERO"),
            ("turning", 103, -5.0, "MUST BE ABOVE ZERO"),
            ("taper", 103, -1.0, "MUST NOT BE BELOW ZERO"),
            ("turning", 105, 500.0, "IS MORE THAN"),
            ("facing", 114, 500.0, "IS MORE THAN"),
            ("facing", 103, -50.0, "IS FAR BEHIND THE CENTRE"),
            ("turning", 111, 20.0, "IS NOT ABOVE"),
        ] {
            let mut planner = run_set(&project(control, &[("path", path), ("depth", "5")]), number, value);
            let before = planner.timeline().words_at(0.0);
            let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
            let message = planner.timeline().message_at(planner.timeline().end()).unwrap_or_default();
            let ending = format!("{ended:?} {message}");
            assert!(ending.contains(wanted), "{control} {path} {number}: {ending}");
            assert_eq!(before, planner.timeline().words_at(planner.timeline().end()), "{control} {path}: it moved");
        }
    }
}
