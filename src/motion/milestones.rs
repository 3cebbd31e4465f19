//! Milestones of a run: spindle switching, and waits, stops and ends of the control.

use super::snapshot::Mode;
use super::timeline::Timeline;
use crate::controls::Code;
use crate::drives::Bound;

/// Event at a milestone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Milestone {
    /// The spindle is switched: [`Code::SpindleCw`], [`Code::SpindleCcw`] or [`Code::SpindleStop`], also by reset or program end.
    Spindle(Code),
    /// The control changes from running to this mode.
    Mode(Mode),
}

impl Timeline {
    /// Milestones of the planned run with their times (s), in order.
    pub fn milestones(&self) -> Vec<(f64, Milestone)> {
        let mut found = Vec::new();
        let mut before = 0;
        for ramp in self.ramps.until(f64::INFINITY) {
            let sign = ramp.command.sign.signum();
            // A spindle that turns while gears mesh is not switched by a code.
            if ramp.command.bound == Bound::Shift && before == 0 {
                continue;
            }
            if sign != before {
                let code = match sign {
                    0 => Code::SpindleStop,
                    1 => Code::SpindleCw,
                    _ => Code::SpindleCcw,
                };
                found.push((ramp.t, Milestone::Spindle(code)));
                before = sign;
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
