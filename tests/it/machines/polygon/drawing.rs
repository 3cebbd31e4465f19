//! The drawing of the polygon lathe: true proportion, the deviation in its lens, a leader that leaves the disc free, blur and stillness.

use super::project;
use crate::machines::every_machine::drawn::{FRAME, Still, texts};
use crate::queries::value;
use macroline::controls::Address;
use macroline::machines::Frame;
use macroline::motion::Snapshot;
use macroline::project::Project;
use macroline::view::scene::Placement;
use macroline::view::{Paint, Pose, Scene, Shape};

/// Numbers of groups and nodes.
const WORK: u16 = 1;
const DISC: u16 = 2;
const INSERTS: u16 = 3;
const BLUR: u16 = 4;
const SIDE: u16 = 5;
const LENS: u16 = 11;
const RING: u16 = 27;
const TURNING_TOOL: u16 = 28;
const SIDE_CUTTER: u16 = 29;
const SECTION: u16 = 0;

/// Sizes from small to large: stock, across flats, tip radius, start of X.
const SIZES: [[&str; 4]; 6] = [
    ["25", "20", "45", "60"],
    ["1000", "500", "1", "1300"],
    ["0.6", "0.5", "1000", "3"],
    ["500", "450", "1000", "600"],
    ["2", "1.5", "1", "2000"],
    ["40", "38", "12", "41"],
];

fn sized([stock, flats, radius, start]: [&str; 4]) -> Project {
    project(&[("stock-diameter", stock), ("across-flats", flats), ("tip-radius", radius), ("start-x", start)])
}

/// The slide at a distance across flats and Z, work and tool at angles.
fn now(project: &Project, (across_flats, z): (f64, f64), (work, tool): (f64, f64)) -> Snapshot {
    let mut now = Snapshot::default();
    let axis = |letter: Address| project.control.axis(letter).unwrap();
    (now.axes[axis(Address::X)].actual, now.axes[axis(Address::Z)].actual) = (0.5 * across_flats, z);
    (now.pmc[0].actual, now.pmc[1].actual) = (work, tool);
    now
}

fn posed(project: &Project, now: &Snapshot, frame: Frame) -> Pose {
    project.prepared().pose(&Still(*now), now, frame)
}

fn placement(pose: &Pose, group: u16) -> Placement {
    *pose.placements.iter().find(|place| place.group == group).unwrap()
}

fn place(scene: &Scene, group: u16) -> (f64, f64) {
    scene.groups[usize::from(group)].at
}

/// Points of a path of straight lines.
fn points(path: &str) -> Vec<(f64, f64)> {
    let numbers: Vec<f64> =
        path.split(['M', 'L', 'Z', ' ']).filter(|part| !part.is_empty()).map(|part| part.parse().unwrap()).collect();
    numbers.chunks(2).map(|pair| (pair[0], pair[1])).collect()
}

/// Units per millimetre: the stock at rest is its radius high.
fn scale(pose: &Pose, stock: f64) -> f64 {
    let section = &pose.paths.iter().find(|(id, _)| *id == SECTION).unwrap().1;
    points(section).iter().map(|(x, _)| *x).fold(0.0, f64::max) / (0.5 * stock)
}

/// Circles of a group.
fn circles(scene: &Scene, group: u16) -> impl Iterator<Item = f64> {
    let nodes = scene.nodes.iter().filter(move |node| node.group == group);
    nodes.filter_map(|node| if let Shape::Circle { r, .. } = node.shape { Some(r) } else { None })
}

#[test]
fn distances_on_the_machine_have_one_scale_at_any_size() {
    for size in SIZES {
        let project = sized(size);
        let [stock, flats, radius, _] = size.map(|text| text.parse::<f64>().unwrap());
        let scene = project.prepared().scene();
        for away in [0.0, 0.3 * stock, 2.0 * stock] {
            let pose = posed(&project, &now(&project, (flats + away, 5.0), (0.0, 0.0)), FRAME);
            let (circle, disc) = (circles(&scene, DISC).fold(0.0, f64::max), placement(&pose, DISC));
            let units = circle / radius;
            let apart = place(&scene, DISC).0 + disc.dx - place(&scene, WORK).0;
            let exact = 0.5 * (flats + away) + radius;
            assert!((apart / units / exact - 1.0).abs() < 1e-9, "{size:?}: {} for {exact}", apart / units);
            assert!(
                (scale(&pose, stock) - units).abs() * 0.5 * stock < 0.011,
                "{size:?}: the section has another scale"
            );
        }
        let side = |at: (f64, f64)| placement(&posed(&project, &now(&project, at, (0.0, 0.0)), FRAME), SIDE);
        let (one, other) = (side((flats, 0.0)), side((flats + 4.0, 2.0)));
        // From above, half of the distance across flats has the scale of the length.
        assert!((one.dx, one.dy) == (0.0, 0.0) && (other.dx - other.dy).abs() < 1e-9, "{other:?}");
    }
}

#[test]
fn work_and_cutter_turn_by_the_angles_of_the_run() {
    let project = project(&[]);
    let pose = posed(&project, &now(&project, (20.0, 0.0), (30.0, 400.0)), FRAME);
    assert_eq!(placement(&pose, WORK).turn, -30.0);
    assert_eq!(placement(&pose, INSERTS).turn, -40.0);
    // The first insert points at the work as the tool starts.
    let scene = project.prepared().scene();
    let inserts = scene.nodes.iter().filter(|node| node.group == INSERTS && node.look.fill == Paint::Accent);
    let tips: Vec<_> =
        inserts.filter_map(|node| if let Shape::Path { d } = &node.shape { Some(points(d)) } else { None }).collect();
    let circle = circles(&scene, DISC).fold(0.0, f64::max);
    assert!((tips[0][0].0 + circle).abs() < 0.02 && tips[0][0].1.abs() < 0.02, "{tips:?}");
}

#[test]
fn lens_shows_the_deviation_of_the_results() {
    for changes in [&[][..], &[("shape", "hexagon"), ("stock-diameter", "24")], &[("tip-radius", "20")]] {
        let project = project(changes);
        let scene = project.prepared().scene();
        let stock = if changes.len() == 2 { 24.0 } else { 25.0 };
        let scale = scale(&posed(&project, &now(&project, (60.0, 30.0), (0.0, 0.0)), FRAME), stock);
        let inside = |node: &&macroline::view::Node| node.group == LENS;
        let side = scene.nodes.iter().filter(inside).find(|node| node.look.stroke == Paint::Ink).unwrap();
        let Shape::Path { d } = &side.shape else { panic!("no path") };
        let heights = points(d).into_iter().map(|(_, y)| y);
        let (top, bottom) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(t, b), y| (t.min(y), b.max(y)));
        let label = scene.nodes.iter().find_map(|node| match &node.shape {
            Shape::Text { text, .. } => text.strip_prefix('↕')?.split_once('×')?.0.parse::<f64>().ok(),
            _ => None,
        });
        let flatness = (bottom - top) / scale / label.unwrap();
        assert!((flatness / value(&project, "flatness") - 1.0).abs() < 0.02, "{changes:?}: {flatness}");
    }
}

#[test]
fn lens_leader_leaves_the_cutter_free() {
    for size in SIZES {
        let project = sized(size);
        let scene = project.prepared().scene();
        let (work, disc) = (place(&scene, WORK), place(&scene, DISC));
        let circle = circles(&scene, DISC).fold(0.0, f64::max);
        let ring = scene.nodes.iter().filter(|node| node.group == RING);
        let (mut centre, mut leader) = (None, None);
        for node in ring {
            match &node.shape {
                Shape::Circle { x, y, .. } => centre = Some((*x, *y)),
                Shape::Path { d } if node.look.stroke == Paint::Accent && d.contains("V46H") => leader = Some(d),
                _ => {}
            }
        }
        let (cut, level) = centre.unwrap();
        assert!(leader.unwrap().starts_with(&format!("M{}", (100.0 * cut).round() / 100.0)), "{leader:?}");
        // Where the tips pass nearest to the axis of the work.
        assert!(level == work.1 && (disc.0 - circle - cut).abs() < 1e-6, "{size:?}: the ring is beside the contact");
        assert!(disc.1 - circle > 46.0 && cut > work.0, "{size:?}: the cutter reaches the leader");
    }
}

#[test]
fn fast_cutter_blurs_and_a_slow_one_is_seen() {
    let project = project(&[]);
    let seen = |degrees: f64| {
        let mut now = now(&project, (20.0, 0.0), (0.0, 0.0));
        now.pmc[1].feed = degrees * 60.0;
        let pose = posed(&project, &now, Frame { step: 1.0, drawing_option: false });
        (placement(&pose, INSERTS).opacity, placement(&pose, BLUR).opacity)
    };
    // Two inserts: up to 30 degrees per frame.
    assert_eq!(seen(29.0), (1.0, 0.0));
    let (inserts, ring) = seen(50.0);
    assert!(inserts == 0.0 && ring > 0.0);
}

#[test]
fn slide_from_above_passes_beside_the_figures() {
    for (length, behind) in [("15", "0"), ("20", "40"), ("60", "0"), ("120", "30")] {
        let project = project(&[("length", length), ("from-face", behind)]);
        let scene = project.prepared().scene();
        let parts = || scene.nodes.iter().filter(|node| [SIDE, SIDE_CUTTER].contains(&node.group));
        let boxes: Vec<[f64; 4]> = parts()
            .filter_map(|node| match node.shape {
                Shape::Rect { x, y, w, h, .. } => Some([x, y, x + w, y + h]),
                _ => None,
            })
            .collect();
        assert!(boxes.len() > 1, "the slide has no boxes");
        let (x, y) = place(&scene, SIDE);
        let number = |text: &str| text.parse::<f64>().unwrap();
        let far = -number(length) - number(behind);
        // At the start, over the face, and along the polygon in the last pass.
        for (across, z) in [(60.0, 30.0), (29.0, 2.0), (20.0, 0.0), (20.0, 0.5 * far), (20.0, far), (29.0, far)] {
            let pose = posed(&project, &now(&project, (across, z), (0.0, 0.0)), FRAME);
            let moved = placement(&pose, SIDE);
            for (text, [left, top, right, bottom]) in texts(&scene, &pose) {
                let met = boxes.iter().find(|part| {
                    let [l, t, r, b] = [
                        part[0] + x + moved.dx,
                        part[1] + y + moved.dy,
                        part[2] + x + moved.dx,
                        part[3] + y + moved.dy,
                    ];
                    l < right && left < r && t < bottom && top < b
                });
                assert_eq!(met, None, "{length} mm at {behind} mm: the slide at {across}, {z} lies on {text:?}");
            }
        }
    }
}

#[test]
fn details_at_the_right_begin_in_few_columns() {
    let project = project(&[]);
    let scene = project.prepared().scene();
    let pose = posed(&project, &now(&project, (60.0, 30.0), (0.0, 0.0)), FRAME);
    let middle = 622.0;
    let starts = scene.nodes.iter().filter_map(|node| match &node.shape {
        Shape::Text { x, anchor, .. } if *x > middle && node.group == 0 => Some((*anchor, *x)),
        _ => None,
    });
    let (mut columns, mut others) = (std::collections::BTreeSet::new(), Vec::new());
    for (anchor, x) in starts {
        match anchor {
            macroline::view::Anchor::Start => drop(columns.insert(x as u32)),
            macroline::view::Anchor::End => others.push(x),
            macroline::view::Anchor::Middle => {}
        }
    }
    // Two columns, the pass between them, and the figures behind their arrows; the start is at the right edge.
    assert_eq!(columns.len(), 4, "{columns:?}");
    assert!(others.iter().all(|x| *x == 1008.0), "{others:?}");
    // The state is below the angle that it is about.
    let text = |wanted: &str| texts(&scene, &pose).into_iter().find(|(text, _)| text == wanted).unwrap().1;
    let (angle, state) = (text("0.00°"), text("stands"));
    assert!(state[0] == angle[0] && state[1] > angle[3], "{angle:?} {state:?}");
}

#[test]
fn turning_tool_takes_the_place_of_the_cutter_at_an_end() {
    let project = Project::named("polygon-lathe", None, Some("threaded-shaft")).unwrap();
    let mut turning = now(&project, (23.0, -5.0), (30.0, 0.0));
    (turning.spindle.actual, turning.spindle.turns) = (800.0, 12.25);
    let opacity = |pose: &Pose, group: u16| placement(pose, group).opacity;
    let pose = posed(&project, &turning, FRAME);
    assert_eq!([DISC, RING, TURNING_TOOL].map(|group| opacity(&pose, group)), [0.0, 0.0, 1.0]);
    // The tip is 1.5 mm from where those of the cutter finish a square of 20 mm; the work turns by the spindle too.
    let scale = placement(&pose, TURNING_TOOL).dx / 1.5;
    assert!((placement(&pose, WORK).turn - -120.0).abs() < 1e-9 && scale > 1.0);
    assert!(pose.texts.iter().any(|(_, text)| text == "800.0 r/min"), "{:?}", pose.texts);
    // The cutter comes back with its own drives, and the work then has their angle.
    turning.spindle.actual = 0.0;
    let pose = posed(&project, &turning, FRAME);
    assert_eq!([DISC, RING, TURNING_TOOL].map(|group| opacity(&pose, group)), [1.0, 1.0, 0.0]);
    assert!((placement(&pose, WORK).turn - -30.0).abs() < 1e-9);
}
