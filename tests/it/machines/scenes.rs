//! The drawings of all machines, at any values of their forms: labels have room, poses move existing parts only.

use macroline::machines::form::Value;
use macroline::machines::{self, AnyMachine, Frame, Samples};
use macroline::motion::{Budget, Retention};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::view::scene::{LETTER, LINE};
use macroline::view::{Font, Node, Pose, Scene, Shape, Theme, svg};

use super::sweep::ends;

const OPTIONS: RunOptions =
    RunOptions { start: None, settings: &[], limits: Budget { blocks: 400, seconds: 12.0 }, keep: Retention::Timeline };

/// Width of a letter over its height, on the safe side for letters that are no figures.
const WIDTH: f64 = 0.6;

/// A label with its box.
struct Label {
    text: String,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

/// Origin and scale of a group in the drawing, at rest.
fn origin(scene: &Scene, group: u16) -> ((f64, f64), f64) {
    if group == 0 {
        return ((0.0, 0.0), 1.0);
    }
    let own = &scene.groups[usize::from(group)];
    let ((x, y), scale) = origin(scene, own.parent);
    ((x + own.at.0 * scale, y + own.at.1 * scale), scale * own.scale)
}

/// The label that a node is in a pose.
fn label(scene: &Scene, pose: &Pose, node: &Node) -> Option<Label> {
    let Shape::Text { x, y, anchor, text, line, font } = &node.shape else { return None };
    if matches!(font, Font::Engraved(_)) {
        return None;
    }
    let posed = pose.texts.iter().find(|(id, _)| node.id == Some(*id)).map(|(_, text)| text);
    let text = posed.unwrap_or(text).clone();
    let ((gx, gy), scale) = origin(scene, node.group);
    assert_eq!(scale, 1.0, "“{text}” is in a scaled group, which would scale its letters");
    let letter = LETTER * scene.unit;
    let wide = WIDTH * letter * text.chars().count() as f64;
    let left = gx + x
        - match *anchor {
            "end" => wide,
            "middle" => 0.5 * wide,
            _ => 0.0,
        };
    let base = gy + y + line * LINE * letter;
    let label = Label { text, left, right: left + wide, top: base - 0.8 * letter, bottom: base + 0.2 * letter };
    (!label.text.is_empty()).then_some(label)
}

/// Faults of the labels of a scene in a pose: two in one place, or one that is cut off.
fn crowded(scene: &Scene, pose: &Pose) -> Vec<String> {
    let labels: Vec<Label> = scene.nodes.iter().filter_map(|node| label(scene, pose, node)).collect();
    let [left, top, width, height] = scene.view;
    let mut found = Vec::new();
    for (at, a) in labels.iter().enumerate() {
        if a.left < left || a.top < top || a.right > left + width || a.bottom > top + height {
            found.push(format!("“{}” is cut off", a.text));
        }
        for b in &labels[at + 1..] {
            if a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom {
                found.push(format!("“{}” over “{}”", a.text, b.text));
            }
        }
    }
    found
}

/// Faults of a pose: groups and nodes that the scene lacks, numbers that are not finite.
fn lost(scene: &Scene, pose: &Pose) -> Vec<String> {
    let mut found = Vec::new();
    for place in &pose.placements {
        let there = scene.groups.get(usize::from(place.group)).is_some();
        let numbers = [place.turn, place.cx, place.cy, place.dx, place.dy, place.size.0, place.size.1];
        if !there || numbers.iter().any(|number| !number.is_finite()) || !(0.0..=1.0).contains(&place.opacity) {
            found.push(format!("{place:?}"));
        }
    }
    let is = |id: u16, kind: fn(&Shape) -> bool| scene.node(id).is_some_and(|node| kind(&node.shape));
    // A machine whose lens has no smear has no node for it.
    let path = |shape: &Shape| matches!(shape, Shape::Path { .. });
    found.extend(
        pose.paths
            .iter()
            .filter(|(id, _)| scene.node(*id).is_some() && !is(*id, path))
            .map(|(id, _)| format!("{id} is no path")),
    );
    let text = |shape: &Shape| matches!(shape, Shape::Text { .. });
    found.extend(pose.texts.iter().filter(|(id, _)| !is(*id, text)).map(|(id, _)| format!("{id} is no text")));
    found
}

/// Faults of the drawing of a project, at the start of its run and later.
fn faults(project: &Project) -> Vec<String> {
    let machine = project.prepared();
    let scene = machine.scene();
    let mut run = run::of_project(project, &project.written(), &OPTIONS);
    run.advance(OPTIONS.limits.seconds, usize::MAX);
    let end = run.timeline().end();
    let mut found = Vec::new();
    for (share, option) in [(0.0, false), (0.4, true), (0.9, false)] {
        let pose = machine.pose(&run, &Samples::at(&run, end * share), Frame { step: 0.004, option });
        found.extend(lost(&scene, &pose));
        // Drawings that give no size of their letters are scaled with them.
        if scene.unit > 0.0 {
            found.extend(crowded(&scene, &pose));
        }
        let picture = svg::picture(&scene, &pose, Theme::Light);
        found.extend(
            ["NaN", "inf", "∞", "fill=\"\"", "stroke=\"\""]
                .into_iter()
                .filter(|bad| picture.contains(bad))
                .map(str::to_owned),
        );
    }
    found.sort();
    found.dedup();
    found
}

/// The default project, and one for each end of each field.
fn projects(machine: &dyn AnyMachine) -> Vec<(String, Project)> {
    let plain = Project::of(machine.id(), None).unwrap();
    let mut all = vec![("default".to_owned(), plain.clone())];
    for field in machine.fields() {
        for value in ends(&field).into_iter().filter(|value| !matches!(value, Value::Text(text) if text.len() > 30)) {
            let mut project = plain.clone();
            let about = format!("{} = {value:?}", field.id);
            project.values.insert(field.id.to_owned(), value);
            all.push((about, project));
        }
    }
    all
}

#[test]
fn labels_have_room_and_poses_fit_at_any_values() {
    let mut found = Vec::new();
    for machine in machines::ALL {
        for (about, project) in projects(*machine) {
            found.extend(faults(&project).into_iter().map(|fault| format!("{} with {about}: {fault}", machine.id())));
        }
    }
    assert!(found.is_empty(), "{} faults:\n{}", found.len(), found[..found.len().min(60)].join("\n"));
}

#[test]
fn parts_of_drawings_name_fields_of_the_form_and_groups_end() {
    for machine in machines::ALL {
        let scene = Project::of(machine.id(), None).unwrap().prepared().scene();
        let fields = machine.fields();
        let mut seen = std::collections::BTreeSet::new();
        for node in &scene.nodes {
            assert!(node.field.is_empty() || fields.iter().any(|field| field.id == node.field), "{}", node.field);
            assert!(node.id.is_none_or(|id| seen.insert(id)), "{}: two nodes {:?}", machine.id(), node.id);
            assert!(usize::from(node.group) < scene.groups.len());
        }
        for group in 0..scene.groups.len() {
            let (mut at, mut steps) = (group, 0);
            while at != 0 {
                at = usize::from(scene.groups[at].parent);
                steps += 1;
                assert!(steps < 20, "{}: group {group} carries itself", machine.id());
            }
        }
    }
}
