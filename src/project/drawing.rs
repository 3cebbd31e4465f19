//! The drawing of a project at a moment of its run.

use super::Project;
use super::run::{RunOptions, of_project};
use crate::machines::{ALL, Frame};
use crate::motion::{Budget, Retention};
use crate::text::catalog::words;
use crate::view::{Pose, Scene, svg};

/// Blocks that are run at most on the way to the moment.
const BLOCKS: u64 = 10_000_000;

/// The scene of a project and its pose at machine time `at` (s), or at the end of a run that is shorter.
pub fn at(project: &Project, at: f64) -> (Scene, Pose) {
    let limits = Budget { blocks: BLOCKS, seconds: at };
    let options = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = of_project(project, &project.written(), &options);
    run.advance(at, usize::MAX);
    let now = run.timeline().at(at.min(run.timeline().end()));
    let machine = project.prepared();
    let pose = machine.pose(&run, &now, Frame { step: 0.0, option: false });
    (machine.scene(), pose)
}

/// The drawing with which the page begins, the default machine before its start, as SVG for the page. It is in the page's HTML
/// (`style/still.svg`), so that it is seen before the module is loaded.
pub fn still() -> Option<String> {
    let project = Project::of(ALL.first()?.id(), None)?;
    let (scene, pose) = at(&project, 0.0);
    Some(svg::page(&scene, Some(&pose), words(scene.alt)) + "\n")
}
