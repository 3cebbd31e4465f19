//! The runs of a sizing: the program on the machine, with the knob near its ends and the feed override at its highest position too.

use crate::drives::shaft_motion::Motion;
use crate::drives::speed::KnobRange;
use crate::machines::driven::{DrivenAxis, SpindleRun};
use crate::machines::{DrivenMachine, PreparedMachine};
use crate::motion::{Action, Budget, Event, Mover, Panel, Retention, RunEnd, RunSegment};
use crate::msg;
use crate::project::Project;
use crate::project::program::Written;
use crate::project::run::{Run, RunOptions, finish, of_project};
use crate::text::Message;

/// Budget of a run: blocks, and seconds of machine time. A longer run is sized up to there, and the sizing reports the cut.
const LIMITS: Budget = Budget { blocks: 200_000, seconds: 8.0 * 3600.0 };

/// Moments of a run among which that of the highest spindle speed is sought.
const MOMENTS: u32 = 400;

/// A spindle speed above that in the middle of the work by this factor counts as another one.
const FASTER: f64 = 1.01;

/// Seconds at rest between two parts of a series. Our choice; the time of a part does not depend on it.
const AT_REST: f64 = 0.1;

/// A run of the program from cycle start until the machine is at rest after its end.
#[derive(Debug)]
pub(super) struct WholeRun {
    /// Position (%) of the knob, if it is not that of the form.
    pub(super) knob: Option<f64>,
    /// Position (%) of the feed override, if it is not at 100 %.
    pub(super) feed: Option<f64>,
    /// The run, planned to its end.
    pub(super) run: Run,
    /// Time (s) of the first contact with the work; without one that of the end.
    pub(super) contact: f64,
    /// Time (s) at which the program ended or stopped.
    pub(super) end: f64,
    /// How it ended.
    pub(super) ended: RunEnd,
    /// Spans (s) in which the motors of the axes carry the torque of their work; none if they always do.
    pub(super) works: Option<Vec<(f64, f64)>>,
}

/// A run that ended before the end of its program.
#[derive(Debug, Clone, PartialEq)]
pub struct TruncatedRun {
    /// Time of the end, s.
    pub at: f64,
    /// Reason of the end.
    pub ended: RunEnd,
    /// Whether a contact of the machine holds the program.
    pub is_held: bool,
}

impl TruncatedRun {
    /// Sentence about the consequence for the sizing.
    pub fn message(&self) -> Message {
        let time = (self.at, 1);
        match &self.ended {
            RunEnd::Blocks => msg!("size.cut-blocks", blocks = LIMITS.blocks as f64, time),
            RunEnd::Seconds => msg!("size.cut-seconds", time),
            RunEnd::Alarm(_) => msg!("size.cut-alarm", time),
            RunEnd::Stop if self.is_held => msg!("size.cut-held", time),
            RunEnd::Stop | RunEnd::ProgramEnd => msg!("size.cut-stop", time),
        }
    }
}

/// Positions (%) of the spindle override in operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OperatedKnob {
    /// The lowest at which the machine is operated.
    pub(super) low: f64,
    /// The highest.
    pub(super) high: f64,
    /// The position 0, where the knob has it: it stops the spindle.
    pub(super) stop: Option<f64>,
}

/// The runs of a program without actions of the operator: at the form's position of the knob, and with the knob at other positions from the
/// start on.
#[derive(Debug)]
pub struct SizingRuns {
    /// At the form's position of the knob.
    pub(super) present: WholeRun,
    /// At the lowest position of the knob in a run, if that is another one.
    pub(super) slow: Option<WholeRun>,
    /// At the highest position of the knob, if that is another one.
    pub(super) fast: Option<WholeRun>,
    /// Positions of the spindle override in operation.
    pub(super) knob: Option<OperatedKnob>,
    /// With the feed override at its highest position, at each of these positions of the knob.
    pub(super) fed: Vec<WholeRun>,
    /// Least and greatest position of the feed override (%), where it acts on the cut.
    pub(super) feed: Option<(f64, f64)>,
}

impl WholeRun {
    fn new(prepared: &PreparedMachine, mut run: Run, knob: Option<f64>, feed: Option<f64>) -> WholeRun {
        let turned = [knob.map(Action::SpindleOverride), feed.map(Action::FeedOverride)];
        for action in turned.into_iter().flatten() {
            run.event(Event { t: 0.0, action });
        }
        let ended = finish(&mut run);
        let end = run.ended_at().unwrap_or(run.timeline().end());
        let contact = prepared.first_contact(&run, end).map_or(end, |(t, _)| t);
        let works = prepared.working(&run, run.timeline().end());
        WholeRun { knob, feed, run, contact, end, ended, works }
    }

    /// Its segments of a mover, from start to rest.
    pub(super) fn run_segments(&self, of: Mover) -> Vec<RunSegment> {
        let timeline = self.run.timeline();
        timeline.run_segments(of, 0.0, timeline.end())
    }

    /// The motion of the motor of an axis, under the torque of its work while that lasts.
    pub(super) fn motion(&self, axis: &DrivenAxis) -> Motion {
        axis.motion(&self.run_segments(axis.mover), self.works.as_deref())
    }

    /// The motor of the main spindle in it; none for other drives.
    pub(super) fn spindle(&self, machine: &dyn DrivenMachine) -> Option<SpindleRun> {
        machine.spindle_run(&self.run, &self.run_segments(Mover::Spindle))
    }

    /// Time (s) of the middle of its work.
    pub(super) fn middle(&self) -> f64 {
        0.5 * (self.contact + self.end)
    }

    /// Whether the work begins before the run ends.
    pub(super) fn works_before_its_end(&self) -> bool {
        self.contact < self.end
    }

    /// Times (s) at which a stop is tried: the middle of the work, and the moment of the highest spindle speed, where that is another one.
    pub(super) fn stops(&self) -> Vec<f64> {
        let speed = |t: f64| self.run.timeline().at(t).spindle.actual.abs();
        let moments = (0..=MOMENTS).map(|at| self.end * f64::from(at) / f64::from(MOMENTS));
        let fastest = moments.reduce(|best, t| if speed(t) > speed(best) { t } else { best });
        let faster = fastest.filter(|t| speed(*t) > FASTER * speed(self.middle()));
        [Some(self.middle()), faster].into_iter().flatten().collect()
    }
}

/// Time (s) of each further part of a series, on a machine whose first part takes another time: that of a second start, behind the end of a
/// run. None where all parts are alike.
pub(in crate::project) fn seconds_of_a_further_part(prepared: &PreparedMachine, run: &Run) -> Option<f64> {
    if !prepared.first_part_differs() {
        return None;
    }
    let (mut again, t) = (run.clone(), run.timeline().end() + AT_REST);
    again.event(Event { t, action: Action::Start });
    let ended = finish(&mut again);
    again.ended_at().filter(|end| ended == RunEnd::ProgramEnd && *end > t).map(|end| end - t)
}

impl SizingRuns {
    /// Time (s) of a part; none if the run does not reach the end of the program.
    pub(super) fn seconds_of_a_part(&self) -> Option<f64> {
        let WholeRun { ended, end, .. } = &self.present;
        (*ended == RunEnd::ProgramEnd && *end > 0.0).then_some(*end)
    }

    /// Time and reason of the end, if the run at the form's position of the knob ended before the end of the program.
    pub(super) fn truncated(&self) -> Option<TruncatedRun> {
        let WholeRun { ended, end, run, .. } = &self.present;
        let is_held = run.is_held_by_plc();
        (*ended != RunEnd::ProgramEnd).then(|| TruncatedRun { at: *end, ended: ended.clone(), is_held })
    }

    /// All runs with the feed override at 100 %, the one at the form's position of the knob first.
    pub(super) fn all(&self) -> impl Iterator<Item = &WholeRun> {
        [Some(&self.present), self.slow.as_ref(), self.fast.as_ref()].into_iter().flatten()
    }

    /// Runs these programs of a project.
    pub fn new(project: &Project, written: &Written) -> SizingRuns {
        SizingRuns::of(project, written, |run| run)
    }

    /// Runs these programs of a project with contacts that do not act.
    pub(super) fn without_contacts(project: &Project, written: &Written) -> SizingRuns {
        SizingRuns::of(project, written, Run::without_contacts)
    }

    fn of(project: &Project, written: &Written, changed: fn(Run) -> Run) -> SizingRuns {
        let prepared = project.prepared();
        let untouched = Project { panel: Panel::default(), ..project.clone() };
        let options = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Timeline };
        let begun = changed(of_project(&untouched, written, &options));
        let now = prepared.panel().spindle_override;
        let KnobRange { low, high, .. } = project.control_context().dialect().spindle().knob;
        let stop = (low <= 0.0).then_some(low);
        let (low, high) = (low.max(prepared.lowest_knob()), high.min(prepared.highest_knob()));
        let other = |percent: f64| Some(percent).filter(|_| now.is_some_and(|now| now != percent));
        let (lowest, highest) = (other(low), other(high));
        let at = |knob: Option<f64>, feed: Option<f64>| WholeRun::new(&prepared, begun.clone(), knob, feed);
        let feed = prepared.with_highest_feed().map(|(highest, _)| (project.control.feed_knob.positions.low, highest));
        let at_feed = |(_, highest_feed): (f64, f64)| {
            let knobs = [None].into_iter().chain([lowest, highest].into_iter().flatten().map(Some));
            knobs.map(|knob| at(knob, Some(highest_feed))).collect()
        };
        SizingRuns {
            present: at(None, None),
            slow: lowest.map(|percent| at(Some(percent), None)),
            fast: highest.map(|percent| at(Some(percent), None)),
            knob: now.map(|_| OperatedKnob { low, high, stop }),
            fed: feed.map_or_else(Vec::new, at_feed),
            feed,
        }
    }
}
