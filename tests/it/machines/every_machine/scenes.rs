//! The drawings of all machines, at any values of their forms: labels have room, poses move existing parts only.

use std::collections::BTreeSet;

use macroline::machines::form::Value;
use macroline::machines::{self, AnyMachine, Frame, Samples};
use macroline::motion::{Budget, Retention};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::view::{Pose, Theme, svg};

use super::drawn::{crowded, lost};
use super::sweep::ends;

const OPTIONS: RunOptions =
    RunOptions { start: None, settings: &[], limits: Budget { blocks: 400, seconds: 12.0 }, keep: Retention::Timeline };

/// Parts that a pose changes. Every pose of a drawing has to change the same parts: the page keeps a part as the last pose has left it.
fn moved(pose: &Pose) -> BTreeSet<String> {
    let groups = pose.placements.iter().map(|place| format!("group {}", place.group));
    let paths = pose.paths.iter().map(|(id, _)| format!("path {id}"));
    let texts = pose.texts.iter().map(|(id, _)| format!("text {id}"));
    let dashes = pose.dashes.iter().map(|(id, _)| format!("dash {id}"));
    let fills = pose.fills.iter().map(|(id, _)| format!("fill {id}"));
    groups.chain(paths).chain(texts).chain(dashes).chain(fills).collect()
}

/// Faults of the drawing of a project, at the start of its run and later.
fn faults(project: &Project) -> Vec<String> {
    let machine = project.prepared();
    let scene = machine.scene();
    let mut run = run::of_project(project, &project.written(), &OPTIONS);
    run.advance(OPTIONS.limits.seconds, usize::MAX);
    let end = run.timeline().end();
    let (mut found, mut first) = (Vec::new(), None);
    for (share, option) in [(0.0, false), (0.4, true), (0.9, false)] {
        let pose = machine.pose(&run, &Samples::at(&run, end * share), Frame { step: 0.004, drawing_option: option });
        found.extend(lost(&scene, &pose));
        let moved = moved(&pose);
        found.extend(
            first
                .get_or_insert_with(|| moved.clone())
                .symmetric_difference(&moved)
                .map(|part| format!("{part} only at times")),
        );
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
fn default_and_field_ends(machine: &dyn AnyMachine) -> Vec<(String, Project)> {
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
        for (about, project) in default_and_field_ends(*machine) {
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
