//! Drawings for any form: labels beside each other and within the view, poses that change existing parts only.

use std::collections::BTreeSet;

use super::sweep::{changes, forms};
use macroline::drives::Bound;
use macroline::machines::{self, Executions, Frame, Samples};
use macroline::motion::{Snapshot, Visit};
use macroline::project::Project;
use macroline::view::drawing::crosses;
use macroline::view::scene::{LETTER, LINE};
use macroline::view::{Font, Pose, Scene, Shape};

/// A run at one constant moment.
pub(in crate::machines) struct Still(pub(in crate::machines) Snapshot);

impl Samples for Still {
    fn at(&self, _: f64) -> Snapshot {
        self.0
    }

    fn executions(&self, _: u32, _: f64) -> Executions {
        Executions::default()
    }

    fn execution_spans(&self, _: u32, _: f64) -> Vec<(f64, f64)> {
        Vec::new()
    }

    fn visits(&self, _: [(usize, f64); 2], _: f64) -> Vec<Visit> {
        Vec::new()
    }
}

pub(in crate::machines) const FRAME: Frame = Frame { step: 0.001, drawing_option: false };

/// At rest, and with the longest figures.
fn moments() -> [Snapshot; 2] {
    let mut far = Snapshot { t: 3.3, ..Snapshot::default() };
    for axis in &mut far.axes {
        axis.actual = -2999.9996;
    }
    for axis in &mut far.pmc {
        (axis.actual, axis.feed) = (123_456.789, -20_000.0 * 360.0);
    }
    far.spindle.actual = -60_000.0;
    far.spindle.volts = -9.998;
    far.spindle.angle = 359.9;
    far.spindle.stage = 4;
    far.spindle.held = true;
    far.spindle.bound = Bound::GearLow;
    [Snapshot::default(), far]
}

/// A text with the box that its letters take: left, top, right, bottom.
pub(in crate::machines) type TextBox = (String, [f64; 4]);

/// The texts of a drawing in a pose.
pub(in crate::machines) fn texts(scene: &Scene, pose: &Pose) -> Vec<TextBox> {
    let mut boxes = Vec::new();
    for node in &scene.nodes {
        let Shape::Text { x, y, anchor, text, line, font } = &node.shape else { continue };
        let posed = pose.texts.iter().find(|(id, _)| Some(*id) == node.id).map(|(_, text)| text);
        let text = posed.unwrap_or(text);
        let (mut x, mut y, mut scale) = (*x, *y, 1.0);
        let mut group = node.group;
        while group != 0 {
            let (place, at) = (&scene.groups[usize::from(group)], pose.placements.iter().find(|p| p.group == group));
            x = x * place.scale + place.at.0 + at.map_or(0.0, |p| p.dx);
            y = y * place.scale + place.at.1 + at.map_or(0.0, |p| p.dy);
            (group, scale) = (place.parent, scale * place.scale);
        }
        let size = match font {
            Font::Engraved(size) => size * scale,
            _ => LETTER * scene.unit * scale,
        };
        let width = 0.6 * size * text.chars().count() as f64;
        y += line * LINE * size;
        let left = anchor.left(x, width);
        if !text.is_empty() {
            boxes.push((text.clone(), [left, y - 0.75 * size, left + width, y + 0.2 * size]));
        }
    }
    boxes
}

/// Texts that overlap or leave the view.
pub(super) fn crowded(scene: &Scene, pose: &Pose) -> Vec<String> {
    let texts = texts(scene, pose);
    let [left, top, width, height] = scene.view;
    let mut faults = Vec::new();
    for (at, (text, a)) in texts.iter().enumerate() {
        if a[0] < left || a[1] < top || a[2] > left + width || a[3] > top + height {
            faults.push(format!("{text:?} leaves the view: {a:.0?}"));
        }
        for (other, b) in &texts[at + 1..] {
            if a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3] {
                faults.push(format!("{text:?} {a:.0?} lies on {other:?} {b:.0?}"));
            }
        }
    }
    faults
}

/// Node and group numbers of a pose that the scene lacks, and invalid paths.
pub(super) fn lost(scene: &Scene, pose: &Pose) -> Vec<String> {
    let mut faults = Vec::new();
    let ids: Vec<u16> = scene.nodes.iter().filter_map(|node| node.id).collect();
    if ids.iter().collect::<BTreeSet<_>>().len() != ids.len() {
        faults.push("two nodes with one number".to_owned());
    }
    for (id, d) in &pose.paths {
        if !scene.node(*id).is_some_and(|node| matches!(node.shape, Shape::Path { .. })) {
            faults.push(format!("no path {id}"));
        }
        if ["NaN", "inf", "∞"].iter().any(|word| d.contains(word)) {
            faults.push(format!("path {id} is {d}"));
        }
    }
    for (id, _) in &pose.texts {
        if !scene.node(*id).is_some_and(|node| matches!(node.shape, Shape::Text { .. })) {
            faults.push(format!("no text {id}"));
        }
    }
    for place in &pose.placements {
        let numbers = [place.turn, place.dx, place.dy, place.size.0, place.size.1];
        if !scene.nodes.iter().any(|node| node.group == place.group) && usize::from(place.group) >= scene.groups.len() {
            faults.push(format!("no group {}", place.group));
        }
        if !numbers.iter().all(|number| number.is_finite()) || !(0.0..=1.0).contains(&place.opacity) {
            faults.push(format!("{place:?}"));
        }
    }
    faults
}

/// Faults of a drawing: leaders that cross the text of another label, and groups that are visible at rest although the pose at rest hides them.
fn crossed(scene: &Scene, pose: &Pose) -> Vec<String> {
    let texts = texts(scene, pose);
    let mut faults = Vec::new();
    let still = scene.nodes.iter().filter(|node| node.group == 0 && node.label > 0);
    for leader in still {
        let Shape::Path { d } = &leader.shape else { continue };
        let points: Vec<f64> = d.split(['M', 'L', ' ']).filter_map(|number| number.parse().ok()).collect();
        let [x0, y0, x1, y1] = points[..] else { continue };
        let own: Vec<&str> = scene
            .nodes
            .iter()
            .filter(|node| node.label == leader.label)
            .filter_map(|node| match &node.shape {
                Shape::Text { text, .. } => {
                    let posed = pose.texts.iter().find(|(id, _)| Some(*id) == node.id).map(|(_, text)| text);
                    Some(posed.unwrap_or(text).as_str())
                }
                _ => None,
            })
            .collect();
        let other = texts.iter().filter(|(text, _)| !own.contains(&text.as_str()));
        let met = other.filter(|(_, area)| crosses((x0, y0), (x1, y1), *area));
        faults.extend(met.map(|(text, _)| format!("the leader of {own:?} crosses {text:?}")));
    }
    let unseen = pose.placements.iter().filter(|place| place.opacity == 0.0);
    faults.extend(
        unseen
            .filter(|place| !scene.groups[usize::from(place.group)].hidden)
            .map(|place| format!("{place:?} is seen at rest")),
    );
    faults
}

#[test]
fn labels_never_overlap_and_poses_fit_any_form() {
    let mut found: Vec<String> = Vec::new();
    for machine in machines::ALL {
        for control in machine.controls() {
            for project in forms(*machine, control) {
                let prepared = project.prepared();
                let scene = prepared.scene();
                for now in moments() {
                    let pose = prepared.pose(&Still(now), &now, FRAME);
                    let mut faults = lost(&scene, &pose);
                    if now.t == 0.0 {
                        faults.extend(crossed(&scene, &pose));
                    }
                    if scene.unit > 0.0 {
                        faults.extend(crowded(&scene, &pose));
                    }
                    let about = || format!("{} on {control},{}", machine.id(), changes(&project));
                    found.extend(faults.into_iter().map(|fault| format!("{fault}\n    {}", about())));
                }
            }
        }
    }
    assert!(found.is_empty(), "{} faults:\n{}", found.len(), found[..found.len().min(90)].join("\n"));
}

#[test]
fn every_leader_of_the_examples_ends_within_the_view() {
    for machine in machines::ALL {
        for example in machine.examples() {
            let scene = Project::named(machine.id(), None, Some(example.id)).unwrap().prepared().scene();
            let [left, top, width, height] = scene.view;
            let still = scene.nodes.iter().filter(|node| node.group == 0 && node.label > 0 && node.id.is_none());
            let mut leaders = 0;
            for leader in still {
                let Shape::Path { d } = &leader.shape else { continue };
                let mut own = scene.nodes.iter().filter(|node| node.label == leader.label);
                let name = own.find(|node| matches!(node.shape, Shape::Text { .. }));
                let about = || format!("{} {}: {d:?} from {name:?}", machine.id(), example.id);
                let points: Vec<f64> = d.split(['M', 'L', ' ']).filter_map(|number| number.parse().ok()).collect();
                let [x0, y0, x1, y1] = points[..] else { panic!("{}", about()) };
                let inside = (left..=left + width).contains(&x1) && (top..=top + height).contains(&y1);
                assert!(inside && (x0, y0) != (x1, y1), "{}", about());
                leaders += 1;
            }
            assert!(leaders > 0, "{} {}", machine.id(), example.id);
        }
    }
}

/// The page shows this drawing before its module is loaded. `UPDATE_EXPECT=1` draws it again.
#[test]
fn still_in_the_page_equals_the_drawing() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("style/still.svg");
    expect_test::expect_file![path].assert_eq(&macroline::project::drawing::still().unwrap());
}

/// Area of a closed path of straight lines.
pub(in crate::machines) fn area(path: &str) -> f64 {
    let numbers: Vec<f64> =
        path.split(['M', 'L', 'Z', ' ']).filter(|part| !part.is_empty()).map(|part| part.parse().unwrap()).collect();
    let points: Vec<&[f64]> = numbers.chunks(2).collect();
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>().abs() / 2.0
}
