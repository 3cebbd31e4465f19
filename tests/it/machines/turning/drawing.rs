//! The drawing of the turning spindle: true proportion, needles on their scales, jaws behind and in front of the part.

use super::{over_time, project};
use crate::machines::every_machine::drawn::{FRAME, Still, texts};
use macroline::controls::{Address, Control};
use macroline::drives::Bound;
use macroline::machines::Samples;
use macroline::math;
use macroline::motion::Snapshot;
use macroline::view::scene::Placement;
use macroline::view::{Node, Pose, Scene, Shape};

/// A control whose analog output can have a sign.
const CONTROL: &str = "knd-k2000t";

fn control() -> &'static Control {
    project(CONTROL, &[]).control
}

/// Numbers of groups and nodes.
const TURRET: u16 = 1;
const SPEED: u16 = 2;
const NEEDLE: u16 = 3;
const KNOB: u16 = 7;
const LENS: u16 = 8;
const CARRIAGE: u16 = 10;
const CROSS_SLIDE: u16 = 11;
const CHIPS: u16 = 12;
const PART: u16 = 0;
const FAR: u16 = 50;
const NEAR: u16 = 70;

/// A lathe with the tool at a radius and Z, and the spindle after some turns.
fn now(radius: f64, z: f64, turns: f64) -> Snapshot {
    let mut now = Snapshot::default();
    let axis = |letter: Address| control().axis(letter).unwrap();
    (now.axes[axis(Address::X)].actual, now.axes[axis(Address::Z)].actual, now.spindle.turns) = (radius, z, turns);
    now.spindle.stage = 1;
    now
}

fn drawn(changes: &[(&str, &str)], now: &Snapshot) -> (Scene, Pose) {
    let project = project(CONTROL, changes);
    let prepared = project.prepared();
    (prepared.scene(), prepared.pose(&Still(*now), now, FRAME))
}

fn placement(pose: &Pose, group: u16) -> Placement {
    *pose.placements.iter().find(|place| place.group == group).unwrap()
}

fn path(pose: &Pose, id: u16) -> &str {
    &pose.paths.iter().find(|(node, _)| *node == id).unwrap().1
}

/// Least and greatest number of the points of straight lines: along, across.
fn extent(path: &str) -> ((f64, f64), (f64, f64)) {
    let numbers: Vec<f64> =
        path.split(['M', 'L', 'Z', ' ']).filter(|part| !part.is_empty()).map(|part| part.parse().unwrap()).collect();
    let range = |offset: usize| {
        let all = numbers.iter().skip(offset).step_by(2);
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), n| (low.min(*n), high.max(*n)))
    };
    (range(0), range(1))
}

#[test]
fn part_and_tool_have_one_scale_at_any_size() {
    for (stock, length, start) in
        [("80", "60", "150"), ("3000", "10000", "5000"), ("1", "0.1", "3"), ("6", "400", "40")]
    {
        let diameter: f64 = stock.parse().unwrap();
        let changes = [
            ("path", "turning"),
            ("stock-diameter", stock),
            ("finished-diameter", "0.5"),
            ("length", length),
            ("start-x", start),
        ];
        let (scene, pose) = drawn(&changes, &now(0.5 * diameter, 0.0, 0.0));
        let ((left, face), (top, bottom)) = extent(path(&pose, PART));
        let scale = (bottom - top) / diameter;
        let at = placement(&pose, TURRET);
        let near = |a: f64, b: f64| assert!((a - b).abs() < 0.02, "{stock} x {length}: {a} for {b}");
        near(at.dx, face);
        near(at.dy, top);
        // Ten millimetres away from the part in both directions.
        let away = placement(&drawn(&changes, &now(0.5 * diameter + 10.0, 10.0, 0.0)).1, TURRET);
        assert!(((away.dx - at.dx) / (10.0 * scale) - 1.0).abs() < 0.02, "along {stock} x {length}");
        assert!(((at.dy - away.dy) / (10.0 * scale) - 1.0).abs() < 0.02, "across {stock} x {length}");
        assert!(left > scene.view[0] && face < scene.view[2], "{stock} x {length} leaves the view");
        assert!(face - left >= length.parse::<f64>().unwrap() * scale, "the length is hidden in the chuck");
    }
}

#[test]
fn needles_are_linear_on_their_scales() {
    let turn = |changes: &[(&str, &str)], speed: f64, volts: f64| {
        let mut now = now(50.0, 10.0, 0.0);
        (now.spindle.actual, now.spindle.volts) = (speed, volts);
        let pose = drawn(changes, &now).1;
        (placement(&pose, SPEED).turn, placement(&pose, NEEDLE).turn)
    };
    // 270 degrees for 3000 r/min, the stage that reaches most.
    for speed in [0.0, 600.0, 1500.0, 3000.0] {
        assert!((turn(&[], speed, 0.0).0 - (135.0 + 0.09 * speed)).abs() < 1e-9);
        assert_eq!(turn(&[], -speed, 0.0).0, turn(&[], speed, 0.0).0, "the dial has no direction");
    }
    assert_eq!(turn(&[], 0.0, 5.0).1, -90.0);
    assert_eq!(turn(&[], 0.0, 10.0).1 + turn(&[], 0.0, 0.0).1, -180.0);
    let bipolar = [("output", "+-10")];
    assert_eq!(turn(&bipolar, 0.0, 0.0).1, -90.0);
    assert_eq!(turn(&bipolar, 0.0, -10.0).1, turn(&[], 0.0, 0.0).1);
}

#[test]
fn near_jaws_paint_over_the_part_and_far_ones_do_not() {
    let (scene, _) = drawn(&[], &now(75.0, 100.0, 0.0));
    let place = |id: u16| scene.nodes.iter().position(|node| node.id == Some(id)).unwrap();
    assert!(place(FAR) < place(PART) && place(PART) < place(NEAR));
    for at in 0..24 {
        let turns = f64::from(at) / 24.0 + 0.01;
        let pose = drawn(&[], &now(75.0, 100.0, turns)).1;
        for jaw in 0..3 {
            let angle = core::f64::consts::TAU * (turns + f64::from(jaw) / 3.0);
            let shown = [FAR, NEAR].map(|layer| !path(&pose, layer + 4 * jaw).is_empty());
            // The top turns towards the operator.
            let is_near = math::sin(angle) > 0.0;
            assert_eq!(shown, [!is_near, is_near], "jaw {jaw} at {turns}");
        }
        // A third of a turn later every jaw is where the next one was.
        let later = drawn(&[], &now(75.0, 100.0, turns + 1.0 / 3.0)).1;
        let ends = |pose: &Pose| {
            let all =
                (0..3).map(|jaw| [FAR, NEAR].map(|layer| path(pose, layer + 4 * jaw + 1).len()).iter().sum::<usize>());
            let mut all: Vec<usize> = all.collect();
            all.sort_unstable();
            all
        };
        assert_eq!(ends(&pose), ends(&later));
    }
}

#[test]
fn lever_follows_the_gear_and_rests_while_it_shifts() {
    let knob = |stage: u8, bound: Bound| {
        let mut now = now(75.0, 100.0, 0.0);
        (now.spindle.stage, now.spindle.bound) = (stage, bound);
        let at = placement(&drawn(&[("stage-3", "4000"), ("stage-4", "5000")], &now).1, KNOB);
        (at.dx, at.dy)
    };
    let all = [1, 2, 3, 4].map(|stage| knob(stage, Bound::None));
    for (at, one) in all.iter().enumerate() {
        assert!(all[at + 1..].iter().all(|other| other != one), "stages share a slot");
    }
    assert_eq!(knob(3, Bound::Shift).1, 0.0);
}

#[test]
fn chips_fly_only_while_the_tool_cuts() {
    let project = project(CONTROL, &[]);
    let planner = over_time(&project);
    let end = planner.timeline().end();
    let chips = |t: f64| {
        let now = Samples::at(&planner, t);
        let pose = project.prepared().pose(&planner, &now, FRAME);
        (placement(&pose, CHIPS).opacity, 2.0 * now.axes[0].actual, path(&pose, 5).matches('M').count())
    };
    let moments: Vec<_> = (0..=400).map(|at| chips(end * f64::from(at) / 400.0)).collect();
    assert!(moments.iter().any(|(seen, ..)| *seen > 0.0));
    assert!(moments.iter().all(|(seen, diameter, _)| *seen == 0.0 || *diameter < 80.0), "a chip without stock");
    assert!(moments.windows(2).all(|pair| pair[0].2 <= pair[1].2), "the tray loses chips");
    assert_eq!((moments[0].2, moments[400].2), (0, 12));
}

#[test]
fn turret_covers_leaders_and_the_bed_covers_chips() {
    let (scene, _) = drawn(&[], &now(50.0, 10.0, 0.0));
    let place = |is: &dyn Fn(&Node) -> bool| scene.nodes.iter().position(is).unwrap();
    let last = |is: &dyn Fn(&Node) -> bool| scene.nodes.iter().rposition(is).unwrap();
    let turret = place(&|node| node.group == TURRET);
    let is_path = |node: &Node| matches!(node.shape, Shape::Path { .. });
    assert!(last(&|node| node.label > 0 && is_path(node)) < turret, "a leader lies on the turret");
    let ways = last(&|node| matches!(node.shape, Shape::Rect { w, .. } if w > scene.view[2]));
    assert!(last(&|node| (CHIPS..CHIPS + 7).contains(&node.group)) < ways, "chips fall before the bed");
}

#[test]
fn figures_of_the_instruments_stay_on_their_panel() {
    let mut now = now(50.0, 10.0, 0.0);
    (now.spindle.actual, now.spindle.volts) = (-12_345.0, -9.998);
    let (mut scene, pose) = drawn(&[("output", "+-10")], &now);
    // Labels keep their size on a small screen, the panel does not.
    for unit in [1.0, 1.3, 3.0] {
        scene.unit = unit;
        let on_panel =
            texts(&scene, &pose).into_iter().filter(|(text, _)| text.ends_with("r/min") || text.ends_with(" V"));
        let figures: Vec<_> = on_panel.filter(|(_, [_, top, ..])| *top < 216.0).collect();
        assert_eq!(figures.len(), 2, "{figures:?}");
        for (text, [left, top, right, bottom]) in &figures {
            assert!(
                *left > -6.0 && *right < 224.0 && *top > 160.0 && *bottom < 216.0,
                "{text} at {unit} units a pixel"
            );
        }
        assert!(figures[0].1[2] < figures[1].1[0], "{figures:?}");
    }
}

/// Areas of the rectangles of the slides, in the drawing.
fn slides(scene: &Scene, pose: &Pose) -> Vec<[f64; 4]> {
    let parts = scene.nodes.iter().filter_map(|node| match node.shape {
        Shape::Rect { x, y, w, h, .. } if [CARRIAGE, CROSS_SLIDE].contains(&node.group) => {
            Some((node.group, [x, y, w, h]))
        }
        _ => None,
    });
    let areas = parts.map(|(group, [x, y, w, h])| {
        let at = placement(pose, group);
        [x + at.dx, y + at.dy, x + w + at.dx, y + h + at.dy]
    });
    areas.collect()
}

fn overlap(a: [f64; 4], b: [f64; 4]) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

#[test]
fn slides_pass_beside_the_figures() {
    // At the start of the default, over the face, at the axis, and along the part in front of the jaws.
    for (path, at) in [
        ("facing", [(75.0, 100.0), (42.0, 2.0), (42.0, 0.0), (10.0, 0.0)]),
        ("turning", [(42.0, 10.0), (42.0, 2.0), (39.0, -30.0), (39.0, -60.0)]),
    ] {
        for (radius, z) in at {
            let (scene, pose) = drawn(&[("path", path)], &now(radius, z, 0.0));
            let slides = slides(&scene, &pose);
            assert_eq!(slides.len(), 2, "carriage and cross slide");
            // Dimensions belong to the part.
            let is_figure = |text: &str| !text.starts_with("Length") && !text.starts_with("Allowance");
            for (text, area) in texts(&scene, &pose).into_iter().filter(|(text, _)| is_figure(text)) {
                let met = slides.iter().find(|slide| overlap(**slide, area));
                assert_eq!(met, None, "{path}: the tool at {radius}, {z} lies on {text:?}");
            }
        }
    }
}

#[test]
fn lens_is_right_of_the_work_at_any_length() {
    for length in ["0.1", "60", "400", "10000"] {
        for tailstock in ["false", "true"] {
            let changes = [("path", "turning"), ("length", length), ("tailstock", tailstock)];
            let (scene, pose) = drawn(&changes, &now(40.0, 0.0, 0.0));
            let ((_, face), _) = extent(path(&pose, PART));
            let Some(Shape::Circle { r, .. }) = scene.groups[usize::from(LENS)].clip else { panic!("no lens") };
            let left = scene.groups[usize::from(LENS)].at.0 - r;
            assert!(left - face > 186.0, "{length} mm: the lens is {} from the face", left - face);
        }
    }
}

#[test]
fn sentence_about_the_speed_is_over_its_dial() {
    let mut now = now(50.0, 10.0, 0.0);
    now.spindle.bound = Bound::Upper;
    let (scene, pose) = drawn(&[], &now);
    let (_, [left, _, _, bottom]) =
        texts(&scene, &pose).into_iter().find(|(text, _)| text == "held by the upper limit").unwrap();
    let dial = scene.groups[usize::from(SPEED)].at;
    assert!(left < dial.0 && bottom < dial.1 - 45.0 && dial.1 - bottom < 100.0, "{left}, {bottom} for {dial:?}");
}
