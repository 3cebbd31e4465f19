//! Planning of the run ahead of the play head, in slices: as far as the page shows it, and again after every change.

use std::time::Duration;

use leptos::prelude::*;

use super::edit_pace::SLOW;
use super::player::{AHEAD, PlannedPart, Player};
use super::put::put;
use crate::motion::{Budget, PlanProgress, Retention};
use crate::project::Project;
use crate::project::debugger::stepping::Goal;
use crate::project::program::Written;
use crate::project::run::{self, Run, RunOptions};
use crate::text::Diagnostic;
use crate::ui::dom;

/// A slice of planning.
struct PlanSlice {
    progress: PlanProgress,
    /// Whether there is more to plan.
    more: bool,
}

/// Milliseconds of planning in one slice.
const SLICE: f64 = 6.0;

/// Milliseconds of planning within a frame, when the play head has caught up with the plan.
const IN_FRAME: f64 = 2.0;

/// Machine seconds that are always planned in the background: an hour, so that film and charts end where the run does.
pub(crate) const HORIZON: f64 = 3600.0;

/// Longest run that is planned: ten hours, which fit the memory.
const LIMITS: Budget = Budget { blocks: 1_000_000_000, seconds: 36_000.0 };

/// Steps of the planner between two looks at the clock.
const STEPS: usize = 64;

/// Begins the run of a project; nothing of it is planned yet.
pub(crate) fn begin(project: &Project, written: &Written) -> Run {
    let begin = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Timeline };
    run::of_project(project, written, &begin)
}

impl Player {
    /// Begins another run; the play head stays at its time.
    pub(crate) fn load(self, project: &Project, written: &Written) {
        self.take(begin(project, written), project, written);
    }

    /// Takes a run that has begun; the play head stays at its time.
    pub(crate) fn take(self, run: Run, project: &Project, written: &Written) {
        let id = project.machine.id();
        if self.state.with_value(|state| state.id != id) {
            self.speed.set(0.0);
            self.zoom.set(None);
            self.changed.set(String::new());
        }
        self.state.update_value(|state| {
            state.planner = Some(run);
            state.id = id;
            state.machine = Some(project.prepared());
            state.visible = project.machine.info().speed;
            state.expected = 0.0;
        });
        self.end_stepping();
        self.stepper.update(|stepper| stepper.points.resolve(&written.parsed));
    }

    /// Shows the changed run after the effects of the change.
    pub(crate) fn settle(self) {
        dom::soon(move || {
            // The page may be gone.
            if self.state.is_disposed() {
                return;
            }
            let now = dom::now();
            let more = if self.state.try_update_value(|state| state.pace.hurries(now)) == Some(true) {
                self.plan_head();
                false
            } else {
                self.plan_whole(now)
            };
            dom::mark("rendered");
            dom::measure("edit", "input", "rendered");
            if more {
                self.plan_on();
            }
        });
    }

    /// Plans the run up to the end of the shown part, and shows it, at a time in ms; returns whether there is more to plan.
    fn plan_whole(self, now: f64) -> bool {
        self.state.update_value(|state| (state.pace.planned, state.pace.is_due) = (now, false));
        let more = self.plan_far();
        self.show();
        more
    }

    /// Shows the run at the play head, and soon as a whole. Until then charts, time axis and findings are those of the last whole plan.
    fn plan_head(self) {
        self.advance_plan(self.head() + AHEAD, SLICE);
        let was_due = self.state.try_update_value(|state| core::mem::replace(&mut state.pace.is_due, true));
        self.show();
        if was_due == Some(false) {
            let whole = move || {
                // The page may be gone, or the run planned meanwhile.
                if self.state.try_with_value(|state| state.pace.is_due) == Some(true) && self.plan_whole(dom::now()) {
                    self.plan_on();
                }
            };
            set_timeout(whole, Duration::from_millis(SLOW as u64));
        }
    }

    /// Replans from the earliest changed action of the operator, for the same project.
    pub(crate) fn replan(self, project: &Project, written: &Written) {
        let done = self.state.try_update_value(|state| Some(run::replan(state.planner.as_mut()?, project)));
        if done.flatten() == Some(true) {
            self.replanned();
        } else {
            self.load(project, written);
        }
    }

    /// After a change of the run: steps again to the block before which the debugger had stopped.
    pub(super) fn replanned(self) {
        let planned = self.planned.get_untracked().end;
        self.state.update_value(|state| state.expected = planned.max(state.expected));
        self.plans.update(|count| *count += 1);
        if self.end_stepping() {
            self.step_to(Goal::Block(0));
        }
    }

    /// Asks the planner something.
    pub(crate) fn ask_planner<T>(self, question: impl FnOnce(&Run) -> T) -> Option<T> {
        self.state.with_value(|state| state.planner.as_ref().map(question))
    }

    /// Whether reset has ended the run.
    pub(crate) fn is_reset(self) -> bool {
        self.ask_planner(|run| run.is_reset()) == Some(true)
    }

    /// Findings of the planned part of the run.
    pub(crate) fn findings(self) -> Vec<Diagnostic> {
        self.plans.track();
        self.state.with_value(|state| state.findings.clone())
    }

    /// Plans now, up to a time, for no longer than a slice.
    pub(crate) fn plan_to(self, t: f64) {
        self.plan(t, SLICE);
    }

    /// Plans up to a time, but only for some milliseconds; returns whether there is more to plan.
    fn plan(self, until: f64, budget: f64) -> bool {
        let advanced = self.advance_plan(until, budget);
        self.state.update_value(|state| {
            state.findings = state.planner.as_ref().map(|planner| planner.diagnostics().to_vec()).unwrap_or_default();
        });
        let Some(PlanSlice { progress: PlanProgress { planned_to, ended }, more }) = advanced else { return false };
        let planned = PlannedPart { end: planned_to, is_over: ended.is_some() };
        self.state.update_value(|state| {
            if planned.is_over || planned.end >= state.expected {
                state.expected = 0.0;
            }
        });
        put(self.ended, ended);
        if self.planned.get_untracked() != planned {
            self.planned.set(planned);
            self.plans.update(|count| *count += 1);
        }
        more
    }

    /// Plans without informing the page; `None` without a run.
    fn advance_plan(self, until: f64, budget: f64) -> Option<PlanSlice> {
        let begun = dom::now();
        let slice = self.state.try_update_value(|state| {
            let planner = state.planner.as_mut()?;
            loop {
                let progress = planner.advance(until, STEPS);
                let done = progress.ended.is_some() || progress.planned_to >= until;
                if done || dom::now() - begun > budget {
                    return Some(PlanSlice { progress, more: !done });
                }
            }
        });
        slice.flatten()
    }

    /// Plans in slices between the frames, until the plan reaches its goal.
    pub(super) fn plan_on(self) {
        let slicing = self.state.try_update_value(|state| core::mem::replace(&mut state.slicing, true));
        if slicing != Some(false) {
            return;
        }
        let slice = move || {
            // The page may be gone.
            if self.state.try_update_value(|state| state.slicing = false).is_none() {
                return;
            }
            let more = self.plan_far();
            // Charts of the whole plan cost more than a slice of planning.
            let due = self.state.with_value(|state| dom::now() - state.slow_at >= SLOW);
            if due || !more {
                self.ask();
            }
            if more {
                self.plan_on();
            }
        };
        set_timeout(slice, Duration::ZERO);
    }

    /// Time (s) up to which the plan is needed now: the end of the charts, and a little ahead of the play head.
    fn soon(self) -> f64 {
        let head = self.head();
        self.axis(head, 0.0).1.max(head + AHEAD)
    }

    /// Plans a slice in the background; returns whether there is more to plan.
    fn plan_far(self) -> bool {
        let more = self.plan(self.soon().max(HORIZON), SLICE);
        if !more {
            self.state.update_value(|state| state.expected = 0.0);
        }
        more
    }

    /// Plans within a frame, when the play head has caught up with the plan.
    pub(super) fn plan_in_frame(self) {
        self.plan(self.soon(), IN_FRAME);
    }
}
