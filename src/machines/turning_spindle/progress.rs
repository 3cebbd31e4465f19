//! Progress of the part: passes done, position of the tool in the present pass, stock removed.

use super::params::Path;
use super::program::{PASS_BEGIN, cut_block};
use super::resolved::TurningSpindle;
use crate::machines::machine::{Executions, Samples};
use crate::math;
use crate::motion::Snapshot;

/// Progress of the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Progress {
    /// Passes that are done.
    pub(super) done: u32,
    /// Position of the tool in the present pass: Z along the part, the diameter on a face; none between passes.
    pub(super) at: Option<f64>,
}

/// Progress of the part: starts of the cutting block, and position of the tool in it.
pub(super) fn progress(lathe: &TurningSpindle, run: &dyn Samples, now: &Snapshot) -> Progress {
    let p = &lathe.params;
    let Executions { begun, executes: mut cutting } = run.executions(PASS_BEGIN, now.t);
    if p.path == Path::Taper {
        let taper = run.executions(cut_block(p.path), now.t);
        // Between the two blocks of a pass.
        cutting |= taper.executes || taper.begun < begun;
    }
    let (radius, z) = lathe.tool(now);
    let at = if p.path == Path::Facing { 2.0 * radius } else { z };
    Progress { done: begun - u32::from(cutting && begun > 0), at: (cutting && begun > 0).then_some(at) }
}

/// Diameter of the finished part at a place: the taper goes on as a cylinder in front of the face.
pub(super) fn contour(lathe: &TurningSpindle, z: f64) -> f64 {
    let p = &lathe.params;
    let end = if p.path == Path::Taper { p.large_diameter } else { p.finished_diameter };
    p.finished_diameter + (end - p.finished_diameter) * math::clamp(-z / p.length, 0.0, 1.0)
}

/// Whether the tool is in the stock.
pub(super) fn cuts(lathe: &TurningSpindle, progress: Progress, now: &Snapshot) -> bool {
    let p = &lathe.params;
    let inside = |at: f64| match p.path {
        Path::Facing => at < p.stock_diameter,
        _ => {
            let before = (contour(lathe, at) + p.left(f64::from(progress.done))).min(p.stock_diameter);
            at < 0.0 && at > -p.length && lathe.diameter(now) < before
        }
    };
    now.spindle.actual != 0.0 && progress.at.is_some_and(inside)
}

/// Removed share of the allowance, 0 to 1.
pub(super) fn removed(lathe: &TurningSpindle, progress: Progress) -> f64 {
    let p = &lathe.params;
    let part = match (progress.at, p.path) {
        (None, _) => 0.0,
        (Some(at), Path::Facing) => 1.0 - at / p.stock_diameter,
        (Some(at), _) => -at / p.length,
    };
    (f64::from(progress.done) + math::clamp(part, 0.0, 1.0)) / p.passes().max(1.0)
}
