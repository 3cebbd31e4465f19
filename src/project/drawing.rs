//! The drawing of a project at a moment of its run.

use super::Project;
use super::run::{RunOptions, of_project};
use crate::machines::{ALL, Frame};
use crate::motion::{Budget, Retention};
use crate::text::catalog::words;
use crate::view::{Pose, Scene, svg};

/// Maximum number of blocks run to reach the moment.
const BLOCKS: u64 = 10_000_000;

/// Longest part of a run (s) whose middle is drawn.
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
    let pose = machine.pose(&run, &now, Frame { step: 0.0, drawing_option: false });
    (machine.scene(), pose)
}

/// First drawing of the page: the default machine before its start, as SVG. The page's HTML contains it (`style/still.svg`), so that it is
/// visible before the module is loaded.
pub fn still() -> Option<String> {
    let project = Project::of(ALL.first()?.id(), None)?;
    let (scene, pose) = at(&project, 0.0);
    Some(svg::page(&scene, Some(&pose), words(scene.alt)) + "\n")
}
