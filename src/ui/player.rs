//! The run: a planner that is ahead of the play head, and the head itself. Not reactive, but for the few signals at its edge.

use std::sync::Arc;
use std::time::Duration;

use leptos::prelude::*;

use super::charts::Charts;
use super::dom::{self, Frames};
use super::local::Local;
use super::scene_view::Stage;
use super::walk::Walk;
use crate::controls::Control;
use crate::interp::inspect::What;
use crate::machines::{Frame, PreparedMachine};
use crate::math;
use crate::motion::{Action, Budget, Event, Retention, RunEnd, Snapshot};
use crate::project::Project;
use crate::project::debug::{Debugger, Goal};
use crate::project::program::Written;
use crate::project::run::{self, RunOptions};
use crate::text::{Diagnostic, Place};

/// Machine seconds per second.
pub(super) const SPEEDS: [f64; 10] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];

/// Milliseconds of planning in one slice.
const SLICE: f64 = 6.0;

/// Milliseconds of planning within a frame, when the head has caught up with the plan.
const IN_FRAME: f64 = 2.0;

/// Machine seconds that are planned ahead of the head, at least.
const AHEAD: f64 = 1.0;

/// Machine seconds that are planned in the background, whatever is shown.
const HORIZON: f64 = 60.0;

/// Where a run is given up: nobody watches ten hours, and they fit the memory.
const LIMITS: Budget = Budget { blocks: 1_000_000_000, seconds: 36_000.0 };

/// Steps of the planner between two looks at the clock.
const STEPS: usize = 64;

/// Milliseconds between two values of the slow signals.
const SLOW: f64 = 100.0;

/// The run of the page. A handle: copies mean the same.
#[derive(Clone, Copy)]
pub(super) struct Player {
    state: Local<State>,
    frames: Local<Option<Frames>>,
    /// Whether the head moves by itself.
    pub playing: Local<bool>,
    /// Machine seconds per second.
    pub speed: Local<f64>,
    /// Whether rollers are shown once per head.
    pub option: Local<bool>,
    /// The machine at the head, some times a second.
    pub now: Local<Snapshot>,
    /// The block that runs at the head.
    pub running: Local<Option<Place>>,
    /// Seconds that are planned, and whether the run is over there.
    pub planned: Local<(f64, bool)>,
    /// Why the run is over, where the plan has reached its end.
    pub ended: Local<Option<RunEnd>>,
    /// Seconds shown by the charts; 0 is the whole plan.
    pub window: Local<f64>,
    /// Counts the plans, for what asks the planner itself.
    pub plans: Local<u32>,
    /// The debugger.
    pub walk: Local<Walk>,
}

struct State {
    planner: Option<run::Run>,
    id: &'static str,
    machine: Option<Arc<PreparedMachine>>,
    head: f64,
    stamp: Option<f64>,
    slow_at: f64,
    slicing: bool,
    asked: bool,
    charts_stale: bool,
    charts_drawn: bool,
    stage: Option<Stage>,
    charts: Charts,
}

impl Player {
    pub(super) fn new() -> Player {
        let state = State {
            planner: None,
            id: "",
            machine: None,
            head: 0.0,
            stamp: None,
            slow_at: 0.0,
            slicing: false,
            asked: false,
            charts_stale: true,
            charts_drawn: false,
            stage: None,
            charts: Charts::default(),
        };
        let player = Player {
            state: Local::new(state),
            frames: Local::new(None),
            playing: Local::new(false),
            speed: Local::new(0.05),
            option: Local::new(false),
            now: Local::new(Snapshot::default()),
            running: Local::new(None),
            planned: Local::new((0.0, false)),
            ended: Local::new(None),
            window: Local::new(10.0),
            plans: Local::new(0),
            walk: Local::new(Walk::default()),
        };
        player.frames.quietly(|frames| *frames = Some(Frames::new(move |stamp| player.frame(stamp))));
        player
    }

    /// Takes another run; the head stays at its time.
    pub(super) fn load(self, project: &Project, written: &Written) {
        let id = project.machine.id();
        if self.state.with_untracked(|state| state.id != id) {
            self.speed.set(project.machine.speed());
        }
        self.state.quietly(|state| {
            let begin = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Timeline };
            state.planner = Some(run::of_project(project, written, &begin));
            state.id = id;
            state.machine = Some(project.prepared());
            state.charts_stale = true;
        });
        self.walk_away();
        self.walk.update(|walk| walk.points.resolve(&written.parsed));
    }

    /// Shows the run as it now is: after what the effects of a change write.
    pub(super) fn settle(self) {
        dom::soon(move || {
            self.plan(self.soon(), SLICE);
            self.show();
            dom::mark("rendered");
            dom::measure("edit", "input", "rendered");
            self.plan_on();
        });
    }

    /// Sets the drawing whose parts move.
    pub(super) fn set_stage(self, stage: Option<Stage>) {
        self.state.quietly(|state| state.stage = stage);
        self.ask();
    }

    /// Plays or pauses. At the end of the run it begins anew.
    pub(super) fn toggle(self) {
        let playing = !self.playing.get_untracked();
        if playing && self.at_end() {
            self.seek(0.0);
        }
        self.state.quietly(|state| state.stamp = None);
        self.playing.set(playing);
        self.ask();
    }

    /// Sets the head, away from where the debugger may have stopped.
    pub(super) fn seek(self, t: f64) {
        self.walk_away();
        self.set_head(t);
    }

    /// Sets the head.
    pub(super) fn set_head(self, t: f64) {
        self.state.quietly(|state| {
            state.head = if t > 0.0 { t } else { 0.0 };
            state.slow_at = 0.0;
        });
        self.ask();
        self.plan_on();
    }

    /// Seconds of the head.
    pub(super) fn head(self) -> f64 {
        self.state.with_untracked(|state| state.head)
    }

    /// Whether the head stands at the end of a run that is over.
    pub(super) fn at_end(self) -> bool {
        let (planned, ended) = self.planned.get_untracked();
        ended && self.head() >= planned
    }

    /// Pauses at the begin of the next block, or of the one before.
    pub(super) fn step(self, forth: bool) {
        self.playing.set(false);
        let to = self.state.with_untracked(|state| {
            let timeline = state.planner.as_ref()?.timeline();
            if forth { timeline.next_block(state.head) } else { Some(timeline.block_before(state.head)) }
        });
        if let Some(t) = to {
            self.seek(t);
        }
    }

    /// Does what the operator does, at the head.
    pub(super) fn act(self, action: Action) -> Event {
        let event = Event { t: self.head(), action };
        self.state.quietly(|state| {
            if let Some(planner) = &mut state.planner {
                planner.event(event.clone());
                state.charts_stale = true;
            }
        });
        // The run has become another; it stands before the same block of it, or before the first one that is read at last.
        if self.walk_away() {
            self.walk_to(Goal::Block(0));
        }
        self.settle();
        event
    }

    /// A variable as the control's screen shows it now, and whether it has changed since the last stop of the debugger.
    pub(super) fn variable(self, control: &Control, number: u32) -> (Option<f64>, bool) {
        self.plans.track();
        let t = self.now.with(|now| now.t);
        // At a stop the block that is read at this very time is not read yet.
        let stopped = self.walk.with(|walk| {
            let debugger = walk.stands()?;
            let changed = debugger.changes().iter().any(|change| change.what == What::Variable(number));
            Some((run::shown(debugger.run(), control, number, f64::INFINITY), changed))
        });
        stopped
            .unwrap_or_else(|| (self.ask_planner(|planner| run::shown(planner, control, number, t)).flatten(), false))
    }

    /// Asks the planner something.
    pub(super) fn ask_planner<T>(self, question: impl FnOnce(&run::Run) -> T) -> Option<T> {
        self.state.with_untracked(|state| state.planner.as_ref().map(question))
    }

    /// What the run has said so far, as far as it is planned.
    pub(super) fn findings(self) -> Vec<Diagnostic> {
        self.plans.track();
        self.ask_planner(|planner| planner.diagnostics().to_vec()).unwrap_or_default()
    }

    /// The charts of the whole plan, for a file.
    pub(super) fn all_charts(self, points: usize) -> Vec<crate::view::Chart> {
        let end = self.planned.get_untracked().0;
        self.state.with_untracked(|state| match (&state.planner, &state.machine) {
            (Some(planner), Some(machine)) => machine.charts(planner, 0.0, end, points),
            _ => Vec::new(),
        })
    }

    /// Sets the element of the charts.
    pub(super) fn set_charts(self, host: web_sys::HtmlElement) {
        self.state.quietly(|state| {
            state.charts.set_host(host);
            state.charts_stale = true;
        });
        self.ask();
    }

    /// Sets the head to a part (0 to 1) of the seconds that the charts show.
    pub(super) fn seek_in_page(self, part: f64) {
        self.playing.set(false);
        self.seek(self.state.with_untracked(|state| state.charts.time(part)));
    }

    /// Plans now, up to a time, for no longer than a slice.
    pub(super) fn plan_to(self, t: f64) {
        self.plan(t, SLICE);
    }

    /// Draws the charts again.
    pub(super) fn refresh_charts(self) {
        self.state.quietly(|state| state.charts_stale = true);
        self.ask();
    }

    /// Plans up to a time, but only for some milliseconds; says whether there is more to plan.
    fn plan(self, until: f64, budget: f64) -> bool {
        let begun = dom::now();
        let more = self.state.quietly(|state| {
            let planner = state.planner.as_mut()?;
            loop {
                let progress = planner.advance(until, STEPS);
                let done = progress.ended.is_some() || progress.planned_to >= until;
                if done || dom::now() - begun > budget {
                    return Some((progress.planned_to, progress.ended, !done));
                }
            }
        });
        let Some((planned, ended, more)) = more else { return false };
        let over = ended.is_some();
        self.ended.put(ended);
        if self.planned.get_untracked() != (planned, over) {
            self.planned.set((planned, over));
            self.plans.update(|count| *count += 1);
            self.state.quietly(|state| state.charts_stale |= state.charts.wants(planned));
        }
        more
    }

    /// Plans on in slices between the frames, until the plan is far enough.
    fn plan_on(self) {
        if self.state.quietly(|state| core::mem::replace(&mut state.slicing, true)) {
            return;
        }
        let slice = move || {
            self.state.quietly(|state| state.slicing = false);
            let more = self.plan(self.soon().max(HORIZON), SLICE);
            self.ask();
            if more {
                self.plan_on();
            }
        };
        set_timeout(slice, Duration::ZERO);
    }

    /// Seconds up to which the plan is needed now: what the charts show, and a little ahead of the head.
    fn soon(self) -> f64 {
        let window = self.window.get_untracked();
        self.state.with_untracked(|state| state.charts.page(state.head, 0.0, window).1.max(state.head + AHEAD))
    }

    /// Asks for a frame.
    pub(super) fn ask(self) {
        if !self.state.quietly(|state| core::mem::replace(&mut state.asked, true)) {
            self.frames.with_untracked(|frames| {
                if let Some(frames) = frames {
                    frames.ask();
                }
            });
        }
    }

    fn frame(self, stamp: f64) {
        dom::mark("frame-begins");
        self.state.quietly(|state| {
            state.asked = false;
            state.charts_drawn = false;
        });
        let playing = self.playing.get_untracked();
        if playing {
            let ahead = self.advance(stamp);
            if ahead < AHEAD / 2.0 {
                self.plan_on();
            }
            if self.at_end() {
                self.playing.set(false);
            }
        }
        self.show();
        dom::mark("frame-ends");
        dom::measure("frame", "frame-begins", "frame-ends");
        if self.playing.get_untracked() {
            self.ask();
        }
    }

    /// Moves the head by the time since the last frame; says how many seconds are planned ahead of it.
    fn advance(self, stamp: f64) -> f64 {
        let speed = self.speed.get_untracked();
        let from = self.head();
        let passed = self.state.quietly(|state| {
            // A tab that was hidden does not jump.
            let passed = state.stamp.map_or(0.0, |last| math::clamp(stamp - last, 0.0, 100.0));
            state.stamp = Some(stamp);
            passed
        });
        let head = self.play_to(from, from + passed / 1000.0 * speed);
        if head > self.planned.get_untracked().0 {
            self.plan(self.soon(), IN_FRAME);
        }
        let (planned, ended) = self.planned.get_untracked();
        // It stands at a breakpoint, be it that the plan is not there yet.
        let most = if self.playing.get_untracked() { planned.max(from) } else { head };
        self.state.quietly(|state| state.head = head.min(most));
        if ended { f64::INFINITY } else { planned - head }
    }

    /// Writes the moment at the head into the page.
    fn show(self) {
        let now = dom::now();
        let (planned, _) = self.planned.get_untracked();
        let playing = self.playing.get_untracked();
        let frame = Frame { step: self.speed.get_untracked() / 60.0, option: self.option.get_untracked() };
        let window = self.window.get_untracked();
        let shown = self.state.quietly(|state| {
            let (planner, machine) = (state.planner.as_ref()?, state.machine.as_deref()?);
            // The debugger may stand where nothing is planned yet.
            let snapshot = self.walk.with_untracked(|walk| {
                let stop = walk.stands().filter(|debugger| debugger.t() > planned);
                let timeline = stop.map_or(planner, Debugger::run).timeline();
                timeline.at(state.head.min(timeline.end()))
            });
            let head = snapshot.t;
            if let Some(stage) = &mut state.stage {
                stage.pose(&machine.pose(planner, &snapshot, frame));
                stage.time(head, planned);
            }
            let (from, to) = state.charts.page(head, planned, window);
            if (state.charts_stale || state.charts.moved(from, to)) && !state.charts_drawn {
                state.charts.draw(machine, planner, from, to);
                state.charts_drawn = true;
                state.charts_stale = false;
            }
            state.charts.cursor(head);
            let slow = !playing || now - state.slow_at >= SLOW;
            if slow {
                state.slow_at = now;
                state.charts.read(head);
            }
            Some((snapshot, slow, state.charts_stale))
        });
        let Some((snapshot, slow, again)) = shown else { return };
        let block = snapshot.block;
        if slow {
            self.now.put(snapshot);
        }
        self.running.put(block);
        if again {
            self.ask();
        }
    }
}
