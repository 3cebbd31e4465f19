//! The runs that a sizing looks at: the program on the machine, at the knob's end where the machine has one.

use crate::drives::speed::Steps;
use crate::motion::{Action, Budget, Event, Panel, Retention, RunEnd};
use crate::project::Project;
use crate::project::program::Written;
use crate::project::run::{Run, RunOptions, of_project};

/// What a run may take: blocks, and seconds of the machine. A longer run is sized as far as it came.
const LIMITS: Budget = Budget { blocks: 50_000, seconds: 900.0 };

/// Events that are planned at a time.
const SLICE: usize = 4096;

/// The run of a program without the operator's hand, and the same with the knob at its upper end.
#[derive(Debug)]
pub struct SizingRuns {
    /// The run, planned to its end.
    pub(super) run: Run,
    /// The run with the knob at its upper end from the start on, where there is a knob.
    pub(super) fast: Option<Run>,
    /// Time (s) of the first contact with the work; that of the end where there is none.
    pub(super) contact: f64,
    /// Time (s) at which the program ended or stopped.
    pub(super) end: f64,
    /// Whether it came to the end of the program.
    has_ended: bool,
    /// Least and greatest position of the spindle override, %.
    pub(super) knob: Option<(f64, f64)>,
}

/// Plans a run until a time (s), or to its end, which is returned.
pub(super) fn plan(run: &mut Run, until: f64) -> Option<RunEnd> {
    while run.timeline().end() < until {
        if let Some(ended) = run.advance(until, SLICE).ended {
            return Some(ended);
        }
    }
    None
}

/// Plans a run to its end.
pub(super) fn finish(run: &mut Run) -> RunEnd {
    loop {
        if let Some(ended) = run.advance(f64::INFINITY, SLICE).ended {
            return ended;
        }
    }
}

impl SizingRuns {
    /// Seconds of a part; none where the program does not come to its end.
    pub(super) fn seconds_of_a_part(&self) -> Option<f64> {
        (self.has_ended && self.end > 0.0).then_some(self.end)
    }

    /// Runs these programs of a project.
    pub fn new(project: &Project, written: &Written) -> SizingRuns {
        let prepared = project.prepared();
        let untouched = Project { panel: Panel::default(), ..project.clone() };
        let options = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Timeline };
        let mut run = of_project(&untouched, written, &options);
        let has_ended = finish(&mut run) == RunEnd::ProgramEnd;
        let end = run.ended_at().unwrap_or(run.timeline().end());
        let contact = prepared.first_contact(&run, end).map_or(end, |(t, _)| t);
        let Steps { low, high, .. } = project.on().dialect().spindle().knob;
        let knob = prepared.panel().spindle_override.map(|_| (low, high));
        let fast = knob.map(|(_, high)| {
            let mut fast = run.clone();
            fast.event(Event { t: 0.0, action: Action::SpindleOverride(high) });
            finish(&mut fast);
            fast
        });
        SizingRuns { run, fast, contact, end, has_ended, knob }
    }
}
