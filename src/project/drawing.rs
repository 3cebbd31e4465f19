//! The drawing of a project at a moment of its run.

use super::Project;
use super::run::{RunOptions, of_project};
use crate::machines::{ALL, Frame};
use crate::motion::{Budget, Retention};
use crate::text::catalog::words;
use crate::view::{Pose, Scene, svg};

/// Blocks that are run at most on the way to the moment.
const BLOCKS: u64 = 10_000_000;

/// Longest run (s) of which the middle is sought.
const LONGEST: f64 = 3600.0;

/// The scene of a project and its pose at machine time `at` (s), or at the end of a run that is shorter.
pub fn at(project: &Project, at: f64) -> (Scene, Pose) {
    drawn(project, at, |end| at.min(end))
}

/// The scene of a project and its pose in the middle of its run, or of the first hour.
pub fn halfway(project: &Project) -> (Scene, Pose) {
    drawn(project, LONGEST, |end| 0.5 * end)
}

/// Runs a project up to `until` (s) and draws it at the moment that `moment` chooses, given the end of the run (s).
fn drawn(project: &Project, until: f64, moment: impl FnOnce(f64) -> f64) -> (Scene, Pose) {
    let limits = Budget { blocks: BLOCKS, seconds: until };
    let options = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = of_project(project, &project.written(), &options);
    run.advance(until, usize::MAX);
    let now = run.timeline().at(moment(run.timeline().end()));
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
