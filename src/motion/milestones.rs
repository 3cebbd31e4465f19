//! Milestones of a run: spindle switching, and waits, stops and ends of the control.

use super::snapshot::Mode;
use super::timeline::Timeline;
use crate::drives::{Bound, Rotation};

/// Event at a milestone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Milestone {
    /// The spindle is switched, also by reset or program end.
    Spindle(Rotation),
    /// The control changes from running to this mode.
    Mode(Mode),
}

impl Timeline {
    /// Milestones of the planned run with their times (s), in order.
    pub fn milestones(&self) -> Vec<(f64, Milestone)> {
        let mut found = Vec::new();
        let mut before = Rotation::Stopped;
        for ramp in self.ramps.until(f64::INFINITY) {
            let rotation = ramp.command.rotation;
            // A spindle that turns while gears mesh is not switched by a code.
            if ramp.command.bound == Bound::Shift && before == Rotation::Stopped {
                continue;
            }
            if rotation != before {
                found.push((ramp.t, Milestone::Spindle(rotation)));
                before = rotation;
            }
        }
        let mut before = Mode::Running;
        for mark in self.marks.until(f64::INFINITY) {
            if mark.mode != before && !matches!(mark.mode, Mode::Running | Mode::WaitFin) {
                found.push((mark.t, Milestone::Mode(mark.mode)));
            }
            before = mark.mode;
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        found
    }
}
